#include "runtime/host/host_card.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "gtcalls/families.h"

namespace oncard::runtime {

Result<const gtcalls::CardType*> CardFromEnvironment(const gtcalls::Family* family) {
  const char* name = std::getenv("ONCARD_CARD");
  if (name == nullptr || *name == '\0') return nullptr;
  std::vector<std::string_view> names;
  for (const gtcalls::Family* each : gtcalls::Families()) {
    if (family != nullptr && each != family) continue;
    for (const gtcalls::CardType& type : each->card_types) {
      if (type.name == name) return &type;
      names.push_back(type.name);
    }
  }
  return MakeError(1, "ONCARD_CARD is '{}', expected one of {}",
                   "ONCARD_CARD 的值为 '{}'，应为 {} 之一", name,
                   fmt::to_string(fmt::join(names, ", ")));
}

}  // namespace oncard::runtime
