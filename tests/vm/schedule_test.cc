// Schedule files: their text, the errors of damaged files, recording and replaying.
#include "vm/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/vm/program_builder.h"
#include "tests/vm/random_program.h"

namespace oncard::vm {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

// --- Text ----------------------------------------------------------------------------------------

Schedule Sample() {
  Schedule schedule;
  schedule.program_hash = 0x0123456789ABCDEF;
  schedule.scenario = "program = \"sum.c\"\n\nthreads = 2\n";
  schedule.segments = {{0, 5}, {31, 9996}, {0, 1}};
  schedule.checkpoints = {{10000, 0xFEDCBA9876543210}};
  return schedule;
}

constexpr std::string_view kSampleText =
    "oncard-schedule 1\n"
    "program 0123456789abcdef\n"
    "scenario 3\n"
    "| program = \"sum.c\"\n"
    "| \n"
    "| threads = 2\n"
    "run 0 5\n"
    "run 31 9996\n"
    "check 10000 fedcba9876543210\n"
    "run 0 1\n"
    "end 10002\n";

TEST(ScheduleTextTest, IsWrittenLineByLine) { EXPECT_EQ(FormatSchedule(Sample()), kSampleText); }

TEST(ScheduleTextTest, SaysWhereSegmentsStop) {
  Schedule schedule = Sample();
  schedule.stops = {{6, 1, "g = r + 1;"}, {12, 300, "goto  lbl;"}, {0, 0, ""}};
  const std::string text = FormatSchedule(schedule);
  EXPECT_THAT(text, HasSubstr("run 0 5\nnext 6 1 g = r + 1;\nrun 31"));
  EXPECT_THAT(text, HasSubstr("run 0 1\nnext 0 0\nend"));
  const auto read = ParseSchedule(text);
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_EQ(read.value(), schedule);
  // There is a `next` line after each segment or after none.
  std::string some = text;
  some.erase(some.find("next 12"), some.find("check") - some.find("next 12"));
  EXPECT_FALSE(ParseSchedule(some).ok());
}

TEST(ScheduleTextTest, IsReadBack) {
  const auto schedule = ParseSchedule(kSampleText);
  ASSERT_TRUE(schedule.ok()) << schedule.error().message.en;
  EXPECT_EQ(schedule.value(), Sample());
}

TEST(ScheduleTextTest, SaysWhereTheRunWasCutOff) {
  Schedule schedule = Sample();
  schedule.cut_us = 5'000'250;
  const std::string text = FormatSchedule(schedule);
  EXPECT_THAT(text, EndsWith("run 0 1\ncut 5000250\nend 10002\n"));
  const auto read = ParseSchedule(text);
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_EQ(read.value(), schedule);
}

TEST(ScheduleTextTest, EmptyScheduleSurvives) {
  const auto schedule = ParseSchedule(FormatSchedule({}));
  ASSERT_TRUE(schedule.ok());
  EXPECT_EQ(schedule.value(), Schedule{});
}

TEST(ScheduleTextTest, CarriageReturnsAndAMissingLastNewlineDoNoHarm) {
  std::string text;
  for (const char c : kSampleText) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  text.resize(text.size() - 2);
  const auto schedule = ParseSchedule(text);
  ASSERT_TRUE(schedule.ok()) << schedule.error().message.en;
  EXPECT_EQ(schedule.value(), Sample());
}

TEST(ScheduleTextTest, DamageIsReportedWithItsLine) {
  const std::string head = "oncard-schedule 1\nprogram 1\nscenario 0\n";
  const std::string run = "expected 'run', a thread 0 to 31 and a number of statements";
  const std::string check = "expected 'check', a statement number already reached and a hash";
  const struct {
    std::string text;
    int line;
    std::string expected;
  } kCases[] = {
      {"", 1, "expected 'oncard-schedule 1'"},
      {"oncard-schedule 2\n", 1, "expected 'oncard-schedule 1'"},
      {"oncard-schedule 1\n", 2, "expected 'program' and its hash"},
      {"oncard-schedule 1\nprogram\n", 2, "expected 'program' and its hash"},
      {"oncard-schedule 1\nprogram xyz\n", 2, "expected 'program' and its hash"},
      {"oncard-schedule 1\nprogram 10000000000000000\n", 2, "expected 'program' and its hash"},
      {"oncard-schedule 1\nprogram 1\nend 0\n", 3, "expected 'scenario' and a number of lines"},
      {"oncard-schedule 1\nprogram 1\nscenario -1\n", 3,
       "expected 'scenario' and a number of lines"},
      {"oncard-schedule 1\nprogram 1\nscenario 2\n| a\nend 0\n", 5,
       "expected a scenario line after '| '"},
      {"oncard-schedule 1\nprogram 1\nscenario 1\n", 4, "expected a scenario line after '| '"},
      {head + "run 32 1\nend 1\n", 4, run},
      {head + "run -1 1\nend 1\n", 4, run},
      {head + "run 0 0\nend 0\n", 4, run},
      {head + "run 0\nend 0\n", 4, run},
      {head + "run 0 1 2\nend 1\n", 4, run},
      {head + "run 0 9223372036854775807\nrun 0 1\nend 0\n", 5, run},
      {head + "run 0 5\ncheck 6 1\nend 5\n", 5, check},
      {head + "run 0 5\ncheck 0 1\nend 5\n", 5, check},
      {head + "run 0 5\ncheck 5 1\ncheck 5 1\nend 5\n", 6, check},
      {head + "run 0 5\ncheck 5\nend 5\n", 5, check},
      {head + "run 0 5\nend 4\n", 5, "expected 'end 5' as the last line"},
      {head + "run 0 5\nend 5\nrun 0 1\n", 5, "expected 'end 5' as the last line"},
      {head + "walk 0 5\n", 4, "expected 'run', 'check', 'cut' or 'end'"},
      {head + "cut -1\nend 0\n", 4, "expected one 'cut' and a time in us"},
      {head + "cut\nend 0\n", 4, "expected one 'cut' and a time in us"},
      {head + "cut 1\ncut 1\nend 0\n", 5, "expected one 'cut' and a time in us"},
      {head + "run 0 5\n", 4, "expected 'end': the file is truncated"},
      {head, 3, "expected 'end': the file is truncated"},
  };
  for (const auto& c : kCases) {
    const auto schedule = ParseSchedule(c.text);
    ASSERT_FALSE(schedule.ok()) << c.text;
    EXPECT_EQ(schedule.error().message.en,
              fmt::format("line {} of the schedule: {}", c.line, c.expected));
    EXPECT_THAT(schedule.error().message.zh, StartsWith(fmt::format("调度文件第 {} 行", c.line)));
  }
}

TEST(ScheduleTextTest, EveryCutIsNoticed) {
  for (size_t length = 0; length + 1 < kSampleText.size(); ++length) {
    EXPECT_FALSE(ParseSchedule(kSampleText.substr(0, length)).ok()) << length;
  }
}

// --- Record and replay ---------------------------------------------------------------------------

class ReplayTest : public MachineTest {
 protected:
  static Policy Replay(const Schedule& schedule) {
    Policy policy;
    policy.kind = PolicyKind::kReplay;
    policy.schedule = std::make_shared<Schedule>(schedule);
    return policy;
  }

