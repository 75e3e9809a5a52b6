// Properties of every mode (motion/profiles/modes.def): a new row is tested without further
// changes.
#include "motion/profiles/modes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "motion/common/state_hash.h"
#include "motion/profiles/profile.h"

namespace oncard::motion {
namespace {

using ::testing::SizeIs;

constexpr ProfileMode kModes[] = {
#define PROFILE_MODE(enumerator, ...) ProfileMode::enumerator,
#define WRITTEN_MODE(enumerator, ...) ProfileMode::enumerator,
#include "motion/profiles/modes.def"
};

TEST(ProfileModes, HaveNumbersAndNamesOfTheirOwn) {
  std::set<uint8_t> numbers;
  std::set<std::string_view> names;
  for (const ProfileMode mode : kModes) {
    numbers.insert(static_cast<uint8_t>(mode));
    names.insert(NameOf(mode));
  }
  EXPECT_THAT(numbers, SizeIs(std::size(kModes)));
  EXPECT_THAT(names, SizeIs(std::size(kModes)));
}

/// A row whose mode is implemented by a class.
template <ProfileMode kSelected, auto kMember>
struct Row {
  static constexpr ProfileMode kMode = kSelected;
  using Mode = std::remove_reference_t<decltype(std::declval<Profile&>().*kMember)>;
  static Mode& In(Profile& profile) { return profile.*kMember; }
};

template <typename Tested>
class EachMode : public ::testing::Test {
 protected:
  EachMode() { profile_.mode = Tested::kMode; }

  /// Sets the profile as after a start, without the mode's own data.
  void Run() {
    Tested::In(profile_).running = true;
    profile_.now = {100, 10, 0, true};
  }
  static uint64_t HashOf(const typename Tested::Mode& mode) {
    return StateHash().Add(mode).value();
  }

  Profile profile_;
};

template <typename Nothing, typename... Rows>
using TypesOf = ::testing::Types<Rows...>;
using Rows = TypesOf<void
#define PROFILE_MODE(enumerator, number, name, member, Class) \
  , Row<ProfileMode::enumerator, &Profile::member>
#include "motion/profiles/modes.def"
                     >;
TYPED_TEST_SUITE(EachMode, Rows);

TYPED_TEST(EachMode, AStopEndsTheRunAndDeceleratesFromItsVelocity) {
  this->Run();
  this->profile_.Stop(0, 1);
  EXPECT_FALSE(TypeParam::In(this->profile_).running);
  this->profile_.Advance(5000);
  EXPECT_EQ(this->profile_.now, (Sample{137.5, 5, -1, true}));
  this->profile_.Advance(10000);
  EXPECT_EQ(this->profile_.now, AtRest(150));
}

TYPED_TEST(EachMode, IsNotChangedWhileOthersAreSelected) {
  const uint64_t registers = TestFixture::HashOf(TypeParam::In(this->profile_));
  for (const ProfileMode other : kModes) {
    if (other == TypeParam::kMode) continue;
    this->profile_.mode = other;
    this->profile_.now = {100, 10, 0, true};
    this->profile_.Stop(0, 1000);
    this->profile_.Advance(1000);
    EXPECT_EQ(TestFixture::HashOf(TypeParam::In(this->profile_)), registers) << NameOf(other);
  }
}

TYPED_TEST(EachMode, FollowsItsMasterWhileItRunsOrNone) {
  const Master* master = nullptr;
  if constexpr (SlaveMode<typename TypeParam::Mode>) master = &TypeParam::In(this->profile_).master;
  EXPECT_EQ(this->profile_.SelectedMaster(), master);
  EXPECT_EQ(this->profile_.FollowedMaster(), nullptr) << "at rest";
  this->Run();
  EXPECT_EQ(this->profile_.FollowedMaster(), master);
  this->profile_.driven = true;
  EXPECT_EQ(this->profile_.FollowedMaster(), nullptr) << "driven";
  this->profile_.driven = false;
  this->profile_.Stop(0, 1);
  EXPECT_EQ(this->profile_.FollowedMaster(), nullptr) << "stopping";
}

TEST(Profile, InAModeThatACoordinateSystemWritesThereIsNothingToFollow) {
  for (const ProfileMode mode : {
#define WRITTEN_MODE(enumerator, ...) ProfileMode::enumerator,
#include "motion/profiles/modes.def"
       }) {
    Profile profile;
    profile.mode = mode;
    profile.now = {100, 10, 0, true};
    EXPECT_EQ(profile.FollowedMaster(), nullptr);
    profile.Advance(1000);
    EXPECT_EQ(profile.now, (Sample{100, 10, 0, true}));
  }
}

}  // namespace
}  // namespace oncard::motion
