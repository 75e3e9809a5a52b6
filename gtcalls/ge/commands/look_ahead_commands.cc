// The look-ahead of path cards: lists in millimetres whose corners limit the velocity (Ex), and the
// calculation of velocities only. Source: GE manual 6.4, 6.5 and chapter 12; public header. Tested
// by tests/gtcalls/ge/look_ahead_command_test.cc.
#include <algorithm>
#include <string_view>
#include <utility>

#include "gtcalls/ge/commands/list_support.h"
#include "gtcalls/ge/commands/path_support.h"
#include "gtcalls/shared/segment_request.h"

namespace oncard::gtcalls::ges {
namespace {

using motion::PathPlanner;
using motion::PathSlot;

constexpr double kMsPerSecond = 1000;
/// GE manual table 6-11: with less the card takes as many.
constexpr int kWindowMin = 200;

/// GT_M30: "not yet".
constexpr int16_t kCallAgain = 9;

/// TLookAheadMsg::error.
enum MessageError : int16_t { kTaken = 0, kSamePoint = 1, kNoRoom = 3, kOtherRefusal = 8 };

LookAhead& LookAheadOf(const Call& call) { return *PathOf(call).look_ahead; }

/// The argument that a parameter's name refers to.
double Named(const Call& call, std::string_view name) {
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    if (call.command.parameters[i].name == name) return call.value(i);
  }
  return 0;
}

/// Writes the message of a command, which is its last argument.
void Report(const Call& call, double number, MessageError error) {
  const size_t message = call.arguments.size() - 1;
  call.Set(message, number, 0);
  call.Set(message, 0, 1);
  call.Set(message, error, 2);
}

int16_t RefuseWith(Call& call, MessageError error, Message why) {
  Report(call, 0, error);
  return RefusePath(call, vm::kRefused, kPathState, std::move(why));
}

}  // namespace

// --- Set-up ----------------------------------------------------------------------------------

int16_t GT_InitLookAheadEx(Call& call) {
  const double scale = call.value(4);
  const double per_ms2 = scale / (kMsPerSecond * kMsPerSecond);
  const CornerFigures figures = {.time = call.value(0) * kMsPerSecond,
                                 .acceleration_max = call.value(1) * per_ms2,
                                 .acceleration = call.value(2) * per_ms2};
  const auto capacity = static_cast<size_t>(std::max(call.integer(3), kWindowMin));
  PathOf(call).look_ahead.Emplace({.scale = scale,
                                   .acceleration = figures.acceleration,
                                   .window = MakeCornerPlanner(figures, capacity)});
  return vm::kOk;
}

int16_t GT_InitLookAheadExx(Call& call) { return GT_InitLookAheadEx(call); }

namespace {

int16_t CheckSetUp(Call& call) {
  if (PathOf(call).look_ahead) return vm::kOk;
  return RefusePath(call, vm::kRefused, kPathState,
                    {"the look-ahead is not set up, call GT_InitLookAheadEx first",
                     "未初始化速度预处理，请先调用 GT_InitLookAheadEx"});
}

int16_t BeginWithLookAhead(Call& call, size_t dimension) {
  int16_t code = CheckRate(call, dimension);
  if (code == vm::kOk) code = CheckSetUp(call);
  if (code == vm::kOk) code = CheckStart(call, dimension);
  if (code != vm::kOk) return code;
  LookAhead& look_ahead = LookAheadOf(call);
  ListStart start = {.dimension = dimension,
                     .looks_ahead = true,
                     .feed = call.value(dimension) * look_ahead.scale / kMsPerSecond,
                     .acceleration = look_ahead.acceleration};
  for (size_t i = 0; i < dimension; ++i) start.point[i] = call.value(i) * look_ahead.scale;
  BeginList(call, start);
  look_ahead.tail = CrdOf(call.card).fifos[kListFifo].tail;
  look_ahead.handed_feed = start.feed;
  return vm::kOk;
}

}  // namespace

