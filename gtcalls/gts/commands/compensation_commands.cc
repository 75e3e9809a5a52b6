// Compensation of backlash and of the pitch error of lead screws. Source: public header; public
// interface comments and a public note. Tested by tests/gtcalls/compensation_command_test.cc.
#include <memory>
#include <vector>

#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls {
namespace {

using motion::Backlash;
using motion::Compensation;
using motion::PitchTable;

const Compensation& CompensationOf(const Call& call) {
  return call.card.motion.state().compensations[NumberOf(call)];
}

}  // namespace

int16_t gts::GT_SetBacklash(Call& call) {
  call.card.motion.SetBacklash(
      NumberOf(call),
      {.value = call.integer(1), .change = call.value(2), .positive = call.integer(3) != 0});
  return vm::kOk;
}

int16_t gts::GT_GetBacklash(Call& call) {
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

int16_t gts::GT_SetLeadScrewComp(Call& call) {
  auto table = std::make_shared<PitchTable>();
  table->start = call.value(2);
  table->length = call.value(3);
  table->positive = Points(call, 4);
  table->negative = Points(call, 5);
  call.card.motion.SetPitchTable(NumberOf(call), std::move(table));
  return vm::kOk;
}

int16_t gts::GT_EnableLeadScrewComp(Call& call) {
  const bool on = call.integer(1) != 0;
  if (on && CompensationOf(call).pitch_table == nullptr) {
    return call.Refuse(
        vm::kRefused,
        MakeMessage("axis {0} has no pitch error table, call GT_SetLeadScrewComp",
                    "轴 {0} 没有螺距误差补偿表，请调用 GT_SetLeadScrewComp", call.integer(0)));
  }
  call.card.motion.EnablePitchCompensation(NumberOf(call), on);
  return vm::kOk;
}

/// The cross error is part of a compensation that this card does not have.
int16_t gts::GT_GetCompensate(Call& call) {
  const Compensation& compensation = CompensationOf(call);
  call.Set(1, compensation.pitch_error);
  call.Set(2, 0);
  call.Set(3, compensation.backlash_error);
  call.Set(4, AxisOf(call).encoder.position);
  call.Set(5, AxisOf(call).profile.position);
  return vm::kOk;
}

}  // namespace oncard::gtcalls
