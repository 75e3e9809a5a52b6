// Paths as older cards have them: a start velocity, an override of 0,
// lists whose joints follow from their feeds. Worked figures are those of
// the GE manual, chapter 6.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/common/state_hash.h"
#include "tests/base/random_cases.h"
#include "tests/motion/crd_run.h"
#include "tests/motion/planned_path.h"

namespace oncard::motion {
namespace {

// --- Start velocity ------------------------------------------------------------------------------

TEST(PathStart, JoinsTheHashOnlyInUse) {
  Crd without;
  Crd with;
  with.start.velocity = 0.5;
  EXPECT_NE(StateHash().Add(with).value(), StateHash().Add(without).value());
  EXPECT_EQ(StateHash().Add(PathStart{}).value(), StateHash().value());
}

TEST(PathStart, IsTakenAtOnceAtBothEnds) {
  CrdRunTest test;
  test.crd().start.velocity = 0.5;
  ASSERT_TRUE(test.Line({3000, 4000}, 20, 0.1));
  test.Start();
  test.core.Tick();
  const Plan plan = test.crd().run.plan;
  // 195 ms and 1998.75 pulses from 0.5 to 20 pulse/ms, 1002.5 pulses at 20.
  struct {
    double t, path, velocity;
  } const instants[] = {{0, 0, 0.5},
                        {11.003125, 11.5550005, 1.6003125},
                        {198.05625, 2059.875, 20},
                        {220.0625, 2500, 20},
                        {253.071875, 3157.02986, 19.2053125},
                        {297.084375, 3905.44867, 14.8040625}};
  for (const auto& at : instants) {
    EXPECT_NEAR(plan.At(at.t).position, at.path, 1e-5) << at.t;
    EXPECT_NEAR(plan.At(at.t).velocity, at.velocity, 1e-9) << at.t;
  }
  EXPECT_NEAR(plan.duration, 195 + 1002.5 / 20 + 195, 1e-9);
  EXPECT_NEAR(plan.end_velocity, 0.5, 1e-12);
  EXPECT_EQ(test.TicksToEnd() + 1, 441);
  EXPECT_EQ(test.profile(1).position, 4000);
  EXPECT_EQ(test.crd().run.velocity, 0);
}

TEST(PathStart, RaisesThePeakOfAShortPath) {
  CrdRunTest test;
  test.crd().start.velocity = 0.3;
  ASSERT_TRUE(test.Line({10, 10}, 100, 1.8));
  test.Start();
  test.core.Tick();
  // sqrt(0.3^2 + 1.8 * 14.1421) = 5.0543, (5.0543 - 0.3) / 1.8 each way.
  EXPECT_NEAR(test.crd().run.plan.pieces[1].velocity, 5.0543, 1e-4);
  EXPECT_NEAR(test.crd().run.plan.duration, 5.2825, 1e-4);
}

TEST(PathStart, IsTheFeedOfASlowerPath) {
  CrdRunTest test;
  test.crd().start.velocity = 3;
  ASSERT_TRUE(test.Line({100, 0}, 2, 0.1));
  test.Start();
  test.core.Tick();
  EXPECT_EQ(test.crd().run.velocity, 2);
  EXPECT_EQ(test.TicksToEnd() + 1, 50);
  EXPECT_EQ(test.profile(0).position, 100);
}

// A joint at the start velocity or below is a rest: the next segment begins with the start velocity
// of its own.
TEST(PathStart, IsTakenAgainBehindASegmentThatRests) {
  CrdRunTest test;
  test.crd().start.velocity = 0.5;
  ASSERT_TRUE(test.Line({100, 0}, 0.25, 0.1));
  ASSERT_TRUE(test.Line({100, 200}, 0.5, 0.1));
  test.Start();
  EXPECT_EQ(test.TicksToEnd(), 400 + 400);
  EXPECT_EQ(test.profile(1).position, 200);
}

TEST(PathStart, AStopRestsAtOnceFromIt) {
  for (const bool abrupt : {false, true}) {
    CrdRunTest test;
    test.crd().start.velocity = 0.5;
    test.crd().smooth_stop = 0.1;
    test.crd().abrupt_stop = 5;
    ASSERT_TRUE(test.Line({5000, 0}, 20, 0.1));
    test.Start();
    test.RunUntil(200);
    const double begin = test.profile(0).position;
    EXPECT_NEAR(begin, 1998.75 + 5 * 20, 1e-9);
    test.core.CrdAt(0).Stop(abrupt);
    // (20 - 0.5) / 0.1 and (20 - 0.5) / 5; (20^2 - 0.5^2) / (2 a).
    EXPECT_EQ(test.TicksToEnd(), abrupt ? 4 : 195);
    EXPECT_NEAR(test.profile(0).position - begin, abrupt ? 39.975 : 1998.75, 1e-9);
    EXPECT_EQ(test.crd().run.velocity, 0);
    EXPECT_TRUE(test.fifo().executing);
    test.Start();
    test.core.Tick();
    EXPECT_NEAR(test.crd().run.velocity, 0.6, 1e-12);
  }
}

TEST(PathStart, AStopAtTheEndOfTheLastSegmentRestsThere) {
  CrdRunTest test;
  test.crd().start.velocity = 0.5;
  test.crd().smooth_stop = 0.01;
  ASSERT_TRUE(test.Line({500, 0}, 20, 0.1));
  test.Start();
  test.RunUntil(60);
  // The deceleration of the stop is not enough for the way that is left.
  test.core.CrdAt(0).Stop(false);
  test.TicksToEnd();
  EXPECT_NEAR(test.profile(0).position, 500, 1e-9);
}

// --- An override of 0 ----------------------------------------------------------------------------

void SetOverride(CrdRunTest* test, double ratio) {
  test->crd().override_ratio = ratio;
  test->crd().Replan(test->core.now());
}

TEST(CrdOverride, OfZeroHoldsThePathUntilItIsRaised) {
  for (const double start : {0.0, 0.5}) {
    CrdRunTest test;
    test.crd().start.velocity = start;
    ASSERT_TRUE(test.Line({3000, 4000}, 20, 1));
    test.Start();
    test.RunUntil(100);
    const double begin = test.crd().fifos[0].path;
    SetOverride(&test, 0);
    test.RunUntil(200);
    EXPECT_TRUE(test.running());
    EXPECT_EQ(test.crd().run.wait, CrdWait::kOverride);
    EXPECT_EQ(test.crd().run.velocity, 0);
    // From 20 with 1 pulse/ms^2 to the start velocity.
    EXPECT_NEAR(test.crd().fifos[0].path - begin, (400 - start * start) / 2, 1e-9);
    SetOverride(&test, 0.5);
    test.core.Tick();
    EXPECT_NEAR(test.crd().run.velocity, start + 1, 1e-12);
    test.TicksToEnd();
    EXPECT_EQ(test.profile(0).position, 3000);
    EXPECT_EQ(test.profile(1).position, 4000);
    EXPECT_EQ(test.fifo().done, 1);
  }
}

TEST(CrdOverride, OfZeroBrakesAcrossJoints) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({1000, 0}, 20, 1, 20));
  ASSERT_TRUE(test.Line({1000, 1000}, 20, 1));
  test.Start();
  test.RunUntil(55);  // 200 + 35 * 20 = 900
  SetOverride(&test, 0);
  test.RunUntil(100);
  // 200 pulses to rest: 100 on each line.
  EXPECT_EQ(test.profile(0).position, 1000);
  EXPECT_NEAR(test.profile(1).position, 100, 1e-9);
  SetOverride(&test, 1);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(1).position, 1000);
}

