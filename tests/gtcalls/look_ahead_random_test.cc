// Commands of the multi-axis look-ahead, in any order and mixed with those of coordinate systems:
// a refused one changes nothing, the planners stay consistent, every number stays finite, and no
// axis jumps. A failure prints its seed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/gtcalls/look_ahead_support.h"

namespace oncard::gtcalls::gts {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

/// The largest path velocity in the commands below, mm/s; 1000 pulses per mm, so that it is also
/// that of an axis in pulse/ms.
constexpr double kVelocity = 100;
/// Coordinate system 1 has axes 1 to 3, coordinate system 2 has 4 and 5; 6 to 8 follow and move.
constexpr size_t kMembers = 5;

class RandomLookAhead {
 public:
  explicit RandomLookAhead(unsigned seed) : random_(seed) {
    for (int axis = 1; axis <= 8; ++axis) card_.Expect(0, "GT_AxisOn", {axis});
    for (const int crd : {1, 2}) {
      SetUpCrd(crd);
      Do("GT_SetupLookAheadCrd", {crd, Choose(2)});
      std::vector<double> cells = LookAheadCard::Parameters(1 + Choose(20));
      Do("GT_InitLookAheadEx", {crd, &cells, 0, 0, nullptr});
    }
  }

  void Run(int rounds) {
    for (int i = 0; i < rounds && !testing::Test::HasFailure(); ++i) {
      Command();
      CheckPlanners();
      if (Choose(6) == 0) Cycles(Choose(4) == 0 ? Choose(400) : Choose(20));
    }
  }
  bool moved() const { return moved_; }

