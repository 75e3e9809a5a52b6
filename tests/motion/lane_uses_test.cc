// The list of what lanes do with the members of a structure is complete only if it names each of
// them once. Those of the card's state are checked in motion/cycle_block.cc.
#include "motion/lane_uses.h"

#include <gtest/gtest.h>

#include <tuple>

namespace oncard::motion {
namespace {

/// A structure with two members, for one way to list them each.
template <int kWay>
struct TwoMembers {
  int first = 0;
  double second = 0;

  auto Fields(auto visit) const { return visit(first, second); }
};
using BothListed = TwoMembers<0>;
using OneForgotten = TwoMembers<1>;
using OneListedTwice = TwoMembers<2>;

}  // namespace

template <>
struct LaneUses<BothListed> {
  using Laned = Members<&BothListed::first>;
  using Beside = Members<>;
  using Rests = Members<&BothListed::second>;
  using Read = Members<>;
};
template <>
struct LaneUses<OneForgotten> {
  using Laned = Members<&OneForgotten::first>;
  using Beside = Members<>;
  using Rests = Members<>;
  using Read = Members<>;
};
template <>
struct LaneUses<OneListedTwice> {
  using Laned = Members<&OneListedTwice::first>;
  using Beside = Members<>;
  using Rests = Members<>;
  using Read = Members<&OneListedTwice::first>;
};

namespace {

TEST(LaneUses, NameEachMemberOnce) {
  EXPECT_TRUE(kLaneUsesComplete<BothListed>);
  EXPECT_FALSE(kLaneUsesComplete<OneForgotten>);
  EXPECT_FALSE(kLaneUsesComplete<OneListedTwice>);
}

}  // namespace
}  // namespace oncard::motion
