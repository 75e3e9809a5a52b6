// Random commands in all modes, including values at the limits of their ranges and beyond: whatever
// they do, no profile may move further in a cycle than its velocities allow, and Trap, Jog and
// stops must keep their accelerations. A failure prints its seed.
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "tests/gtcalls/crd_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

/// The maximum velocity and acceleration in the commands below, pulse/ms and pulse/ms^2.
constexpr double kVelocity = 100;
constexpr double kAcceleration = 10;
/// Maximum ratio of slaves: twice the master's velocity.
constexpr double kRatio = 2;

constexpr int kTrapAxis = 1;
constexpr int kJogAxis = 2;
constexpr int kPtAxis = 3;
constexpr int kPvtAxis = 4;
constexpr int kGearAxis = 5;
constexpr int kFollowAxis = 6;
/// Axes 7 and 8 form a coordinate system, whose buffered commands also move axis 2.
constexpr int kAxes = 8;

struct Bound {
  double velocity = 0;
  double acceleration = std::numeric_limits<double>::infinity();
};

/// Limits of axis n + 1. PVT: a cubic between velocities up to kVelocity with a mean up to
/// kVelocity stays within 5 times kVelocity.
constexpr std::array<Bound, kAxes> kBounds = {{{kVelocity, kAcceleration},
                                               {kVelocity},
                                               {kVelocity},
                                               {5 * kVelocity},
                                               {kRatio * kVelocity},
                                               {kRatio * kVelocity},
                                               {kVelocity},
                                               {kVelocity}}};

class RandomMotion {
 public:
  explicit RandomMotion(unsigned seed)
      : random_(seed), card_({.axis_count = kAxes, .cycle_us = seed % 2 == 0 ? 250 : 1000}) {
    std::vector<double> trap = {Acceleration(), Acceleration(), 0,
                                static_cast<double>(Pick({0, 1, 25, 50}))};
    std::vector<double> jog = {Acceleration(), Acceleration(), Pick({0, 0.01, 0.5, 0.99})};
    card_.Expect(0, "GT_SetTrapPrm", {kTrapAxis, &trap});
    card_.Expect(0, "GT_PrfJog", {kJogAxis});
    card_.Expect(0, "GT_SetJogPrm", {kJogAxis, &jog});
    card_.Expect(0, "GT_PrfPt", {kPtAxis, static_cast<int>(seed / 2 % 2)});
    card_.Expect(0, "GT_PrfPvt", {kPvtAxis});
    card_.Expect(0, "GT_PrfGear", {kGearAxis, Choose(3) - 1});
    card_.Expect(0, "GT_PrfFollow", {kFollowAxis, Choose(3) - 1});
    // The master is 1, as a profile or as an axis.
    card_.Expect(0, "GT_SetGearMaster", {kGearAxis, kTrapAxis, 2 + Choose(2), 0});
    card_.Expect(0, "GT_SetFollowMaster", {kFollowAxis, kTrapAxis, 2 + Choose(2), 0});
    std::vector<double> crd(21);
    crd[0] = 2;
    crd[1 + 6] = 1;
    crd[1 + 7] = 2;
    crd[9] = kVelocity;
    crd[10] = kAcceleration;
    crd[11] = Pick({0, 0, 10, 32766});
    card_.Expect(0, "GT_SetCrdPrm", {1, &crd});
    for (int axis = 1; axis <= kAxes; ++axis) {
      card_.Expect(0, "GT_SetStopDec", {axis, Acceleration(), kAcceleration});
      card_.Expect(0, "GT_AxisOn", {axis});
    }
  }

  void Run(int cycles) {
    for (int i = 0; i < cycles && !testing::Test::HasFailure(); ++i) {
      if (Choose(4) == 0) Command();
      Tick();
    }
  }

