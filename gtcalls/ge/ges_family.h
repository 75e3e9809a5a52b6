// The family of GE cards for paths.
#pragma once

#include "gtcalls/family.h"

namespace oncard::gtcalls {

const Family& GesFamily();

}  // namespace oncard::gtcalls
