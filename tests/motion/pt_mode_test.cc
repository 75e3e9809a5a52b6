// Position/time motion: examples 7-3 and 7-4 of the GTS manual, segment types, loops, buffers.
#include "motion/profiles/pt_mode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/motion/profile_run.h"

namespace oncard::motion {
namespace {

constexpr double kExact = 1e-9;

struct PtRun : ProfileRun {
  explicit PtRun(Micros cycle_us = 250, bool dynamic = false) : ProfileRun(cycle_us) {
    profile.mode = ProfileMode::kPt;
    profile.pt.SetDynamic(dynamic);
  }
  void Append(double position, int32_t time, PtSegmentType type = PtSegmentType::kNormal,
              size_t buffer = 0, int32_t number = 0) {
    profile.pt.Append(buffer, position, time, type, number);
  }
  void AppendExample73(size_t buffer = 0) {
    Append(1024, 1024, PtSegmentType::kNormal, buffer, 11);
    Append(3072, 2048, PtSegmentType::kNormal, buffer, 12);
    Append(4096, 3072, PtSegmentType::kNormal, buffer, 13);
  }
  void Start() { profile.Start(now); }
};

void ExpectMotion(const Sample& sample, double position, double velocity, double acceleration) {
  EXPECT_NEAR(sample.position, position, kExact);
  EXPECT_NEAR(sample.velocity, velocity, kExact);
  EXPECT_NEAR(sample.acceleration, acceleration, kExact);
  EXPECT_TRUE(sample.moving);
}

/// a = 2/1024: 256 and 1 after 512 ms, then 2 for 1024 ms, then the same in reverse.
void ExpectExample73(PtRun& run, double begin, double origin) {
  constexpr double kA = 2.0 / 1024;
  ExpectMotion(run.At(begin + 512), origin + 256, 1, kA);
  ExpectMotion(run.At(begin + 1024), origin + 1024, 2, 0);
  ExpectMotion(run.At(begin + 1536), origin + 2048, 2, 0);
  ExpectMotion(run.At(begin + 2048), origin + 3072, 2, -kA);
  ExpectMotion(run.At(begin + 2560), origin + 3840, 1, -kA);
}

TEST(PtStatic, Example73AtEveryCycleLength) {
  for (const Micros cycle_us : {125, 250, 500, 1000, 2000, 4000}) {
    PtRun run(cycle_us);
    run.AppendExample73();
    run.Start();
    ExpectExample73(run, 0, 0);
    EXPECT_EQ(run.At(3072), AtRest(4096)) << cycle_us;
    EXPECT_EQ(run.profile.pt.loop_count, 1);
    EXPECT_EQ(run.profile.pt.Space(0), 29U);
  }
}

TEST(PtStatic, PositionsCountFromWhereTheRunBegan) {
  PtRun run;
  run.profile.SetPosition(-500);
  run.AppendExample73(1);
  run.profile.pt.run_buffer = 1;
  run.Start();
  ExpectExample73(run, 0, -500);
  EXPECT_EQ(run.At(3072), AtRest(3596));
  run.Start();
  ExpectExample73(run, 3072, 3596);
}

TEST(PtStatic, LoopsFollowWithoutAGapAndAddUp) {
  PtRun run(4000);
  run.AppendExample73();
  run.profile.pt.loop_target = 3;
  run.Start();
  for (int pass = 0; pass < 3; ++pass) {
    ExpectExample73(run, 3072 * pass, 4096 * pass);
    EXPECT_EQ(run.profile.pt.loop_count, pass);
    EXPECT_TRUE(run.At(3072 * pass + 3068).moving);
  }
  EXPECT_EQ(run.At(9216), AtRest(3 * 4096));
  EXPECT_EQ(run.profile.pt.loop_count, 3);
}

TEST(PtStatic, WithoutEndUntilTheRegisterChanges) {
  PtRun run(4000);
  run.Append(1, 1);  // ends at 2, starts again at 0: several passes per cycle
  run.profile.pt.loop_target = 0;
  run.Start();
  ExpectMotion(run.At(100), 100, 0, 2);
  EXPECT_EQ(run.profile.pt.loop_count, 100);
  run.profile.pt.loop_target = 102;
  EXPECT_EQ(run.At(104), AtRest(102));
}

TEST(PtStatic, NumbersAndRemainderFollowTheRun) {
  PtRun run;
  run.AppendExample73();
  const PtMode& pt = run.profile.pt;
  EXPECT_EQ(pt.Remainder(), 3U);
  run.Start();
  EXPECT_EQ(pt.number, 11);
  EXPECT_EQ(pt.Remainder(), 2U);
  run.At(1024);
  EXPECT_EQ(pt.number, 12);
  EXPECT_EQ(pt.Remainder(), 1U);
  run.At(2048.25);
  EXPECT_EQ(pt.number, 13);
  EXPECT_EQ(pt.Remainder(), 0U);
}

TEST(PtSegments, TypesSetTheVelocitiesOfTheirEnds) {
  PtRun run;
  run.Append(100, 100);                        // 0 to 2
  run.Append(250, 200, PtSegmentType::kEven);  // 1.5
  run.Append(350, 300);                        // 1.5 to 0.5
  run.Append(450, 400, PtSegmentType::kStop);  // 2 to 0
  run.Append(400, 500);                        // 0 to -1
  run.Append(350, 600, PtSegmentType::kStop);  // -1 to 0
  run.Start();
  ExpectMotion(run.At(50), 25, 1, 0.02);
  ExpectMotion(run.At(100), 100, 1.5, 0);
  ExpectMotion(run.At(150), 175, 1.5, 0);
  ExpectMotion(run.At(200), 250, 1.5, -0.01);
  ExpectMotion(run.At(300), 350, 2, -0.02);
  ExpectMotion(run.At(350), 425, 1, -0.02);
  ExpectMotion(run.At(400), 450, 0, -0.01);
  ExpectMotion(run.At(550), 362.5, -0.5, 0.01);
  EXPECT_EQ(run.At(600), AtRest(350));
}

TEST(PtStop, DeceleratesFromTheOutputAndKeepsStaticData) {
  PtRun run;
  run.AppendExample73();
  run.Start();
  run.At(1536);
  run.Stop(0.01);  // 2 pulse/ms: 200 ms, 200 pulses
  EXPECT_EQ(run.At(1736), AtRest(2248));
  EXPECT_EQ(run.profile.pt.Space(0), 29U);
  run.Start();
  ExpectExample73(run, 1736, 2248);
}

TEST(PtStop, DropsDynamicData) {
  PtRun run(250, true);
  run.AppendExample73();
  run.Start();
  run.At(1536);
  run.Stop(0.01);
  EXPECT_EQ(run.profile.pt.Space(0), 64U);
  EXPECT_EQ(run.profile.pt.LastTime(0), 0);
}

// --- Dynamic -----------------------------------------------------------------------------------

struct Point {
  double position;
  int32_t time;
  PtSegmentType type;
};

/// Example 7-4: two periods of 50 sin(2 pi t / 1000), its trapezoidal integral at every 16 ms.
std::vector<Point> Example74() {
  std::vector<Point> points;
  for (int period = 0; period < 2; ++period) {
    double position = 0;
    double before = 0;
    for (int t = 16; t < 1000; t += 16) {
      const double velocity = 50 * std::sin(2 * std::numbers::pi * t / 1000);
      position += (velocity + before) * 8;
      before = velocity;
      points.push_back({position, 1000 * period + t, PtSegmentType::kNormal});
    }
    points.push_back({0, 1000 * (period + 1), PtSegmentType::kStop});
  }
  return points;
}

TEST(PtDynamic, Example74RunsThroughBothBuffersInTurn) {
  const std::vector<Point> points = Example74();
  ASSERT_EQ(points.size(), 126U);
  PtRun run(250, true);
  PtMode& pt = run.profile.pt;
  size_t sent = 0;
  const auto feed = [&] {
    while (sent < points.size() && pt.Space(0) > 0) {
      run.Append(points[sent].position, points[sent].time, points[sent].type);
      ++sent;
    }
  };
  feed();
  EXPECT_EQ(sent, 64U);
  run.Start();
  double highest = 0;
  double fastest = 0;
  while (run.now < 2'000'000) {
    const Sample& sample = run.Tick();
    highest = std::max(highest, sample.position);
    fastest = std::max(fastest, std::fabs(sample.velocity));
    // Space becomes free in whole buffers: 32 segments last 512 ms.
    if (run.now == 511'750) {
      EXPECT_EQ(pt.Space(0), 0U);
    }
    if (run.now == 512'000) {
      EXPECT_EQ(pt.Space(0), 32U);
    }
    if (run.now == 16'000) {
      EXPECT_NEAR(sample.position, 40.145, 1e-3);
    }
    if (run.now == 48'000) {
      EXPECT_NEAR(sample.position, 358.874, 1e-3);
    }
    if (run.now == 496'000) {
      EXPECT_NEAR(sample.position, 15899.6, 0.1);
    }
    if (run.now == 992'000) {
      EXPECT_NEAR(sample.velocity, -2.51, 1e-2);
      EXPECT_NEAR(sample.position, 10.04, 1e-2);
    }
    if (run.now == 1'000'000) {
      EXPECT_NEAR(sample.position, 0, kExact);
      EXPECT_NEAR(sample.velocity, 0, kExact);
    }
    feed();
  }
  // In the segment from 496 ms on, the velocity crosses 0 after 4 ms.
  EXPECT_NEAR(highest, 15902.1, 0.1);
  EXPECT_NEAR(fastest, 49.996, 1e-3);
  EXPECT_EQ(run.profile.now, AtRest(0));
  EXPECT_EQ(pt.Space(0), 64U);
}

TEST(PtDynamic, StopsWhereTheDataEnds) {
  PtRun run(250, true);
  run.Append(100, 100);
  run.Append(300, 200);
  run.Start();
  ExpectMotion(run.At(150), 200, 2, 0);
  EXPECT_EQ(run.At(200), AtRest(300));
  EXPECT_EQ(run.profile.pt.Space(0), 64U);
  // Data appended later starts a new run.
  run.Append(100, 100);
  EXPECT_EQ(run.At(250), AtRest(300));
  run.Start();
  ExpectMotion(run.At(300), 325, 1, 0.02);
}

TEST(PtDynamic, DataInTimeContinuesTheRun) {
  PtRun run(250, true);
  run.Append(100, 100);
  run.Start();
  run.At(99.75);
  run.Append(300, 200);
  ExpectMotion(run.At(150), 200, 2, 0);
}

TEST(PtDynamic, LoopsMeanNothing) {
  PtRun run(250, true);
  run.profile.pt.loop_target = 0;
  run.Append(100, 100);
  run.Start();
  EXPECT_EQ(run.At(100), AtRest(100));
}

TEST(PtBuffers, HoldTheirSegmentsAndOtherUseEmptiesThem) {
  PtMode pt;
  EXPECT_EQ(pt.Space(0), 32U);
  pt.large_memory = true;
  for (int i = 1; i <= 1024; ++i) pt.Append(0, i, i, PtSegmentType::kEven, 0);
  EXPECT_EQ(pt.Space(0), 0U);
  EXPECT_EQ(pt.Space(1), 1024U);
  pt.SetDynamic(false);
  EXPECT_EQ(pt.Space(0), 0U);
  pt.SetDynamic(true);
  EXPECT_EQ(pt.Space(0), 2048U);
}

}  // namespace
}  // namespace oncard::motion