 private:
  int Choose(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  double Draw(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  double Pick(const std::vector<double>& values) {
    return values[static_cast<size_t>(Choose(static_cast<int>(values.size())))];
  }
  double Tiny() { return Pick({5e-324, 1e-310, 1e-300, 1e-154, 1e-17, 1e-9, 1e-6}); }
  double Acceleration() { return Choose(8) == 0 ? Pick({1e-9, 1e-3}) : Draw(0.01, kAcceleration); }
  double Velocity() {
    const double value = Choose(4) == 0 ? Tiny() : Draw(0, kVelocity);
    return Choose(8) == 0 ? 0 : value * (Choose(2) == 0 ? 1 : -1);
  }
  int Position() { return static_cast<int>(Draw(-1, 1) * Pick({2, 1000, 1e6, 1073741823})); }

  /// Calls a command, which may be refused.
  void Do(std::string_view name, const std::vector<Argument>& arguments) {
    card_.Call(name, arguments);
  }

  void Command() {
    switch (Choose(9)) {
      case 0:
        return MoveTrap();
      case 1:
        Do("GT_SetVel", {kJogAxis, Velocity()});
        return Do("GT_Update", {1 << (kJogAxis - 1)});
      case 2:
        return MovePt();
      case 3:
        return MovePvt();
      case 4:
        return MoveGear();
      case 5:
        return MoveFollow();
      case 6:
        return AppendPath();
      case 7:
        return RunPath();
      default:
        return Disturb();
    }
  }

  void MoveTrap() {
    Do("GT_SetPos", {kTrapAxis, Position()});
    Do("GT_SetVel", {kTrapAxis, Velocity()});
    Do("GT_Update", {1 << (kTrapAxis - 1)});
  }

  void MovePt() {
    // NORMAL: from the last velocity to another, the first from 0; data is only appended at rest.
    if (card_.motion.state().profiles[kPtAxis - 1].now.moving) return;
    Do("GT_PtClear", {kPtAxis, 0});
    double velocity = 0;
    double position = 0;
    int time = 0;
    for (int i = 0; i < 8; ++i) {
      const int duration = 1 + Choose(40);
      const double next = Choose(3) == 0 ? 0 : Draw(-kVelocity, kVelocity);
      position += (velocity + next) / 2 * duration;
      time += duration;
      Do("GT_PtData", {kPtAxis, position, time, 0, 0});
      velocity = next;
    }
    Do("GT_SetPtLoop", {kPtAxis, Choose(4)});
    Do("GT_PtStart", {1 << (kPtAxis - 1), 0});
  }

  void MovePvt() {
    std::vector<double> times = {Pick({0, 1, 10})};
    std::vector<double> positions = {0};
    std::vector<double> velocities = {0};
    for (int i = 0; i < 5; ++i) {
      const double duration = Pick({0.001, 0.1, 1, 50}) * Draw(1, 3);
      times.push_back(times.back() + duration);
      positions.push_back(positions.back() + Draw(-kVelocity, kVelocity) * duration);
      velocities.push_back(Draw(-kVelocity, kVelocity));
    }
    Do("GT_PvtTable", {1, 6, &times, &positions, &velocities});
    Do("GT_SetPvtLoop", {kPvtAxis, Choose(3)});
    Do("GT_PvtTableSelect", {kPvtAxis, 1});
    Do("GT_PvtStart", {1 << (kPvtAxis - 1)});
  }

  void MoveGear() {
    const int slave = static_cast<int>(Draw(-1000 * kRatio, 1000 * kRatio));
    const int slope = static_cast<int>(Pick({0, 2, 1000, 1e6}));
    Do("GT_SetGearRatio", {kGearAxis, 1000, slave, slope});
    Do("GT_GearStart", {1 << (kGearAxis - 1)});
  }

  void MoveFollow() {
    const int fifo = Choose(2);
    if (card_.Call("GT_FollowClear", {kFollowAxis, fifo}) != 0) return;  // it is in use
    double ratio = 0;
    double slave = 0;
    int master = 0;
    for (int i = 0; i < 4; ++i) {
      const int length = 1 + static_cast<int>(Draw(0, 1) * Pick({10, 1000, 1e5}));
      const double next = Draw(-kRatio, kRatio);
      const int type = Choose(3);  // NORMAL, EVEN, STOP
      slave += length * (type == 0 ? (ratio + next) / 2 : type == 1 ? next : next / 2);
      ratio = type == 2 ? 0 : next;
      master += length;
      Do("GT_FollowData", {kFollowAxis, master, slave, type, fifo});
    }
    Do("GT_SetFollowEvent", {kFollowAxis, 1 + Choose(2), Choose(2) == 0 ? 1 : -1, Position()});
    Do("GT_SetFollowLoop", {kFollowAxis, Choose(5)});
    Do("GT_FollowStart", {1 << (kFollowAxis - 1), fifo << (kFollowAxis - 1)});
    Do("GT_FollowSwitch", {1 << (kFollowAxis - 1)});
  }

  void AppendPath() {
    const int x = Position();
    const int y = Position();
    const double velocity = std::fabs(Velocity());
    switch (Choose(6)) {
      case 0:
        return Do("GT_BufDelay", {1, Choose(10), 0});
      case 1:
        Do("GT_PrfTrap", {kJogAxis});
        return Do("GT_BufMove",
                  {1, kJogAxis, Choose(10000), velocity, Acceleration(), Choose(2), 0});
      case 2:
        return AppendGear(velocity);
      case 3:
        return Do("GT_ArcXYR", {1, x % 10000, y % 10000, 20000.0, Choose(2), velocity,
                                Acceleration(), velocity, 0});
      default:
        return Do("GT_LnXY", {1, x, y, velocity, Acceleration(), std::fabs(Velocity()), 0});
    }
  }

  /// Moves by half of a line's length, with ramps over the whole line: not faster than the path.
  void AppendGear(double velocity) {
    const motion::CrdFifo& fifo = card_.motion.state().crds[0].fifos[0];
    const motion::Coordinates end = fifo.idle() ? card_.motion.CrdPosition(0) : fifo.tail;
    const double x = end[0] + (end[0] < 0 ? 2000 : -2000);
    Do("GT_BufGearPercent", {1, kJogAxis, Choose(1000), 50, 50, 0});
    Do("GT_LnXY", {1, x, end[1], velocity, Acceleration(), 0, 0});
  }

  void RunPath() {
    switch (Choose(5)) {
      case 0:
        return Do("GT_SetOverride", {1, Choose(2) == 0 ? Tiny() : Draw(0.001, 1)});
      case 1:
        return Do("GT_Stop", {0x100, Choose(2) << 8});
      case 2:
        return Do("GT_CrdClear", {1, 0});
      default:
        return Do("GT_CrdStart", {1, 0});
    }
  }

  void Disturb() {
    const int axis = 1 + Choose(kAxes);
    switch (Choose(6)) {
      case 0:
        return Do("GT_SetSoftLimit", {axis, Position(), Position()});
      case 1:
        Do("GT_AxisOff", {axis});
        return Do("GT_AxisOn", {axis});
      case 2:
        return Do("GT_ZeroPos", {axis, 1});
      case 3:
        return Do("GT_SetPrfPos", {axis, Position()});
      case 4:
        Do("GT_PrfJog", {kJogAxis});
        return Do("GT_ClrSts", {axis, 1});
      default:
        return Do("GT_Stop", {1 << (axis - 1), Choose(2) << (axis - 1)});
    }
  }

  /// Runs a cycle and checks how far each profile has moved.
  void Tick() {
    std::array<motion::Sample, kAxes> before;
    for (size_t i = 0; i < kAxes; ++i) before[i] = card_.motion.state().profiles[i].now;
    card_.motion.Tick();
    const double ms = static_cast<double>(card_.motion.config().cycle_us) / 1000;
    for (size_t i = 0; i < kAxes; ++i) {
      const motion::Sample& after = card_.motion.state().profiles[i].now;
      const double way = std::fabs(after.position - before[i].position);
      const double change = std::fabs(after.velocity - before[i].velocity);
      // The rounding error of positions up to 2^30 pulses.
      constexpr double kRounding = 1e-5;
      EXPECT_LE(way, kBounds[i].velocity * ms + kRounding)
          << "axis " << i + 1 << " from " << before[i].position << " to " << after.position
          << " in cycle " << card_.motion.state().cycle;
      EXPECT_LE(change, kBounds[i].acceleration * ms + kRounding)
          << "axis " << i + 1 << " from " << before[i].velocity << " to " << after.velocity
          << " pulse/ms in cycle " << card_.motion.state().cycle;
    }
  }

  std::mt19937 random_;
  CrdCommandCard card_;
};

TEST(RandomMotion, NoProfileGoesFurtherThanItsVelocityAllows) {
  for (unsigned seed = 1; seed <= 400 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomMotion(seed).Run(3000);
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gts
