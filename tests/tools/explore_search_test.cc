// oncard explore with searches in files: interrupted, in parts, merged.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <xxhash.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string Increments() {
  std::string source = "int x;\n//@ final: x <= 6\n";
  for (const char* name : {"t0", "t1", "t2"}) {
    source += std::string("int ") + name + "() {\n  int t;\n";
    for (int i = 0; i < 2; ++i) source += "  t = x;\n  t = t + 1;\n  x = t;\n";
    source += "  return 0;\n}\n";
  }
  return source;
}

class ExploreSearch : public ::testing::Test {
 protected:
  ExploreSearch() { scratch_.Write("inc.c", Increments()); }
  ProcessResult Explore(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "explore");
    return RunOncard(arguments, scratch_.path());
  }
  nlohmann::json Json(std::vector<std::string> arguments) const {
    arguments.emplace_back("--format=json");
    return nlohmann::json::parse(Explore(std::move(arguments)).out);
  }

  ScratchFolder scratch_;
};

TEST_F(ExploreSearch, GoesOnFromItsFile) {
  const auto begun =
      Json({"inc.c", "--engine=dpor", "--max-executions=1000", "--search=kept.search"});
  EXPECT_EQ(begun["verdict"], "INCOMPLETE");
  EXPECT_EQ(begun["executions"], 1000);
  const auto more = Json({"kept.search", "--max-executions=2000"});
  EXPECT_EQ(more["verdict"], "INCOMPLETE");
  EXPECT_EQ(more["executions"], 3000);
  const auto done = Json({"inc.c", "--search=kept.search"});
  EXPECT_EQ(done["verdict"], "PROVED");
  EXPECT_EQ(done["traces"], 7134);
  EXPECT_EQ(done["blocked"], 0);
  EXPECT_EQ(done["final_full"], 5);
}

TEST_F(ExploreSearch, SaysWhichFilesAreToBeContinued) {
  EXPECT_EQ(Explore({"inc.c", "--shard=1/2", "--max-executions=5"}).exit_code, 6);
  EXPECT_EQ(Explore({"inc.c", "--shard=2/2"}).exit_code, 5);
  const ProcessResult merged = Explore({"--merge", "inc.1-of-2.search", "inc.2-of-2.search"});
  EXPECT_EQ(merged.exit_code, 6);
  EXPECT_THAT(merged.out, HasSubstr("\ntry        oncard explore inc.1-of-2.search\n"));
}

TEST_F(ExploreSearch, PartsMakeTheWhole) {
  for (const char* part : {"1/3", "2/3", "3/3"}) {
    const auto found = Json({"inc.c", "--shard", part});
    EXPECT_EQ(found["verdict"], "PASSED");
  }
  // In any order, and step by step.
  EXPECT_EQ(Json({"--merge", "inc.3-of-3.search", "inc.1-of-3.search",
                  "--search=some.search"})["verdict"],
            "PASSED");
  const auto all = Json({"--merge", "some.search", "inc.2-of-3.search"});
  EXPECT_EQ(all["verdict"], "PROVED");
  EXPECT_EQ(all["traces"], 7134);
  EXPECT_EQ(all["final_globals"], 5);
}

TEST_F(ExploreSearch, RandomRunsInPartsAreThoseInOnePiece) {
  const std::vector<std::string> how = {"inc.c", "--engine=pct", "--runs=101", "--seed=5"};
  for (const char* part : {"1/2", "2/2"}) {
    std::vector<std::string> arguments = how;
    arguments.insert(arguments.end(), {"--shard", part});
    EXPECT_EQ(Explore(arguments).exit_code, 5);
  }
  auto merged = Json({"--merge", "inc.1-of-2.search", "inc.2-of-2.search"});
  auto whole = Json(how);
  // What is kept in files has no coverage.
  whole.erase("coverage");
  EXPECT_EQ(merged, whole);
}

