// The family of GE cards for point-to-point motion.
#pragma once

#include "gtcalls/family.h"

namespace oncard::gtcalls {

const Family& GepFamily();

}  // namespace oncard::gtcalls