TEST(CrdOverride, OfZeroLeavesTheSegmentsOfTheSecondOverrideAlone) {
  CrdRunTest test;
  PathSlot rapid;
  rapid.is_segment = true;
  rapid.segment = *MakeLine({}, {100, 0});
  rapid.velocity = 10;
  rapid.acceleration = 1;
  rapid.second_override = true;
  ASSERT_TRUE(test.core.CrdAt(0).Append(0, rapid));
  ASSERT_TRUE(test.Line({200, 0}, 10, 1));
  test.crd().override_ratio = 0;
  test.Start();
  test.RunUntil(100);
  EXPECT_EQ(test.profile(0).position, 100);
  EXPECT_EQ(test.crd().run.wait, CrdWait::kOverride);
  SetOverride(&test, 1);
  EXPECT_EQ(test.TicksToEnd(), 20);
  EXPECT_EQ(test.profile(0).position, 200);
}

TEST(CrdOverride, AStopEndsAHeldRun) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({1000, 0}, 10, 1));
  test.Start();
  test.RunUntil(50);
  SetOverride(&test, 0);
  test.RunUntil(100);
  const double held = test.profile(0).position;
  test.core.CrdAt(0).Stop(false);
  EXPECT_FALSE(test.running());
  SetOverride(&test, 1);
  test.Start();
  test.TicksToEnd();
  EXPECT_LT(held, 1000);
  EXPECT_EQ(test.profile(0).position, 1000);
}

