// How the world of a scenario reacts to its card. A cycle takes 0.25 ms.
#include "runtime/sim/reactions.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "runtime/scenario/run/reaction_conditions.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kReactingProgram =
    "int go, n;\nint f()\n{\n  GT_Delay(100);\n  return 0;\n}\n";
constexpr const char* kReacts = "[[world.react]]\nwhen = \"go == 1\"\nindex = 1\nvalue = 1\n";

/// A card whose thread only waits; the tests write its variables as a host does.
class ReactingCard {
 public:
  explicit ReactingCard(const std::string& world)
      : scenario_(ScenarioForTest(world)), controller_(CardOptions(scenario_)) {
    EXPECT_TRUE(StartScenario(scenario_, CompileForTest(kReactingProgram), &controller_).ok());
  }
  Controller& card() { return controller_; }
  void Set(const std::string& name, double value) {
    EXPECT_TRUE(SetVariable({name, {value}}, name, &controller_).ok());
  }
  uint32_t pins() const { return controller_.motion().state().io.Pins(motion::DiType::kGpi); }
  /// The cycles, of the next `count`, whose end finds other levels than their beginning.
  std::vector<int64_t> Changes(int count) {
    std::vector<int64_t> cycles;
    for (int i = 0; i < count; ++i) {
      const uint32_t before = pins();
      controller_.RunCycle();
      if (pins() != before) cycles.push_back(controller_.cycle());
    }
    return cycles;
  }

 private:
  Scenario scenario_;
  Controller controller_;
};

// --- When ----------------------------------------------------------------------------------------

struct DelayCase {
  const char* after_ms;
  int64_t cycle;
};

class ReactionDelayTest : public testing::TestWithParam<DelayCase> {};

