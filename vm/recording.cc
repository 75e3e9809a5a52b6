#include "vm/recording.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "vm/limits.h"
#include "vm/schedule_text.h"

namespace oncard::vm {
namespace {

/// True for statements in a row of one thread.
bool IsAlone(const RecordedRounds& rounds) { return rounds.threads == uint32_t{1} << rounds.first; }

/// True if a thread can be the next one of a round: it follows the others in their order.
bool ComesAfter(const RecordedRounds& rounds, int thread) {
  const int place = (thread - rounds.first + kThreadCount) % kThreadCount;
  return std::rotr(rounds.threads, rounds.first) >> place == 0;
}

/// The threads of a round, in their order.
class ThreadsOf {
 public:
  explicit ThreadsOf(const RecordedRounds& rounds) {
    for (int i = 0; i < kThreadCount; ++i) {
      const int thread = (rounds.first + i) % kThreadCount;
      if ((rounds.threads >> thread & 1) != 0) threads_[count_++] = static_cast<uint8_t>(thread);
    }
  }
  const uint8_t* begin() const { return threads_.data(); }
  const uint8_t* end() const { return begin() + count_; }
  int64_t size() const { return static_cast<int64_t>(count_); }

 private:
  std::array<uint8_t, kThreadCount> threads_;
  size_t count_ = 0;
};

/// Passes segments on; those of one thread that follow each other become one.
template <typename Take>
class Joined {
 public:
  explicit Joined(const Take& take) : take_(take) {}

  void Add(uint8_t thread, int64_t statements) {
    if (last_.thread != thread) PassOn();
    last_.thread = thread;
    last_.statements += statements;
  }
  void PassOn() {
    if (last_.statements > 0) take_(last_);
    last_ = {};
  }

 private:
  Take take_;
  ScheduleSegment last_;  // not passed on: more may follow
};

/// About the characters of the rounds' lines.
size_t Length(const RecordedRounds& rounds) {
  if (IsAlone(rounds)) return sizeof "run 10 1";
  return static_cast<size_t>(rounds.rounds * std::popcount(rounds.threads)) * sizeof "run 10 1";
}

}  // namespace

void Recording::AddTurn(int thread, int64_t statements) {
  RecordedRounds* last = rounds.empty() ? nullptr : &rounds.back();
  const bool begins =
      last == nullptr || last->rounds != 1 || statements != 1 || !ComesAfter(*last, thread);
  if (begins) return AddRounds({uint32_t{1} << thread, static_cast<uint8_t>(thread), statements});
  last->threads |= uint32_t{1} << thread;
  if (rounds.size() < 2) return;
  // The round may be complete now.
  RecordedRounds& before = last[-1];
  if (before.threads != last->threads || before.first != last->first) return;
  ++before.rounds;
  rounds.pop_back();
}

void Recording::AddRounds(const RecordedRounds& added) {
  if (!rounds.empty() && rounds.back().threads == added.threads &&
      rounds.back().first == added.first) {
    rounds.back().rounds += added.rounds;
  } else {
    rounds.push_back(added);
  }
}

Schedule ScheduleOf(const Recording& recording) {
  Schedule schedule;
  schedule.program_hash = recording.program_hash;
  schedule.scenario = recording.scenario;
  schedule.checkpoints = recording.checkpoints;
  schedule.cut_us = recording.cut_us;
  Joined segments([&](const ScheduleSegment& segment) { schedule.segments.push_back(segment); });
  for (const RecordedRounds& rounds : recording.rounds) {
    if (IsAlone(rounds)) {
      segments.Add(rounds.first, rounds.rounds);
      continue;
    }
    const ThreadsOf threads(rounds);
    for (int64_t round = 0; round < rounds.rounds; ++round) {
      for (const uint8_t thread : threads) segments.Add(thread, 1);
    }
  }
  segments.PassOn();
  return schedule;
}

std::string FormatRecording(const Recording& recording) {
  ScheduleText text(recording.program_hash, recording.scenario, recording.checkpoints);
  size_t length = 0;
  for (const RecordedRounds& rounds : recording.rounds) length += Length(rounds);
  text.Reserve(length);
  Joined segments([&](const ScheduleSegment& segment) {
    text.AddRun(segment);
    text.AddChecks();
  });
  for (const RecordedRounds& rounds : recording.rounds) {
    if (IsAlone(rounds)) {
      segments.Add(rounds.first, rounds.rounds);
      continue;
    }
    const ThreadsOf threads(rounds);
    const auto add_one = [&] {
      for (const uint8_t thread : threads) segments.Add(thread, 1);
    };
    add_one();
    // The last line of a round has not been written yet: more may follow. So these are the lines
    // from it to the last but one of the next round.
    std::string lines = LineOf({threads.end()[-1], 1});
    for (const uint8_t thread : std::span(threads.begin(), threads.end() - 1)) {
      lines += LineOf({thread, 1});
    }
    for (int64_t left = rounds.rounds - 1; left > 0;) {
      const int64_t some = std::min(left, (text.UntilCheck() - 1) / threads.size());
      for (int64_t i = 0; i < some; ++i) text.AddRuns(lines, threads.size());
      left -= some;
      if (left > 0) {
        add_one();
        --left;
      }
    }
  }
  segments.PassOn();
  return text.Finish(recording.cut_us);
}

}  // namespace oncard::vm
