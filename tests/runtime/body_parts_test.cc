// The body of a card in parts: what belongs to which, and that together they are the body.
#include "runtime/sim/body_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "tests/motion/change_state.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr size_t kAxes = 4;
constexpr size_t kThirdAxis = BodyDivision::kFirstAxis + 2;

/// A card whose program has just been started.
class Started {
 public:
  explicit Started(const std::string& statements, const std::string& keys = {})
      : scenario_(ScenarioForTest("axes = 4\n" + keys)), card_(CardOptions(scenario_)) {
    const std::string program = "int f()\n{\n" + statements + "  return 0;\n}\n";
    EXPECT_TRUE(StartScenario(scenario_, CompileForTest(program), &card_).ok());
  }
  Controller& card() { return card_; }
  CardBody After(int cycles) {
    card_.RunCycles(cycles);
    return card_.Body();
  }

 private:
  Scenario scenario_;
  Controller card_;
};

const std::string kJog =
    "  GT_AxisOn(3);\n  GT_PrfJog(3);\n  GT_SetVel(3, 10);\n  GT_Update(4);\n  GT_Delay(100);\n";

std::vector<uint64_t> ValuesOf(const CardBody& body, size_t part) {
  motion::StateWords words;
  BodyDivision(kAxes).AddValues(body, part, &words);
  return {words.words().begin(), words.words().end()};
}

std::vector<size_t> Differences(const CardBody& one, const CardBody& other) {
  std::vector<size_t> parts;
  for (size_t part = 0; part < BodyDivision(kAxes).part_count(); ++part) {
    if (ValuesOf(one, part) != ValuesOf(other, part)) parts.push_back(part);
  }
  return parts;
}

TEST(BodyParts, AnAxisThatMovesIsOnePart) {
  Started started(kJog);
  const CardBody before = started.After(20);
  EXPECT_THAT(Differences(before, started.After(1)),
              ElementsAre(size_t{BodyDivision::kClock}, kThirdAxis));
}

TEST(BodyParts, WhatIsSetIsInItsPart) {
  Started started({});
  const CardBody before = started.card().Body();
  const auto changed = [&](auto change) {
    started.card().RestoreBody(before);
    change(motion::ChangeState(started.card().motion()));
    return Differences(before, started.card().Body());
  };
  using State = motion::MotionState;
  EXPECT_THAT(changed([](State& state) { state.adcs[1].volts = 2; }),
              ElementsAre(size_t{BodyDivision::kIo}));
  EXPECT_THAT(changed([](State& state) { state.homing[2].running = true; }),
              ElementsAre(kThirdAxis));
  EXPECT_THAT(changed([](State& state) { state.gantry.on = true; }),
              ElementsAre(size_t{BodyDivision::kRest}));
  // Behind the axes that the card has.
  EXPECT_THAT(changed([](State& state) { state.encoders[kAxes].position += 1; }),
              ElementsAre(size_t{BodyDivision::kRest}));
}

TEST(BodyParts, EventsThatAreStillToComeAreAPart) {
  const auto input = [](const char* ms) {
    return std::string("[[world.input]]\nindex = 1\nvalue = 1\nat_ms = ") + ms + "\n";
  };
  Started early({}, input("2"));
  Started late({}, input("4") + input("6"));
  // 250 us a cycle: no event has happened, one of each has, and all have.
  EXPECT_THAT(Differences(early.After(4), late.After(4)),
              ElementsAre(size_t{BodyDivision::kWorld}));
  EXPECT_THAT(Differences(early.After(16), late.After(16)),
              ElementsAre(size_t{BodyDivision::kWorld}));
  const CardBody body = early.After(16);
  CardBody other = late.After(16);
  EXPECT_THAT(Differences(body, other), IsEmpty());
  // The last event of another body is still to come, too.
  const BodyDivision division(kAxes);
  other.motion.world.next = 0;
  division.Put(division.PartOf(body, BodyDivision::kWorld), BodyDivision::kWorld, &other);
  EXPECT_EQ(other.motion.world.next, 2u);
}

TEST(BodyParts, TogetherTheyAreTheBody) {
  Started from(kJog + "  GT_SetDoBit(12, 1, 1);\n");
  Started to("  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 3);\n  GT_Update(1);\n");
  const CardBody body = from.After(30);
  CardBody composed = to.After(10);
  const BodyDivision division(kAxes);
  for (size_t part = 0; part < division.part_count(); ++part) {
    division.Put(division.PartOf(body, part), part, &composed);
  }
  EXPECT_THAT(Differences(body, composed), IsEmpty());
  to.card().RestoreBody(composed);
  EXPECT_EQ(to.card().BodyHash(), from.card().BodyHash());
  // And it goes on as that one does.
  from.After(50);
  to.card().motion().Tick();
  for (int i = 1; i < 50; ++i) to.card().motion().Tick();
  EXPECT_EQ(to.card().motion().Hash(), from.card().motion().Hash());
}

bool LeavesApart(const CardBody& body) {
  const BodyDivision division(kAxes);
  for (size_t part = 0; part < division.part_count(); ++part) {
    if (!division.LeavesAxesApart(body, part)) return false;
  }
  return true;
}

TEST(BodyParts, KnowWhetherAxesDependOnEachOther) {
  EXPECT_TRUE(LeavesApart(Started(kJog).After(20)));
  EXPECT_FALSE(LeavesApart(
      Started("  GT_PrfGear(2, 0);\n  GT_SetGearMaster(2, 1, 2, 0);\n  GT_GearStart(2);\n")
          .After(20)));
  Started gantry({});
  motion::ChangeState(gantry.card().motion()).gantry.on = true;
  EXPECT_FALSE(LeavesApart(gantry.card().Body()));
}

}  // namespace
}  // namespace oncard::runtime