  // Two endless threads that increment a shared variable.
  void StartCounters(const Policy& policy) {
    machine_.SetPolicy(policy);
    Load({MakeFunction({Set(Local(0), Global(0)), Add(Local(0), Local(0), ImmediateInt(1)),
                        Set(Global(0), Local(0)), Goto(-3)})});
    Start(0);
    Start(1);
  }

  Schedule RecordCounters(int64_t statements) {
    StartCounters(ParsePolicy("random:3").value());
    Recording recording;
    machine_.Record(&recording);
    machine_.Execute(statements);
    machine_.Record(nullptr);
    return ScheduleOf(recording);
  }
};

TEST_F(ReplayTest, ReplayOfAnyPolicyEndsInTheSameState) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    for (const char* name : {"rr", "rr:3", "priority", "random:5", "pct:5:4:300"}) {
      RandomNumbers random(seed);
      const RandomProgram program = MakeRandomProgram(random);
      StartProgram(program, ParsePolicy(name).value(), commands_, &machine_);
      Recording recording;
      machine_.Record(&recording);
      const int64_t executed = machine_.Execute(300) + machine_.Execute(200);
      machine_.Record(nullptr);
      const uint64_t hash = machine_.Hash();
      StartProgram(program, ParsePolicy(name).value(), commands_, &machine_);
      EXPECT_EQ(machine_.Execute(500), executed);
      EXPECT_EQ(machine_.Hash(), hash) << "recording changes nothing";

      const auto read = ParseSchedule(FormatRecording(recording));
      ASSERT_TRUE(read.ok());
      StartProgram(program, Replay(read.value()), commands_, &machine_);
      int64_t replayed = 0;
      while (replayed < executed) {
        const int64_t some = machine_.Execute(37);
        if (some == 0) break;
        replayed += some;
      }
      EXPECT_EQ(replayed, executed) << name << ' ' << seed;
      EXPECT_EQ(machine_.Hash(), hash) << name << ' ' << seed;
    }
  }
}