// The condition becomes true in cycle 2 and is looked at with its end, at 0.5 ms. Cycle 3 begins
// there, cycle 4 at 0.75 ms.
TEST_P(ReactionDelayTest, EndsAtTheFirstBoundaryThatIsNotBefore) {
  ReactingCard card(std::string(kReacts) + "after_ms = " + GetParam().after_ms + "\n");
  card.card().RunCycle();
  card.card().RunCycle();
  card.Set("go", 1);
  EXPECT_THAT(card.Changes(300), ElementsAre(GetParam().cycle));
  EXPECT_EQ(card.pins(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Delays, ReactionDelayTest,
                         testing::Values(DelayCase{"0", 3}, DelayCase{"0.1", 4},
                                         DelayCase{"0.25", 4}, DelayCase{"0.3", 5},
                                         DelayCase{"30", 123}));

TEST(Reactions, AConditionThatIsTrueAtTheStartStartsOne) {
  ReactingCard card("[[world.react]]\nwhen = \"go == 0\"\nafter_ms = 0.5\nindex = 1\nvalue = 1\n");
  EXPECT_THAT(card.Changes(10), ElementsAre(3));
}

// The second rise is at 0.5 ms, while the first reaction is pending.
TEST(Reactions, EveryRiseStartsOneAndNoFallCancelsIt) {
  ReactingCard card(
      "[[world.react]]\nwhen = \"go == 1\"\nafter_ms = 2\nindex = 1\nvalue = 1\n"
      "[[world.react]]\nwhen = \"go == 1\"\nafter_ms = 2.25\nindex = 1\nvalue = 0\n");
  card.Set("go", 1);
  card.card().RunCycle();
  card.Set("go", 0);
  card.card().RunCycle();
  card.Set("go", 1);
  card.card().RunCycle();
  EXPECT_EQ(card.card().reactions()->state().pending.size(), 4u);
  // It stays true: no third one.
  EXPECT_THAT(card.Changes(40), ElementsAre(9, 10, 11, 12));
}

TEST(Reactions, OfOneInstantHappenInTheOrderOfTheFileBeforeItsInputs) {
  const std::string off = "[[world.react]]\nwhen = \"go == 1\"\nindex = 1\nvalue = 0\n";
  ReactingCard ends_high(off + kReacts);
  ends_high.Set("go", 1);
  ends_high.card().RunCycle();
  EXPECT_EQ(ends_high.pins(), 1u);
  ReactingCard ends_low(kReacts + off);
  ends_low.Set("go", 1);
  ends_low.card().RunCycle();
  EXPECT_EQ(ends_low.pins(), 0u);
  ReactingCard input("[[world.input]]\nindex = 1\nvalue = 0\nat_ms = 0.25\n" +
                     std::string(kReacts));
  input.card().RunCycle();
  input.Set("go", 1);
  input.card().RunCycle();
  EXPECT_EQ(input.pins(), 0u);
}

TEST(Reactions, ReachAWholeWord) {
  ReactingCard card("[[world.input]]\nvalue = 2\n[[world.react]]\nwhen = \"go\"\nvalue = 0x8001\n");
  card.Set("go", 1);
  card.card().RunCycle();
  EXPECT_EQ(card.pins(), 0x8001u);
}

// The input filter takes three samples, so that the conditions see a change three cycles later.
TEST(Reactions, CanStartEachOther) {
  ReactingCard card(
      "[[world.react]]\nwhen = \"gpi[1] == 0\"\nindex = 1\nvalue = 1\n"
      "[[world.react]]\nwhen = \"gpi[1] == 1\"\nindex = 1\nvalue = 0\n");
  EXPECT_THAT(card.Changes(12), ElementsAre(1, 4, 7, 10));
}

// --- Names ---------------------------------------------------------------------------------------

TEST(Reactions, DoNotStartWhileTheirNamesDoNotExist) {
  const Scenario scenario = ScenarioForTest(
      "[[world.react]]\nwhen = \"go == 0\"\nindex = 1\nvalue = 1\n"
      "[[world.react]]\nwhen = \"axis1.prfPos == 0\"\nindex = 2\nvalue = 1\n");
  Controller card(CardOptions(scenario));
  ApplyWorld(scenario, &card);
  const auto pins = [&] { return card.motion().state().io.Pins(motion::DiType::kGpi); };
  card.RunCycles(4);
  EXPECT_EQ(pins(), 2u);
  EXPECT_EQ(card.reactions()->existed(), 2u);
  EXPECT_EQ(card.reactions()->started(), 2u);
  ASSERT_TRUE(card.Load(CompileForTest(kReactingProgram)).ok());
  card.RunCycle();
  EXPECT_EQ(pins(), 3u);
  // The program is gone, and comes again.
  card.Reset();
  card.RunCycle();
  EXPECT_EQ(card.reactions()->state().held, 2u);
  EXPECT_EQ(card.reactions()->existed(), 3u);
}

TEST(Reactions, NamesThatAProgramDoesNotHaveAreNamedAtTheirPlace) {
  const Scenario scenario =
      ScenarioForTest(std::string(kReacts) + "[[world.react]]\nwhen = \"og == 1\"\nvalue = 1\n");
  const auto fits = CheckScenario(scenario, CompileForTest(kReactingProgram));
  ASSERT_FALSE(fits.ok());
  EXPECT_THAT(fits.error().message.en, HasSubstr("t.toml:7:8: nothing is named 'og'"));
  EXPECT_THAT(fits.error().message.en, Not(HasSubstr("t.toml:3")));
}

// --- State ---------------------------------------------------------------------------------------

TEST(Reactions, ArePartOfTheStateOfTheCard) {
  ReactingCard card(std::string(kReacts) + "after_ms = 1\n");
  const ControllerSnapshot before = card.card().Snapshot();
  card.Set("go", 1);
  card.card().RunCycle();
  const ControllerSnapshot pending = card.card().Snapshot();
  const uint64_t body = card.card().BodyHash();
  const uint64_t hash = card.card().Hash();
  EXPECT_THAT(card.Changes(10), ElementsAre(5));
  const uint64_t end = card.card().Hash();
  // Nothing is left of it.
  card.card().Restore(before);
  EXPECT_THAT(card.Changes(10), IsEmpty());
  // It is pending again.
  card.card().Restore(pending);
  EXPECT_EQ(card.card().Hash(), hash);
  EXPECT_EQ(card.card().BodyHash(), body);
  EXPECT_THAT(card.Changes(10), ElementsAre(5));
  EXPECT_EQ(card.card().Hash(), end);
  // It makes a difference although nothing else does.
  ControllerSnapshot forgotten = pending;
  forgotten.body.reactions->pending.clear();
  card.card().Restore(forgotten);
  EXPECT_NE(card.card().BodyHash(), body);
  EXPECT_NE(card.card().Hash(), hash);
}

TEST(Reactions, ManyCyclesAtOnceAreTheSame) {
  const std::string world =
      "[[world.react]]\nwhen = \"clock >= 3\"\nafter_ms = 4\nindex = 1\nvalue = 1\n";
  ReactingCard one(world);
  EXPECT_THAT(one.Changes(100), ElementsAre(29));
  ReactingCard many(world);
  many.card().RunCycles(100);
  EXPECT_EQ(many.card().Hash(), one.card().Hash());
  ReactingCard quiet(world);
  EXPECT_EQ(quiet.card().RunUntilQuiet(100), RunEnd::kTimeLimit);
  EXPECT_EQ(quiet.card().Hash(), one.card().Hash());
}

TEST(Reactions, GoOnWhileOneIsPending) {
  ReactingCard card(std::string(kReacts) + "after_ms = 1\n");
  card.card().RunCycle();
  EXPECT_FALSE(card.card().GoesOn());
  card.Set("go", 1);
  card.card().RunCycle();
  EXPECT_TRUE(card.card().GoesOn());
  card.card().RunCycles(4);
  EXPECT_FALSE(card.card().GoesOn());
}

// --- What a run says -----------------------------------------------------------------------------

std::vector<std::string> WarningsOf(const std::string& scenario) {
  std::vector<std::string> texts;
  for (const Message& warning : RunForTest(kReactingProgram, scenario).warnings)
    texts.push_back(warning.en);
  return texts;
}

TEST(Reactions, ARunNamesThoseThatNothingStarted) {
  EXPECT_THAT(WarningsOf(kReacts),
              ElementsAre("nothing started the [[world.react]] of 'go == 1': it held at no "
                          "boundary of profile cycles"));
  EXPECT_THAT(WarningsOf(std::string(kReacts) + "[globals]\ngo = 1\n"), IsEmpty());
}

// The thread ends in cycle 401, at 100.25 ms.
TEST(Reactions, ARunNamesThoseThatItsEndCutsOff) {
  EXPECT_THAT(WarningsOf(std::string(kReacts) + "after_ms = 200\n[globals]\ngo = 1\n"),
              ElementsAre("the run ended at 100.25 ms, before the [[world.react]] of 'go == 1' "
                          "acts at 200 ms: 'until_ms' makes it last longer"));
}

// --- Files ---------------------------------------------------------------------------------------

TEST(Reactions, AreWrittenAsTheyAreRead) {
  const std::string text =
      "[[world.react]]\nwhen = \"gpo[1] == 1 && axis1.prfPos > 5\"\nafter_ms = 12.5\n"
      "type = \"home\"\nindex = 2\nvalue = 1\n\n"
      "[[world.react]]\nwhen = \"go\"\nafter_ms = 0\ntype = \"gpi\"\nvalue = 3\n";
  const Scenario scenario = ScenarioForTest(text);
  const std::vector<InputReaction>& read = scenario.world.reactions;
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].when, "gpo[1] == 1 && axis1.prfPos > 5");
  EXPECT_EQ(read[0].after_us, 12'500);
  EXPECT_EQ(read[0].input, (InputEvent{0, motion::DiType::kHome, 2, 1}));
  EXPECT_EQ(read[1].input, (InputEvent{0, motion::DiType::kGpi, 0, 3}));
  EXPECT_EQ(PlaceOfText(scenario, kReactionPlaces, 1).line, 10);
  EXPECT_THAT(FormatScenario(scenario), HasSubstr(text));
}

struct MistakeCase {
  const char* keys;
  const char* message;
};

class ReactionMistakeTest : public testing::TestWithParam<MistakeCase> {};

TEST_P(ReactionMistakeTest, SaysWhatToDo) {
  const auto scenario = ParseScenario(
      std::string("program = \"p.c\"\n[[world.react]]\n") + GetParam().keys, "t.toml");
  ASSERT_FALSE(scenario.ok());
  EXPECT_THAT(scenario.error().message.en, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, ReactionMistakeTest,
    testing::Values(
        MistakeCase{"value = 1\n",
                    "t.toml:2:1: 'when' is missing: the condition, as in \"gpo[1] == 1\""},
        MistakeCase{"when = \"gpo[1] ==\"\nvalue = 1\n", "t.toml:3:8: "},
        MistakeCase{"when = \"a == 1 @ 5ms\"\nvalue = 1\n", "t.toml:3:8: "},
        MistakeCase{"when = 5\nvalue = 1\n", "t.toml:3:8: 'when' must be a string"},
        MistakeCase{"when = \"a\"\n", "'value' is missing: the level of the pin, 0 or 1"},
        MistakeCase{"when = \"a\"\nindex = 1\nvalue = 2\n",
                    "'value' must be a whole number from 0 to 1"},
        MistakeCase{"when = \"a\"\nindex = 17\nvalue = 1\n",
                    "'index' must be a whole number from 1 to 16"},
        MistakeCase{"when = \"a\"\ntype = \"knob\"\nvalue = 1\n", "no inputs are named 'knob'"},
        MistakeCase{"when = \"a\"\nvalue = 1\nafter_ms = -1\n",
                    "t.toml:5:12: 'after_ms' must be a time in ms"},
        MistakeCase{"when = \"a\"\nvalue = 1\nafter_ms = 60000.5\n",
                    "t.toml:5:12: 'after_ms' must be at most 60000"},
        MistakeCase{"when = \"a\"\nvalue = 1\nat_ms = 5\n", "unknown key 'at_ms'"},
        MistakeCase{
            "when = \"a\"\ntype = \"home\"\nindex = 1\nvalue = 1\n"
            "[[world.switch]]\naxis = 1\nfrom = 5\n",
            "t.toml:3:8: a [[world.react]] drives an input that a [[world.switch]] is wired to"}));

TEST(Reactions, ThereAreAtMost64) {
  std::string text = "program = \"p.c\"\n";
  for (int i = 0; i < 64; ++i) text += kReacts;
  EXPECT_TRUE(ParseScenario(text, "t.toml").ok());
  const auto more = ParseScenario(text + kReacts, "t.toml");
  ASSERT_FALSE(more.ok());
  EXPECT_THAT(more.error().message.en,
              HasSubstr("there are more than 64 [[world.react]]: join some of them"));
}

}  // namespace
}  // namespace oncard::runtime
