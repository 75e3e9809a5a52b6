// Rounds of a recording as segments and as text.
#include "vm/recording.h"

#include <gtest/gtest.h>

#include "tests/vm/program_builder.h"
#include "tests/vm/random_program.h"

namespace oncard::vm {
namespace {

using Segments = std::vector<ScheduleSegment>;

TEST(RecordingTest, ARoundBeginsWithItsFirstThreadAndGoesOnInAscendingOrder) {
  Recording recording;
  recording.AddRounds({1u << 3 | 1u << 10 | 1u << 31, 10, 2});
  EXPECT_EQ(ScheduleOf(recording).segments,
            (Segments{{10, 1}, {31, 1}, {3, 1}, {10, 1}, {31, 1}, {3, 1}}));
}

TEST(RecordingTest, StatementsOfOneThreadThatFollowEachOtherAreOneSegment) {
  Recording recording;
  recording.AddTurn(2, 3);
  recording.AddRounds({1u << 2 | 1u << 5, 2, 2});
  recording.AddRounds({1u << 5 | 1u << 6, 5, 1});
  recording.AddTurn(6, 4);
  EXPECT_EQ(ScheduleOf(recording).segments, (Segments{{2, 4}, {5, 1}, {2, 1}, {5, 2}, {6, 5}}));
}

TEST(RecordingTest, RoundsThatAreAlikeAreKeptOnce) {
  Recording recording;
  for (int i = 0; i < 1000; ++i) recording.AddRounds({7, 1, 1'000'000});
  ASSERT_EQ(recording.rounds.size(), 1u);
  EXPECT_EQ(recording.rounds[0].rounds, 1'000'000'000);
  recording.AddRounds({7, 2, 1});
  EXPECT_EQ(recording.rounds.size(), 2u) << "another order";
}

TEST(RecordingTest, TurnsThatMakeRoundsAreKeptAsRounds) {
  Recording recording;
  for (int i = 0; i < 1000; ++i) {
    for (const int thread : {30, 2, 7}) recording.AddTurn(thread, 1);
  }
  ASSERT_EQ(recording.rounds.size(), 1u);
  EXPECT_EQ(recording.rounds[0].threads, 1u << 30 | 1u << 2 | 1u << 7);
  EXPECT_EQ(recording.rounds[0].first, 30);
  EXPECT_EQ(recording.rounds[0].rounds, 1000);
}

TEST(RecordingTest, TurnsKeepTheirOrder) {
  RandomNumbers random(5);
  for (int i = 0; i < 3000; ++i) {
    Recording recording;
    Segments expected;
    const auto threads = random.Between(1, 5);
    auto thread = random.Between(0, 31);
    for (int turn = 0; turn < 60; ++turn) {
      thread = random.OneIn(8) ? random.Between(0, 31) : (thread + 7) % (7 * threads);
      const int64_t statements = random.OneIn(8) ? 2 : 1;
      recording.AddTurn(static_cast<int>(thread % 32), statements);
      const auto number = static_cast<uint8_t>(thread % 32);
      if (expected.empty() || expected.back().thread != number) expected.push_back({number, 0});
      expected.back().statements += statements;
    }
    ASSERT_EQ(ScheduleOf(recording).segments, expected) << i;
  }
}

// Rounds of one to four threads, and checkpoints at any of their statements.
Recording RandomRecording(RandomNumbers& random) {
  Recording recording;
  recording.program_hash = 1;
  recording.scenario = "program = \"p.c\"\n";
  int64_t total = 0;
  for (int i = 0; i < 6; ++i) {
    RecordedRounds rounds;
    while (rounds.threads == 0 || random.OneIn(2)) {
      rounds.first =
          static_cast<uint8_t>(random.OneIn(2) ? random.Between(0, 3) : random.Between(0, 31));
      rounds.threads |= uint32_t{1} << rounds.first;
    }
    rounds.rounds = random.Between(1, 12);
    recording.AddRounds(rounds);
    total += rounds.rounds * std::popcount(rounds.threads);
  }
  for (int64_t at = random.Between(1, 20); at <= total; at += random.Between(1, 20)) {
    recording.checkpoints.push_back({at, static_cast<uint64_t>(at)});
  }
  if (random.OneIn(2)) recording.cut_us = 250;
  return recording;
}

TEST(RecordingTest, ItsTextIsThatOfItsSchedule) {
  RandomNumbers random(7);
  for (int i = 0; i < 3000; ++i) {
    const Recording recording = RandomRecording(random);
    const Schedule schedule = ScheduleOf(recording);
    const std::string text = FormatRecording(recording);
    ASSERT_EQ(text, FormatSchedule(schedule)) << i;
    const auto read = ParseSchedule(text);
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read.value(), schedule) << i;
  }
}

}  // namespace
}  // namespace oncard::vm