// Statements that are executed at once run ahead of each other; one after the other they do not.
TEST_F(ReplayTest, RecordingIsTheSameHoweverMuchIsExecutedAtOnce) {
  int64_t in_the_middle = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    RandomNumbers random(seed);
    const RandomProgram program = MakeRandomProgram(random);
    const auto record = [&](int64_t piece) {
      Machine machine(&commands_);
      StartProgram(program, {}, commands_, &machine);
      Recording recording;
      machine.Record(&recording);
      for (int64_t cycle = 1; cycle <= 2; ++cycle) {
        for (int64_t left = 5500; left > 0; left -= piece) {
          if (machine.Execute(std::min(piece, left)) == 0) break;
        }
        machine.BeginCycle(cycle);
      }
      machine.EndRecording();
      return recording;
    };
    const Recording one_by_one = record(1);
    in_the_middle += std::ranges::count_if(
        one_by_one.checkpoints, [](const auto& at) { return at.statement == kCheckpointInterval; });
    for (const int64_t piece : {37, 5500}) {
      ASSERT_EQ(FormatRecording(record(piece)), FormatRecording(one_by_one))
          << seed << ' ' << piece;
    }
  }
  EXPECT_GT(in_the_middle, 0) << "some programs must come to the checkpoint in the middle";
}

TEST_F(ReplayTest, CheckpointsAreRecordedAndMet) {
  const Schedule schedule = RecordCounters(25000);
  const uint64_t hash = machine_.Hash();
  ASSERT_EQ(schedule.checkpoints.size(), 2u);
  EXPECT_EQ(schedule.checkpoints[0].statement, 10000);
  EXPECT_EQ(schedule.checkpoints[1].statement, 20000);
  StartCounters(Replay(schedule));
  EXPECT_EQ(machine_.Execute(10000), 10000);
  EXPECT_EQ(machine_.Hash(), schedule.checkpoints[0].hash);
  EXPECT_EQ(machine_.Execute(1000000), 15000);
  EXPECT_EQ(machine_.last_stop(), Stop::kScheduleEnd);
  EXPECT_EQ(machine_.Hash(), hash);
}

TEST_F(ReplayTest, AnotherStateAtACheckpointIsADivergence) {
  const Schedule schedule = RecordCounters(25000);
  StartCounters(Replay(schedule));
  SetGlobalInt(0, 1);
  EXPECT_EQ(machine_.Execute(25000), 10000);
  EXPECT_EQ(machine_.last_stop(), Stop::kScheduleDiverged);
}

TEST_F(ReplayTest, ThreadThatCannotRunIsADivergence) {
  Schedule schedule;
  schedule.segments = {{0, 3}, {5, 1}, {0, 1}};
  StartCounters(Replay(schedule));
  EXPECT_EQ(machine_.Execute(10), 3);
  EXPECT_EQ(machine_.last_stop(), Stop::kScheduleDiverged);
}

TEST_F(ReplayTest, SingleStepsAreRecordedToo) {
  StartCounters({});
  Recording recording;
  machine_.Record(&recording);
  for (const int thread : {1, 1, 0, 1}) machine_.ExecuteOne(thread);
  machine_.Execute(1);
  machine_.Pause(1);
  machine_.Step(1);
  EXPECT_EQ(ScheduleOf(recording).segments,
            (std::vector<ScheduleSegment>{{1, 2}, {0, 1}, {1, 1}, {0, 1}, {1, 1}}));
}

}  // namespace
}  // namespace oncard::vm