int16_t GT_MvXYEx(Call& call) { return BeginWithLookAhead(call, 2); }
int16_t GT_MvXYZEx(Call& call) { return BeginWithLookAhead(call, 3); }

// --- From the window to the list -------------------------------------------------------------

namespace {

/// The words of a slot in the list (assumption): those of the segment with as many coordinates as
/// the list has, its end velocity, and its feed if that changes.
uint32_t WordsOfSlot(const PathSlot& slot, size_t dimension, double feed_before) {
  constexpr uint32_t kOneValue = 3;
  if (!slot.is_segment) return kOneValue;
  const auto segment = static_cast<uint32_t>(2 + 2 * dimension);
  return segment + kOneValue + (slot.velocity == feed_before ? 0 : kOneValue);
}

/// Hands the oldest slot of the window over; false if the buffer has no room.
bool HandOver(Call& call, bool ended) {
  LookAhead& look_ahead = LookAheadOf(call);
  List& list = ListOf(call);
  const PathSlot& oldest = look_ahead.window->ring.front();
  const uint32_t words = WordsOfSlot(oldest, list.dimension, look_ahead.handed_feed);
  list.words.Free(CrdOf(call.card).fifos[kListFifo].done);
  if (!list.words.Fit(words, kListWords)) return false;
  const PathSlot slot = look_ahead.window->Take(ended);
  if (slot.is_segment) {
    look_ahead.handed_feed = slot.velocity;
    AppendSegment(call.card, slot, words);
  } else {
    list.words.AddCommand(words);
    AppendCommand(call.card, slot.command);
  }
  return true;
}

/// Puts a slot into the window; false if the oldest one does not leave it.
bool Enter(Call& call, const PathSlot& slot) {
  PathPlanner& window = *LookAheadOf(call).window;
  for (size_t leaving = window.LeavingFor(slot); leaving > 0; --leaving) {
    if (!HandOver(call, false)) return false;
  }
  window.Push(slot);
  return true;
}

/// 0, or the code of a command that cannot enter the window.
int16_t CheckWindow(Call& call, size_t dimension) {
  int16_t code = CheckAxesFree(call);
  if (code == vm::kOk) code = CheckListBegun(call, true);
  if (code == vm::kOk) code = CheckSetUp(call);
  if (code != vm::kOk || dimension <= ListOf(call).dimension) return code;
  return RefusePath(call, vm::kRefused, kPathState,
                    MakeMessage("the list has begun with {0} coordinates",
                                "缓冲区起点只有 {0} 个坐标", ListOf(call).dimension));
}

/// What waits for the next segment enters the window before it.
bool EnterBits(Call& call) {
  BetweenSegments& between = ListOf(call).between;
  if (between.bit_mask == 0) return true;
  if (!Enter(call, CommandSlot(BitsOf(between)))) return false;
  between.bit_mask = 0;
  between.bit_levels = 0;
  return true;
}

int16_t EnterSegment(Call& call) {
  const double scale = PathOf(call).look_ahead ? LookAheadOf(call).scale : 1;
  const SegmentRequest request = ReadSegment(call, scale);
  const int16_t code = CheckWindow(call, request.dimension);
  if (code != vm::kOk) {
    Report(call, 0, kOtherRefusal);
    return code;
  }
  LookAhead& look_ahead = LookAheadOf(call);
  const double feed = Named(call, "F") * scale / kMsPerSecond;
  // Written so that the check fails for a NaN.
  if (!(feed > 0 && feed <= kPathRateMax)) {
    return RefuseWith(call, kOtherRefusal, {"F must be greater than 0", "F 应大于 0"});
  }
  if (request.direction != 1 && request.direction != -1) {
    return RefuseWith(call, kOtherRefusal, {"direction must be 1 or -1", "direction 应为 1 或 -1"});
  }
  const SegmentResult result = MakeSegment(look_ahead.tail, request, kChordTolerance);
  if (!result.segment && !request.is_arc()) {
    return RefuseWith(call, kSamePoint,
                      {"the point is that before: it is left out", "该点与前一点相同，已忽略"});
  }
  if (!result.segment) {
    return RefuseWith(call, kOtherRefusal,
                      {"there is no such arc: radius, chord and angle must fit",
                       "圆弧不存在：半径、弦长和角度应匹配"});
  }
  PathSlot slot;
  slot.is_segment = true;
  slot.segment = *result.segment;
  slot.velocity = feed;
  slot.acceleration = look_ahead.acceleration;
  slot.ends_at_rest = Named(call, "dccFlag") != 0;
  slot.second_override = IsG0(call.command);
  if (!EnterBits(call) || !Enter(call, slot)) {
    Report(call, 0, kNoRoom);
    return RefuseFull(call);
  }
  ListOf(call).between = {};
  look_ahead.tail = slot.segment.end;
  Report(call, Named(call, "CodeNum"), kTaken);
  return vm::kOk;
}

}  // namespace

