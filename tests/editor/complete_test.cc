#include "editor/complete.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/editor/marked_source.h"

namespace oncard::editor {
namespace {

struct CompleteCase {
  const char* rule;
  const char* source;
  std::vector<std::string> present;
  std::vector<std::string> absent;
  bool structured = false;
};

std::ostream& operator<<(std::ostream& out, const CompleteCase& rule) { return out << rule.rule; }

class CompleteTest : public testing::TestWithParam<CompleteCase> {};

std::vector<std::string> LabelsOf(const Json& answer) {
  std::vector<std::string> labels;
  for (const Json& item : answer["items"]) labels.push_back(item["label"]);
  return labels;
}

TEST_P(CompleteTest, OffersWhatCanStandThere) {
  const AnalysedSource source(GetParam().source, GetParam().structured);
  const std::vector<std::string> labels =
      LabelsOf(Complete(source.analysis(), source.cursor(), Language::kEnglish));
  for (const std::string& label : GetParam().present) {
    EXPECT_EQ(std::ranges::count(labels, label), 1)
        << label << " of " << testing::PrintToString(labels);
  }
  for (const std::string& label : GetParam().absent) {
    EXPECT_EQ(std::ranges::count(labels, label), 0) << label;
  }
}

const std::vector<CompleteCase>& CompleteCases() {
  static const std::vector<CompleteCase> cases = {
      {"file level", "$0", {"int", "double", "TTrapPrm", "void"}, {"if", "GT_AxisOn", "static"}},
      {"file level of structured C",
       "$0",
       {"int", "const", "static", "enum", "struct", "bool"},
       {"if"},
       kStructured},
      {"a statement",
       "int g;\nint f(int k)\n{\n  int i;\n  i = 1;\n  $0\n}\n",
       {"g", "k", "i", "if", "goto", "return", "GT_AxisOn"},
       {"int", "while", "GT_Open", "f"}},
      {"a statement of structured C",
       "int g()\n{\n}\nint f(int k)\n{\n  k = 1;\n  $0\n}\n",
       {"k", "g", "while", "switch", "int", "GT_AxisOn"},
       {},
       kStructured},
      {"the word that is being written",
       "int abc;\nint f()\n{\n  ab$0\n}\n",
       {"abc", "GT_AxisOn"},
       {}},
      {"the declarations of a function",
       "int f()\n{\n  int i;\n  $0\n}\n",
       {"int", "i", "return"},
       {}},
      {"after a missing semicolon",
       "int f()\n{\n  int i;\n  i = 1\n  $0\n}\n",
       {"i", "GT_AxisOn"},
       {}},
      {"an expression",
       "int a;\nint f()\n{\n  a = $0\n}\n",
       {"a", "abs"},
       {"if", "GT_AxisOn", "int"}},
      {"after an operator", "int a;\nint f()\n{\n  a = a + $0;\n}\n", {"a"}, {"if", "GT_AxisOn"}},
      {"after a label", "int a;\nint f()\n{\nx: $0\n}\n", {"a", "GT_AxisOn", "goto"}, {}},
      {"a condition", "int a;\nint f()\n{\n  if ($0\n}\n", {"a"}, {"GT_AxisOn", "return"}},
      {"after a condition", "int a;\nint f()\n{\n  if (a) $0\n}\n", {"goto", "return"}, {}},
      {"a jump", "int f()\n{\n  goto $0\nx:\n}\nint g()\n{\ny:\n}\n", {"x"}, {"y", "f", "if"}},
      {"members",
       "TTrapPrm t;\nint f()\n{\n  t.$0\n}\n",
       {"acc", "dec", "smoothTime"},
       {"t", "if"}},
      {"members that are being written",
       "TTrapPrm t;\nint f()\n{\n  t.sm$0oth = 1;\n}\n",
       {"smoothTime"},
       {"t"}},
      {"no members of a number", "int i;\nint f()\n{\n  i.$0\n}\n", {}, {"acc", "i"}},
      {"nothing in comments", "int a; // $0\n", {}, {"int", "a"}},
      {"nothing in numbers", "int f()\n{\n  return 1$0;\n}\n", {}, {"f"}},
      {"nothing where a name is declared", "int a;\nint $0\n", {}, {"int", "a"}},
      {"types after unsigned", "unsigned $0\n", {"int", "char"}, {}, kStructured},
      {"directives", "#$0\n", {"define", "include"}, {"ifdef", "int"}},
      {"directives of structured C",
       "#in$0\n",
       {"include", "ifdef", "endif"},
       {"int"},
       kStructured},
      {"macros in conditions", "#define N 1\n#if $0\n#endif\n", {"N"}, {"int"}, kStructured},
      {"nothing for a new macro", "#define N 1\n#define $0\n", {}, {"N"}, kStructured},
      {"macros until #undef",
       "#define N 1\n#undef N\n#define M 2\nint a = $0;\n",
       {"M"},
       {"N"},
       kStructured},
      {"inner blocks",
       "int f()\n{\n  { int x; }\n  int y;\n  { int z; y = $0; }\n}\n",
       {"y", "z"},
       {"x"},
       kStructured},
      {"names once", "int a;\nint f(int a)\n{\n  a = $0;\n}\n", {"a"}, {}},
      {"names of included files",
       "#include \"h.h\"\nint f()\n{\n  return $0;\n}\n=== h.h\nint a;\n",
       {"a"},
       {}},
      {"values of an axis",
       "int i;\nint f()\n{\n  GT_AxisOn($0);\n}\n",
       {"1", "12", "i"},
       {"0", "13", "GT_AxisOn"}},
      {"no values of a wide range", "int i;\nint f()\n{\n  GT_SetVel(1, $0);\n}\n", {"i"}, {"1"}},
      {"variables of the structure that is wanted",
       "int i;\nTTrapPrm t;\nTJogPrm j;\nint f()\n{\n  GT_SetTrapPrm(1, $0);\n}\n",
       {"t"},
       {"i", "j", "abs"}},
  };
  return cases;
}

// Each `$0` stands behind a structure of the program.
TEST(Complete, OffersTheMembersOfAStructure) {
  const std::string head =
      "struct point { int x; double y[2]; };\n"
      "typedef struct { int target; struct point at[2]; TTrapPrm trap; } axis_t;\n"
      "axis_t axis[3];\nstruct point home(void) { struct point p = {1}; return p; }\n";
  const std::vector<std::string> of_point = {"x", "y"};
  const std::vector<std::string> of_axis = {"target", "at", "trap"};
  const auto offered = [&head](const std::string& statement) {
    const AnalysedSource source(head + "void t0(int i)\n{\n  " + statement + "\n}\n", kStructured);
    return LabelsOf(Complete(source.analysis(), source.cursor(), Language::kEnglish));
  };
  EXPECT_EQ(offered("axis[i + 1].$0;"), of_axis);
  EXPECT_EQ(offered("axis[i].ta$0rget = 1;"), of_axis);
  EXPECT_EQ(offered("axis[i].at[0].$0;"), of_point);
  EXPECT_EQ(offered("i = home().$0;"), of_point);
  EXPECT_EQ(offered("struct point p; p.$0"), of_point);
  EXPECT_EQ(offered("i.$0;"), std::vector<std::string>());
  EXPECT_EQ(offered("struct $0"), std::vector<std::string>{"point"});
  EXPECT_EQ(offered("axis[i].trap.$0;"),
            (std::vector<std::string>{"acc", "dec", "velStart", "smoothTime"}));
  const AnalysedSource source(
      head + "void set(axis_t *a, struct point *p)\n{\n  a->target = 1;\n  (*p).$0\n}\n",
      kStructured);
  const Json answer = Complete(source.analysis(), source.cursor(), Language::kEnglish);
  EXPECT_EQ(LabelsOf(answer), of_point);
  EXPECT_EQ(answer["items"][1]["detail"], "double y[2]");
  EXPECT_EQ(answer["items"][1]["kind"], "member");
}

INSTANTIATE_TEST_SUITE_P(Rules, CompleteTest, testing::ValuesIn(CompleteCases()),
                         [](const auto& each) { return TestName(each.param.rule); });

TEST(Complete, ReplacesTheWord) {
  const AnalysedSource source("int abc;\nint f()\n{\n  return ab$0c;\n}\n");
  const Json answer = Complete(source.analysis(), source.cursor(), Language::kEnglish);
  EXPECT_EQ(answer["range"], Json::parse(R"({
      "file": "p.c", "line": 4, "column": 10, "end_line": 4, "end_column": 13})"));
}

TEST(Complete, GivesCommandsTheAddressOfVariables) {
  const std::string head = "double d;\nint i;\nint a[3];\nint f()\n{\n  ";
  const AnalysedSource plain(head + "GT_GetClock($0\n}\n");
  const Json answer = Complete(plain.analysis(), plain.cursor(), Language::kEnglish);
  EXPECT_EQ(answer["argument"]["name"], "pClock");
  EXPECT_EQ(answer["argument"]["index"], 0);
  // The parameter is a whole number, so that `d` is the last one.
  ASSERT_EQ(LabelsOf(answer), (std::vector<std::string>{"a", "i", "d"}));
  EXPECT_FALSE(answer["items"][0].contains("insert"));
  EXPECT_EQ(answer["items"][1]["insert"], "&i");
  const AnalysedSource with_sign(head + "GT_GetClock(&$0\n}\n");
  const Json again = Complete(with_sign.analysis(), with_sign.cursor(), Language::kEnglish);
  EXPECT_FALSE(again["items"][1].contains("insert"));
}

TEST(Complete, DocumentsCommandsInTheLanguageOfTheClient) {
  const AnalysedSource source("int f()\n{\n  $0\n}\n");
  const auto documentation = [&](Language language) {
    const Json answer = Complete(source.analysis(), source.cursor(), language);
    const std::vector<std::string> labels = LabelsOf(answer);
    const auto index = std::ranges::find(labels, "GT_SetVel") - labels.begin();
    return answer["items"].at(static_cast<size_t>(index)).value("documentation", "");
  };
  EXPECT_EQ(documentation(Language::kEnglish), "set the target velocity");
  EXPECT_EQ(documentation(Language::kChinese), "设置目标速度");
}

}  // namespace
}  // namespace oncard::editor