 private:
  int Choose(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  double Draw(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  bool Rarely() { return Choose(40) == 0; }
  /// The value, or rarely one that no command can use.
  double Or(double value) {
    if (!Rarely()) return value;
    const double odd[] = {kNotANumber, kEndless, -kEndless, 1e300, -1, 0, 5e-324, 1e9};
    return odd[Choose(8)];
  }
  double Position() { return Or(std::round(Draw(-20, 20) * 8) / 8); }
  double Velocity() { return Or(Draw(1, kVelocity)); }
  double Acceleration() { return Or(Draw(50, 3000)); }
  int Crd() { return Rarely() ? Choose(4) : 1 + Choose(2); }
  int Fifo() { return Choose(4) == 0 ? Choose(2) : 0; }

  /// Calls a command; a refused one must not change anything.
  int16_t Do(std::string_view name, const std::vector<Argument>& arguments) {
    last_ += std::string(name) + " ";
    if (last_.size() > 600) last_.erase(0, last_.size() - 600);
    const uint64_t before = card_.Hash();
    const int16_t code = card_.Call(name, arguments);
    // A flush sends as much as there is space for.
    const bool flush = name == "GT_CrdDataEx" || name == "GT_CrdData";
    if (code != 0 && !flush) {
      EXPECT_EQ(card_.Hash(), before) << name << " gave " << code << " and changed something";
    }
    return code;
  }

  void SetUpCrd(int crd) {
    std::vector<double> cells(21);
    cells[0] = crd == 1 ? 3 : 2;
    for (int i = 0; i < static_cast<int>(cells[0]); ++i) {
      cells[static_cast<size_t>(1 + (crd == 1 ? 0 : 3) + i)] = i + 1;
    }
    cells[9] = 500;
    cells[10] = Choose(3) == 0 ? 1 : 10;
    cells[11] = Choose(50);
    Do("GT_SetCrdPrm", {crd, &cells});
  }

  void Initialise() {
    std::vector<double> cells = LookAheadCard::Parameters(Rarely() ? 0 : 1 + Choose(12));
    cells[1] = Or(Draw(0.001, 0.1));
    cells[2] = Or(Draw(0.01, 2));
    for (size_t i = 0; i < 8; ++i) {
      cells[3 + i] = Or(Draw(20, 200));
      cells[11 + i] = Or(Draw(100, 2000));
      cells[19 + i] = Or(Draw(50, 1000));
    }
    if (Rarely()) cells[27] = 2000;
    if (Rarely()) cells[35 + static_cast<size_t>(Choose(8))] = Choose(10);
    std::vector<double> start(8);
    for (double& value : start) value = Position();
    const int virtually = Choose(6) == 0 ? 1 : 0;
    if (Choose(2) == 0) {
      Do("GT_InitLookAheadEx", {Crd(), &cells, Fifo(), virtually, nullptr});
    } else {
      Do("GT_InitLookAheadEx", {Crd(), &cells, Fifo(), virtually, &start});
    }
  }

  void SetSettings() {
    std::vector<double> modes(8);
    std::vector<double> follows(8);
    for (size_t i = 0; i < 8; ++i) modes[i] = Choose(8);
    for (size_t i = 5; i < 8; ++i) follows[i] = Choose(2);
    std::vector<double> limits(8);
    for (double& limit : limits) limit = Or(Draw(20, 500));
    switch (Choose(7)) {
      case 0:
        Do("GT_SetupLookAheadCrd", {Crd(), Rarely() ? Choose(5) : Choose(2)});
        return;
      case 1:
        Do("GT_SetAxisLimitModeLa", {Crd(), &modes});
        return;
      case 2:
        Do("GT_SetWorkLimitModeLa", {Crd(), Choose(2)});
        return;
      case 3:
        Do("GT_SetVelDefineModeLa", {Crd(), Choose(3)});
        return;
      case 4:
        Do("GT_SetAxisVelValidModeLa", {Crd(), Choose(2) == 0 ? 0xFF : 0x7});
        return;
      case 5:
        Do("GT_SetFollowAxisParaLa", {Crd(), &follows, &limits, &limits, &limits});
        return;
      default:
        Do("GT_InitLookAheadPara", {Crd(), Choose(20), Or(0.01), Or(1), Or(1000), Fifo()});
        return;
    }
  }

  void Segment() {
    const int crd = Crd();
    const int fifo = Fifo();
    const double x = Position();
    const double y = Position();
    const double v = Velocity();
    const double a = Acceleration();
    const int second = Rarely() ? 2 : Choose(2);
    const double centre = Position() / 2;
    const int turn = Choose(2);
    switch (Choose(10)) {
      case 0:
        Do("GT_LnXYZEx", {crd, x, y, Position(), v, a, 1, second, fifo});
        return;
      case 1:
        Do("GT_LnXYG0Ex", {crd, x, y, v, a, 2, second, fifo});
        return;
      case 2:
        Do("GT_ArcXYREx", {crd, x, y, Or(Draw(-40, 40)), turn, v, a, 3, second, fifo});
        return;
      case 3:
        // A full circle, as the start is where the path ends.
        Do("GT_ArcXYCEx", {crd, last_x_, last_y_, centre, Position(), turn, v, a, 4, second, fifo});
        return;
      case 4:
        Do("GT_HelixXYRZEx", {crd, x, y, Position(), 30., turn, v, a, 5, second, fifo});
        return;
      case 5:
        Do("GT_ArcXYZEx",
           {crd, x, y, Position(), Position(), Position(), Position(), v, a, 6, second, fifo});
        return;
      case 6:
        Do("GT_LnXYZAEx", {crd, x, y, 0., 1., v, a, 7, second, fifo});
        return;
      default:
        if (Do("GT_LnXYEx", {crd, x, y, v, a, 8, second, fifo}) == 0) {
          last_x_ = x;
          last_y_ = y;
        }
        return;
    }
  }

  void Auxiliary() {
    const int crd = Crd();
    const int fifo = Fifo();
    const int profile = Rarely() ? Choose(14) : 6 + Choose(3);
    switch (Choose(7)) {
      case 0:
        Do("GT_BufDelayEx", {crd, Choose(20), fifo});
        return;
      case 1:
        Do("GT_BufIOEx", {crd, 12, 1, Choose(2), fifo});
        return;
      case 2:
        Do("GT_BufDAEx", {crd, 1 + Choose(9), Choose(20000) - 10000, fifo});
        return;
      case 3:
        Do("GT_BufGearEx", {crd, profile, Position() / 4, fifo});
        return;
      case 4:
        Do("GT_BufMoveEx",
           {crd, profile, Position() / 10, Velocity(), Acceleration(), Choose(2), fifo});
        return;
      case 5:
        Do("GT_SetUserSegNumEx", {crd, Choose(100), fifo});
        return;
      default:
        for (int i = Choose(20); i > 0; --i) Do("GT_BufIOEx", {crd, 12, 1, i % 2, fifo});
        return;
    }
  }

  void InPulses() {
    const int crd = Crd();
    const int fifo = Fifo();
    const int x = Choose(20000) - 10000;
    std::vector<double> buffer(1);
    switch (Choose(6)) {
      case 0:
        Do("GT_BufDelay", {crd, Choose(20), fifo});
        return;
      case 1:
        Do("GT_BufGearPercent", {crd, 6 + Choose(3), x / 10, Choose(60), Choose(60), fifo});
        return;
      case 2:
        Do("GT_InitLookAhead", {crd, fifo, 5., 1., 1 + Choose(10), &buffer});
        return;
      case 3:
        Do("GT_CrdData", {crd, nullptr, fifo});
        return;
      case 4:
        Do("GT_ArcXYC", {crd, x, x / 2, x / 3., 4000., 1, 50., 1., 0., fifo});
        return;
      default:
        Do("GT_LnXY", {crd, x, Choose(20000) - 10000, 50., 1., 0., fifo});
        return;
    }
  }

  void Control() {
    const int crd = Crd();
    const int fifo = Fifo();
    std::vector<double> value(4);
    std::vector<double> count(1);
    switch (Choose(16)) {
      case 0:
        Do("GT_Stop", {Choose(4) << 8, Choose(2) << 8});
        return;
      case 1:
        Do("GT_CrdClear", {crd, fifo});
        return;
      case 2:
        Do("GT_SetOverride", {crd, Or(Draw(0.05, 1))});
        return;
      case 3:
        Do("GT_SetOverride2", {crd, Or(Draw(0.05, 1))});
        return;
      case 4:
        if (Choose(4) == 0) SetUpCrd(1 + Choose(2));
        return;
      case 5:
        Do("GT_CrdStatus", {crd, &value, &count, fifo});
        return;
      case 6:
        Do("GT_CrdSpace", {crd, &value, fifo});
        return;
      case 7:
        Do("GT_GetRemainderSegNum", {crd, &value, fifo});
        return;
      case 8:
        Do("GT_GetLookAheadSpace", {crd, &value, fifo});
        EXPECT_GE(value[0], 0);
        return;
      case 9:
        if (Do("GT_GetMotionTimeEx", {crd, &value, fifo}) == 0) {
          EXPECT_TRUE(value[0] >= 0 && std::isfinite(value[0])) << value[0];
        }
        return;
      case 10:
        Do("GT_CrdStartStep", {crd, 0});
        return;
      case 11:
        if (Rarely()) Do("GT_CrdStepMode", {3, Choose(4)});
        return;
      case 12:
        Do("GT_SetCrdStopDec", {crd, Draw(0.5, 10), 10.});
        return;
      case 13:
        value = {Draw(20, 200), Draw(20, 200), Draw(20, 200), 100};
        Do("GT_SetCrdSingleMaxVel", {crd, &value});
        return;
      default:
        Do("GT_CrdStart", {1 + Choose(3), Choose(8) == 0 ? Choose(4) : 0});
        return;
    }
  }

  void Command() {
    switch (Choose(24)) {
      case 0:
        return SetSettings();
      case 1:
        return Initialise();
      case 2:
        return InPulses();
      case 3:
      case 4:
        Do("GT_CrdDataEx", {Crd(), nullptr, Fifo()});
        return;
      case 5:
      case 6:
      case 7:
        return Control();
      case 8:
      case 9:
      case 10:
      case 11:
        return Auxiliary();
      default:
        return Segment();
    }
  }

  void CheckPlanners() {
    for (const motion::Crd& crd : card_.motion.state().crds) {
      for (const motion::CrdFifo& fifo : crd.fifos) {
        EXPECT_LE(fifo.slots.size(), motion::kCrdFifoSize) << last_;
        if (!fifo.planner) continue;
        const motion::PathPlanner& planner = *fifo.planner;
        EXPECT_LE(planner.spans.size(), planner.capacity) << last_;
        EXPECT_EQ(planner.spans.size(), planner.ring.CountSegments()) << last_;
        EXPECT_LE(planner.settled, planner.spans.size()) << last_;
        EXPECT_LE(planner.ring.size(), 17 * (planner.spans.size() + 1)) << last_;
        for (size_t i = 0; i < planner.spans.size(); ++i) {
          const motion::WindowSpan& span = planner.spans.At(i);
          ASSERT_LT(span.slot - planner.taken, planner.ring.size()) << last_;
          EXPECT_TRUE(planner.SlotOf(span).is_segment) << last_;
          EXPECT_TRUE(std::isfinite(span.top) && span.top > 0) << last_;
          EXPECT_TRUE(span.junction >= 0 && span.junction <= span.top) << last_;
        }
        EXPECT_TRUE(planner.speed >= 0 && std::isfinite(planner.speed)) << last_;
      }
    }
  }

  void Cycles(int count) {
    for (int i = 0; i < count; ++i) {
      std::array<double, kMembers> before;
      for (size_t k = 0; k < kMembers; ++k) before[k] = card_.Position(k);
      card_.Cycle();
      for (size_t k = 0; k < 8; ++k) {
        const motion::Sample& now = card_.motion.state().profiles[k].now;
        ASSERT_TRUE(std::isfinite(now.position) && std::isfinite(now.velocity) &&
                    std::isfinite(now.acceleration))
            << k << " after " << last_;
      }
      for (size_t k = 0; k < kMembers; ++k) {
        ASSERT_LE(std::fabs(card_.Position(k) - before[k]), 2 * kVelocity + 1e-3)
            << "axis " << k + 1 << " after " << last_;
        moved_ = moved_ || card_.Position(k) != before[k];
      }
    }
  }

  std::mt19937 random_;
  LookAheadCard card_;
  std::string last_;
  double last_x_ = 0;
  double last_y_ = 0;
  bool moved_ = false;
};

TEST(RandomLookAhead, StaysConsistent) {
  int moved = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    RandomLookAhead run(seed);
    run.Run(600);
    moved += run.moved() ? 1 : 0;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(moved, 6);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
