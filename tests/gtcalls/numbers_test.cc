// The numbers of the header's constants, and what they stand for in the motion core.
#include "gtcalls/gts/numbers.h"

#include <gtest/gtest.h>

namespace oncard::gtcalls::gts {
namespace {

using motion::CaptureSource;
using motion::DiType;
using motion::DoType;
using motion::FollowEvent;
using motion::FollowSegmentType;
using motion::GearEvent;
using motion::HomeError;
using motion::HomeMode;
using motion::HomeStage;
using motion::MasterType;
using motion::PtSegmentType;

TEST(Numbers, NameTheInputWords) {
  EXPECT_EQ(DiTypeOf(0), DiType::kLimitPositive);
  EXPECT_EQ(DiTypeOf(1), DiType::kLimitNegative);
  EXPECT_EQ(DiTypeOf(2), DiType::kAlarm);
  EXPECT_EQ(DiTypeOf(3), DiType::kHome);
  EXPECT_EQ(DiTypeOf(4), DiType::kGpi);
  EXPECT_EQ(DiTypeOf(5), DiType::kArrive);
  EXPECT_EQ(DiTypeOf(6), DiType::kMpg);
  EXPECT_EQ(DiTypeOf(-1), std::nullopt);
  EXPECT_EQ(DiTypeOf(7), std::nullopt);
}

TEST(Numbers, NameTheOutputWords) {
  EXPECT_EQ(DoTypeOf(10), DoType::kEnable);
  EXPECT_EQ(DoTypeOf(11), DoType::kClear);
  EXPECT_EQ(DoTypeOf(12), DoType::kGpo);
  for (const int number : {0, 9, 13}) EXPECT_EQ(DoTypeOf(number), std::nullopt) << number;
}

TEST(Numbers, NameTheModesOfHoming) {
  for (const int number : {0, 10, 11, 12, 13, 20, 22, 30, 40, 41}) {
    EXPECT_EQ(HomeNumber(HomeModeOf(number)), number);
    EXPECT_EQ(HomeModeOf(number) == HomeMode::kNone, number == 0) << number;
  }
  EXPECT_EQ(HomeModeOf(13), HomeMode::kLimitHomeIndex);
  EXPECT_EQ(HomeModeOf(22), HomeMode::kHomeIndex);
  EXPECT_EQ(HomeModeOf(40), HomeMode::kForcedHome);
  for (const int number : {-1, 1, 21, 31, 42}) {
    EXPECT_EQ(HomeModeOf(number), HomeMode::kNone) << number;
  }
}

TEST(Numbers, NameTheStagesAndErrorsOfHoming) {
  EXPECT_EQ(HomeNumber(HomeStage::kIdle), 0);
  EXPECT_EQ(HomeNumber(HomeStage::kEscape), 2);
  EXPECT_EQ(HomeNumber(HomeStage::kLimitReturnStop), 16);
  EXPECT_EQ(HomeNumber(HomeStage::kSearchHomeStop), 22);
  EXPECT_EQ(HomeNumber(HomeStage::kSearchIndex), 30);
  EXPECT_EQ(HomeNumber(HomeStage::kGoHome), 80);
  EXPECT_EQ(HomeNumber(HomeStage::kEnd), 100);
  EXPECT_EQ(HomeNumber(HomeError::kNone), 0);
  EXPECT_EQ(HomeNumber(HomeError::kMode), 6);
  EXPECT_EQ(HomeNumber(HomeError::kNoIndex), 10);
}

TEST(Numbers, NameTheSourcesOfCaptures) {
  EXPECT_EQ(CaptureSourceOf(1), CaptureSource::kHome);
  EXPECT_EQ(CaptureSourceOf(2), CaptureSource::kIndex);
  EXPECT_EQ(CaptureSourceOf(3), CaptureSource::kProbe);
  EXPECT_EQ(CaptureSourceOf(6), CaptureSource::kHsio0);
  EXPECT_EQ(CaptureSourceOf(7), CaptureSource::kHsio1);
  EXPECT_EQ(CaptureSourceOf(8), CaptureSource::kHomeGpi);
  for (const int number : {-1, 0, 4, 5, 9}) {
    EXPECT_EQ(CaptureSourceOf(number), CaptureSource::kNone) << number;
  }
  for (const int number : {0, 1, 2, 3, 6, 7, 8}) {
    EXPECT_EQ(CaptureNumber(CaptureSourceOf(number)), number);
  }
}

TEST(Numbers, NameTheMastersOfSlaves) {
  EXPECT_EQ(MasterTypeOf(1), MasterType::kEncoder);
  EXPECT_EQ(MasterTypeOf(2), MasterType::kProfile);
  EXPECT_EQ(MasterTypeOf(3), MasterType::kAxis);
  for (const int number : {1, 2, 3}) EXPECT_EQ(MasterNumber(*MasterTypeOf(number)), number);
  for (const int number : {0, 4}) EXPECT_EQ(MasterTypeOf(number), std::nullopt) << number;
}

TEST(Numbers, NameTheEventsOfSlaves) {
  EXPECT_EQ(GearEventOf(1), GearEvent::kStart);
  EXPECT_EQ(GearEventOf(2), GearEvent::kPass);
  EXPECT_EQ(GearEventOf(5), GearEvent::kArea);
  for (const int number : {1, 2, 5}) EXPECT_EQ(EventNumber(*GearEventOf(number)), number);
  for (const int number : {0, 3, 4, 6}) EXPECT_EQ(GearEventOf(number), std::nullopt) << number;
  EXPECT_EQ(FollowEventOf(1), FollowEvent::kStart);
  EXPECT_EQ(FollowEventOf(2), FollowEvent::kPass);
  for (const int number : {1, 2}) EXPECT_EQ(EventNumber(*FollowEventOf(number)), number);
  for (const int number : {0, 3}) EXPECT_EQ(FollowEventOf(number), std::nullopt) << number;
}

TEST(Numbers, NameTheTypesOfSegments) {
  EXPECT_EQ(PtSegmentTypeOf(0), PtSegmentType::kNormal);
  EXPECT_EQ(PtSegmentTypeOf(1), PtSegmentType::kEven);
  EXPECT_EQ(PtSegmentTypeOf(2), PtSegmentType::kStop);
  for (const int number : {-1, 3}) EXPECT_EQ(PtSegmentTypeOf(number), std::nullopt) << number;
  EXPECT_EQ(FollowSegmentTypeOf(0), FollowSegmentType::kNormal);
  EXPECT_EQ(FollowSegmentTypeOf(1), FollowSegmentType::kEven);
  EXPECT_EQ(FollowSegmentTypeOf(2), FollowSegmentType::kStop);
  EXPECT_EQ(FollowSegmentTypeOf(3), FollowSegmentType::kContinue);
  for (const int number : {-1, 4}) EXPECT_EQ(FollowSegmentTypeOf(number), std::nullopt) << number;
}

TEST(Numbers, NameThePlanesOfArcs) {
  const auto normal = [](int number) {
    const auto plane = ArcPlaneOf(number);
    return plane ? plane->normal : -1;
  };
  EXPECT_EQ(normal(0), 2);  // XY
  EXPECT_EQ(normal(1), 0);  // YZ
  EXPECT_EQ(normal(2), 1);  // ZX
  EXPECT_EQ(normal(-1), -1);
  EXPECT_EQ(normal(3), -1);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
