// The numbers by which GTS commands name what the motion core has names for: words of inputs and
// outputs (MC_...), modes, stages and errors of homing (HOME_...), sources of captures
// (CAPTURE_...), masters and events of slaves (GEAR_..., FOLLOW_...), types of segments
// (PT_SEGMENT_..., FOLLOW_SEGMENT_...), planes of arcs. Source: the public header's constants.
// Tested by tests/gtcalls/numbers_test.cc.
#pragma once

#include <cstdint>
#include <optional>

#include "motion/homing.h"
#include "motion/io/capture.h"
#include "motion/io/digital_io.h"
#include "motion/paths/segment.h"
#include "motion/profiles/follow_mode.h"
#include "motion/profiles/gear_mode.h"
#include "motion/profiles/master.h"
#include "motion/profiles/pt_mode.h"

namespace oncard::gtcalls::gts {

/// MC_MPG, the last input word, from 0; and MC_ENABLE and MC_GPO, the first and the last output
/// word.
inline constexpr int kInputWordLast = 6;
inline constexpr int kOutputWordFirst = 10;
inline constexpr int kOutputWordLast = 12;

/// The input word of MC_LIMIT_POSITIVE ... MC_MPG; empty for other numbers.
std::optional<motion::DiType> DiTypeOf(int number);
/// The output word of MC_ENABLE, MC_CLEAR, MC_GPO; empty for other numbers.
std::optional<motion::DoType> DoTypeOf(int number);

/// Assumption: the stop types of GT_SetStopIo and GT_BufSetStopIo, as public host programs use
/// them; the stop modes of GT_SetCrdLmtStopMode have the same numbers.
inline constexpr int kAbruptStopType = 0;
inline constexpr int kSmoothStopType = 1;
/// Assumption: this input number disables their stop input, like index -1 in a configuration.
inline constexpr int kNoInput = -1;

/// The homing of HOME_MODE_...; kNone for other numbers.
motion::HomeMode HomeModeOf(int number);
/// HOME_MODE_..., HOME_STAGE_..., HOME_ERROR_...; 0 for a mode kNone.
int HomeNumber(motion::HomeMode mode);
int HomeNumber(motion::HomeStage stage);
int HomeNumber(motion::HomeError error);

/// The source of CAPTURE_...; kNone for other numbers.
motion::CaptureSource CaptureSourceOf(int number);
/// CAPTURE_...; 0 for kNone.
int CaptureNumber(motion::CaptureSource source);

/// The type of GEAR_MASTER_... and FOLLOW_MASTER_..., which have the same numbers; empty for
/// others.
std::optional<motion::MasterType> MasterTypeOf(int number);
int MasterNumber(motion::MasterType type);

/// The event of GEAR_EVENT_...; empty for other numbers.
std::optional<motion::GearEvent> GearEventOf(int number);
int EventNumber(motion::GearEvent event);
/// The event of FOLLOW_EVENT_...; empty for other numbers.
std::optional<motion::FollowEvent> FollowEventOf(int number);
int EventNumber(motion::FollowEvent event);

/// The type of PT_SEGMENT_...; empty for other numbers.
std::optional<motion::PtSegmentType> PtSegmentTypeOf(int number);
/// The type of FOLLOW_SEGMENT_...; empty for other numbers.
std::optional<motion::FollowSegmentType> FollowSegmentTypeOf(int number);

/// The plane of TCrdData.circlePlat; empty for other numbers.
std::optional<motion::ArcPlane> ArcPlaneOf(int number);

}  // namespace oncard::gtcalls::gts
