// Captures, their offsets, and triggers. Source: public header; table 10-2 for the offsets.
// Tested by tests/gtcalls/capture_command_test.cc.
#include <algorithm>

#include "gtcalls/gts/commands/motion_support.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Capture;
using motion::CaptureSource;
using motion::CaptureUnit;
using motion::Trigger;

/// Cells of TTrigger.
enum TriggerCell : size_t {
  kEncoder,
  kProbeType,
  kProbeIndex,
  kSense,
  kOffset,
  kLoop,
  kWindowOnly,
  kFirstPosition,
  kLastPosition
};
constexpr size_t kTriggerStatusCells = 3;

const CaptureUnit& UnitOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::capture>();
}
const Capture& CaptureOf(const Call& call) { return UnitOf(call).capture(NumberOf(call)); }
CaptureUnit& ChangeUnit(const Call& call) { return call.card.motion.capture(); }

/// 0, or 7 if there is no capture source with this number.
int16_t CheckSource(Call& call, double number) {
  if (CaptureSourceOf(static_cast<int>(number)) != CaptureSource::kNone) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("capture source {0} does not exist; there are 1 to 3 and 6 to 8",
                                 "捕获方式为 {0}；应为 1 到 3 或 6 到 8", number));
}

int16_t RefuseRange(Call& call, std::string_view name, double value, double first, double last) {
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{0} is {1}; {2} to {3} is expected",
                                 "{0} 为 {1}；应为 {2} 到 {3}", name, value, first, last));
}

/// 0, or 7 if the card has no encoder with this number.
int16_t CheckEncoder(Call& call, std::string_view name, double number) {
  if (number >= 1 && call.card.motion.HasEncoder(static_cast<size_t>(number) - 1)) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{0} is {1}; this card has no such encoder",
                                 "{0} 为 {1}；本控制卡没有该编码器", name, number));
}

}  // namespace

int16_t GT_SetCaptureMode(Call& call) {
  const int16_t code = CheckSource(call, call.value(1));
  if (code != vm::kOk) return code;
  ChangeUnit(call).Arm(NumberOf(call), CaptureSourceOf(call.integer(1)));
  return vm::kOk;
}

int16_t GT_GetCaptureMode(Call& call) {
  return ReadEach(call, [&](size_t i) { return CaptureNumber(UnitOf(call).capture(i).source); });
}

int16_t GT_GetCaptureStatus(Call& call) {
  for (int i = 0; i < call.integer(3); ++i) {
    const auto cell = static_cast<size_t>(i);
    const Capture& capture = UnitOf(call).capture(NumberOf(call) + cell);
    call.Set(1, capture.captured ? 1 : 0, cell);
    call.Set(2, capture.value, cell);
  }
  call.Set(4, UnsignedLong(call.card.motion.ClockMs()));
  return vm::kOk;
}

int16_t GT_SetCaptureSense(Call& call) {
  const int16_t code = CheckSource(call, call.value(1));
  if (code != vm::kOk) return code;
  ChangeUnit(call).SetSense(NumberOf(call), CaptureSourceOf(call.integer(1)), call.integer(2) != 0);
  return vm::kOk;
}

int16_t GT_ClearCaptureStatus(Call& call) {
  ChangeUnit(call).Clear(NumberOf(call));
  return vm::kOk;
}

namespace {

/// 0, or 1 while the capture is armed.
int16_t CheckDisarmed(Call& call) {
  if (!CaptureOf(call).armed) return vm::kOk;
  return call.Refuse(vm::kRefused, MakeMessage("capture {0} is armed, wait until it has captured",
                                               "捕获 {0} 已启动，请等待捕获完成", call.integer(0)));
}

}  // namespace

/// Public samples call it after GT_SetCaptureMode.
int16_t GT_SetCaptureRepeat(Call& call) {
  ChangeUnit(call).SetRepeat(NumberOf(call), static_cast<uint16_t>(call.integer(1)));
  return vm::kOk;
}

int16_t GT_GetCaptureRepeatStatus(Call& call) {
  call.Set(1, static_cast<double>(CaptureOf(call).positions.size()));
  return vm::kOk;
}

/// Positions are numbered from 1, as in public samples.
int16_t GT_GetCaptureRepeatPos(Call& call) {
  const std::vector<double>& positions = CaptureOf(call).positions;
  const int first = call.integer(2);
  const int count = call.integer(3);
  if (first < 1 || first + count - 1 > static_cast<int>(positions.size())) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("positions {0} to {1} were requested; {2} are captured, counted from 1",
                    "读取第 {0} 到 {1} 个位置；已捕获 {2} 个，从 1 编号", first, first + count - 1,
                    positions.size()));
  }
  for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
    call.Set(1, positions[static_cast<size_t>(first - 1) + i], i);
  }
  return vm::kOk;
}

