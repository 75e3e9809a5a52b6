#include "gtcalls/gts/unsupported.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace oncard::gtcalls::gts {

#define FAMILY_UNSUPPORTED "gtcalls/gts/unsupported.def"
#include "gtcalls/rows/unsupported.inc"

}  // namespace oncard::gtcalls::gts
