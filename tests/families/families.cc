// The families of the programs in this folder: that of the tests beside those of every build.
#include "gtcalls/families.h"

namespace oncard::gtcalls {

#define FAMILY(name, Name) const Family& Name##Family();
#include "gtcalls/families.def"
const Family& ToyFamily();

std::span<const Family* const> Families() {
  static const Family* const kFamilies[] = {
#define FAMILY(name, Name) &Name##Family(),
#include "gtcalls/families.def"
      &ToyFamily()};
  return kFamilies;
}

}  // namespace oncard::gtcalls
