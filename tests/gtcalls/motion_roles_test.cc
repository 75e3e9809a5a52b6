// The commands that mean something for the motion of single axes.
#include "gtcalls/gts/motion_roles.h"

#include <gtest/gtest.h>

#include "gtcalls/gts/catalogue.h"

namespace oncard::gtcalls::gts {
namespace {

// Those who read roles take the first parameter for a profile or a mask of profiles.
TEST(MotionRoles, BelongToCommandsThatNameProfilesFirst) {
  int with_role = 0;
  for (const Command& command : GtsCatalogue().commands()) {
    if (MotionRoleOf(command) == MotionRole::kNone) continue;
    ++with_role;
    ASSERT_FALSE(command.parameters.empty()) << command.name;
    const Parameter& first = command.parameters[0];
    EXPECT_TRUE(first.unit == Unit::kMask || first.axis_number) << command.name;
  }
  EXPECT_EQ(with_role, 4);
}

TEST(MotionRoles, AreThoseOfTheManual) {
  const auto role = [](std::string_view name) { return MotionRoleOf(*GtsCatalogue().Find(name)); };
  EXPECT_EQ(role("GT_SetPos"), MotionRole::kTarget);
  EXPECT_EQ(role("GT_SetVel"), MotionRole::kVelocity);
  EXPECT_EQ(role("GT_Update"), MotionRole::kCommit);
  EXPECT_EQ(role("GT_PtStart"), MotionRole::kNone);
  EXPECT_EQ(role("GT_ClrSts"), MotionRole::kAcknowledge);
  EXPECT_EQ(role("GT_Stop"), MotionRole::kNone);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
