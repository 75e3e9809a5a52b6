// The list of segments: what it takes when, runs, stops, and what stands between segments. Source:
// GE manual 6.3, table 2-4 and chapter 12. Tested by tests/gtcalls/ge/list_command_test.cc.
#include "gtcalls/ge/commands/list_support.h"
#include "gtcalls/ge/commands/path_support.h"

namespace oncard::gtcalls::ges {

// --- Opening and closing ---------------------------------------------------------------------

int16_t GT_StrtList(Call& call) {
  int16_t code = CheckListClosed(call, kListState);
  if (code == vm::kOk && ListRuns(call.card)) code = CheckNoPath(call, kListState);
  if (code != vm::kOk) return code;
  Path& path = PathOf(call);
  path.list = {};
  path.list.open = true;
  path.break_point = {};
  if (path.look_ahead) path.look_ahead->window->Clear();
  motion::CrdDriver driver = DriverOf(call.card);
  driver.Clear(kListFifo);
  driver.OpenList(kListFifo);
  return vm::kOk;
}

int16_t GT_AddList(Call& call) {
  const int16_t code = CheckListClosed(call, kListState);
  if (code != vm::kOk) return code;
  ListOf(call).open = true;
  DriverOf(call.card).OpenList(kListFifo);
  return vm::kOk;
}

int16_t GT_EndList(Call& call) {
  if (!ListOf(call).open) return vm::kOk;
  ListOf(call).open = false;
  DriverOf(call.card).CloseList(kListFifo);
  NoticePath(call.card);
  return vm::kOk;
}

// --- The start of a list ---------------------------------------------------------------------

int16_t CheckStart(Call& call, size_t dimension) {
  int16_t code = CheckAxisCount(call, dimension);
  if (code == vm::kOk) code = CheckAxesFree(call);
  if (code != vm::kOk) return code;
  const List& list = ListOf(call);
  if (list.open && list.dimension == 0) return vm::kOk;
  return RefusePath(call, vm::kRefused, kPathState,
                    {"the start of a list comes directly after GT_StrtList",
                     "缓冲区起点指令必须紧跟 GT_StrtList"});
}

void BeginList(Call& call, const ListStart& start) {
  List& list = ListOf(call);
  list.dimension = start.dimension;
  list.looks_ahead = start.looks_ahead;
  list.feed = start.feed;
  list.acceleration = start.acceleration;
  motion::Coordinates end = {};
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    const double position = call.card.motion.profile(i).now.position;
    end[i] = i < start.dimension ? start.point[i] : position - CrdOf(call.card).origin[i];
  }
  motion::PathSlot slot;
  slot.is_segment = true;
  slot.segment.end = end;
  slot.approach.axes = static_cast<uint8_t>((1u << start.dimension) - 1);
  slot.velocity = start.feed;
  slot.acceleration = start.acceleration;
  slot.ends_at_rest = true;
  slot.second_override = true;
  AppendSegment(call.card, slot, WordsOf(call.command));
}

namespace {

int16_t Begin(Call& call, size_t dimension) {
  int16_t code = CheckRate(call, dimension);
  if (code == vm::kOk) code = CheckRate(call, dimension + 1);
  if (code == vm::kOk) code = CheckStart(call, dimension);
  if (code != vm::kOk) return code;
  ListStart start = {.dimension = dimension,
                     .feed = call.value(dimension),
                     .acceleration = call.value(dimension + 1)};
  for (size_t i = 0; i < dimension; ++i) start.point[i] = call.value(i);
  BeginList(call, start);
  return vm::kOk;
}

}  // namespace

int16_t GT_MvXY(Call& call) { return Begin(call, 2); }
int16_t GT_MvXYZ(Call& call) { return Begin(call, 3); }
int16_t GT_MvXYZA(Call& call) { return Begin(call, 4); }

// --- Between segments ------------------------------------------------------------------------

namespace {

/// 0, or -1 while the list is closed.
int16_t CheckListOpen(Call& call) {
  if (ListOf(call).open) return vm::kOk;
  return RefusePath(call, kListClosed, kPathState,
                    {"the list is closed, call GT_StrtList or GT_AddList first",
                     "缓冲区未打开，请先调用 GT_StrtList 或 GT_AddList"});
}

int16_t RefuseMore(Call& call, int most) {
  return RefusePath(call, vm::kRefused, kPathState,
                    MakeMessage("between two segments there can be {0} at most",
                                "两段轨迹之间最多 {0} 条", most));
}

/// 0, or 1 if a command cannot be appended to the list.
int16_t CheckBetween(Call& call, bool looks_ahead) {
  const int16_t code = CheckListBegun(call, looks_ahead);
  return code == vm::kOk ? CheckRoom(call, WordsOf(call.command)) : code;
}

}  // namespace