TEST_F(ExploreSearch, WhatDoesNotBelongTogetherIsRefused) {
  EXPECT_EQ(Explore({"inc.c", "--shard=1/2"}).exit_code, 5);
  EXPECT_EQ(Explore({"inc.c", "--shard=2/3"}).exit_code, 5);
  const ProcessResult twice = Explore({"--merge", "inc.1-of-2.search", "inc.1-of-2.search"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.err, HasSubstr("part 1"));
  EXPECT_EQ(Explore({"--merge", "inc.1-of-2.search", "inc.2-of-3.search"}).exit_code, 2);
  EXPECT_EQ(Explore({"inc.c", "--shard=3/2"}).exit_code, 2);
  EXPECT_EQ(
      Explore({"inc.c", "--shard=1/2", "--engine=stateful", "--search=other.search"}).exit_code, 2);
  EXPECT_EQ(Explore({"inc.c", "inc.c"}).exit_code, 2);
}

TEST_F(ExploreSearch, AChangedProgramOrFileIsRefused) {
  EXPECT_EQ(Explore({"inc.c", "--shard=1/2"}).exit_code, 5);
  const std::string kept = scratch_.Read("inc.1-of-2.search");
  std::string edited = kept;
  edited.replace(edited.find("\"bad\":0"), 7, "\"bad\":1");
  scratch_.Write("inc.1-of-2.search", edited);
  EXPECT_EQ(Explore({"inc.1-of-2.search"}).exit_code, 3);
  scratch_.Write("inc.1-of-2.search", "{}");
  EXPECT_EQ(Explore({"inc.1-of-2.search"}).exit_code, 3);
  scratch_.Write("inc.1-of-2.search", kept);
  scratch_.Write("inc.c", "int y;\n" + Increments());
  const ProcessResult changed = Explore({"inc.1-of-2.search"});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_THAT(changed.err, HasSubstr("has changed"));
}

/// A search of a minute or more, stopped by a signal as soon as it handles the signal.
class ExploreSignal : public ExploreSearch, public ::testing::WithParamInterface<const char*> {};

TEST_P(ExploreSignal, KeepsTheSearch) {
  std::string source = "int x;\n//@ final: x <= 64\n";
  for (const char* name : {"t0", "t1", "t2", "t3"}) {
    source += std::string("int ") + name + "() {\n  int t;\n";
    for (int i = 0; i < 8; ++i) source += "  t = x;\n  t = t + 1;\n  x = t;\n";
    source += "  return 0;\n}\n";
  }
  scratch_.Write("long.c", source);
  constexpr const char* kScript =
      "\"$0\" explore long.c --engine=dpor $2 & pid=$!\n"
      "n=$(kill -l $1)\n"
      "while caught=$(sed -n 's/^SigCgt:[^0-9a-f]*//p' /proc/$pid/status) &&\n"
      "      test $(( 0x${caught:-0} >> (n - 1) & 1 )) = 0; do :; done\n"
      "kill -$1 $pid\n"
      "wait $pid";
  for (const char* option : {"", "--search=long.search"}) {
    const ProcessResult ended =
        RunProgram({"bash", "-c", kScript, ONCARD_BUILD_DIR "/bin/oncard", GetParam(), option},
                   scratch_.path());
    EXPECT_EQ(ended.exit_code, 6) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("it was interrupted"));
    ASSERT_TRUE(scratch_.Has("long.search"));
    const auto more = Json({"long.search", "--max-executions=5"});
    EXPECT_EQ(more["verdict"], "INCOMPLETE");
    EXPECT_GT(more["executions"], 5);
  }
}

INSTANTIATE_TEST_SUITE_P(ExploreSearch, ExploreSignal, ::testing::Values("INT", "TERM", "HUP"));

TEST_F(ExploreSearch, APathThatNoSearchFileCanNameIsRefused) {
  // As written by Chinese Windows: GBK.
  scratch_.Write("\xd6\xd0/inc.c", Increments());
  const std::string inside = scratch_.path() + "/\xd6\xd0";
  ASSERT_EQ(RunOncard({"explore", "inc.c", "--shard=1/2"}, inside).exit_code, 5);
  for (const ProcessResult& refused :
       {Explore({"\xd6\xd0/inc.c", "--search=kept.search"}),
        RunOncard({"explore", "--merge", "inc.1-of-2.search", "--search=../kept.search"},
                  inside)}) {
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("its path is not UTF-8"));
    EXPECT_FALSE(scratch_.Has("kept.search"));
  }
  // Without a search file no path needs to be written.
  EXPECT_EQ(Explore({"\xd6\xd0/inc.c"}).exit_code, 0);
}

