// Names in a scenario that its program does not have are all reported by every command, with line
// and column, in the order of the file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/core.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Places = std::vector<std::string>;

/// `line:column` of every error in the file, as in the output.
Places PlacesIn(const std::string& file, const std::string& said) {
  Places places;
  const std::regex headline(file + ":([0-9]+:[0-9]+): ");
  for (std::sregex_iterator found(said.begin(), said.end(), headline), end; found != end; ++found) {
    places.push_back((*found)[1]);
  }
  return places;
}

constexpr const char* kPlain = "int n;\nint t0(int k)\n{\n  n = k;\n  return n;\n}\n";
constexpr const char* kMoves =
    "int n;\nint t0(int k)\n{\n  n = k;\n  GT_Delay(1);\n  return n;\n}\n";

constexpr const char* kClashes =
    "program = \"p.c\"\n"
    "expect = [\"n == 1\", \"m == 1\"]\n"
    "trace = [\"nn\"]\n"
    "never = [\"l == 1\"]\n"
    "final = [\"k == 1\"]\n"
    "[globals]\n"
    "q = 1\n"
    "[[thread]]\n"
    "function = \"t9\"\n"
    "[[thread]]\n"
    "thread = 1\n"
    "function = \"t0\"\n"
    "init = { j = 1 }\n";
const Places kPlaces = {"2:21", "3:10", "4:10", "5:10", "7:1", "9:12", "13:10"};

TEST(ScenarioPlaces, EveryCommandTellsThemAll) {
  for (const char* program : {kPlain, kMoves}) {
    const ScratchFolder scratch;
    scratch.Write("p.c", program);
    scratch.Write("s.toml", kClashes);
    for (const std::string command : {"run", "test", "explore"}) {
      const ProcessResult result = RunOncard({command, "s.toml"}, scratch.path());
      EXPECT_NE(result.exit_code, 0);
      EXPECT_EQ(PlacesIn("s.toml", result.out + result.err), kPlaces) << command << '\n'
                                                                      << result.out << result.err;
    }
  }
}

// Without any thread the explorer has no model of the program.
TEST(ScenarioPlaces, TheExplorerTellsThemWithoutAnyThread) {
  for (const char* program : {kPlain, kMoves}) {
    const ScratchFolder scratch;
    scratch.Write("p.c", program);
    scratch.Write("s.toml",
                  "program = \"p.c\"\nfinal = [\"m == 1\", \"ret0 == 1\"]\n"
                  "[[thread]]\nfunction = \"t9\"\n");
    const ProcessResult result = RunOncard({"explore", "s.toml"}, scratch.path());
    EXPECT_EQ(PlacesIn("s.toml", result.err), (Places{"2:10", "4:12"})) << result.err;
  }
}

TEST(ScenarioPlaces, WhatSpeaksOfAllSchedulesHasItsPlaceToo) {
  const ScratchFolder scratch;
  const std::string scenario =
      "program = \"p.c\"\nsync = [\"n\", \"flags\"]\nraces = \"none\"\n"
      "explore = { engine = \"dpor\" }\n[[thread]]\nfunction = \"t0\"\ninit = { j = 1 }\n";
  scratch.Write("s.toml", scenario);
  scratch.Write("p.c", kPlain);
  const ProcessResult plain = RunOncard({"explore", "s.toml"}, scratch.path());
  EXPECT_EQ(PlacesIn("s.toml", plain.err), (Places{"2:14", "7:10"})) << plain.err;

  // With the card there are no traces of variables alone.
  scratch.Write("p.c", kMoves);
  const ProcessResult card = RunOncard({"explore", "s.toml"}, scratch.path());
  EXPECT_EQ(PlacesIn("s.toml", card.err), (Places{"2:14", "4:22", "7:10"})) << card.err;

  // Text from the command line has no place.
  const ProcessResult said =
      RunOncard({"explore", "s.toml", "--engine=dpor", "--benign"}, scratch.path());
  EXPECT_EQ(PlacesIn("s.toml", said.err), (Places{"2:14", "4:22", "7:10"})) << said.err;
  EXPECT_THAT(said.err, HasSubstr("\nwhether a race is benign is known only"));
}

TEST(ScenarioPlaces, CommentsOfASourceHaveThem) {
  const ScratchFolder scratch;
  scratch.Write("p.c",
                "//@ final: m == 1\n"
                "//@ init: n = 1, q = 2\n"
                "//@ always: l < 3\n"
                "//@ sync: n, flags\n" +
                    std::string(kPlain));
  const ProcessResult result = RunOncard({"explore", "p.c"}, scratch.path());
  EXPECT_EQ(PlacesIn("p.c", result.err), (Places{"1:12", "2:18", "3:13", "4:14"})) << result.err;
}

TEST(ScenarioPlaces, AnOptionInPlaceOfTheScheduleStandsNowhere) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kPlain);
  scratch.Write("s.toml", "program = \"p.c\"\nschedule = \"rrr\"\n");
  const ProcessResult read = RunOncard({"run", "s.toml"}, scratch.path());
  EXPECT_EQ(PlacesIn("s.toml", read.err), (Places{"2:12"})) << read.err;
  const ProcessResult said = RunOncard({"run", "s.toml", "--schedule=prr"}, scratch.path());
  EXPECT_THAT(said.err, StartsWith("oncard: 'prr' is not a schedule policy"));
}

// Names are not part of a program's hash. In the recording the scenario follows three lines, and
// each of its lines begins with "| ".
TEST(ScenarioPlaces, AReplayNamesThoseOfTheRecording) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kPlain);
  RunOncard(
      {"run", "p.c", "--thread=0=t0:k=1", "--set=n=0", "--expect=n == 1", "--record=r.schedule"},
      scratch.path());
  scratch.Write("p.c", "int m;\nint t1(int k)\n{\n  m = k;\n  return m;\n}\n");
  Places wanted;
  int number = 0;
  std::istringstream lines(scratch.Read("r.schedule"));
  for (std::string line; std::getline(lines, line);) {
    ++number;
    for (const char* clash : {"\"n == 1\"", "\"n\" = 0", "\"t0\""}) {
      const size_t column = line.find(clash);
      if (column != std::string::npos) wanted.push_back(fmt::format("{}:{}", number, column + 1));
    }
  }
  ASSERT_EQ(wanted.size(), 3u);
  for (const Places& options : {Places{}, Places{"--tolerant"}}) {
    Places command = {"replay", "r.schedule"};
    command.insert(command.end(), options.begin(), options.end());
    const ProcessResult result = RunOncard(command, scratch.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(PlacesIn("r.schedule", result.err), wanted) << result.err;
  }
}

}  // namespace
}  // namespace oncard::tools
