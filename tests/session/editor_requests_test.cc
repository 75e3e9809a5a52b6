#include "session/editor_requests.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/session/asking_test.h"

namespace oncard::session {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kSource = "#include \"h.h\"\nint f()\n{\n  GT_AxisOn(A);\n}\n";

class EditorRequestsTest : public AskingTest {
 protected:
  Json AskAt(const std::string& request, int line, int column, Json arguments) {
    arguments["line"] = line;
    arguments["column"] = column;
    return Ask(request, arguments);
  }

  const Json files_ = {{"p.c", kSource},
                       {"h.h", "#define A 1\n"},
                       {"s.toml", "program = \"p.c\"\n[[thread]]\nfunction = \"f\"\n"}};
};

TEST_F(EditorRequestsTest, TakeAProgramAScenarioOrAnIncludedFile) {
  for (const char* main : {"p.c", "s.toml"}) {
    const Json command = AskAt("describe", 4, 4, {{"main", main}, {"files", files_}});
    EXPECT_EQ(command["result"]["name"], "GT_AxisOn");
    const Json macro =
        AskAt("describe", 1, 9, {{"main", main}, {"files", files_}, {"file", "h.h"}});
    EXPECT_EQ(macro["result"]["name"], "A");
  }
  EXPECT_EQ(Ask("outline", {{"main", "p.c"}, {"files", files_}, {"file", "x.h"}})["error"],
            "the program 'p.c' does not include 'x.h'");
  EXPECT_EQ(Ask("outline", {{"main", "p.bin"}})["error"],
            "'p.bin' is an object file and has no source");
}

// What a scenario is for makes no difference to its program.
TEST_F(EditorRequestsTest, TakeAScenarioForTheExplorer) {
  Json files = files_;
  files["s.toml"] = "program = \"p.c\"\nraces = \"none\"\nsync = [\"a\"]\nexplore = \"prove\"\n";
  const Json command = AskAt("describe", 4, 4, {{"main", "s.toml"}, {"files", files}});
  ASSERT_TRUE(command["ok"]) << command;
  EXPECT_EQ(command["result"]["name"], "GT_AxisOn");
  EXPECT_EQ(Ask("fixes", {{"main", "s.toml"}, {"files", files}})["result"]["compiled"], true);
}

TEST_F(EditorRequestsTest, KnowCommentsThatSayWhatMustHold) {
  const Json files = {
      {"p.c", "//@ always: n < 5\nint n;\nint t0()\n{\n  //@ assert: n < 5\n  n = 1;\n}\n"}};
  const Json items =
      AskAt("complete", 1, 5, {{"main", "p.c"}, {"files", files}})["result"]["items"];
  ASSERT_FALSE(items.empty());
  EXPECT_EQ(items[0]["label"], "always");
  const Json described = AskAt("describe", 5, 9, {{"main", "p.c"}, {"files", files}})["result"];
  EXPECT_EQ(described["name"], "assert");
  // A condition is of no more use than before.
  EXPECT_EQ(AskAt("describe", 1, 14, {{"main", "p.c"}, {"files", files}})["result"], nullptr);
}

TEST_F(EditorRequestsTest, KnowStructuredC) {
  const Json files = {{"p.c", "enum { A = 3 };\n"}};
  EXPECT_EQ(Ask("outline", {{"main", "p.c"}, {"files", files}})["result"].size(), 0u);
  EXPECT_EQ(
      Ask("outline", {{"main", "p.c"}, {"files", files}, {"structured", true}})["result"].size(),
      1u);
}

TEST_F(EditorRequestsTest, ListMissingFiles) {
  const Json answer = Ask("outline", {{"main", "p.c"}, {"files", {{"p.c", kSource}}}});
  EXPECT_EQ(answer["ok"], true);
  EXPECT_THAT(answer["missing"], ElementsAre("h.h"));
}

TEST_F(EditorRequestsTest, SpeakTheLanguageOfTheSession) {
  Ask("hello", {{"language", "zh"}});
  const Json answer = AskAt("describe", 4, 4, {{"main", "p.c"}, {"files", files_}});
  EXPECT_THAT(answer["result"]["markdown"].get<std::string>(), HasSubstr("返回值"));
}

TEST_F(EditorRequestsTest, ReportMistakesOfTheArguments) {
  EXPECT_EQ(Ask("rename", {{"main", "p.c"}, {"files", files_}, {"line", 0}})["error"],
            "'name' is missing: a text\n'line' is wrong: an integer from 1 to 2147483647\n"
            "'column' is missing: an integer from 1 to 2147483647");
}

TEST_F(EditorRequestsTest, FixAllMistakesInAllFiles) {
  const Json files = {{"p.c", "#include \"h.h\"\nint f()\n{\n  return a\n}\n"}, {"h.h", "int a\n"}};
  const Json result = Ask("fixes", {{"main", "p.c"}, {"files", files}})["result"];
  EXPECT_EQ(result["compiled"], true);
  EXPECT_EQ(result["count"], 2);
  EXPECT_EQ(result["files"], Json::parse(R"([{"path": "h.h", "text": "int a;\n"},
                            {"path": "p.c",
                             "text": "#include \"h.h\"\nint f()\n{\n  return a;\n}\n"}])"));
  const Json good = Ask("fixes", {{"main", "p.c"}, {"files", files_}})["result"];
  EXPECT_EQ(good["count"], 0);
  EXPECT_EQ(good["files"].size(), 0u);
}

TEST_F(EditorRequestsTest, LowerStructuredC) {
  const Json files = {{"p.c", "int x;\nint f()\n{\n  while (x < 3) ++x;\n}\n"}};
  const Json result =
      Ask("lower", {{"main", "p.c"}, {"files", files}, {"structured", true}})["result"];
  EXPECT_EQ(result["compiled"], true);
  const std::string text = result["text"];
  EXPECT_THAT(text, HasSubstr("goto"));
  // Every line of the text has its origin.
  EXPECT_EQ(static_cast<std::ptrdiff_t>(result["origins"].size()), std::ranges::count(text, '\n'));
  EXPECT_EQ(Ask("lower", {{"main", "p.c"}, {"files", files}})["error"],
            "'p.c' is not structured C: there is nothing to lower");
  const Json broken = Ask(
      "lower", {{"main", "p.c"}, {"files", {{"p.c", "int f( {"}}}, {"structured", true}})["result"];
  EXPECT_EQ(broken["compiled"], false);
  EXPECT_FALSE(broken.contains("text"));
}

TEST_F(EditorRequestsTest, ShowStructuredCBesideWhatItBecomes) {
  const Json files = {
      {"p.c", "#include \"h.h\"\n// adds\nint f()\n{\n  for (; x < 3; ++x) g(x);\n}\n"},
      {"h.h", "int x;\nvoid g(int n) { x = n * 2 + 1; }\n"}};
  const Json result =
      Ask("two_columns", {{"main", "p.c"}, {"files", files}, {"structured", true}})["result"];
  EXPECT_EQ(result["compiled"], true);
  const Json& rows = result["rows"];
  EXPECT_EQ(rows[0], Json({{"file", "h.h"},
                           {"line", 1},
                           {"text", "int x;"},
                           {"card", "int x;"},
                           {"card_line", 1}}));
  const auto count = [&](const Json& row) { return std::ranges::count(rows, row); };
  EXPECT_EQ(count({{"file", "p.c"}, {"line", 2}, {"text", "// adds"}}), 1) << rows.dump(1);
  // The first part of the loop, and what is behind its body.
  int loops = 0;
  int again = 0;
  int last = 0;
  for (const Json& row : rows) {
    if (row.value("file", "") == "p.c" && row.value("line", 0) == 5)
      ++(row.contains("again") ? again : loops);
    if (!row.contains("card")) continue;
    EXPECT_GT(row["card_line"], last) << rows.dump(1);
    last = row["card_line"];
  }
  EXPECT_EQ(loops, 1);
  EXPECT_GE(again, 1);
  const Json plain = {{"p.c", "int x;\nint f()\n{\n  x = 1;\n}\n"}};
  EXPECT_EQ(Ask("two_columns", {{"main", "p.c"}, {"files", plain}})["result"],
            Json({{"compiled", true}, {"diagnostics", Json::array()}}));
  const Json broken =
      Ask("two_columns",
          {{"main", "p.c"}, {"files", {{"p.c", "int f( {"}}}, {"structured", true}})["result"];
  EXPECT_EQ(broken["compiled"], false);
  EXPECT_EQ(broken["diagnostics"].size(), 1u);
  EXPECT_FALSE(broken.contains("rows"));
}

TEST_F(EditorRequestsTest, TakePlacesBehindTheEnd) {
  const Json arguments = {{"main", "p.c"}, {"files", files_}};
  for (const char* request : {"describe", "signature", "complete", "definition", "references"}) {
    EXPECT_EQ(AskAt(request, 1000000, 1, arguments)["ok"], true) << request;
    EXPECT_EQ(AskAt(request, 4, 1000000, arguments)["ok"], true) << request;
  }
}

}  // namespace
}  // namespace oncard::session
