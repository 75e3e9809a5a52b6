// Searches in files (explore/search/search_file.h); tests/tools/explore_search_test.cc tests how
// the command uses them.
#include "explore/search/search_file.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <xxhash.h>

#include <nlohmann/json.hpp>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

SearchFile Interrupted(const Problem& problem, int64_t executions) {
  SearchFile file;
  file.input = "inc.c";
  file.problem = HashOf(problem);
  file.held = {1};
  SearchTraces(problem, {.executions = executions}, &file.traces);
  return file;
}

TEST(SearchFileTest, TheTextHoldsEverything) {
  const Problem problem = ProblemOf(Increments(3, 2));
  const SearchFile file = Interrupted(problem, 500);
  ASSERT_FALSE(file.traces.units.front().frames.empty());
  const auto read = ParseSearchFile(FormatSearchFile(file));
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_EQ(read.value().input, "inc.c");
  EXPECT_EQ(read.value().problem, file.problem);
  EXPECT_EQ(read.value().traces.units, file.traces.units);
  EXPECT_EQ(read.value().traces.executions, 500);
  EXPECT_EQ(read.value().traces.bad, file.traces.bad);
  EXPECT_EQ(read.value().traces.globals, file.traces.globals);
  EXPECT_EQ(read.value().traces.full, file.traces.full);
  EXPECT_EQ(read.value().traces.failing, file.traces.failing);
  EXPECT_EQ(FormatSearchFile(read.value()), FormatSearchFile(file));
}

TEST(SearchFileTest, TheResultsAreShownAsOfASearchInOnePiece) {
  // Without requirements on the results: additions may be lost.
  const Problem problem = {ProblemOf(Increments(2, 2)).model};
  ASSERT_TRUE(problem.requirements.empty());
  for (const EngineKind engine : {EngineKind::kDpor, EngineKind::kPct}) {
    const auto whole = Explore(problem, {.engine = engine, .runs = 40});
    ASSERT_TRUE(whole.ok());
    ASSERT_GT(whole.value().ends.size(), 1u);
    SearchFile all;
    for (int part = 1; part <= 2; ++part) {
      SearchFile file;
      file.problem = HashOf(problem);
      file.engine = engine;
      file.parts = 2;
      file.held = {part};
      file.runs = 40;
      if (engine == EngineKind::kDpor) {
        file.traces = TracesOfPart(problem, {part, 2});
        SearchTraces(problem, {}, &file.traces);
      } else {
        file.seed = 1;
        const auto [first, runs] = RunsOfPart(40, {part, 2});
        file.samples =
            Sample(problem, {.kind = SamplerKind::kPct, .runs = runs, .first_run = first});
      }
      const auto read = ParseSearchFile(FormatSearchFile(file));
      ASSERT_TRUE(read.ok()) << read.error().message.en;
      if (part == 1) {
        all = read.value();
      } else {
        ASSERT_TRUE(MergeInto(&all, read.value()).ok());
      }
    }
    EXPECT_EQ(Conclude(problem, all).ends, whole.value().ends);
  }
}

