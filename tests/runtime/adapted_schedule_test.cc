// Schedules for edited programs: lines are identified by their text.
#include "runtime/scenario/run/adapted_schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/compiler.h"
#include "runtime/scenario/run/scenario_run.h"
#include "tests/compiler/memory_files.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kLostUpdate =
    "int g;\n"
    "int add()\n"
    "{\n"
    "  int r;\n"
    "  r = g;\n"
    "  g = r + 1;\n"
    "  return 0;\n"
    "}\n";

vm::Object Compiled(std::string_view source) {
  auto compilation = compiler::CompileText("p.c", std::string(source), {}, compiler::NoFiles());
  EXPECT_TRUE(compilation.ok());
  return compilation.ok() ? *compilation.object : vm::Object{};
}

/// Two threads that run `add`.
Scenario TwoThreads() {
  Scenario scenario;
  for (int thread = 0; thread < 2; ++thread) {
    ThreadStart start;
    start.thread = thread;
    start.page = thread;
    start.function = "add";
    scenario.threads.push_back(start);
  }
  return scenario;
}

/// The schedule that loses an update: thread 0 reads, thread 1 executes everything, thread 0
/// continues.
vm::Schedule Annotated() {
  vm::Schedule schedule;
  schedule.segments = {{0, 1}, {1, 3}, {0, 2}};
  const auto done = AnnotateSchedule(TwoThreads(), Compiled(kLostUpdate), kLostUpdate, &schedule);
  EXPECT_TRUE(done.ok());
  return schedule;
}

/// The value of g at the end of the adapted schedule.
std::string ReplayOf(std::string_view source, const AdaptedSchedule& adapted) {
  RunOptions options;
  options.replay = std::make_shared<const vm::Schedule>(adapted.schedule);
  const auto result = RunScenario(TwoThreads(), Compiled(source), options);
  EXPECT_TRUE(result.ok() && result.value().passed());
  return result.ok() ? result.value().values[0].elements[0] : "";
}

std::string Edited(std::string_view from, std::string_view to) {
  std::string source(kLostUpdate);
  source.replace(source.find(from), from.size(), to);
  return source;
}

TEST(AnnotateSchedule, SaysWhereEverySegmentStops) {
  EXPECT_EQ(Annotated().stops,
            (std::vector<vm::ScheduleStop>{{6, 1, "g = r + 1;"}, {0, 0, ""}, {0, 0, ""}}));
}

TEST(AnnotateSchedule, RefusesTheScheduleOfAnotherProgram) {
  vm::Schedule schedule;
  schedule.segments = {{0, 4}};
  EXPECT_FALSE(AnnotateSchedule(TwoThreads(), Compiled(kLostUpdate), kLostUpdate, &schedule).ok());
}

TEST(AdaptSchedule, FollowsTheSameProgramExactly) {
  const auto adapted = AdaptSchedule(TwoThreads(), Compiled(kLostUpdate), kLostUpdate, Annotated());
  EXPECT_EQ(adapted.value().schedule.segments, Annotated().segments);
  EXPECT_EQ(adapted.value().followed, 3u);
  EXPECT_EQ(ReplayOf(kLostUpdate, adapted.value()), "1");
}

TEST(AdaptSchedule, PassesOverLinesThatWereAdded) {
  for (const auto& [from, to] : {std::pair{"  r = g;\n", "  r = 0;\n  r = g;\n"},
                                 {"  g = r + 1;\n", "  r = r * 1;\n  g = r + 1;\n"},
                                 {"int g;\n", "int g;\nint h;\n\n"},
                                 {"  return 0;\n", "  g = g + 0;\n  return 0;\n"}}) {
    const std::string source = Edited(from, to);
    const auto adapted = AdaptSchedule(TwoThreads(), Compiled(source), source, Annotated());
    ASSERT_TRUE(adapted.ok());
    EXPECT_FALSE(adapted.value().divergence) << to;
    EXPECT_EQ(adapted.value().followed, 3u) << to;
    EXPECT_EQ(ReplayOf(source, adapted.value()), "1") << to;
  }
}

TEST(AdaptSchedule, SaysWhereItCannotFollow) {
  const std::string source = Edited("  r = g;\n  g = r + 1;\n", "  g = g + 1;\n");
  const auto adapted = AdaptSchedule(TwoThreads(), Compiled(source), source, Annotated());
  EXPECT_EQ(adapted.value().followed, 0u);
  EXPECT_EQ(adapted.value().divergence->en,
            "thread 0 no longer reaches 'g = r + 1;' (line 6 of the old program)");
  EXPECT_EQ(ReplayOf(source, adapted.value()), "2");
}

TEST(AdaptSchedule, CountsThePassesOfALoop) {
  constexpr std::string_view kLoop =
      "int g;\n"
      "int add()\n"
      "{\n"
      "  int i;\n"
      "  int cc;\n"
      "  i = 0;\n"
      "L:\n"
      "  g = g * 2;\n"
      "  i = i + 1;\n"
      "  cc = i < 3;\n"
      "  if (cc) goto L;\n"
      "  g = g + 1;\n"
      "  return 0;\n"
      "}\n";
  vm::Schedule schedule;
  schedule.segments = {{0, 5}, {1, 15}, {0, 10}};
  ASSERT_TRUE(AnnotateSchedule(TwoThreads(), Compiled(kLoop), kLoop, &schedule).ok());
  EXPECT_EQ(schedule.stops[0], (vm::ScheduleStop{8, 2, "g = g * 2;"}));
  const auto adapted = AdaptSchedule(TwoThreads(), Compiled(kLoop), kLoop, schedule);
  EXPECT_EQ(adapted.value().schedule.segments, schedule.segments);
}

TEST(AdaptSchedule, NeedsAnAnnotatedSchedule) {
  vm::Schedule schedule;
  schedule.segments = {{0, 1}};
  const auto adapted = AdaptSchedule(TwoThreads(), Compiled(kLostUpdate), kLostUpdate, schedule);
  ASSERT_FALSE(adapted.ok());
  EXPECT_THAT(adapted.error().message.en, HasSubstr("explore --save"));
}

}  // namespace
}  // namespace oncard::runtime