// --- Joints of a list ----------------------------------------------------------------------------

/// A segment of a list along X.
struct ListedSegment {
  double length, feed;
  bool rests = false;
  double end_velocity = kUnlimited;
  // Expected: the largest velocity, that at the end, and the time until then.
  double peak = 0;
  double end = 0;
  double time = 0;
};

class ListTest : public CrdRunTest {
 public:
  explicit ListTest(double start_velocity = 0.5, double acceleration = 0.5)
      : acceleration_(acceleration) {
    crd().start.velocity = start_velocity;
    fifo().list.joints = JointRule::kFeeds;
  }

  bool Append(const ListedSegment& added) {
    // A segment that rests at its end does so at its start, too.
    if (added.rests) crd().RestAfterLast(0, core.now());
    const double begin = fifo().idle() ? core.CrdPosition(0)[0] : fifo().tail[0];
    PathSlot slot;
    slot.is_segment = true;
    slot.segment = *MakeLine({begin}, {begin + added.length});
    slot.velocity = added.feed;
    slot.acceleration = acceleration_;
    slot.end_velocity = added.end_velocity;
    slot.ends_at_rest = added.rests;
    return core.CrdAt(0).Append(0, slot);
  }

 private:
  double acceleration_;
};

struct ListCase {
  const char* name;
  double acceleration;
  std::vector<ListedSegment> segments;
};

const ListCase kListCases[] = {
    // Example 6-3: every segment is too short for its feed.
    {"short",
     1.8,
     {{14.1421356, 100, false, kUnlimited, 7.15273991, 7.15273991, 3.69596662},
      {30.3597001, 100, false, kUnlimited, 10.5607868, 7.91225815, 7.06073085},
      {17.3205081, 100, false, kUnlimited, 7.91225815, 0.5, 11.1786521}}},
    // The lower of both feeds; the third segment ends at rest because the fourth begins there.
    {"feeds",
     0.5,
     {{4000, 20, false, kUnlimited, 20, 20, 219.0125},
      {6000, 40, false, kUnlimited, 40, 10, 401.5125},
      {500, 10, false, kUnlimited, 10, 0.5, 460.5375},
      {8000, 50, true, kUnlimited, 50, 0.5, 718.5475},
      {3000, 30, false, kUnlimited, 30, 0.5, 876.564167}}},
    // End velocities that are given for one segment each; 0 is a rest.
    {"given",
     0.5,
     {{4000, 20, false, 5, 20, 5, 230.2625},
      {6000, 25, false, kUnlimited, 25, 20, 487.2625},
      {3000, 20, false, 0, 20, 0.5, 656.275},
      {2000, 20, false, kUnlimited, 20, 0.5, 794.3}}}};

TEST(SegmentList, JoinsTheHashOnlyInUse) {
  EXPECT_EQ(StateHash().Add(SegmentList{}).value(), StateHash().value());
  EXPECT_NE(StateHash().Add(SegmentList{JointRule::kFeeds}).value(), StateHash().value());
}