int16_t GT_SetCaptureEncoder(Call& call) {
  const int16_t code = CheckDisarmed(call);
  if (code != vm::kOk) return code;
  ChangeUnit(call).SetEncoder(NumberOf(call), NumberOf(call, 1));
  return vm::kOk;
}

int16_t GT_SetCaptureOffset(Call& call) {
  if (call.value(3) < 0) return RefuseRange(call, "loop", call.value(3), 0, 2147483647);
  std::vector<int32_t> offsets;
  for (const double offset : call.cells(1)) offsets.push_back(static_cast<int32_t>(offset));
  ChangeUnit(call).SetOffsets(NumberOf(call), std::move(offsets), call.integer(3));
  return vm::kOk;
}

int16_t GT_GetCaptureOffset(Call& call) {
  const Capture& capture = CaptureOf(call);
  const size_t count = std::min(call.cells(1).size(), capture.offsets.size());
  for (size_t i = 0; i < count; ++i) call.Set(1, capture.offsets[i], i);
  call.Set(2, static_cast<double>(capture.offsets.size()));
  call.Set(3, capture.loop);
  return vm::kOk;
}

int16_t GT_GetCaptureOffsetStatus(Call& call) {
  const Capture& capture = CaptureOf(call);
  call.Set(1, capture.offsets_used);
  call.Set(2, capture.loops_done);
  call.Set(3, capture.raw);
  return vm::kOk;
}

int16_t GT_LinkCaptureOffset(Call& call) {
  const int16_t code = CheckEncoder(call, "source", call.value(1));
  if (code != vm::kOk) return code;
  ChangeUnit(call).LinkOffsets(NumberOf(call), NumberOf(call, 1));
  return vm::kOk;
}

int16_t GT_SetTrigger(Call& call) {
  const std::span<double> cells = call.cells(1);
  const int axes = call.card.motion.config().axis_count;
  int16_t code = CheckEncoder(call, "TTrigger.encoder", cells[kEncoder]);
  if (code == vm::kOk) code = CheckSource(call, cells[kProbeType]);
  if (code != vm::kOk) return code;
  if (cells[kProbeIndex] < 1 || cells[kProbeIndex] > axes) {
    return RefuseRange(call, "TTrigger.probeIndex", cells[kProbeIndex], 1, axes);
  }
  for (const auto& [cell, name] :
       {std::pair{kSense, "TTrigger.sense"}, {kWindowOnly, "TTrigger.windowOnly"}}) {
    if (cells[cell] != 0 && cells[cell] != 1) return RefuseRange(call, name, cells[cell], 0, 1);
  }
  if (cells[kWindowOnly] == 1 && cells[kFirstPosition] > cells[kLastPosition]) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("TTrigger.firstPosition {0} is beyond lastPosition {1}",
                                   "TTrigger.firstPosition {0} 大于 lastPosition {1}",
                                   cells[kFirstPosition], cells[kLastPosition]));
  }
  Trigger trigger;
  trigger.encoder = static_cast<uint8_t>(cells[kEncoder] - 1);
  trigger.source = CaptureSourceOf(static_cast<int>(cells[kProbeType]));
  trigger.input = static_cast<uint8_t>(cells[kProbeIndex] - 1);
  trigger.rising = cells[kSense] != 0;
  trigger.offset = static_cast<int16_t>(cells[kOffset]);
  trigger.loop = static_cast<uint32_t>(cells[kLoop]);
  trigger.window_only = cells[kWindowOnly] != 0;
  trigger.first = static_cast<int32_t>(cells[kFirstPosition]);
  trigger.last = static_cast<int32_t>(cells[kLastPosition]);
  ChangeUnit(call).SetTrigger(NumberOf(call), trigger);
  return vm::kOk;
}

int16_t GT_GetTrigger(Call& call) {
  const Trigger& t = UnitOf(call).trigger(NumberOf(call));
  const double cells[] = {double(t.encoder + 1),
                          double(CaptureNumber(t.source)),
                          double(t.input + 1),
                          t.rising ? 1.0 : 0.0,
                          double(t.offset),
                          double(t.loop),
                          t.window_only ? 1.0 : 0.0,
                          double(t.first),
                          double(t.last)};
  for (size_t i = 0; i < std::size(cells); ++i) call.Set(1, cells[i], i);
  return vm::kOk;
}

int16_t GT_GetTriggerStatus(Call& call) {
  const size_t count =
      std::min(static_cast<size_t>(call.integer(2)), call.cells(1).size() / kTriggerStatusCells);
  for (size_t i = 0; i < count; ++i) {
    const Trigger& t = UnitOf(call).trigger(NumberOf(call) + i);
    call.Set(1, t.armed ? 1 : 0, kTriggerStatusCells * i);
    call.Set(1, t.done ? 1 : 0, kTriggerStatusCells * i + 1);
    call.Set(1, t.position, kTriggerStatusCells * i + 2);
  }
  return vm::kOk;
}

int16_t GT_ClearTriggerStatus(Call& call) {
  ChangeUnit(call).ClearTrigger(NumberOf(call));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
