// Failing runs for pages that draw them (explore/reports/interleaving.h).
#include "explore/reports/interleaving.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using Json = nlohmann::ordered_json;

Json InterleavingOf(const std::string& source, Language language = Language::kEnglish) {
  Findings findings = FindingsOf(source, {.engine = EngineKind::kStateful});
  if (!findings.exploration.failure) return {};
  findings.source.text = source;
  return InterleavingJson(findings, *findings.exploration.failure, language);
}

/// `1 t0 t = x;`, `3-5 t1`.
std::vector<std::string> Lines(const Json& rows) {
  std::vector<std::string> lines;
  for (const Json& row : rows) {
    std::string line = row["step"].dump();
    if (row["last"] != row["step"]) line += "-" + row["last"].dump();
    line += " t" + row.value("thread", Json("?")).dump();
    if (row.contains("statement")) line += " " + row["statement"].get<std::string>();
    if (row.contains("fatal")) line += " fatal";
    lines.push_back(line);
  }
  return lines;
}

// Both threads read 0; thread 0 then writes 1 over the 1 of thread 1.
TEST(InterleavingTest, ShowsTheStatementsThatMakeASharedValueAndGapsForTheOthers) {
  const Json json = InterleavingOf(Increments(2, 1));
  EXPECT_EQ(json["reason"], "final: x == 2 does not hold");
  EXPECT_EQ(json["actual"], "x is 1, expected 2");
  EXPECT_EQ(json["threads"],
            Json::parse(R"([{"thread":0,"function":"t0"},{"thread":1,"function":"t1"}])"));
  EXPECT_EQ(
      Lines(json["rows"]),
      (std::vector<std::string>{"1 t0 t = x;", "2 t1 t = x; fatal", "3 t1 t = t + 1;",
                                "4 t1 x = t;", "5 t1", "6 t0 t = t + 1;", "7 t0 x = t;", "8 t0"}));
}

TEST(InterleavingTest, HasEachValueBeforeAndAfter) {
  const Json rows = InterleavingOf(Increments(2, 1))["rows"];
  EXPECT_EQ(rows[0]["reads"], Json::parse(R"([{"name":"x","value":"0","shared":true}])"));
  EXPECT_EQ(rows[3]["writes"],
            Json::parse(R"([{"name":"x","before":"0","after":"1","shared":true}])"));
  EXPECT_EQ(rows[5]["writes"],
            Json::parse(R"([{"name":"t","before":"0","after":"1","shared":false}])"));
  EXPECT_FALSE(rows[5].contains("reads")) << "of locals only what was written is said";
}

TEST(InterleavingTest, LeadsFromTheStaleReadToTheLostWrite) {
  EXPECT_EQ(InterleavingOf(Increments(2, 1))["stale"],
            Json::parse(R"({"kind":"overwrites","name":"x","value":"0","changed":"1",)"
                        R"("read":1,"write":4,"use":7})"));
}

TEST(InterleavingTest, IsInTheLanguageOfTheReader) {
  const Json json = InterleavingOf(Increments(2, 1), Language::kChinese);
  EXPECT_EQ(json["actual"], "x 为 1，应为 2");
}

TEST(InterleavingTest, StepsThatRepeatForEverGoOnCounting) {
  const Json json = InterleavingOf(
      "int a, b;\n//@ final: a == 0\n"
      "int t0() {\n  int w;\nL:\n  w = b == 0;\n  if (w) goto L;\n  return 0;\n}\n");
  ASSERT_TRUE(json.contains("cycle")) << json;
  const Json& rows = json["rows"];
  const int before = rows.empty() ? 0 : rows.back()["last"].get<int>();
  EXPECT_EQ(json["cycle"][0]["step"], before + 1);
  EXPECT_FALSE(json.contains("stale"));
}

// Nothing orders the write of thread 0 and the read of thread 1.
TEST(InterleavingTest, ADataRaceHasBothOrdersUpToTheirEnds) {
  const Json json = InterleavingOf(
      "int y, z;\n//@ races: none\n"
      "int t0() {\n  y = 200;\n  return 0;\n}\n"
      "int t1() {\n  int got;\n  got = y;\n  z = got;\n  return 0;\n}\n");
  ASSERT_EQ(json["orders"].size(), 2u) << json;
  for (const Json& order : json["orders"]) {
    const Json& rows = order["rows"];
    const bool write_first = order["first"] == 0;
    EXPECT_EQ(order["end"], write_first ? "z = 200" : "z = 0");
    const auto lines = Lines(rows);
    const auto at = [&](size_t which) { return order["racing"][which].get<size_t>() - 1; };
    EXPECT_EQ(rows[at(0)]["thread"], order["first"]);
    EXPECT_NE(rows[at(1)]["thread"], order["first"]);
    const Json& read = rows[at(write_first ? 1 : 0)];
    EXPECT_EQ(read["statement"], "got = y;");
    EXPECT_EQ(read["reads"][0]["value"], write_first ? "200" : "0");
    EXPECT_EQ(rows.back()["last"], 5) << "both threads have ended";
  }
}

TEST(InterleavingTest, WhatIsNoRaceHasNoOrders) {
  EXPECT_FALSE(InterleavingOf(Increments(2, 1)).contains("orders"));
}

TEST(InterleavingTest, PassesOfALoopAreOneRow) {
  const Json json = InterleavingOf(
      "int x;\n//@ final: x == 9\n"
      "int t0() {\n  int i;\n  int m;\n  i = 5;\nL:\n  x = x + 1;\n  i = i - 1;\n  m = i > 0;\n"
      "  if (m) goto L;\n  return 0;\n}\n");
  EXPECT_EQ(Lines(json["rows"]), (std::vector<std::string>{"1 t0", "2 t0 x = x + 1;", "3-5 t0",
                                                           "6-18 t0 line 8 × 4 more", "19-22 t0"}));
  EXPECT_EQ(json["rows"][3]["writes"],
            Json::parse(R"([{"name":"x","before":"1","after":"5","shared":true}])"));
}

}  // namespace
}  // namespace oncard::explore