TEST(SegmentList, JointsFollowFromTheFeeds) {
  for (const ListCase& list : kListCases) {
    SCOPED_TRACE(list.name);
    ListTest test(0.5, list.acceleration);
    for (const ListedSegment& segment : list.segments) ASSERT_TRUE(test.Append(segment));
    test.Start();
    std::vector<Plan> plans(list.segments.size());
    std::vector<double> begins(list.segments.size());
    while (test.running()) {
      test.core.Tick();
      if (!test.running()) break;
      plans[static_cast<size_t>(test.fifo().done)] = test.crd().run.plan;
      begins[static_cast<size_t>(test.fifo().done)] = test.crd().run.at;
    }
    for (size_t i = 0; i < plans.size(); ++i) {
      SCOPED_TRACE(i);
      double peak = plans[i].end_velocity;
      for (size_t k = 0; k < plans[i].count; ++k) {
        peak = std::max(peak, plans[i].pieces[k].velocity);
      }
      EXPECT_NEAR(peak, list.segments[i].peak, 1e-7);
      EXPECT_NEAR(plans[i].end_velocity, list.segments[i].end, 1e-8);
      EXPECT_NEAR(begins[i] + plans[i].duration, list.segments[i].time, 1e-6);
    }
  }
}

// A list of which not all is known when it starts is as fast as one that is known, if every segment
// comes before the path begins to brake for the end of what is known.
TEST(SegmentList, AppendedSegmentsRaiseTheVelocitiesBeforeThem) {
  for (const ListCase& list : kListCases) {
    SCOPED_TRACE(list.name);
    ListTest test(0.5, list.acceleration);
    ASSERT_TRUE(test.Append(list.segments[0]));
    test.Start();
    test.core.Tick();
    for (size_t i = 1; i < list.segments.size(); ++i) ASSERT_TRUE(test.Append(list.segments[i]));
    test.TicksToEnd();
    EXPECT_NEAR(test.crd().run.at, list.segments.back().time, 1e-6);
  }
}

TEST(SegmentList, ASegmentThatIsAppendedWhileThePathBrakesMakesItFasterAgain) {
  ListTest test(0, 1);
  ASSERT_TRUE(test.Append({500, 20}));
  test.Start();
  test.RunUntil(35);  // 20 ms and 200 pulses up, 5 ms and 100 at 20, 10 ms down to 10
  EXPECT_NEAR(test.crd().run.velocity, 10, 1e-9);
  ASSERT_TRUE(test.Append({500, 20}));
  test.core.Tick();
  EXPECT_NEAR(test.crd().run.velocity, 11, 1e-9);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 1000);
}

TEST(SegmentList, OutputsBetweenSegmentsDoNotChangeTheirJoint) {
  for (const bool outputs : {false, true}) {
    ListTest test(0, 1);
    ASSERT_TRUE(test.Append({500, 20}));
    if (outputs) {
      ASSERT_TRUE(
          test.Command({BufferedKind::kOutputs, static_cast<int>(DoType::kGpo), 0, {1, 1}}));
    }
    ASSERT_TRUE(test.Append({500, 20}));
    test.Start();
    // 20 ms and 200 pulses at each end, 600 at 20.
    EXPECT_EQ(test.TicksToEnd(), 70);
  }
}

TEST(SegmentList, ADelayMakesTheSegmentBeforeItRest) {
  ListTest test(0, 1);
  ASSERT_TRUE(test.Append({400, 20}));
  ASSERT_TRUE(test.Delay(15));
  ASSERT_TRUE(test.Append({400, 20}));
  test.Start();
  EXPECT_EQ(test.TicksToEnd(), 40 + 15 + 40);
}

TEST(SegmentList, AnOverrideScalesTheJoints) {
  ListTest test(0, 1);
  test.crd().override_ratio = 0.5;
  ASSERT_TRUE(test.Append({200, 20}));
  ASSERT_TRUE(test.Append({150, 10}));
  test.Start();
  // 10 ms and 50 pulses to 10, 112.5 at 10 and 5 ms and 37.5 to 5; 137.5 at 5, 5 ms to rest.
  test.TicksToEnd();
  EXPECT_NEAR(test.crd().run.at, 10 + 11.25 + 5 + 27.5 + 5, 1e-9);
}

