// Requirements under `leads` and `within` against their definition.
#include "runtime/scenario/run/response.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

namespace oncard::runtime {
namespace {

struct Seen {
  bool left = false;
  bool right = false;
  int64_t ns = 0;
};

/// The first state that is too late, by the definition: for each state with the left side there is
/// this or a later one with the right side whose clock is at most `limit_ns` greater.
std::optional<size_t> FirstLate(const std::vector<Seen>& run, int64_t limit_ns) {
  std::optional<size_t> first;
  for (size_t i = 0; i < run.size(); ++i) {
    if (!run[i].left) continue;
    bool answered = false;
    std::optional<size_t> late;
    for (size_t j = i; j < run.size(); ++j) {
      const bool in_time = run[j].ns <= run[i].ns + limit_ns;
      answered = answered || (run[j].right && in_time);
      if (!in_time && !late) late = j;
    }
    if (!answered && late && (!first || *late < *first)) first = late;
  }
  return first;
}

/// Whether a state with the left side has no later one with the right side.
bool Unanswered(const std::vector<Seen>& run) {
  for (size_t i = 0; i < run.size(); ++i) {
    bool answered = !run[i].left;
    for (size_t j = i; j < run.size(); ++j) answered = answered || run[j].right;
    if (!answered) return true;
  }
  return false;
}

TEST(Response, OweWhatTheDefinitionSays) {
  std::mt19937 random(1);
  int late_runs = 0;
  int unanswered_runs = 0;
  for (int n = 0; n < 20'000; ++n) {
    std::vector<Seen> run;
    int64_t ns = 0;
    for (size_t i = 0; i < 2 + random() % 12; ++i) {
      ns += random() % 2 == 0 ? 0 : 250'000;
      run.push_back({random() % 4 == 0, random() % 5 == 0, ns});
    }
    const Requirement leads = {.scope = Scope::kLeads, .text = "p", .then = "q"};
    // 0 to 1.2 ms: also between two cycles.
    const Requirement within = {.scope = Scope::kWithin,
                                .text = "p",
                                .then = "q",
                                .within_us = static_cast<int64_t>(random() % 13) * 100};
    Owed owed;
    Owed ever;
    std::optional<size_t> late;
    for (size_t i = 0; i < run.size(); ++i) {
      owed.Observe(within, run[i].left, run[i].right, run[i].ns, 0);
      ever.Observe(leads, run[i].left, run[i].right, run[i].ns, 0);
      if (owed.late && !late) late = i;
    }
    ASSERT_EQ(late, FirstLate(run, within.within_us * 1000)) << "run " << n;
    ASSERT_EQ(ever.pending, Unanswered(run)) << "run " << n;
    ASSERT_FALSE(ever.late);
    late_runs += late ? 1 : 0;
    unanswered_runs += ever.pending ? 1 : 0;
  }
  EXPECT_GT(late_runs, 1000);
  EXPECT_GT(unanswered_runs, 1000);
}

}  // namespace
}  // namespace oncard::runtime
