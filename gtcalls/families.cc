#include "gtcalls/families.h"

namespace oncard::gtcalls {

#define FAMILY(name, Name) const Family& Name##Family();
#include "gtcalls/families.def"

std::span<const Family* const> Families() {
  static const Family* const kFamilies[] = {
#define FAMILY(name, Name) &Name##Family(),
#include "gtcalls/families.def"
  };
  return kFamilies;
}

}  // namespace oncard::gtcalls
