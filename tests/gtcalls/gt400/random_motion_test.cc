// Random programs with breakpoints, limits and gears, beside a model of the card that is written
// here from the manual: planned positions and status words agree in every tick, codes in every
// call. ONCARD_RANDOM_TICKS makes the programs longer.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "gtcalls/gt400/status_word.h"
#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;

enum class Mode { kT, kV, kGear };
enum class Break { kNone, kPositive, kNegative, kMotion };

// Bits of the status word.
constexpr unsigned kComplete = 1u << 0;
constexpr unsigned kBreak = 1u << 2;
constexpr unsigned kLimits[] = {1u << 5, 1u << 6};  // positive, negative
constexpr unsigned kRefused = 1u << 7;
constexpr unsigned kMoving = 1u << 10;

struct Registers {
  int position = 0;
  double velocity = 0;
  double acceleration = 0;
  double ratio = 0;
  int breakpoint = 0;
};

/// A time of constant acceleration.
struct Piece {
  double length;
  double acceleration;
};

struct Plan {
  double begin = 0;
  double position = 0;
  double velocity = 0;
  std::vector<Piece> pieces;
  bool ends = true;  ///< otherwise the last velocity lasts
};

/// Accelerates from `velocity` to `to`.
Piece Ramp(double velocity, double to, double acceleration) {
  return {std::fabs(to - velocity) / acceleration, to < velocity ? -acceleration : acceleration};
}

/// The way to a target in mode T: it turns after a stop if it cannot stop before.
std::vector<Piece> Way(double position, double velocity, double target, double most,
                       double acceleration) {
  std::vector<Piece> pieces;
  const double stop = velocity * std::fabs(velocity) / (2 * acceleration);
  const double side =
      position + stop <= target ? 1 : -1;  // of the target, from where it would stop
  if (velocity * side < 0) {
    pieces.push_back(Ramp(velocity, 0, acceleration));
    position += stop;
    velocity = 0;
  }
  const double speed = velocity * side;
  const double way = (target - position) * side;
  if (speed > most) {
    pieces.push_back(Ramp(velocity, most * side, acceleration));
    const double braking = (speed * speed - most * most) / (2 * acceleration);
    pieces.push_back({(way - braking - most * most / (2 * acceleration)) / most, 0});
    pieces.push_back(Ramp(most * side, 0, acceleration));
    return pieces;
  }
  const double peak = std::min(most, std::sqrt(acceleration * way + speed * speed / 2));
  pieces.push_back(Ramp(velocity, peak * side, acceleration));
  const double rest =
      way - (peak * peak - speed * speed) / (2 * acceleration) - peak * peak / (2 * acceleration);
  pieces.push_back({std::max(rest, 0.0) / peak, 0});
  pieces.push_back(Ramp(peak * side, 0, acceleration));
  return pieces;
}

struct ModelAxis {
  Registers waiting;
  Registers valid;
  bool motion_written = false;
  bool ratio_written = false;

  Mode mode = Mode::kT;
  double position = 0;
  double velocity = 0;
  bool moves = false;  ///< it has a plan, or follows a master
  Plan plan;
  int master = 0;
  double ratio = 0;
  double last = 0;  ///< the position of the master
  bool held = false;
  double sampled = 0;  ///< the velocity of the tick, before it was stopped

  unsigned events = 0;
  unsigned news = 0;
  bool moved = false;
  bool watched = true;
  std::array<bool, 2> pins{};
  std::array<bool, 2> levels{};     ///< of the last tick
  std::array<bool, 2> noticed{};    ///< switches that are no new event
  std::array<bool, 2> forbidden{};  ///< positive, negative direction
  Break breakpoint = Break::kNone;
  bool updates = false;