int16_t GT_LnXYEx(Call& call) { return EnterSegment(call); }
int16_t GT_LnXYZEx(Call& call) { return EnterSegment(call); }
int16_t GT_LnXYG0Ex(Call& call) { return EnterSegment(call); }
int16_t GT_LnXYZG0Ex(Call& call) { return EnterSegment(call); }
int16_t GT_ArcXYEx(Call& call) { return EnterSegment(call); }
int16_t GT_ArcXYPEx(Call& call) { return EnterSegment(call); }
int16_t GT_ArcYZEx(Call& call) { return EnterSegment(call); }
int16_t GT_ArcYZPEx(Call& call) { return EnterSegment(call); }
int16_t GT_ArcZXEx(Call& call) { return EnterSegment(call); }
int16_t GT_ArcZXPEx(Call& call) { return EnterSegment(call); }

namespace {

int16_t EnterCommand(Call& call, int BetweenSegments::*count,
                     const motion::BufferedCommand& command) {
  if (!Enter(call, CommandSlot(command))) return RefuseFull(call);
  ++(ListOf(call).between.*count);
  return vm::kOk;
}

}  // namespace

int16_t GT_BufIOEx(Call& call) {
  const int16_t code = CheckOutputs(call, true);
  if (code != vm::kOk) return code;
  return EnterCommand(call, &BetweenSegments::outputs, OutputsOf(call.value(0)));
}

int16_t GT_BufIOBitEx(Call& call) {
  const int16_t code = CheckBit(call, true);
  if (code == vm::kOk) NoteBit(call);
  return code;
}

int16_t GT_DelayEx(Call& call) {
  const int16_t code = CheckDelay(call, true);
  if (code != vm::kOk) return code;
  return EnterCommand(call, &BetweenSegments::delays, DelayOf(call.value(0)));
}

int16_t GT_M30(Call& call) {
  int16_t code = CheckListBegun(call, true);
  if (code == vm::kOk) code = CheckSetUp(call);
  if (code != vm::kOk) {
    Report(call, 0, kOtherRefusal);
    return code;
  }
  PathPlanner& window = *LookAheadOf(call).window;
  window.EndPath();
  while (!window.ring.empty()) {
    if (HandOver(call, true)) continue;
    Report(call, 0, kNoRoom);
    return RefuseFull(call, kCallAgain);
  }
  Report(call, 0, kTaken);
  return vm::kOk;
}

// --- Velocities only -------------------------------------------------------------------------

int16_t GT_InitLookAhead(Call& call) {
  const CornerFigures figures = {
      .time = call.value(0), .acceleration_max = call.value(1), .acceleration = call.value(2)};
  PathOf(call).velocity_table.Emplace(
      {.acceleration = figures.acceleration,
       .velocity = call.value(3),
       .window = MakeCornerPlanner(figures, static_cast<size_t>(call.integer(4)))});
  return vm::kOk;
}

