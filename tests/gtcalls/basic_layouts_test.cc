// The layouts of the vendor's basic header (gtcalls/gts/basic_layouts.def), compared with ours: the
// conversions between the two copy each member to the one with the same name.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "gtcalls/gts/catalogue.h"
#include "gtcalls/gts/interface_form.h"

namespace oncard::gtcalls::gts {
namespace {

/// Arrays that are shorter in the basic header, where a coordinate system has four axes.
constexpr struct {
  std::string_view structure;
  std::string_view member;
  int size;
  int basic_size;
} kShorterArrays[] = {{"TCrdData", "pos", 8, 4}, {"TCrdData", "cos", 8, 4}};

/// The elements that a member of the basic header has if ours has `size`.
int BasicSize(std::string_view structure, std::string_view member, int size) {
  for (const auto& shorter : kShorterArrays) {
    if (shorter.structure == structure && shorter.member == member && shorter.size == size) {
      return shorter.basic_size;
    }
  }
  return size;
}

TEST(BasicLayouts, HaveMembersOfOurStructuresInTheSameOrder) {
  ASSERT_FALSE(GtsInterfaceForm().basic_layouts.empty());
  for (const Structure& basic : GtsInterfaceForm().basic_layouts) {
    const Structure* ours = GtsCatalogue().FindStructure(basic.name);
    ASSERT_NE(ours, nullptr) << basic.name;
    auto rest = ours->members.begin();
    for (const Member& member : basic.members) {
      SCOPED_TRACE(testing::Message() << basic.name << '.' << member.name);
      rest = std::find_if(rest, ours->members.end(),
                          [&](const Member& m) { return m.name == member.name; });
      ASSERT_NE(rest, ours->members.end());
      EXPECT_EQ(member.type, rest->type);
      EXPECT_EQ(member.structure, rest->structure);
      EXPECT_FALSE(member.pointer || rest->pointer);
      EXPECT_EQ(member.array_size, BasicSize(basic.name, member.name, rest->array_size));
    }
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gts
