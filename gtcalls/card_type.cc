#include "gtcalls/card_type.h"

#include <algorithm>
#include <set>

#include "gtcalls/families.h"
#include "gtcalls/family.h"

namespace oncard::gtcalls {

std::vector<std::string_view> CardTypeNames() {
  std::vector<std::string_view> names;
  for (const Family* family : Families()) {
    for (const CardType& type : family->card_types) names.push_back(type.name);
  }
  return names;
}

std::vector<int> AxisCounts() {
  std::set<int> counts;
  for (const Family* family : Families()) {
    for (const CardType& type : family->card_types) counts.insert(type.axis_count);
  }
  return {counts.begin(), counts.end()};
}

std::optional<NamedCard> FindCard(std::string_view name) {
  for (const Family* family : Families()) {
    const auto type = std::ranges::find(family->card_types, name, &CardType::name);
    if (type != family->card_types.end()) return NamedCard{family, &*type};
  }
  return std::nullopt;
}

}  // namespace oncard::gtcalls
