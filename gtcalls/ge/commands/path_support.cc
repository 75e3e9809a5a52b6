#include "gtcalls/ge/commands/path_support.h"

#include <utility>

namespace oncard::gtcalls::ges {

using motion::Coordinates;
using motion::Crd;
using motion::PathSlot;

// --- The coordinate system -------------------------------------------------------------------

const Crd& CrdOf(const Card& card) {
  return card.motion.part<&motion::MotionState::crds>().front();
}

motion::CrdDriver DriverOf(Card& card) {
  motion::CrdDriver driver = card.motion.CrdAt(0);
  if (CrdOf(card).exists()) return driver;
  motion::CrdParameters parameters;
  parameters.dimension = static_cast<int16_t>(card.motion.axis_count());
  parameters.sets_origin = true;
  for (size_t i = 0; i < card.motion.axis_count(); ++i) {
    parameters.coordinates[i] = static_cast<int16_t>(i + 1);
  }
  driver.SetUp(parameters);
  driver.SetJoints(kListFifo, motion::JointRule::kFeeds);
  return driver;
}

bool PathRuns(const Card& card) { return CrdOf(card).run.running; }

bool ListRuns(const Card& card) { return PathRuns(card) && CrdOf(card).run.fifo == kListFifo; }

bool ListWaits(const Card& card) { return !CrdOf(card).fifos[kListFifo].idle(); }

// --- Checks ----------------------------------------------------------------------------------

int16_t RefusePath(Call& call, int16_t code, CommandCause cause, Message why) {
  call.cause = cause;
  return call.Refuse(code, std::move(why));
}

int16_t CheckNoPath(Call& call, CommandCause cause) {
  if (!PathRuns(call.card)) return vm::kOk;
  return RefusePath(call, vm::kRefused, cause,
                    {"a path is under way, wait until bit 0 of GT_GetCrdSts is 1",
                     "轨迹正在运动，请等待 GT_GetCrdSts 的第 0 位变为 1"});
}

int16_t CheckListClosed(Call& call, CommandCause cause) {
  if (!ListOf(call).open) return vm::kOk;
  return RefusePath(
      call, vm::kRefused, cause,
      {"the list is open, call GT_EndList first", "缓冲区已打开，请先调用 GT_EndList"});
}

int16_t CheckAxesFree(Call& call) {
  for (size_t axis = 0; axis < call.card.motion.axis_count(); ++axis) {
    if ((call.card.motion.Conditions(axis) & motion::kAlarmBit) == 0) continue;
    return RefuseAxis(call, axis, kIllegal,
                      MakeMessage("axis {0} has an alarm: remove its cause, and call GT_ClrSts",
                                  "轴 {0} 报警：请排除原因并调用 GT_ClrSts", axis + 1));
  }
  if (PathOf(call).wheel.axis == 0) return vm::kOk;
  return RefusePath(
      call, vm::kRefused, kPathState,
      MakeMessage("axis {0} follows the hand wheel, call GT_ExitHWheel first",
                  "轴 {0} 正跟随手轮，请先调用 GT_ExitHWheel", PathOf(call).wheel.axis));
}

int16_t CheckAxisCount(Call& call, size_t needed) {
  if (call.card.motion.axis_count() >= needed) return vm::kOk;
  return RefusePath(
      call, vm::kRefused, kNotOnCard,
      MakeMessage("the command needs {0} axes; this card has {1}",
                  "指令需要 {0} 个轴；本控制卡有 {1} 个", needed, call.card.motion.axis_count()));
}

int16_t CheckListBegun(Call& call, bool looks_ahead) {
  const List& list = ListOf(call);
  if (!list.open) {
    return RefusePath(call, vm::kRefused, kPathState,
                      {"the list is closed, call GT_StrtList or GT_AddList first",
                       "缓冲区未打开，请先调用 GT_StrtList 或 GT_AddList"});
  }
  if (list.dimension == 0) {
    return RefusePath(call, vm::kRefused, kPathState,
                      {"the list has no start, call GT_MvXY, GT_MvXYZ or GT_MvXYZA first",
                       "缓冲区没有起点，请先调用 GT_MvXY、GT_MvXYZ 或 GT_MvXYZA"});
  }
  if (list.looks_ahead == looks_ahead) return vm::kOk;
  return RefusePath(call, vm::kRefused, kPathState,
                    {"commands with Ex and without cannot be in the same list",
                     "同一缓冲区中不能混用带 Ex 和不带 Ex 的指令"});
}

int16_t CheckRoom(Call& call, uint32_t words) {
  ListWords& used = ListOf(call).words;
  used.Free(CrdOf(call.card).fifos[kListFifo].done);
  return used.Fit(words, kListWords) ? vm::kOk : RefuseFull(call);
}

int16_t RefuseFull(Call& call, int16_t code) {
  return RefusePath(call, code, kBufferFull,
                    {"the buffer is full: send the command again when a segment has ended",
                     "缓冲区已满：请在轨迹段执行完后重新发送该指令"});
}

int16_t CheckRate(Call& call, size_t argument, bool may_be_zero) {
  const double rate = call.value(argument);
  if ((rate > 0 || (may_be_zero && rate == 0)) && rate <= kPathRateMax) return vm::kOk;
  return RefusePath(
      call, kBadRate, kPathState,
      MakeMessage("parameter {0} is {1}; the range is {2}0, {3}]",
                  "参数 {0} 为 {1}；取值范围为 {2}0, {3}]", call.command.parameters[argument].name,
                  rate, may_be_zero ? "[" : "(", kPathRateMax));
}

// --- The list --------------------------------------------------------------------------------

PathSlot CommandSlot(const motion::BufferedCommand& command) {
  PathSlot slot;
  slot.command = command;
  return slot;
}

motion::BufferedCommand BitsOf(const BetweenSegments& between) {
  return {
      .kind = motion::BufferedKind::kOutputs,
      .item = static_cast<int32_t>(motion::DoType::kGpo),
      .detail = 0,
      .values = {static_cast<double>(between.bit_mask), static_cast<double>(between.bit_levels)}};
}

void AppendCommand(Card& card, const motion::BufferedCommand& command) {
  DriverOf(card).Append(kListFifo, CommandSlot(command));
}

void AppendSegment(Card& card, PathSlot slot, uint32_t words) {
  List& list = PathIn(card).list;
  list.words.AddSegment(words);
  if (list.between.bit_mask != 0) AppendCommand(card, BitsOf(list.between));
  list.between = {};
  if (!slot.approach.in_use()) {
    list.last_number = list.last_number % kSegmentNumberMax + 1;
    slot.given_number = list.last_number;
  }
  DriverOf(card).Append(kListFifo, slot);
}

// --- Runs ------------------------------------------------------------------------------------

namespace {

/// True if a run would begin towards a limit that an axis is at.
bool BeginsIntoLimit(const Card& card) {
  const Coordinates direction = CrdOf(card).FirstDirection();
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    const uint32_t conditions = card.motion.Conditions(axis);
    if (direction[axis] > 0 && (conditions & motion::kPositiveLimitBit) != 0) return true;
    if (direction[axis] < 0 && (conditions & motion::kNegativeLimitBit) != 0) return true;
  }
  return false;
}

/// The line back to the break point. Assumption: with the override of G0.
PathSlot LineBack(const List& list) {
  PathSlot back;
  back.velocity = list.feed;
  back.acceleration = list.acceleration;
  back.second_override = true;
  return back;
}

/// Assumption: with GT_SetEStpAcc, GT_SetStpAcc is the deceleration of GT_StpMtn.
void SetDecelerations(const Path& path, double acceleration, motion::CrdDriver driver) {
  const bool apart = path.emergency_acceleration > 0;
  driver.SetStopDecelerations(apart ? path.stop_acceleration : acceleration,
                              apart ? path.emergency_acceleration : path.stop_acceleration);
}

}  // namespace

