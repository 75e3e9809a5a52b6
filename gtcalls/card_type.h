// The types of cards that users can name, in all families.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/common/card_defaults.h"

namespace oncard::gtcalls {

struct Family;

/// One of the cards of a family.
struct CardType {
  std::string_view name;  ///< in scenarios and in ONCARD_CARD
  int axis_count;
  /// What its motion core is after a reset.
  motion::CardDefaults defaults;
};

/// The names of all types, family by family.
std::vector<std::string_view> CardTypeNames();

/// The numbers of axes that cards have, in ascending order.
std::vector<int> AxisCounts();

/// A card that a user has named.
struct NamedCard {
  const Family* family;
  const CardType* type;
};

/// The card with that name; nothing if there is none.
std::optional<NamedCard> FindCard(std::string_view name);

}  // namespace oncard::gtcalls