/// A plan can be as long as a whole run; the file does not become deeper.
TEST(SearchFileTest, LongPlansDoNotNest) {
  SearchFile file;
  file.held = {1};
  SavedFrame frame;
  for (int i = 0; i < 100'000; ++i) frame.plans.push_back({0, 1});
  frame.plans.back().next = 0;
  file.traces.units = {{{}, {}, {frame}}};
  const auto read = ParseSearchFile(FormatSearchFile(file));
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_EQ(read.value().traces.units, file.traces.units);
}

/// What a search is saved in must not take longer than the search.
TEST(SearchFileTest, APlannedStepTakesFewBytes) {
  SearchFile file;
  file.held = {1};
  const size_t without = FormatSearchFile(file).size();
  SavedFrame frame;
  frame.plans.assign(1000, {7, 2});
  file.traces.units = {{{}, {}, {frame}}};
  EXPECT_LT(FormatSearchFile(file).size(), without + 1000 * std::string("7,2,").size() + 100);
}

/// The reader must not look at all keys for each of them.
TEST(SearchFileTest, AnObjectWithManyKeysIsReadInOneGo) {
  SearchFile file;
  file.held = {1};
  std::string keys = "{";
  for (int i = 0; i < 300'000; ++i) keys += fmt::format("{}\"{:x}\":0", i == 0 ? "" : ",", i);
  std::string text = FormatSearchFile(file);
  text = text.substr(0, text.rfind(",\"check\"")) + ",\"more\":" + keys + "}";
  text += fmt::format(",\"check\":\"{:016x}\"}}", XXH64(text.data(), text.size(), 0));
  const auto read = ParseSearchFile(text);
  EXPECT_TRUE(read.ok()) << read.error().message.en;
}

/// The text of a file with another value at a path, and the matching check value.
std::string WithValue(const SearchFile& file, const std::string& place, const std::string& value) {
  auto json = nlohmann::ordered_json::parse(FormatSearchFile(file));
  json[nlohmann::ordered_json::json_pointer(place)] = nlohmann::ordered_json::parse(value);
  json.erase("check");
  std::string text = json.dump();
  text.pop_back();  // the check is the last value, of the text before it
  return fmt::format("{},\"check\":\"{:016x}\"}}", text, XXH64(text.data(), text.size(), 0));
}

struct BadValue {
  const char* place;
  const char* value;
  const char* error;
};

class BadSearchFile : public ::testing::TestWithParam<BadValue> {};

TEST_P(BadSearchFile, IsRefusedWithThePlace) {
  const auto [place, value, error] = GetParam();
  static const Problem problem = ProblemOf(Increments(3, 2));
  SearchFile file = Interrupted(problem, 500);
  if (std::string(place).starts_with("/samples")) {
    file.engine = EngineKind::kPct;
    file.runs = 10;
    file.parts = 2;
    file.runs_cut = 5;
    file.samples = Sample(problem, {.runs = 0});
  }
  ASSERT_TRUE(ParseSearchFile(FormatSearchFile(file)).ok());
  const auto read = ParseSearchFile(WithValue(file, place, value));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().message.en, error);
}

INSTANTIATE_TEST_SUITE_P(
    SearchFileTest, BadSearchFile,
    ::testing::Values(
        BadValue{"/input", "7", "'input' is 7: expected a text"},
        BadValue{"/problem", "\"12\"", "'problem' is \"12\": expected 16 hexadecimal digits"},
        BadValue{"/races", "\"some\"", "'races' is \"some\": expected any, benign or none"},
        BadValue{"/engine", "\"auto\"", "'engine' is \"auto\": expected dpor, random, pct or pos"},
        BadValue{"/engine", "[]", "'engine' is []: expected a text"},
        BadValue{"/parts", "0", "'parts' is 0: expected a whole number from 1 to 100000"},
        BadValue{"/parts", "1e3", "'parts' is 1000.0: expected a whole number from 1 to 100000"},
        BadValue{"/held", "[]", "'held' is []: expected numbers of parts, in order"},
        BadValue{"/held", "[2]", "'held[0]' is 2: expected a whole number from 1 to 1"},
        BadValue{"/held", "{\"a\":1}", "'held' is {\"a\":1}: expected a list"},
        BadValue{"/traces", "3", "'traces' is 3: expected an object"},
        BadValue{"/traces", "null", "'traces' is missing: expected an object"},
        BadValue{"/traces/units/0", "[]", "'traces.units[0]' is []: expected an object"},
        BadValue{"/traces/units/0/prefix", "[0,32]",
                 "'traces.units[0].prefix[1]' is 32: expected a whole number from 0 to 31"},
        BadValue{"/traces/units/0/sleep", "[-1]",
                 "'traces.units[0].sleep[0]' is -1: expected a whole number from 0 to 31"},
        BadValue{"/traces/units/0/frames/1/plans", "[1]",
                 "'traces.units[0].frames[1].plans' is [1]: expected pairs of numbers"},
        BadValue{"/traces/units/0/frames/1/plans", "[99,0]",
                 "'traces.units[0].frames[1].plans' is [99,0]: expected threads from 0 to 31"},
        BadValue{"/traces/units/0/frames/0/races", "[\"a\"]",
                 "'traces.units[0].frames[0].races[0]' is \"a\": expected a whole number from 0 "
                 "to 4294967295"},
        BadValue{"/traces/executions", "-1",
                 "'traces.executions' is -1: expected a whole number from 0 to 1000000000000000"},
        BadValue{"/traces/bad", "18446744073709551615",
                 "'traces.bad' is 18446744073709551615: expected a whole number from 0 to "
                 "1000000000000000"},
        BadValue{"/traces/too_deep", "0", "'traces.too_deep' is 0: expected true or false"},
        BadValue{"/traces/globals", "[\"xyz\"]",
                 "'traces.globals[0]' is \"xyz\": expected 32 hexadecimal digits, greater than the "
                 "previous ones"},
        BadValue{"/traces/failing", "[255]",
                 "'traces.failing[0]' is 255: expected a whole number from 0 to 31"},
        BadValue{"/samples/depth", "65",
                 "'samples.depth' is 65: expected a whole number from 1 to 64"},
        BadValue{"/samples/runs_cut", "6",
                 "'samples.runs_cut' is 6: expected at most the 5 runs of its part"}));

TEST(SearchFileTest, KeysComeInOrder) {
  SearchFile file;
  file.held = {1};
  file.traces.globals = {{2, 0}, {1, 0}};
  EXPECT_FALSE(ParseSearchFile(FormatSearchFile(file)).ok());
  file.traces.globals = {{1, 0}, {2, 0}};
  EXPECT_TRUE(ParseSearchFile(FormatSearchFile(file)).ok());
}

/// The JSON reader accepts any depth, but writing or destroying the result would overflow the
/// stack.
TEST(SearchFileTest, DeepFilesAreRefused) {
  for (const char* open : {"[", "{\"a\":", "[{\"a\":"}) {
    std::string text;
    for (int i = 0; i < 60'000; ++i) text += open;
    const auto read = ParseSearchFile(text);
    ASSERT_FALSE(read.ok());
    EXPECT_THAT(read.error().message.en, HasSubstr("nested more than 16 deep"));
  }
  const auto quoted = ParseSearchFile("{\"kind\": \"" + std::string(100, '[') + "\\\"[[\"}");
  EXPECT_THAT(quoted.error().message.en, HasSubstr("this is not a search file: expected"));
}

TEST(SearchFileTest, SaysWhetherItIsDone) {
  const Problem problem = ProblemOf(Increments(2, 1));
  const SearchFile interrupted = Interrupted(problem, 2);
  EXPECT_FALSE(interrupted.done());
  EXPECT_EQ(Conclude(problem, interrupted).verdict, Verdict::kFailed);
  const SearchFile whole = Interrupted(problem, 1000);
  EXPECT_TRUE(whole.done() && whole.whole());
}

TEST(SearchFileTest, OtherProblemsHaveOtherHashes) {
  const std::string source = Increments(2, 1);
  const uint64_t hash = HashOf(ProblemOf(source));
  EXPECT_EQ(HashOf(ProblemOf(source)), hash);
  EXPECT_NE(HashOf(ProblemOf(source + "//@ never: x == 7\n")), hash);
  EXPECT_NE(HashOf(ProblemOf(source + "//@ init: x=1\n")), hash);
  EXPECT_NE(HashOf(ProblemOf(source + "//@ races: none\n")), hash);
  EXPECT_NE(HashOf(ProblemOf(source + "//@ livelock: any\n")), hash);
}

TEST(SearchFileTest, PartsAreNumberedFromOne) {
  EXPECT_EQ(ParsePart("3/8").value(), (SearchPart{3, 8}));
  for (const char* bad : {"", "3", "0/8", "9/8", "3/", "/8", "3/8x", "-1/8", "1/100001"}) {
    EXPECT_FALSE(ParsePart(bad).ok()) << bad;
  }
}

TEST(SearchFileTest, RandomRunsThatAreNotDoneAreNotMerged) {
  SearchFile first;
  first.engine = EngineKind::kRandom;
  first.parts = 2;
  first.held = {1};
  SearchFile second = first;
  second.held = {2};
  second.runs_cut = 3;
  SearchFile file = first;
  EXPECT_FALSE(MergeInto(&file, second).ok());
  second.runs_cut = 0;
  EXPECT_TRUE(MergeInto(&file, second).ok());
  EXPECT_TRUE(file.whole());
}

TEST(SearchFileTest, RunsAreSharedOut) {
  EXPECT_EQ(RunsOfPart(10, {1, 3}), (std::pair<int64_t, int64_t>{0, 4}));
  EXPECT_EQ(RunsOfPart(10, {2, 3}), (std::pair<int64_t, int64_t>{4, 3}));
  EXPECT_EQ(RunsOfPart(10, {3, 3}), (std::pair<int64_t, int64_t>{7, 3}));
  EXPECT_EQ(RunsOfPart(1, {2, 2}), (std::pair<int64_t, int64_t>{1, 0}));
}

}  // namespace
}  // namespace oncard::explore
