// The types of cards that users can name, in all families.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace oncard::gtcalls {

struct Family;

/// One of the cards of a family.
struct CardType {
  std::string_view name;  ///< in scenarios and in ONCARD_CARD
  int axis_count;
};

/// The names of all types, family by family.
inline constexpr std::string_view kCardTypeNames[] = {
#define CARD_TYPE(name, axes) name,
#include "gtcalls/gts/card_types.def"
};

/// The families of this build.
std::span<const Family* const> Families();

/// A card that a user has named.
struct NamedCard {
  const Family* family;
  const CardType* type;
};

/// The card with that name; nothing if there is none.
std::optional<NamedCard> FindCard(std::string_view name);

}  // namespace oncard::gtcalls