  bool Follows() const { return mode == Mode::kGear && moves; }
  bool Forbids(double direction) const {
    return (direction > 0 && forbidden[0]) || (direction < 0 && forbidden[1]);
  }
  void Tell(unsigned bits) {
    events |= bits;
    news |= bits;
  }
  void TellLimit(double direction) { Tell(kLimits[direction > 0 ? 0 : 1]); }
  void Rest() {
    moves = held = false;
    velocity = 0;
  }
  void NoticeSwitches() {
    for (const size_t i : {0u, 1u}) {
      const bool active = watched && levels[i];
      if (active && !noticed[i]) Tell(kLimits[i]);
      noticed[i] = active;
    }
  }
  void Forbid() {
    for (const size_t i : {0u, 1u}) {
      forbidden[i] = watched && (levels[i] || (events & kLimits[i]) != 0);
    }
  }
  /// Where the plan leads from here.
  double Direction() const {
    if (mode == Mode::kGear) return 0;
    return mode == Mode::kV ? valid.velocity : valid.position - position;
  }
  unsigned Status() const { return events | (moves && !held ? kMoving : 0); }
};

class Model {
 public:
  ModelAxis& at(int axis) { return axes_[static_cast<size_t>(axis)]; }

  // --- Commands: their codes -------------------------------------------------------------------

  int Choose(int axis, Mode mode, int master = 0) {
    ModelAxis& a = at(axis);
    if (a.mode != Mode::kGear && a.moves) return Refuse(axis);
    if (a.mode == Mode::kGear) a.Rest();
    a.mode = mode;
    a.master = master;
    return Done();
  }
  /// With the tick that it waits for.
  int Update(int axis) {
    ModelAxis& a = at(axis);
    if (RefusesUpdate(a)) return Refuse(axis);
    const Registers registers = a.waiting;
    const bool motion = std::exchange(a.motion_written, false);
    const bool ratio = std::exchange(a.ratio_written, false);
    Tick();
    Apply(axis, registers, motion, ratio);
    return Done();
  }
  int Stop(int axis) {
    ModelAxis& a = at(axis);
    a.Rest();
    a.waiting.velocity = a.valid.velocity = 0;
    a.Tell(kComplete);
    return Done();
  }
  int Set(int axis, Break breakpoint) {
    at(axis).breakpoint = breakpoint;
    at(axis).news = 0;
    return Done();
  }
  int Clear(int axis) {
    at(axis).events = 0;
    return Done();
  }
  int Watch(int axis, bool on) {
    at(axis).watched = on;
    return Done();
  }
  int Done() {
    for (ModelAxis& a : axes_) {
      a.NoticeSwitches();
      a.Forbid();
      a.moved = a.moves;
    }
    return 0;
  }

  // --- A tick ----------------------------------------------------------------------------------

  void Tick() {
    ++now_;
    for (ModelAxis& a : axes_) {
      if (a.moves && !a.Follows()) FollowPlan(a);
    }
    for (ModelAxis& a : axes_) {
      if (a.Follows()) FollowMaster(a);
    }
    for (ModelAxis& a : axes_) {
      a.levels = a.pins;
      for (const size_t i : {0u, 1u}) a.forbidden[i] |= a.watched && a.levels[i];
      a.sampled = a.velocity;
      if (!a.moves || !a.Forbids(a.velocity)) continue;
      if (a.Follows()) {
        a.held = true;
        a.velocity = 0;
      } else {
        a.Rest();
      }
    }
    for (ModelAxis& a : axes_) a.NoticeSwitches();
    StopMasters();
    for (ModelAxis& a : axes_) {
      if (!a.moved || a.moves) continue;
      const double direction = a.sampled != 0 ? a.sampled : a.Direction();
      if (a.Forbids(direction)) a.TellLimit(direction);
      if (a.mode != Mode::kGear) a.Tell(kComplete);
    }
    for (ModelAxis& a : axes_) {
      a.moved = a.moves;
      a.Forbid();
    }
    for (int axis = 0; axis < kAxisMax; ++axis) MeetBreakpoint(axis);
  }

 private:
  static bool RefusesUpdate(const ModelAxis& a) {
    return a.mode == Mode::kT && a.moves && a.waiting.acceleration != a.valid.acceleration;
  }
  int Refuse(int axis) {
    Done();
    at(axis).Tell(kRefused);
    return 1;
  }

