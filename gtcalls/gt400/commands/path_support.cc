#include "gtcalls/gt400/commands/path_support.h"

#include <cmath>
#include <utility>

namespace oncard::gtcalls::gt400 {

int16_t RefuseFigure(Call& call, int16_t code, Message why) {
  call.cause = kIllegal;
  return call.Refuse(code, std::move(why));
}

int16_t CheckFinite(Call& call) {
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    const Parameter& parameter = call.command.parameters[i];
    if (parameter.passing != Passing::kValue || std::isfinite(call.value(i))) continue;
    return call.Refuse(vm::kBadParameter, MakeMessage("{0} is not a finite number",
                                                      "{0} 不是有限数值", parameter.name));
  }
  return vm::kOk;
}

int16_t CheckRate(Call& call, size_t argument) {
  const double rate = call.value(argument);
  if (rate > 0 && rate <= kRateMax) return vm::kOk;
  return RefuseFigure(
      call, kBadRate,
      MakeMessage("{0} is {1}; the range is (0, {2}]", "{0} 为 {1}；取值范围为 (0, {2}]",
                  call.command.parameters[argument].name, rate, kRateMax));
}

int16_t CheckPoint(Call& call, const motion::Coordinates& point) {
  for (const double coordinate : point) {
    if (std::fabs(coordinate) <= kFarthest) continue;
    return RefuseFigure(call, kBadEnd,
                        MakeMessage("a coordinate is {0}; its size is at most {1}",
                                    "坐标为 {0}；其绝对值不得超过 {1}", coordinate, kFarthest));
  }
  const motion::Crd& crd = CrdOf(call.card.view());
  for (size_t axis = 0; crd.map && axis < kAxisMax; ++axis) {
    const double position = crd.map->PositionOf(axis, point);
    // Written so that the check fails for a NaN.
    if (std::fabs(position) <= kFarthest) continue;
    return RefuseFigure(
        call, kBadEnd,
        MakeMessage("axis {0} would move to {1} pulses; the farthest is {2}",
                    "轴 {0} 将运动到 {1} 脉冲；最远为 {2}", axis + 1, position, kFarthest));
  }
  return vm::kOk;
}

int16_t CheckNoPath(Call& call) {
  if (!PathRuns(call.card.view())) return vm::kOk;
  return RefuseFor(call, kPathState,
                   {"a path is under way, wait until bit 0 of GT_GetCrdSts is 1",
                    "轨迹正在运动，请等待 GT_GetCrdSts 的第 0 位变为 1"});
}

int16_t CheckListBegun(Call& call) {
  if (ListOf(call).dimension > 0) return vm::kOk;
  return RefuseFor(call, kListOrder,
                   {"the list has no start point, call GT_MvXY, GT_MvXYZ or GT_MvXYZA first",
                    "缓冲区没有起点，请先调用 GT_MvXY、GT_MvXYZ 或 GT_MvXYZA"});
}

int16_t CheckRoom(Call& call) {
  ListWords& words = ListOf(call).words;
  words.Free(CrdOf(call.card.view()).fifos[kListFifo].done);
  if (words.Fit(WordsOf(call.command), kListWords)) return vm::kOk;
  return RefuseFor(call, kListFull,
                   {"the buffer is full: send the command again when a segment has ended",
                    "缓冲区已满：请在轨迹段执行完后重新发送该指令"});
}

}  // namespace oncard::gtcalls::gt400
