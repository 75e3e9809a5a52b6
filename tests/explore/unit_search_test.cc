// Units of a search (explore/search/unit_search.h) and their text in a search file.
#include "explore/search/unit_search.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <xxhash.h>

#include <nlohmann/json.hpp>

#include "explore/search/search_file.h"

namespace oncard::explore {
namespace {

TEST(UnitSearch, OneUnitForEachPartOrFour) {
  EXPECT_EQ(GroupsFor(1, 1), 4);
  EXPECT_EQ(GroupsFor(2, 1), 2);
  EXPECT_EQ(GroupsFor(121, 1), 1);
  EXPECT_EQ(GroupsFor(1, 8), 8);
  EXPECT_EQ(GroupsFor(3, 8), 3);
  EXPECT_EQ(GroupsFor(8, 8), 1);
  EXPECT_EQ(UnitsOfPart(9, 1, 4), (std::vector<int64_t>{0, 4, 8}));
  EXPECT_EQ(UnitsOfPart(9, 4, 4), (std::vector<int64_t>{3, 7}));
}

SearchFile FileOfUnits() {
  SearchFile file;
  file.engine = EngineKind::kAuto;
  file.parts = 3;
  file.held = {1, 3};
  UnitSearch& units = file.units.emplace();
  units.cases = 4;
  units.groups = 2;
  units.all = true;
  units.islands = false;
  units.reductions = false;
  units.merge_private = false;
  units.preemptions = 5;
  units.left = {2, 6};
  units.failing = 3;
  Exploration& found = units.found.emplace();
  found.engine = EngineKind::kStateful;
  found.verdict = Verdict::kPassed;
  found.paired = true;
  found.horizon = {12.25, 3, 5};
  found.traces = TraceCounts{1, 2, 3, 4, 5, 6, true, true};
  found.states = StateCounts{7, 8, 9, 10, 11, true, true, {12, 13}, true, true};
  found.islands = IslandCounts{{{0, 2}, {1}}, {"done"}, 14, 15};
  found.reduced = ReducedCounts{18, 19, 20};
  found.bounded.emplace();
  found.bounded->preemptions = 2;
  found.bounded->states = 16;
  found.bounded->different_ends = 17;
  found.bounded->complete = true;
  found.ends = {{-1, 2}, {3, 4}};
  file.remarks.refused = {{{1, "f", "p.c", 12, ""}, {"refused", "拒绝"}, 7, 250, 3}};
  runtime::CardFinding& finding = file.remarks.card.emplace_back();
  finding.place = {-1, "", "", 0, "GT_Update(0x4)"};
  finding.text = {"found", "发现"};
  finding.at_end = true;
  file.remarks.untested.Add(std::vector<Message>{{"a", "甲"}, {"b", "乙"}});
  file.remarks.untested.Add(std::vector<Message>{{"b", "乙"}});
  return file;
}

TEST(UnitSearch, TheTextHoldsEverything) {
  const SearchFile file = FileOfUnits();
  const auto read = ParseSearchFile(FormatSearchFile(file));
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_EQ(FormatSearchFile(read.value()), FormatSearchFile(file));
  const UnitSearch& units = *read.value().units;
  EXPECT_EQ(units.Kind(), file.units->Kind());
  EXPECT_EQ(units.left, file.units->left);
  EXPECT_EQ(units.failing, 3);
  EXPECT_EQ(units.found->horizon.at_ms, 12.25);
  EXPECT_EQ(units.found->traces->final_full, 6);
  EXPECT_EQ(units.found->states->finals_within, (std::vector<int64_t>{12, 13}));
  EXPECT_TRUE(units.found->states->in_groups);
  EXPECT_TRUE(units.found->states->symmetric);
  EXPECT_EQ(units.found->islands->threads, file.units->found->islands->threads);
  EXPECT_EQ(units.found->reduced->starts, 20);
  EXPECT_FALSE(units.reductions);
  EXPECT_EQ(units.found->bounded->different_ends, 17);
  EXPECT_EQ(units.found->ends, file.units->found->ends);
  EXPECT_EQ(read.value().remarks.refused.front().place.line, 12);
  EXPECT_EQ(read.value().remarks.card.front().text.zh, "发现");
  EXPECT_EQ(read.value().remarks.untested.Texts().size(), 1u);
}

struct BadUnits {
  const char* place;
  const char* value;
  const char* error;
};

class BadUnitSearch : public ::testing::TestWithParam<BadUnits> {};

TEST_P(BadUnitSearch, IsRefusedWithThePlace) {
  const auto [place, value, error] = GetParam();
  auto json = nlohmann::ordered_json::parse(FormatSearchFile(FileOfUnits()));
  json[nlohmann::ordered_json::json_pointer(place)] = nlohmann::ordered_json::parse(value);
  json.erase("check");
  std::string text = json.dump();
  text.pop_back();
  const auto read = ParseSearchFile(
      fmt::format("{},\"check\":\"{:016x}\"}}", text, XXH64(text.data(), text.size(), 0)));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().message.en, error);
}

INSTANTIATE_TEST_SUITE_P(
    UnitSearch, BadUnitSearch,
    ::testing::Values(
        BadUnits{"/engine", "\"pct\"",
                 "'engine' is \"pct\": expected auto, dpor, stateful or bounded"},
        BadUnits{"/units", "[]", "'units' is []: expected an object"},
        BadUnits{"/units/cases", "0",
                 "'units.cases' is 0: expected a whole number from 1 to 1000000"},
        BadUnits{"/units/groups", "-1",
                 "'units.groups' is -1: expected a whole number from 1 to 100000"},
        BadUnits{"/units/left", "[8]", "'units.left[0]' is 8: expected a whole number from 0 to 7"},
        BadUnits{"/units/left", "[6,2]",
                 "'units.left' is [6,2]: expected units of its parts, in order"},
        BadUnits{"/units/left", "[1]",
                 "'units.left' is [1]: expected units of its parts, in order"},
        BadUnits{"/units/failing", "8",
                 "'units.failing' is 8: expected a whole number from 0 to 7"},
        BadUnits{"/units/found/engine", "\"none\"",
                 "'units.found.engine' is \"none\": expected an engine"},
        BadUnits{"/units/found/states/states", "-1",
                 "'units.found.states.states' is -1: expected a whole number from 0 to "
                 "1000000000000000"},
        BadUnits{"/units/found/states/within", "[1,2,3,4,5]",
                 "'units.found.states.within' is [1,2,3,4,5]: expected at most 4 numbers"},
        BadUnits{"/units/found/islands/threads/0/island", "[32]",
                 "'units.found.islands.threads[0].island[0]' is 32: expected a whole number from "
                 "0 to 31"},
        BadUnits{"/remarks/warnings/0/warning", "\"x\"",
                 "'remarks.warnings[0].warning' is \"x\": expected a warning"},
        BadUnits{"/remarks/refused/0/text", "[]",
                 "'remarks.refused[0].text' is []: expected one text"}));

TEST(UnitSearch, PartsAddUpToTheirWhole) {
  SearchFile first = FileOfUnits();
  SearchFile second = first;
  second.held = {2};
  second.units->left = {1};
  second.units->failing = 4;
  ASSERT_TRUE(MergeInto(&first, second).ok());
  EXPECT_EQ(first.units->left, (std::vector<int64_t>{1, 2, 6}));
  EXPECT_EQ(first.units->failing, 3);
  EXPECT_EQ(first.units->found->states->states, 14);
  EXPECT_EQ(first.remarks.refused.size(), 1u);
  EXPECT_EQ(first.remarks.refused.front().count, 6);
  EXPECT_TRUE(first.whole());
  SearchFile other = FileOfUnits();
  other.held = {2};
  other.units->islands = true;
  SearchFile alone = FileOfUnits();
  EXPECT_FALSE(MergeInto(&alone, other).ok());
}

}  // namespace
}  // namespace oncard::explore
