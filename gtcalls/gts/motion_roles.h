// What GTS commands mean for the motions of single axes (MotionRole). Source: GTS manual chapters 7
// and 8; GT_ClrSts in 6.2. Tested by tests/gtcalls/motion_roles_test.cc.
#pragma once

#include "gtcalls/family.h"

namespace oncard::gtcalls::gts {

MotionRole MotionRoleOf(const Command& command);

}  // namespace oncard::gtcalls::gts
