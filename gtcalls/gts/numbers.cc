#include "gtcalls/gts/numbers.h"

#include <algorithm>
#include <iterator>

namespace oncard::gtcalls::gts {
namespace {

using motion::ArcPlane;
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

template <typename Name>
struct Row {
  int number;
  Name name;
};

constexpr Row<DiType> kInputWords[] = {
    {0, DiType::kLimitPositive}, {1, DiType::kLimitNegative}, {2, DiType::kAlarm},
    {3, DiType::kHome},          {4, DiType::kGpi},           {5, DiType::kArrive},
    {6, DiType::kMpg},
};

constexpr Row<DoType> kOutputWords[] = {
    {10, DoType::kEnable}, {11, DoType::kClear}, {12, DoType::kGpo}};

constexpr Row<HomeMode> kHomeModes[] = {
    {0, HomeMode::kNone},
    {10, HomeMode::kLimit},
    {11, HomeMode::kLimitHome},
    {12, HomeMode::kLimitIndex},
    {13, HomeMode::kLimitHomeIndex},
    {20, HomeMode::kHome},
    {22, HomeMode::kHomeIndex},
    {30, HomeMode::kIndex},
    {40, HomeMode::kForcedHome},
    {41, HomeMode::kForcedHomeIndex},
};

constexpr Row<HomeStage> kHomeStages[] = {
    {0, HomeStage::kIdle},
    {1, HomeStage::kStart},
    {2, HomeStage::kEscape},
    {10, HomeStage::kSearchLimit},
    {11, HomeStage::kSearchLimitStop},
    {13, HomeStage::kLimitEscape},
    {15, HomeStage::kLimitReturn},
    {16, HomeStage::kLimitReturnStop},
    {20, HomeStage::kSearchHome},
    {22, HomeStage::kSearchHomeStop},
    {25, HomeStage::kHomeReturn},
    {30, HomeStage::kSearchIndex},
    {80, HomeStage::kGoHome},
    {100, HomeStage::kEnd},
};

constexpr Row<HomeError> kHomeErrors[] = {
    {0, HomeError::kNone},     {1, HomeError::kNotTrap},
    {2, HomeError::kDisabled}, {3, HomeError::kAlarm},
    {4, HomeError::kStop},     {5, HomeError::kStage},
    {6, HomeError::kMode},     {7, HomeError::kSetCaptureHome},
    {8, HomeError::kNoHome},   {9, HomeError::kSetCaptureIndex},
    {10, HomeError::kNoIndex},
};

constexpr Row<CaptureSource> kCaptureSources[] = {
    {0, CaptureSource::kNone},    {1, CaptureSource::kHome},  {2, CaptureSource::kIndex},
    {3, CaptureSource::kProbe},   {6, CaptureSource::kHsio0}, {7, CaptureSource::kHsio1},
    {8, CaptureSource::kHomeGpi},
};

constexpr Row<MasterType> kMasterTypes[] = {
    {1, MasterType::kEncoder}, {2, MasterType::kProfile}, {3, MasterType::kAxis}};

constexpr Row<GearEvent> kGearEvents[] = {
    {1, GearEvent::kStart}, {2, GearEvent::kPass}, {5, GearEvent::kArea}};

constexpr Row<FollowEvent> kFollowEvents[] = {{1, FollowEvent::kStart}, {2, FollowEvent::kPass}};

constexpr Row<PtSegmentType> kPtSegmentTypes[] = {
    {0, PtSegmentType::kNormal}, {1, PtSegmentType::kEven}, {2, PtSegmentType::kStop}};

constexpr Row<FollowSegmentType> kFollowSegmentTypes[] = {
    {0, FollowSegmentType::kNormal},
    {1, FollowSegmentType::kEven},
    {2, FollowSegmentType::kStop},
    {3, FollowSegmentType::kContinue},
};

constexpr Row<ArcPlane> kArcPlanes[] = {
    {0, motion::kXyPlane}, {1, motion::kYzPlane}, {2, motion::kZxPlane}};

template <typename Name, size_t kSize>
std::optional<Name> NameIn(const Row<Name> (&rows)[kSize], int number) {
  const auto* row = std::find_if(std::begin(rows), std::end(rows),
                                 [&](const auto& r) { return r.number == number; });
  return row == std::end(rows) ? std::nullopt : std::optional(row->name);
}

/// The tables name every enumerator.
template <typename Name, size_t kSize>
int NumberIn(const Row<Name> (&rows)[kSize], Name name) {
  return std::find_if(std::begin(rows), std::end(rows),
                      [&](const auto& r) { return r.name == name; })
      ->number;
}

}  // namespace

std::optional<DiType> DiTypeOf(int number) { return NameIn(kInputWords, number); }
std::optional<DoType> DoTypeOf(int number) { return NameIn(kOutputWords, number); }

HomeMode HomeModeOf(int number) { return NameIn(kHomeModes, number).value_or(HomeMode::kNone); }
int HomeNumber(HomeMode mode) { return NumberIn(kHomeModes, mode); }
int HomeNumber(HomeStage stage) { return NumberIn(kHomeStages, stage); }
int HomeNumber(HomeError error) { return NumberIn(kHomeErrors, error); }

CaptureSource CaptureSourceOf(int number) {
  return NameIn(kCaptureSources, number).value_or(CaptureSource::kNone);
}
int CaptureNumber(CaptureSource source) { return NumberIn(kCaptureSources, source); }

std::optional<MasterType> MasterTypeOf(int number) { return NameIn(kMasterTypes, number); }
int MasterNumber(MasterType type) { return NumberIn(kMasterTypes, type); }

std::optional<GearEvent> GearEventOf(int number) { return NameIn(kGearEvents, number); }
int EventNumber(GearEvent event) { return NumberIn(kGearEvents, event); }
std::optional<FollowEvent> FollowEventOf(int number) { return NameIn(kFollowEvents, number); }
int EventNumber(FollowEvent event) { return NumberIn(kFollowEvents, event); }

std::optional<PtSegmentType> PtSegmentTypeOf(int number) { return NameIn(kPtSegmentTypes, number); }
std::optional<FollowSegmentType> FollowSegmentTypeOf(int number) {
  return NameIn(kFollowSegmentTypes, number);
}

std::optional<ArcPlane> ArcPlaneOf(int number) { return NameIn(kArcPlanes, number); }

}  // namespace oncard::gtcalls::gts
