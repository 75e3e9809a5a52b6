// The families of cards that the module knows: those with motion programs. Pages run programs, and
// the module is downloaded.
#include "gtcalls/families.h"
#include "gtcalls/gts/family.h"

namespace oncard::gtcalls {

std::span<const Family* const> Families() {
  static const Family* const kFamilies[] = {&GtsFamily()};
  return kFamilies;
}

}  // namespace oncard::gtcalls