TEST_F(ExploreSearch, ASearchThatCannotBeKeptSaysSoWhenItIsEnded) {
  // Threads that read inputs for 10 s: far too many states to search.
  std::string source = "int x;\n";
  for (const char* name : {"t0", "t1", "t2"}) {
    source += std::string("void ") + name +
              "() {\n  int di;\nL:\n  GT_GetDi(4, &di);\n  x = x + 1;\n  goto L;\n}\n";
  }
  scratch_.Write("card.c", source);
  scratch_.Write("card.toml",
                 "program = \"card.c\"\nuntil_ms = 10000\n[[thread]]\nfunction = \"t0\"\n"
                 "[[thread]]\nthread = 1\nfunction = \"t1\"\n");
  const ProcessResult ended = Explore({"card.toml", "--time=0.2"});
  EXPECT_EQ(ended.exit_code, 6) << ended.out;
  EXPECT_THAT(
      ended.err,
      HasSubstr("the search could not be saved: with a card, or with choices, only a search "
                "that is begun with --search or --shard is saved"));
  // The verdict comes first where both are read together.
  const ProcessResult together = RunProgram(
      {"sh", "-c", "exec " ONCARD_BUILD_DIR "/bin/oncard explore card.toml --time=0.2 2>&1"},
      scratch_.path());
  EXPECT_THAT(together.out, StartsWith("INCOMPLETE\n"));
}

TEST_F(ExploreSearch, MergedPartsShowTheResults) {
  std::string source = Increments();
  source.erase(source.find("//@"), source.find('\n', source.find("//@")) - source.find("//@"));
  scratch_.Write("inc.c", source);
  for (const char* part : {"1/2", "2/2"}) Explore({"inc.c", "--shard", part});
  const auto merged = Json({"--merge", "inc.1-of-2.search", "inc.2-of-2.search"});
  EXPECT_EQ(merged["results"].size(), 5u) << merged;
  EXPECT_EQ(merged["results"], Json({"inc.c", "--engine=dpor"})["results"]);
}

