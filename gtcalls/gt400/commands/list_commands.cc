// The list of segments: what it takes when, its runs and stops. Source: GT manual 5.4. Tested by
// tests/gtcalls/gt400/list_command_test.cc.
#include "gtcalls/gt400/commands/path_support.h"

namespace oncard::gtcalls::gt400 {

// --- Opening and closing ---------------------------------------------------------------------

int16_t GT_StrtList(Call& call) {
  if (ListRuns(call.card.view())) return CheckNoPath(call);
  Path& path = PathOf(call);
  path.list = {};
  path.list.started = path.list.open = true;
  path.break_point = {};
  path.immediate = path.jumped = false;
  motion::CrdDriver driver = DriverOf(call.card);
  driver.ForgetHold();
  driver.Clear(kListFifo);
  driver.OpenList(kListFifo);
  return vm::kOk;
}

int16_t GT_AddList(Call& call) {
  PathList& list = ListOf(call);
  if (!list.started || list.open) {
    return RefuseFor(call, kPathState,
                     list.open ? Message{"the list is open already", "缓冲区已打开"}
                               : Message{"there is no list, call GT_StrtList first",
                                         "没有缓冲区运动，请先调用 GT_StrtList"});
  }
  list.open = true;
  DriverOf(call.card).OpenList(kListFifo);
  return vm::kOk;
}

int16_t GT_EndList(Call& call) {
  CloseList(call.card);
  return vm::kOk;
}

// --- The start point -------------------------------------------------------------------------

namespace {

/// The list begins with a line from wherever the path will be.
int16_t BeginList(Call& call, size_t dimension) {
  int16_t code = CheckFinite(call);
  if (code != vm::kOk) return code;
  motion::Coordinates point = call.card.motion.CrdPosition(0);
  for (size_t i = 0; i < dimension; ++i) point[i] = call.value(i);
  code = CheckPoint(call, point);
  if (code == vm::kOk) code = CheckRate(call, dimension);
  if (code == vm::kOk) code = CheckRate(call, dimension + 1);
  if (code != vm::kOk) return code;
  PathList& list = ListOf(call);
  if (!list.open || list.dimension != 0) {
    return RefuseFor(call, kListOrder,
                     {"the start point of a list comes directly after GT_StrtList",
                      "缓冲区起点指令必须紧跟 GT_StrtList"});
  }
  Path& path = PathOf(call);
  path.velocity = list.velocity = call.value(dimension);
  path.acceleration = list.acceleration = call.value(dimension + 1);
  list.dimension = dimension;
  list.words.AddSegment(WordsOf(call.command));
  motion::PathSlot slot;
  slot.is_segment = true;
  slot.segment.end = point;
  slot.approach.axes = static_cast<uint8_t>(motion::kAllCoordinates);
  slot.velocity = list.velocity;
  slot.acceleration = list.acceleration;
  slot.ends_at_rest = true;
  DriverOf(call.card).Append(kListFifo, slot);
  return vm::kOk;
}

}  // namespace

int16_t GT_MvXY(Call& call) { return BeginList(call, 2); }
int16_t GT_MvXYZ(Call& call) { return BeginList(call, 3); }
int16_t GT_MvXYZA(Call& call) { return BeginList(call, 4); }

// --- Runs and stops --------------------------------------------------------------------------

int16_t GT_StrtMtn(Call& call) {
  const int16_t code = CheckNoPath(call);
  if (code != vm::kOk) return code;
  if (CrdOf(call.card.view()).fifos[kListFifo].idle()) {
    return RefuseFor(call, kPathState,
                     {"nothing of the list is left to be executed", "缓冲区中没有未执行的轨迹段"});
  }
  StartList(call.card);
  return vm::kOk;
}

int16_t GT_StpMtn(Call& call) {
  StopPath(call.card, false);
  return vm::kOk;
}

int16_t GT_EStpMtn(Call& call) {
  StopPath(call.card, true);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