  void FollowPlan(ModelAxis& a) const {
    double time = now_ - a.plan.begin;
    double position = a.plan.position;
    double velocity = a.plan.velocity;
    for (const Piece& piece : a.plan.pieces) {
      const double part = std::min(time, piece.length);
      position += (velocity + piece.acceleration * part / 2) * part;
      velocity += piece.acceleration * part;
      time -= part;
    }
    // What begins at rest towards a limit does not begin.
    if (a.velocity == 0 && a.Forbids(position - a.position)) return a.Rest();
    a.velocity = velocity;
    a.position = position + (a.plan.ends ? 0 : velocity * time);
    if (time == 0 || !a.plan.ends) return;
    if (a.mode == Mode::kT) a.position = a.valid.position;
    a.Rest();
  }

  void FollowMaster(ModelAxis& a) {
    const ModelAxis& master = at(a.master);
    const double way = a.ratio * (master.position - a.last);
    if (master.position != a.last) a.held = false;
    a.last = master.position;
    if (a.velocity == 0 && a.Forbids(way)) {
      a.held = true;
      return;
    }
    a.position += way;
    a.velocity = a.ratio * master.velocity;
  }

  /// Those that lead a slave towards its limit.
  void StopMasters() {
    std::vector<int> masters;
    for (ModelAxis& a : axes_) {
      const double direction = a.ratio * at(a.master).velocity;
      if (!a.Follows() || !a.held || !a.Forbids(direction)) continue;
      a.TellLimit(direction);
      masters.push_back(a.master);
    }
    for (int master : masters) {
      for (int links = 0; links < kAxisMax && at(master).Follows(); ++links) {
        master = at(master).master;
      }
      if (!at(master).Follows()) at(master).Rest();
    }
  }

  void MeetBreakpoint(int axis) {
    ModelAxis& a = at(axis);
    const double actual = std::round(a.position);
    const bool met = (a.breakpoint == Break::kPositive && actual >= a.valid.breakpoint) ||
                     (a.breakpoint == Break::kNegative && actual <= a.valid.breakpoint) ||
                     (a.breakpoint == Break::kMotion && (a.news & kComplete) != 0);
    a.news = 0;
    if (!met) return;
    a.breakpoint = Break::kNone;
    a.Tell(kBreak);
    if (!a.updates || RefusesUpdate(a)) return;
    const bool motion = std::exchange(a.motion_written, false);
    const bool ratio = std::exchange(a.ratio_written, false);
    Apply(axis, a.waiting, motion, ratio);
  }

  /// The first axis that may not go where this one would lead it.
  ModelAxis* Held(int axis, double direction, int links = 0) {
    if (at(axis).Forbids(direction)) {
      at(axis).TellLimit(direction);
      return &at(axis);
    }
    for (ModelAxis& slave : axes_) {
      if (links == kAxisMax || !slave.Follows() || slave.master != axis) continue;
      const auto number = static_cast<int>(&slave - axes_.data());
      if (ModelAxis* held = Held(number, direction * slave.ratio, links + 1)) return held;
    }
    return nullptr;
  }

  void Apply(int axis, const Registers& registers, bool motion, bool ratio) {
    ModelAxis& a = at(axis);
    a.valid = registers;
    if (!motion) return;
    if (a.mode == Mode::kGear) return ratio ? Engage(a) : void();
    const bool moves = a.valid.acceleration > 0 && (a.mode == Mode::kV || a.valid.velocity > 0);
    if (!a.moves && moves && Held(axis, a.Direction()) != nullptr) return a.Tell(kComplete);
    if (!a.moves && a.Direction() == 0) return a.Tell(kComplete);
    if (!moves) return;
    a.plan = {now_, a.position, a.velocity, {}, true};
    if (a.mode == Mode::kT) {
      a.plan.pieces =
          Way(a.position, a.velocity, a.valid.position, a.valid.velocity, a.valid.acceleration);
    } else {
      a.plan.pieces = {Ramp(a.velocity, a.valid.velocity, a.valid.acceleration)};
      a.plan.ends = a.valid.velocity == 0;
    }
    a.moves = a.moved = true;
  }