void StartPath(Card& card, size_t fifo) {
  Path& path = PathIn(card);
  motion::CrdDriver driver = DriverOf(card);
  const bool is_list = fifo == kListFifo;
  driver.SetStartVelocity(path.start_velocity);
  driver.SetPathVelocityMax(path.max_velocity);
  SetDecelerations(path, is_list ? path.list.acceleration : path.acceleration, driver);
  path.runs = true;
  path.commanded = false;
  path.held = false;
  if (is_list) {
    path.list.stopped = false;
    // Axes beyond its dimension stay, wherever they were when its segments were appended.
    driver.KeepCoordinates(kListFifo, path.list.dimension);
    driver.Resume(fifo, LineBack(path.list));
  } else {
    driver.Start(fifo, false);
  }
  if (BeginsIntoLimit(card)) driver.Stop(true);
  NoticePath(card);
}

void StopPath(Card& card, bool emergency) {
  Path& path = PathIn(card);
  if (path.list.open) {
    path.list.open = false;
    DriverOf(card).CloseList(kListFifo);
  }
  if (!PathRuns(card)) return NoticePath(card);
  path.commanded = true;
  DriverOf(card).Stop(emergency);
  NoticePath(card);
}

void NoticePath(Card& card) {
  Path& path = PathIn(card);
  if (!path.runs) return;
  const motion::MotionCore& core = card.motion;
  const Crd& crd = CrdOf(card);
  const bool ended = !crd.run.running;
  const bool is_list = crd.run.fifo == kListFifo;
  // The run of an open list has no end of its own.
  const bool unfinished = !crd.active().idle() || (is_list && path.list.open);
  path.runs = !ended;
  // An immediate motion has no break point.
  if (ended && !is_list) DriverOf(card).Clear(kImmediateFifo);
  if (!crd.run.stopping && !(ended && unfinished)) return;
  if (path.list.open) {
    path.list.open = false;
    DriverOf(card).CloseList(kListFifo);
  }
  path.held = path.held || !path.commanded;
  if (!ended || !is_list || !unfinished) return;
  path.list.stopped = true;
  for (size_t i = 0; i < core.axis_count(); ++i) {
    path.break_point[i] =
        crd.origin[i] +
        (crd.fifos[kListFifo].executing ? crd.fifos[kListFifo].Breakpoint()[i] : crd.position[i]);
  }
}

}  // namespace oncard::gtcalls::ges