TEST_F(ExploreSearch, AHostileFileIsRefused) {
  EXPECT_EQ(
      Explore({"inc.c", "--engine=dpor", "--max-executions=10", "--search=kept.search"}).exit_code,
      6);
  const std::string kept = scratch_.Read("kept.search");
  const auto with_value = [&](const char* place, const nlohmann::ordered_json& value) {
    auto json = nlohmann::ordered_json::parse(kept);
    json[nlohmann::ordered_json::json_pointer(place)] = value;
    json.erase("check");
    std::string text = json.dump();
    text.pop_back();  // the brace after the checksum, which is of all before it
    const auto check = XXH64(text.data(), text.size(), 0);
    scratch_.Write("kept.search", text + fmt::format(",\"check\":\"{:016x}\"}}", check));
    return Explore({"kept.search"});
  };
  EXPECT_EQ(with_value("/traces/units/0/prefix", {0, "a"}).exit_code, 3);
  const ProcessResult thread = with_value("/traces/units/0/frames/0/plans/0", 31);
  EXPECT_EQ(thread.exit_code, 3);
  EXPECT_THAT(thread.err,
              HasSubstr("kept.search: units[0].frames[0].plans: thread 31 of the search"));
  scratch_.Write("kept.search", std::string(60'000, '['));
  const ProcessResult deep = Explore({"kept.search"});
  EXPECT_EQ(deep.exit_code, 3);
  EXPECT_THAT(deep.err, HasSubstr("nested more than 16 deep"));
}

/// A sample with choices, which the tests split.
class ExploreAnyInstant : public ExploreSearch {
 protected:
  ExploreAnyInstant() {
    for (const char* name : {"act_check.c", "act_check.toml", "check_act.c", "check_act.toml"}) {
      std::ifstream file(std::string(ONCARD_SOURCE_DIR "/samples/50_any_instant/") + name);
      scratch_.Write(name, {std::istreambuf_iterator<char>(file), {}});
    }
  }
};

TEST_F(ExploreAnyInstant, PartsMakeTheWhole) {
  for (const char* part : {"1/3", "2/3", "3/3"}) {
    EXPECT_EQ(Explore({"act_check.toml", "--shard", part}).exit_code, 5);
  }
  const ProcessResult some =
      Explore({"--merge", "act_check.3-of-3.search", "act_check.1-of-3.search"});
  EXPECT_EQ(some.exit_code, 2);
  EXPECT_THAT(some.err, HasSubstr("of the 3 parts these are missing: 2"));
  const ProcessResult all = Explore(
      {"--merge", "act_check.3-of-3.search", "act_check.1-of-3.search", "act_check.2-of-3.search"});
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_EQ(all.out, Explore({"act_check.toml"}).out);
}

TEST_F(ExploreAnyInstant, AFaultOfOnePartIsOneOfTheWhole) {
  // Case 36 fails, of 121, and others of the same kind that are not searched in its part.
  EXPECT_EQ(Explore({"check_act.toml", "--shard=36/121"}).exit_code, 1);
  EXPECT_EQ(Explore({"check_act.toml", "--shard=1/121"}).exit_code, 5);
  // The others need not be there.
  const auto merged = Json({"--merge", "check_act.1-of-121.search", "check_act.36-of-121.search"});
  const auto whole = Json({"check_act.toml"});
  EXPECT_EQ(merged["verdict"], "FAILED");
  EXPECT_EQ(merged["choice"], whole["choice"]);
  EXPECT_EQ(merged["schedule"], whole["schedule"]);
}

TEST_F(ExploreAnyInstant, GoesOnFromItsFile) {
  const auto begun = Json({"act_check.toml", "--max-states=10000", "--search=kept.search"});
  EXPECT_EQ(begun["verdict"], "INCOMPLETE");
  EXPECT_GT(begun["cases_searched"], 0);
  EXPECT_LT(begun["cases_searched"], 121);
  const std::string again = Explore({"kept.search", "--max-states=10"}).out;
  EXPECT_THAT(again, HasSubstr("reached    in the case gpi[1] = 1 at "));
  EXPECT_THAT(again, HasSubstr("try        oncard explore kept.search --max-states=40\n"));
  const ProcessResult done = Explore({"kept.search"});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(done.out, Explore({"act_check.toml"}).out);
}

TEST_F(ExploreAnyInstant, ASignalKeepsTheUnits) {
  // As soon as the signal is handled, in some unit.
  constexpr const char* kScript =
      "\"$0\" explore act_check.toml --search=kept.search --no-islands & pid=$!\n"
      "while caught=$(sed -n 's/^SigCgt:[^0-9a-f]*//p' /proc/$pid/status) &&\n"
      "      test $(( 0x${caught:-0} >> 14 & 1 )) = 0; do :; done\n"
      "kill -TERM $pid\n"
      "wait $pid";
  const ProcessResult ended =
      RunProgram({"bash", "-c", kScript, ONCARD_BUILD_DIR "/bin/oncard"}, scratch_.path());
  EXPECT_EQ(ended.exit_code, 6) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("it was interrupted; "));
  ASSERT_TRUE(scratch_.Has("kept.search"));
  EXPECT_EQ(Explore({"act_check.toml", "--search=kept.search"}).out,
            Explore({"act_check.toml", "--no-islands"}).out);
}

TEST_F(ExploreAnyInstant, RandomRunsInPartsAreThoseInOnePiece) {
  const std::vector<std::string> how = {"act_check.toml", "--engine=pos", "--runs=130"};
  for (const char* part : {"1/2", "2/2"}) {
    std::vector<std::string> arguments = how;
    arguments.insert(arguments.end(), {"--shard", part});
    EXPECT_EQ(Explore(arguments).exit_code, 5);
  }
  auto whole = Json(how);
  whole.erase("coverage");
  EXPECT_EQ(Json({"--merge", "act_check.1-of-2.search", "act_check.2-of-2.search"}), whole);
}

TEST_F(ExploreAnyInstant, WhatIsKeptSaysNothingOfCoverage) {
  // Else a search in one go would say more than one that was continued.
  EXPECT_FALSE(Json({"act_check.toml", "--search", "kept.search"}).contains("coverage"));
}

TEST_F(ExploreAnyInstant, AChangedScenarioIsRefused) {
  EXPECT_EQ(Explore({"act_check.toml", "--shard=1/121"}).exit_code, 5);
  std::string keys = scratch_.Read("act_check.toml");
  keys.replace(keys.find("[10, 40]"), 8, "[10, 41]");
  scratch_.Write("act_check.toml", keys);
  const ProcessResult changed = Explore({"act_check.1-of-121.search"});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_THAT(changed.err, HasSubstr("has changed"));
}

TEST_F(ExploreSearch, SchedulesOfAProgramWithItsCardAreDivided) {
  scratch_.Write("card.c",
                 "int t0() {\n  GT_AxisOn(1);\n  return 0;\n}\n"
                 "int t1() {\n  GT_AxisOn(2);\n  return 0;\n}\n");
  for (const char* part : {"1/2", "2/2"}) {
    EXPECT_EQ(Explore({"card.c", "--engine=stateful", "--shard", part}).exit_code, 5);
  }
  const auto merged = Json({"--merge", "card.1-of-2.search", "card.2-of-2.search"});
  EXPECT_EQ(merged["verdict"], "PROVED");
  EXPECT_EQ(merged["states_in_groups"], true);
  EXPECT_EQ(Explore({"card.c", "--engine=bounded", "--shard=1/2", "--search=b.search"}).exit_code,
            2);
}

}  // namespace
}  // namespace oncard::tools
