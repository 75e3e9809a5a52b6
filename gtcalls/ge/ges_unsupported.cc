#include "gtcalls/ge/ges_unsupported.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace oncard::gtcalls::ges {

#define FAMILY_UNSUPPORTED "gtcalls/ge/ges_unsupported.def"
#include "gtcalls/rows/unsupported.inc"

}  // namespace oncard::gtcalls::ges