int16_t CheckOutputs(Call& call, bool looks_ahead) {
  constexpr int kMost = 2;
  int16_t code = CheckListOpen(call);
  if (code == vm::kOk && ListOf(call).between.outputs == kMost) code = RefuseMore(call, kMost);
  return code == vm::kOk ? CheckBetween(call, looks_ahead) : code;
}

int16_t CheckBit(Call& call, bool looks_ahead) {
  const int16_t code = CheckListOpen(call);
  return code == vm::kOk ? CheckBetween(call, looks_ahead) : code;
}

int16_t CheckDelay(Call& call, bool looks_ahead) {
  constexpr int kMost = 1;
  if (ListOf(call).open && ListOf(call).between.delays == kMost) return RefuseMore(call, kMost);
  return CheckBetween(call, looks_ahead);
}

motion::BufferedCommand OutputsOf(double levels) {
  constexpr double kAll = 0xFFFF;
  return {.kind = motion::BufferedKind::kOutputs,
          .item = static_cast<int32_t>(motion::DoType::kGpo),
          .detail = 0,
          .values = {kAll, levels}};
}

motion::BufferedCommand DelayOf(double ms) {
  return {.kind = motion::BufferedKind::kDelay, .item = 0, .detail = 0, .values = {ms}};
}

void NoteBit(Call& call) {
  BetweenSegments& between = ListOf(call).between;
  const auto bit = static_cast<uint16_t>(1u << call.integer(0));
  between.bit_mask |= bit;
  between.bit_levels = static_cast<uint16_t>(call.integer(1) != 0 ? between.bit_levels | bit
                                                                  : between.bit_levels & ~bit);
}

int16_t GT_BufIO(Call& call) {
  const int16_t code = CheckOutputs(call, false);
  if (code != vm::kOk) return code;
  ++ListOf(call).between.outputs;
  ListOf(call).words.AddCommand(WordsOf(call.command));
  AppendCommand(call.card, OutputsOf(call.value(0)));
  return vm::kOk;
}

int16_t GT_BufIOBit(Call& call) {
  const int16_t code = CheckBit(call, false);
  if (code != vm::kOk) return code;
  ListOf(call).words.AddCommand(WordsOf(call.command));
  NoteBit(call);
  return vm::kOk;
}

int16_t GT_Delay(Call& call) {
  const int16_t code = CheckDelay(call, false);
  if (code != vm::kOk) return code;
  ++ListOf(call).between.delays;
  ListOf(call).words.AddCommand(WordsOf(call.command));
  AppendCommand(call.card, DelayOf(call.value(0)));
  return vm::kOk;
}

// --- Runs and stops --------------------------------------------------------------------------

namespace {

int16_t CheckStartable(Call& call) {
  const int16_t code = CheckNoPath(call, kListState);
  return code == vm::kOk ? CheckAxesFree(call) : code;
}

}  // namespace

int16_t GT_StrtMtn(Call& call) {
  const int16_t code = CheckStartable(call);
  if (code != vm::kOk) return code;
  if (!ListWaits(call.card) && !ListOf(call).open) return vm::kOk;
  if (ListOf(call).stopped) {
    call.Note(
        {"the list was stopped: it goes on from its break point, as with GT_RestoreMtn; a "
         "real card may go astray",
         "缓冲区运动曾被停止：与 GT_RestoreMtn 一样从断点继续；实际控制卡可能运动错误"});
  }
  StartPath(call.card, kListFifo);
  return vm::kOk;
}

int16_t GT_RestoreMtn(Call& call) {
  int16_t code = CheckStartable(call);
  if (code == vm::kOk && !ListWaits(call.card)) {
    code = RefusePath(call, vm::kRefused, kListState,
                      {"nothing of the list is left to be executed", "缓冲区中没有未执行的轨迹段"});
  }
  if (code == vm::kOk) StartPath(call.card, kListFifo);
  return code;
}

int16_t GT_StpMtn(Call& call) {
  StopPath(call.card, false);
  return vm::kOk;
}

int16_t GT_EStpMtn(Call& call) {
  StopPath(call.card, true);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ges
