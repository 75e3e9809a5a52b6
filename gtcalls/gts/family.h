// The family of GTS controllers.
#pragma once

#include "gtcalls/family.h"

namespace oncard::gtcalls {

const Family& GtsFamily();

}  // namespace oncard::gtcalls
