#include "gtcalls/gt400/unsupported.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace oncard::gtcalls::gt400 {

#define FAMILY_UNSUPPORTED "gtcalls/gt400/unsupported.def"
#include "gtcalls/rows/unsupported.inc"

}  // namespace oncard::gtcalls::gt400