TEST(SegmentList, AnOverrideOfZeroBrakesAcrossItsJoints) {
  ListTest test(0, 1);
  ASSERT_TRUE(test.Append({1000, 20}));
  ASSERT_TRUE(test.Append({1000, 20}));
  test.Start();
  test.RunUntil(55);  // 200 + 35 * 20 = 900
  SetOverride(&test, 0);
  test.RunUntil(100);
  EXPECT_NEAR(test.profile(0).position, 1100, 1e-9);
  EXPECT_EQ(test.crd().run.wait, CrdWait::kOverride);
  SetOverride(&test, 1);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 2000);
}

// What the path is slow for when it goes on does not make it brake harder.
TEST(SegmentList, AStopBrakesAcrossJointsWithItsOwnDeceleration) {
  ListTest test(0, 1);
  test.crd().smooth_stop = 0.5;
  ASSERT_TRUE(test.Append({1000, 20}));
  ASSERT_TRUE(test.Append({1000, 5}));
  test.Start();
  test.RunUntil(50);  // 200 + 30 * 20 = 800, which is 12.5 pulses before it would brake to 5
  test.core.CrdAt(0).Stop(false);
  EXPECT_EQ(test.TicksToEnd(), 40);
  EXPECT_NEAR(test.profile(0).position, 800 + 400, 1e-9);
}

// --- Open lists ----------------------------------------------------------------------------------

TEST(OpenList, MakesARunWaitForMoreSegments) {
  ListTest test(0, 1);
  test.core.CrdAt(0).OpenList(0);
  test.Start();
  test.RunUntil(10);
  EXPECT_EQ(test.crd().run.wait, CrdWait::kData);
  ASSERT_TRUE(test.Append({400, 20}));
  test.RunUntil(49);
  EXPECT_GT(test.crd().run.velocity, 0);
  test.RunUntil(50);
  EXPECT_EQ(test.profile(0).position, 400);
  EXPECT_EQ(test.crd().run.wait, CrdWait::kData);
  EXPECT_EQ(test.crd().run.velocity, 0);
  EXPECT_TRUE(test.profile(0).moving);
  test.RunUntil(100);
  // A command acts at once.
  ASSERT_TRUE(test.Command({BufferedKind::kOutputs, static_cast<int>(DoType::kGpo), 0, {1, 1}}));
  ASSERT_TRUE(test.Append({100, 20}));
  test.core.CrdAt(0).CloseList(0);
  EXPECT_EQ(test.TicksToEnd(), 20);
  EXPECT_EQ(test.core.state().io.Register(DoType::kGpo), 0x1u);
  EXPECT_EQ(test.profile(0).position, 500);
}

TEST(OpenList, EndsAWaitingRunWhenItIsClosed) {
  ListTest test(0, 1);
  test.core.CrdAt(0).OpenList(0);
  ASSERT_TRUE(test.Append({400, 20}));
  test.Start();
  test.RunUntil(60);
  EXPECT_TRUE(test.running());
  test.core.CrdAt(0).CloseList(0);
  EXPECT_FALSE(test.running());
  EXPECT_FALSE(test.profile(0).moving);
}

TEST(OpenList, EndsAWaitingRunAtAStop) {
  ListTest test(0, 1);
  test.core.CrdAt(0).OpenList(0);
  test.Start();
  test.RunUntil(10);
  test.core.CrdAt(0).Stop(false);
  EXPECT_FALSE(test.running());
}

// --- Approaches and lines back -------------------------------------------------------------------

/// A line to a point from wherever the path is, with the coordinates of the set `axes`.
PathSlot ApproachTo(const Coordinates& end, uint8_t axes, double velocity, double acceleration) {
  PathSlot slot;
  slot.is_segment = true;
  slot.segment.end = end;
  slot.velocity = velocity;
  slot.acceleration = acceleration;
  slot.ends_at_rest = true;
  slot.approach.axes = axes;
  return slot;
}

