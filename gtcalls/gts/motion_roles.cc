#include "gtcalls/gts/motion_roles.h"

#include <algorithm>
#include <iterator>

namespace oncard::gtcalls::gts {
namespace {

struct RoleRow {
  std::string_view command;
  MotionRole role;
};

// compiler/flow_warnings.cc names the first three, too.
constexpr RoleRow kRoleRows[] = {
    {"GT_SetPos", MotionRole::kTarget},
    {"GT_SetVel", MotionRole::kVelocity},
    {"GT_Update", MotionRole::kCommit},
    {"GT_ClrSts", MotionRole::kAcknowledge},
};

}  // namespace

MotionRole MotionRoleOf(const Command& command) {
  const auto* row = std::ranges::find(kRoleRows, command.name, &RoleRow::command);
  return row == std::end(kRoleRows) ? MotionRole::kNone : row->role;
}

}  // namespace oncard::gtcalls::gts