  void Engage(ModelAxis& a) {
    a.ratio = a.valid.ratio;
    if (!a.moves) a.last = at(a.master).position;
    a.moves = a.moved = true;
  }

  std::array<ModelAxis, kAxisMax> axes_;
  double now_ = 0;
};

// --- Random programs ---------------------------------------------------------------------------

class RandomProgram {
 public:
  explicit RandomProgram(unsigned seed) : random_(seed) {
    for (int axis = 1; axis <= kAxisMax; ++axis) card_.Enable(axis);
  }

  void Act() {
    const int axis = Below(kAxisMax);
    ModelAxis& a = model_.at(axis);
    Do("GT_Axis", {axis + 1.0}, model_.Done());
    switch (Below(16)) {
      case 0:
      case 1:
        if (!Do("GT_PrflT", {}, model_.Choose(axis, Mode::kT))) return;
        SetAcceleration(a);
        SetSpeed(a, Between(0.2, 6));
        SetTarget(a);
        return Update(axis);
      case 2:
      case 3:
        if (!Do("GT_PrflV", {}, model_.Choose(axis, Mode::kV))) return;
        SetAcceleration(a);
        SetSpeed(a, Below(4) == 0 ? 0 : Between(-6, 6));
        return Update(axis);
      case 4: {
        const int master = (axis + 1 + Below(kAxisMax - 1)) % kAxisMax;
        if (!Do("GT_PrflG", {master + 1.0}, model_.Choose(axis, Mode::kGear, master))) return;
        SetRatio(a);
        return Update(axis);
      }
      case 5:
        Redirect(a);
        return Update(axis);
      case 6:  // for an automatic update
        Redirect(a);
        return SetBreakpoint(axis);
      case 7:
        return SetBreakpoint(axis);
      case 8:
        a.updates = Below(3) > 0;
        Do(a.updates ? "GT_AuUpdtOn" : "GT_AuUpdtOff", {}, model_.Done());
        return;
      case 9:
        if (Below(3) == 0) Do("GT_AbptStp", {}, model_.Stop(axis));
        return;
      case 10: {
        const bool on = Below(4) > 0;
        Do(on ? "GT_LmtsOn" : "GT_LmtsOff", {}, model_.Watch(axis, on));
        return;
      }
      case 11:
      case 12: {
        const int limit = Below(2);
        const bool active = Below(3) == 0;
        a.pins[static_cast<size_t>(limit)] = active;
        ChangeState(card_.motion)
            .io.SetPin(limit == 0 ? DiType::kLimitPositive : DiType::kLimitNegative, axis, active);
        return;
      }
      default:
        Do("GT_ClrSts", {}, model_.Clear(axis));
    }
  }

  void Tick() {
    card_.Cycle();
    model_.Tick();
  }

  /// True if the card is where the model is.
  bool Agrees() {
    for (int axis = 0; axis < kAxisMax; ++axis) {
      const ModelAxis& a = model_.at(axis);
      const auto index = static_cast<size_t>(axis);
      constexpr unsigned kCompared = 0x4FF;
      EXPECT_EQ(StatusWord(card_.card.view(), index) & kCompared, a.Status())
          << "axis " << axis + 1;
      EXPECT_NEAR(card_.motion.profile(index).now.position, a.position,
                  1e-7 * (1 + std::fabs(a.position)))
          << "axis " << axis + 1;
    }
    return !testing::Test::HasFailure();
  }
  int refusals() const { return refusals_; }
  unsigned seen() const { return seen_; }
  /// Which events have occurred at all.
  void Look() {
    for (int axis = 0; axis < kAxisMax; ++axis) seen_ |= model_.at(axis).Status();
  }