TEST(Approach, JoinsTheHashOnlyInUse) {
  EXPECT_EQ(StateHash().Add(PathApproach{}).value(), StateHash().value());
  EXPECT_NE(StateHash().Add(PathApproach{3}).value(), StateHash().value());
}

TEST(Approach, BeginsWhereverThePathIs) {
  CrdRunTest test;
  ASSERT_TRUE(test.core.CrdAt(0).Append(0, ApproachTo({300, 400}, 3, 20, 1)));
  ASSERT_TRUE(test.Line({300, 800}, 20, 1));
  test.core.ProfileAt(1).SetPosition(800);
  test.Start();
  test.RunUntil(10);
  // 50 of 500 pulses towards (300, 400).
  EXPECT_NEAR(test.profile(0).position, 30, 1e-9);
  EXPECT_NEAR(test.profile(1).position, 800 - 40, 1e-9);
  test.RunUntil(45);  // 20 ms each way, 5 ms at 20
  EXPECT_EQ(test.profile(0).position, 300);
  EXPECT_EQ(test.profile(1).position, 400);
  EXPECT_EQ(test.fifo().done, 1);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(1).position, 800);
}

TEST(Approach, LeavesOtherCoordinatesWhereTheyAre) {
  CrdRunTest test(1000, 3);
  ASSERT_TRUE(test.core.CrdAt(0).Append(0, ApproachTo({300, 400, 7}, 3, 20, 1)));
  test.core.ProfileAt(2).SetPosition(50);
  test.Start();
  EXPECT_EQ(test.TicksToEnd(), 45);
  EXPECT_EQ(test.profile(0).position, 300);
  EXPECT_EQ(test.profile(2).position, 50);
}

TEST(Approach, WithoutLengthIsLeftOut) {
  CrdRunTest test;
  ASSERT_TRUE(test.core.CrdAt(0).Append(0, ApproachTo({}, 3, 20, 1)));
  ASSERT_TRUE(test.Line({400, 0}, 20, 1));
  test.Start();
  EXPECT_EQ(test.TicksToEnd(), 40);
  EXPECT_EQ(test.fifo().done, 2);
}

TEST(Approach, ThatWasStoppedIsMadeAnew) {
  CrdRunTest test;
  ASSERT_TRUE(test.core.CrdAt(0).Append(0, ApproachTo({300, 400}, 3, 20, 1)));
  test.Start();
  test.RunUntil(20);
  test.core.CrdAt(0).Stop(true);
  test.TicksToEnd();
  test.core.ProfileAt(0).SetPosition(0);
  test.core.ProfileAt(1).SetPosition(0);
  test.core.CrdAt(0).Resume(0, {});
  EXPECT_EQ(test.TicksToEnd(), 45);
  EXPECT_EQ(test.profile(0).position, 300);
  EXPECT_EQ(test.profile(1).position, 400);
  EXPECT_EQ(test.fifo().done, 1);
}

/// A run that was stopped in the first of two lines, along X, and whose Y was moved to 300.
class InterruptedRun : public CrdRunTest {
 public:
  InterruptedRun() {
    crd().start.velocity = 0.5;
    crd().smooth_stop = 1;
    EXPECT_TRUE(Line({600, 0}, 10, 1));
    EXPECT_TRUE(Line({600, 100}, 10, 1));
    Start();
    RunUntil(30);
    core.CrdAt(0).Stop(false);
    TicksToEnd();
    stopped = profile(0).position;
    core.ProfileAt(1).SetPosition(300);
    back.velocity = 20;
    back.acceleration = 2;
  }

  double stopped;
  PathSlot back;
};

