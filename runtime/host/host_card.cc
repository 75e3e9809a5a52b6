#include "runtime/host/host_card.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "gtcalls/gts/family.h"
#include "runtime/host/clock.h"

namespace oncard::runtime {

const gtcalls::Family& LibraryFamily() { return gtcalls::GtsFamily(); }

Result<const gtcalls::CardType*> CardFromEnvironment() {
  const char* name = std::getenv("ONCARD_CARD");
  if (name == nullptr || *name == '\0') return nullptr;
  const auto& types = LibraryFamily().card_types;
  const auto type = std::ranges::find(types, std::string_view(name), &gtcalls::CardType::name);
  if (type != types.end()) return &*type;
  std::vector<std::string_view> names;
  for (const gtcalls::CardType& known : types) names.push_back(known.name);
  return MakeError(kOpenFailed, "ONCARD_CARD is '{}', expected one of {}",
                   "ONCARD_CARD 的值为 '{}'，应为 {} 之一", name,
                   fmt::to_string(fmt::join(names, ", ")));
}

}  // namespace oncard::runtime
