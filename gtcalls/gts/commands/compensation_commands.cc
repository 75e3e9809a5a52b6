// What is added to an axis' command: compensation of backlash and of the pitch error of lead
// screws, and input shaping. Source: public header; public interface comments and a public note.
// Tested by tests/gtcalls/compensation_command_test.cc and input_shaping_command_test.cc.
#include <memory>
#include <vector>

#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Backlash;
using motion::Compensation;
using motion::PitchTable;

const Compensation& CompensationOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::compensations>()[NumberOf(call)];
}

}  // namespace

int16_t GT_SetBacklash(Call& call) {
  AxisAt(call).SetBacklash(
      {.value = call.integer(1), .change = call.value(2), .positive = call.integer(3) != 0});
  return vm::kOk;
}

int16_t GT_GetBacklash(Call& call) {
  const Backlash& backlash = CompensationOf(call).backlash;
  call.Set(1, backlash.value);
  call.Set(2, backlash.change);
  call.Set(3, backlash.positive ? 1 : 0);
  return vm::kOk;
}

namespace {

std::vector<int32_t> Points(const Call& call, size_t index) {
  std::vector<int32_t> points;
  for (const double cell : call.cells(index)) points.push_back(static_cast<int32_t>(cell));
  return points;
}

}  // namespace

int16_t GT_SetLeadScrewComp(Call& call) {
  auto table = std::make_shared<PitchTable>();
  table->start = call.value(2);
  table->length = call.value(3);
  table->positive = Points(call, 4);
  table->negative = Points(call, 5);
  AxisAt(call).SetPitchTable(std::move(table));
  return vm::kOk;
}

int16_t GT_EnableLeadScrewComp(Call& call) {
  const bool on = call.integer(1) != 0;
  if (on && CompensationOf(call).pitch_table == nullptr) {
    return call.Refuse(
        vm::kRefused,
        MakeMessage("axis {0} has no pitch error table, call GT_SetLeadScrewComp",
                    "轴 {0} 没有螺距误差补偿表，请调用 GT_SetLeadScrewComp", call.integer(0)));
  }
  AxisAt(call).EnablePitchCompensation(on);
  return vm::kOk;
}

/// The cross error is part of a compensation that this card does not have.
int16_t GT_GetCompensate(Call& call) {
  const Compensation& compensation = CompensationOf(call);
  call.Set(1, compensation.pitch_error);
  call.Set(2, 0);
  call.Set(3, compensation.backlash_error);
  call.Set(4, AxisOf(call).encoder.position);
  call.Set(5, AxisOf(call).profile.position);
  return vm::kOk;
}

/// Assumption: a zero-vibration shaper (motion/input_shaper.h). `count` and `k` mean nothing when
/// it is switched off.
int16_t GT_SetAxisInputShaping(Call& call) {
  const size_t axis = NumberOf(call);
  const bool on = call.integer(1) != 0;
  if (on && (call.integer(2) < 1 || call.value(3) < kAboveZero)) {
    return call.Refuse(vm::kBadParameter, MakeMessage("count {0} and k {1}: both must be above 0",
                                                      "count 为 {0}，k 为 {1}：两者均须大于 0",
                                                      call.integer(2), call.value(3)));
  }
  const int16_t code = CheckAxisAtRest(call, axis);
  if (code != vm::kOk) return code;
  if (!call.card.motion.ShaperSettled(axis)) {
    return call.Refuse(
        vm::kRefused,
        MakeMessage("the input shaper of axis {0} has not yet output the whole motion",
                    "轴 {0} 的输入整形器尚未输出全部运动", call.integer(0)));
  }
  AxisAt(call).SetInputShaper(on ? static_cast<size_t>(call.integer(2)) : 0,
                              on ? call.value(3) : 0);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
