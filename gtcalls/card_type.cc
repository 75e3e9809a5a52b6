#include "gtcalls/card_type.h"

#include <algorithm>

#include "gtcalls/family.h"
#include "gtcalls/gts/family.h"

namespace oncard::gtcalls {

std::span<const Family* const> Families() {
  static const Family* const kFamilies[] = {&GtsFamily()};
  return kFamilies;
}

std::optional<NamedCard> FindCard(std::string_view name) {
  for (const Family* family : Families()) {
    const auto type = std::ranges::find(family->card_types, name, &CardType::name);
    if (type != family->card_types.end()) return NamedCard{family, &*type};
  }
  return std::nullopt;
}

}  // namespace oncard::gtcalls