namespace {

constexpr int kRapid = 0;  ///< G00
constexpr int kClockwise = 2;
constexpr int kXyGroup = 17;
constexpr int kZxGroup = 18;

int16_t CheckTable(Call& call) {
  if (PathOf(call).velocity_table) return vm::kOk;
  return RefusePath(call, vm::kRefused, kPathState,
                    {"the calculation is not set up, call GT_InitLookAhead first",
                     "未初始化速度计算，请先调用 GT_InitLookAhead"});
}

motion::ArcPlane PlaneOfGroup(int group) {
  if (group == kXyGroup) return motion::kXyPlane;
  return group == kZxGroup ? motion::kZxPlane : motion::kYzPlane;
}

}  // namespace

/// Assumption: cx and cy are the centre in the two axes of the plane; segments are added in their
/// order, so that their places in the buffer follow from it.
int16_t GT_AddLookData(Call& call) {
  int16_t code = CheckTable(call);
  if (code != vm::kOk) return code;
  VelocityTable& table = *PathOf(call).velocity_table;
  const motion::Coordinates end = {Named(call, "x"), Named(call, "y"), Named(call, "z")};
  const int kind = call.integer(0);
  std::optional<motion::Segment> segment;
  if (kind < kClockwise) {
    segment = motion::MakeLine(table.tail, end);
    if (!segment) {
      return RefusePath(call, vm::kRefused, kPathState,
                        {"the point is that before: it is left out", "该点与前一点相同，已忽略"});
    }
  } else {
    const motion::ArcPlane plane = PlaneOfGroup(call.integer(1));
    segment = motion::MakeArcAroundCentre(
        table.tail, end, plane, Named(call, "cx") - table.tail[plane.first],
        Named(call, "cy") - table.tail[plane.second], kind != kClockwise);
    if (!segment) {
      return call.Refuse(vm::kBadParameter,
                         {"there is no such arc around cx and cy", "以 cx、cy 为圆心的圆弧不存在"});
    }
  }
  if (table.window->Held() == table.window->capacity) {
    return RefusePath(
        call, vm::kRefused, kBufferFull,
        {"the window is full, call GT_CalVel first", "预处理缓冲区已满，请先调用 GT_CalVel"});
  }
  PathSlot slot;
  slot.is_segment = true;
  slot.segment = *segment;
  slot.velocity = std::min(Named(call, "vel"), table.velocity);
  slot.acceleration = table.acceleration;
  slot.ends_at_rest = kind == kRapid || Named(call, "flag") != 0;
  slot.given_number = static_cast<int32_t>(Named(call, "n"));
  table.window->Push(slot);
  table.tail = end;
  return vm::kOk;
}

namespace {

/// Takes the oldest segment of the window; 1 if it is the last.
int16_t TakeVelocity(Call& call) {
  const int16_t code = CheckTable(call);
  if (code != vm::kOk) return code;
  PathPlanner& window = *PathOf(call).velocity_table->window;
  if (window.ring.empty()) {
    return RefusePath(call, vm::kRefused, kPathState,
                      {"the window is empty, call GT_AddLookData first",
                       "预处理缓冲区为空，请先调用 GT_AddLookData"});
  }
  const PathSlot slot = window.Take(true);
  call.Set(0, slot.ends_at_rest ? 0 : slot.end_velocity);
  call.Set(1, slot.given_number);
  if (call.arguments.size() > 2) call.Set(2, slot.velocity);
  if (!window.ring.empty()) return vm::kOk;
  return call.Refuse(vm::kRefused, {"this was the last segment", "这是最后一段"});
}

}  // namespace

int16_t GT_CalVel(Call& call) { return TakeVelocity(call); }
int16_t GT_CalVelEx(Call& call) { return TakeVelocity(call); }

}  // namespace oncard::gtcalls::ges
