#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compiler/diagnostic_printer.h"
#include "tests/compiler/printer_support.h"

namespace oncard::compiler {
namespace {

using Json = nlohmann::json;

// `轴` precedes the error, so that columns that count bytes would be detected.
Compilation Sample() {
  Compilation compilation = CompilationOf("int sum;\n/* 轴 */ sun = 1;\n", "my dir/p.c");
  Diagnostic& diagnostic =
      Report(compilation, kUndeclared, "sun", {"'sun' is not declared", "未声明“sun”"});
  diagnostic.notes.push_back({RangeOf(compilation, "sum"), true, {"declared here", "声明于此"}});
  diagnostic.notes.push_back({{}, false, {"a hint", "提示"}});
  diagnostic.fixits.push_back({RangeOf(compilation, "sun"), "sum"});
  Report(compilation, kTruncated, "1", {"cut", "被截断"});
  return compilation;
}

TEST(PrintJson, WritesOneObjectPerLine) {
  const std::string text = PrintJson(Sample(), {.language = Language::kChinese});
  ASSERT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  const Json first = Json::parse(text.substr(0, text.find('\n')));
  EXPECT_EQ(first["code"], "MP027");
  EXPECT_EQ(first["severity"], "error");
  EXPECT_EQ(first["slug"], "undeclared");
  EXPECT_EQ(first["message"], "未声明“sun”");
  EXPECT_EQ(first["message_en"], "'sun' is not declared");
  EXPECT_EQ(first["message_zh"], "未声明“sun”");
  EXPECT_EQ(first["file"], "my dir/p.c");
  EXPECT_EQ(first["line"], 2);
  EXPECT_EQ(first["column"], 9);
  EXPECT_EQ(first["end_line"], 2);
  EXPECT_EQ(first["end_column"], 12);
  EXPECT_EQ(first["notes"][0]["line"], 1);
  EXPECT_EQ(first["notes"][0]["message"], "声明于此");
  EXPECT_FALSE(first["notes"][1].contains("line"));
  EXPECT_EQ(first["fixits"][0]["text"], "sum");
  EXPECT_EQ(first["fixits"][0]["column"], 9);
  // "int sum;" + LF is 9 bytes, `/* 轴 */ ` is 10.
  EXPECT_EQ(first["fixits"][0]["begin_offset"], 19);
  EXPECT_EQ(first["fixits"][0]["end_offset"], 22);
  EXPECT_EQ(Json::parse(text.substr(text.find('\n')))["severity"], "warning");
}

TEST(PrintJson, StaysValidWhenMessagesHoldOtherBytes) {
  Compilation compilation = CompilationOf("x\n");
  Report(compilation, kUndeclared, "x", {"'\xD6\xE1' found", "\xFF"});
  EXPECT_TRUE(Json::accept(PrintJson(compilation, {})));
}

TEST(PrintSarif, HasTheRequiredShape) {
  const std::vector<Compilation> runs = {Sample(), CompilationOf("int a;\n")};
  const Json document = Json::parse(PrintSarif(runs, {}));
  EXPECT_EQ(document["version"], "2.1.0");
  ASSERT_EQ(document["runs"].size(), 1u);
  const Json& run = document["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["name"], "oncard");
  ASSERT_EQ(run["tool"]["driver"]["rules"].size(), 2u);
  EXPECT_EQ(run["tool"]["driver"]["rules"][0]["id"], "MP027");
  EXPECT_EQ(run["tool"]["driver"]["rules"][1]["defaultConfiguration"]["level"], "warning");
  ASSERT_EQ(run["results"].size(), 2u);
  const Json& result = run["results"][0];
  EXPECT_EQ(result["ruleId"], "MP027");
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(result["message"]["text"], "'sun' is not declared\na hint");
  const Json& place = result["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "my%20dir/p.c");
  EXPECT_EQ(place["region"]["startLine"], 2);
  EXPECT_EQ(place["region"]["startColumn"], 9);
  EXPECT_EQ(place["region"]["endColumn"], 12);
  EXPECT_EQ(result["relatedLocations"][0]["message"]["text"], "declared here");
  const Json& change = result["fixes"][0]["artifactChanges"][0];
  EXPECT_EQ(change["replacements"][0]["insertedContent"]["text"], "sum");
}

TEST(PrintSarif, OfACleanRunHasNoResults) {
  const Json document = Json::parse(PrintSarif({}, {}));
  EXPECT_TRUE(document["runs"][0]["results"].is_array());
  EXPECT_TRUE(document["runs"][0]["results"].empty());
}

}  // namespace
}  // namespace oncard::compiler