  int Below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

 private:
  double Between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  /// True if the command succeeds, on both.
  bool Do(const char* command, const std::vector<double>& values, int code) {
    EXPECT_EQ(card_.Call(command, values), code) << command;
    refusals_ += code;
    return code == 0;
  }
  void Update(int axis) { Do("GT_Update", {}, model_.Update(axis)); }
  /// In motion, one that lies further on: where a motion turns is often exactly at a tick, and then
  /// rounding decides on which side.
  void SetTarget(ModelAxis& a) {
    const int way = Below(2001);
    if (!a.moves) {
      a.waiting.position = static_cast<int>(a.position) + 2 * way - 2000;
    } else {
      a.waiting.position = a.valid.position + (a.valid.position < a.position ? -way : way);
    }
    Written(a, "GT_SetPos", a.waiting.position);
  }
  /// Registers of another motion, which takes the place of the one in progress. One in mode V gets
  /// another acceleration for the same reason.
  void Redirect(ModelAxis& a) {
    switch (a.mode) {
      case Mode::kT:
        SetTarget(a);
        SetSpeed(a, Between(0.2, 6));
        if (Below(8) == 0) SetAcceleration(a);
        return;
      case Mode::kV:
        SetAcceleration(a);
        return SetSpeed(a, Between(-6, 6));
      case Mode::kGear:
        return SetRatio(a);
    }
  }
  void SetSpeed(ModelAxis& a, double speed) {
    a.waiting.velocity = speed;
    Written(a, "GT_SetVel", speed);
  }
  void SetAcceleration(ModelAxis& a) {
    a.waiting.acceleration = Between(0.01, 0.5);
    Written(a, "GT_SetAcc", a.waiting.acceleration);
  }
  void SetRatio(ModelAxis& a) {
    a.waiting.ratio = Between(-2, 2);
    a.ratio_written = true;
    Written(a, "GT_SetRatio", a.waiting.ratio);
  }
  void Written(ModelAxis& a, const char* command, double value) {
    a.motion_written = true;
    Do(command, {value}, model_.Done());
  }
  void SetBreakpoint(int axis) {
    constexpr struct {
      const char* command;
      Break breakpoint;
    } kCommands[] = {{"GT_PosBrk", Break::kPositive},
                     {"GT_NegBrk", Break::kNegative},
                     {"GT_MtnBrk", Break::kMotion},
                     {"GT_BrkOff", Break::kNone}};
    ModelAxis& a = model_.at(axis);
    a.waiting.breakpoint = static_cast<int>(a.position) + Below(1001) - 500;
    Do("GT_SetBrkCn", {static_cast<double>(a.waiting.breakpoint)}, model_.Done());
    if (Below(2) == 0) Update(axis);
    const auto& chosen = kCommands[Below(4)];
    Do(chosen.command, {}, model_.Set(axis, chosen.breakpoint));
  }

  std::mt19937_64 random_;
  Gt400TestCard card_;
  Model model_;
  int refusals_ = 0;
  unsigned seen_ = 0;
};

int TickCount() {
  const char* count = std::getenv("ONCARD_RANDOM_TICKS");
  return count != nullptr ? std::atoi(count) : 1500;
}

TEST(Gt400RandomMotion, IsThatOfTheModel) {
  constexpr unsigned kPrograms = 20;
  int refusals = 0;
  unsigned seen = 0;
  for (unsigned seed = 1; seed <= kPrograms; ++seed) {
    RandomProgram program(seed);
    for (int tick = 0; tick < TickCount(); ++tick) {
      if (program.Below(12) == 0) program.Act();
      program.Look();
      if (!program.Agrees()) FAIL() << "program " << seed << ", tick " << tick;
      program.Tick();
    }
    refusals += program.refusals();
    seen |= program.seen();
  }
  EXPECT_GT(refusals, 0);
  EXPECT_EQ(seen, kComplete | kBreak | kLimits[0] | kLimits[1] | kRefused | kMoving);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