TEST(ResumeCrd, GoesBackToTheBreakpointAndOn) {
  InterruptedRun test;
  test.core.CrdAt(0).Resume(0, test.back);
  EXPECT_EQ(test.fifo().Remaining(), 2u);
  test.core.Tick();
  // The line back begins with the start velocity.
  EXPECT_NEAR(test.profile(1).position, 300 - 0.5 - 1, 1e-9);
  while (test.fifo().interruption) {
    test.core.Tick();
    EXPECT_TRUE(!test.fifo().interruption || test.profile(0).position == test.stopped);
  }
  // 300 pulses: 9.75 ms up and down, 9.75 * 20.5 pulses; the rest at 20.
  EXPECT_NEAR(test.crd().run.at, 2 * 9.75 + (300 - 9.75 * 20.5) / 20, 1e-9);
  EXPECT_EQ(test.profile(1).position, 0);
  EXPECT_NEAR(test.crd().run.velocity, 0.5, 1);
  EXPECT_EQ(test.fifo().done, 0);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 600);
  EXPECT_EQ(test.profile(1).position, 100);
  EXPECT_EQ(test.fifo().done, 2);
}

TEST(ResumeCrd, LeavesOutALineWithoutLength) {
  InterruptedRun test;
  test.core.ProfileAt(1).SetPosition(0);
  test.core.CrdAt(0).Resume(0, test.back);
  EXPECT_FALSE(test.fifo().interruption);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 600);
}

TEST(ResumeCrd, MakesALineBackThatWasStoppedAnew) {
  InterruptedRun test;
  test.core.CrdAt(0).Resume(0, test.back);
  test.RunUntil(static_cast<double>(test.core.now()) / 1000 + 5);
  test.core.CrdAt(0).Stop(true);
  test.TicksToEnd();
  EXPECT_GT(test.profile(1).position, 200);
  EXPECT_LT(test.profile(1).position, 300);
  EXPECT_EQ(test.fifo().Breakpoint(), (Coordinates{test.stopped, 0}));
  test.core.ProfileAt(1).SetPosition(-10);
  test.core.CrdAt(0).Resume(0, test.back);
  test.TicksToEnd();
  EXPECT_EQ(test.profile(0).position, 600);
  EXPECT_EQ(test.profile(1).position, 100);
}

TEST(ResumeCrd, GoesBackBetweenTwoSegments) {
  CrdRunTest test;
  ASSERT_TRUE(test.Line({400, 0}, 20, 1));
  ASSERT_TRUE(test.Delay(100));
  ASSERT_TRUE(test.Line({400, 400}, 20, 1));
  test.Start();
  test.RunUntil(50);
  test.core.CrdAt(0).Stop(false);
  ASSERT_FALSE(test.running());
  test.core.ProfileAt(0).SetPosition(0);
  PathSlot back;
  back.velocity = 20;
  back.acceleration = 1;
  test.core.CrdAt(0).Resume(0, back);
  EXPECT_EQ(test.fifo().Remaining(), 1u);
  EXPECT_EQ(test.TicksToEnd(), 80);
  EXPECT_EQ(test.profile(0).position, 400);
  EXPECT_EQ(test.profile(1).position, 400);
  EXPECT_EQ(test.fifo().done, 2);
}

// --- Random lists --------------------------------------------------------------------------------

/// A list on a bare coordinate system, to which segments are appended while it runs.
class RandomList {
 public:
  explicit RandomList(uint32_t seed) : random_(seed) {
    crd_.parameters.dimension = 2;
    crd_.parameters.velocity_max = 60;
    crd_.start.velocity = random_.Between(0, 1) < 0.5 ? 0 : random_.Between(0, 3);
    crd_.smooth_stop = kStop;
    fifo().list = {JointRule::kFeeds, true};
    for (double chance = 1; random_.Between(0, 1) < chance; chance = 0.8) AppendSegment();
  }

  /// Runs to the end, and checks each cycle and the end.
  void Run() {
    crd_.Start(0, false, 0);
    for (int cycle = 1; crd_.run.running; ++cycle) {
      ASSERT_LT(cycle, 20000);
      now_ = cycle * Micros{1000};
      Advance();
      CheckCycle();
      if (testing::Test::HasFatalFailure()) return;
      Disturb(cycle);
    }
    EXPECT_EQ(crd_.position, end_);
    EXPECT_EQ(fifo().done, appended_);
    EXPECT_EQ(crd_.run.velocity, 0);
  }

 private:
  CrdFifo& fifo() { return crd_.fifos[0]; }

  void AppendSegment() {
    PathSlot slot;
    slot.is_segment = true;
    Coordinates next = end_;
    next[0] += random_.Between(1, 60);
    next[1] += random_.Between(-60, 60);
    slot.segment = *MakeLine(end_, next);
    slot.velocity = random_.Between(0.5, 30);
    slot.acceleration = kAcceleration;
    slot.end_velocity = random_.Between(0, 1) < 0.1 ? random_.Between(0, 10) : kUnlimited;
    slot.ends_at_rest = random_.Between(0, 1) < 0.1;
    if (slot.ends_at_rest) crd_.RestAfterLast(0, now_);
    ASSERT_TRUE(crd_.Append(0, slot, now_));
    end_ = next;
    ++appended_;
    if (random_.Between(0, 1) < 0.1) {
      PathSlot delay;
      delay.command = {BufferedKind::kDelay, 0, 0, {random_.Between(0, 5)}};
      ASSERT_TRUE(crd_.Append(0, delay, now_));
    }
  }

  void Advance() {
    before_ = {crd_.run.velocity, crd_.run.stopping, fifo().executing, fifo().done, fifo().path};
    EXPECT_EQ(crd_.Advance(now_), nullptr);
  }

  void CheckCycle() {
    const CrdRun& run = crd_.run;
    ASSERT_LE(run.velocity, 60);
    if (fifo().executing && run.plan.count > 0 && run.velocity > crd_.FeedOf(fifo().current)) {
      // Too fast only while it brakes.
      ASSERT_LE(run.acceleration, 1e-9);
    }
    // At rest the velocity jumps by the start velocity, and it can do so twice in a cycle.
    const double jump = crd_.start.velocity + 1e-9;
    const bool same = before_.executing && fifo().executing && fifo().done == before_.done;
    if (same) {
      ASSERT_GE(fifo().path, before_.path - 1e-9);
      ASSERT_LE(fifo().path - before_.path,
                std::max(run.velocity, before_.velocity) + kAcceleration / 2 + jump);
    }
    ASSERT_LE(run.velocity - before_.velocity, kAcceleration + jump);
    ASSERT_LE(before_.velocity - run.velocity, (before_.stopping ? kStop : kAcceleration) + jump);
  }

  /// What may happen between two cycles.
  void Disturb(int cycle) {
    const double event = random_.Between(0, 1);
    if (cycle > 300) {
      crd_.override_ratio = 1;
      crd_.Replan(now_);
      crd_.CloseList(0);
    } else if (event < 0.05) {
      AppendSegment();
    } else if (event < 0.06) {
      crd_.override_ratio = random_.Between(0, 1) < 0.3 ? 0 : random_.Between(0.1, 1.5);
      crd_.Replan(now_);
    } else if (event < 0.07) {
      crd_.Stop(false, now_);
      stopping_ = crd_.run.running;
    }
    // A stop that has ended is resumed.
    if (!crd_.run.running && (stopping_ || event < 0.07) && !fifo().idle()) {
      stopping_ = false;
      crd_.Start(0, false, now_);
    }
  }

  static constexpr double kAcceleration = 1;
  static constexpr double kStop = 2;

  RandomNumbers random_;
  Crd crd_;
  Micros now_ = 0;
  Coordinates end_{};
  int appended_ = 0;
  bool stopping_ = false;
  struct {
    double velocity;
    bool stopping;
    bool executing;
    int done;
    double path;
  } before_{};
};

TEST(SegmentList, KeepsItsLimitsAndItsEndInAnyRun) {
  const uint32_t lists = RandomCases(100'000u);
  for (uint32_t seed = 0; seed < lists; ++seed) {
    SCOPED_TRACE(seed);
    RandomList(seed).Run();
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace oncard::motion
