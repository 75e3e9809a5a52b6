#include "editor/describe.h"

#include <gmock/gmock.h>

#include "editor/command_help.h"
#include "gtcalls/gts/catalogue.h"
#include "tests/editor/marked_source.h"

namespace oncard::editor {
namespace {

using ::testing::HasSubstr;

struct DescribeCase {
  const char* rule;
  const char* source;  ///< with the place at `$0`
  const char* answer;  ///< members that it must have; `null`: there is nothing
  bool structured = false;
};

std::ostream& operator<<(std::ostream& out, const DescribeCase& rule) { return out << rule.rule; }

class DescribeTest : public testing::TestWithParam<DescribeCase> {};

TEST_P(DescribeTest, Says) {
  const AnalysedSource source(GetParam().source, GetParam().structured);
  const Json answer =
      Describe(source.analysis(), source.cursor(), source.object(), Language::kEnglish);
  const Json expected = Json::parse(GetParam().answer);
  if (!expected.is_object()) {
    EXPECT_EQ(answer, expected);
    return;
  }
  for (const auto& [name, value] : expected.items())
    EXPECT_EQ(answer.value(name, Json()), value) << answer;
}

constexpr DescribeCase kDescribeCases[] = {
    {"a command", "int f()\n{\n  GT_A$0xisOn(1);\n}\n",
     R"json({"kind": "command", "declaration": "GT_AxisOn(short axis)", "number": 78})json"},
    {"a command for hosts", "int f()\n{\n  GT_Op$0en();\n}\n",
     R"json({"kind": "command", "callers": "can only be called by a host program"})json"},
    {"a global with its slot", "int a[3];\nint b;\nint f()\n{\n  b$0 = 1;\n}\n",
     R"json({"kind": "global", "declaration": "int b", "type": "int", "slot": 3})json"},
    {"a local with its slot", "int f(int k)\n{\n  double d$0;\n  d = 1.0;\n}\n",
     R"json({"kind": "local", "function": "f", "type": "double", "slot": 1})json"},
    {"a structure has the slot of its first member", "int a;\nTTrapPrm $0t;\nint f()\n{\n}\n",
     R"json({"kind": "global", "type": "TTrapPrm", "slot": 1})json"},
    {"without an object there is no slot", "int $0a;\nint f()\n{\n  b = 1;\n}\n",
     R"json({"kind": "global", "slot": null})json"},
    {"a structure of the program",
     "int v;\nstruct s { int x; double y[2]; };\nstruct s $0a;\nvoid f()\n{\n  a.x = v;\n}\n",
     R"json({"kind": "global", "declaration": "struct s a", "slot": 1})json", kStructured},
    {"the name of a structure", "struct s { int x; double y[2]; };\nstruct $0s a;\n",
     R"json({"kind": "struct", "declaration": "struct s",
             "markdown": "```c\nstruct s {\n  int x;\n  double y[2];\n}\n```\nstructure\n"})json",
     kStructured},
    {"a member of a structure of the program",
     "struct s { int x; double y[2]; } a[3];\nint f(int i)\n{\n  return a[i].$0y[1];\n}\n",
     R"json({"kind": "member", "declaration": "double y[2]"})json", kStructured},
    {"a name of a typedef", "typedef int row[4];\n$0row a;\n",
     R"json({"kind": "typedef", "declaration": "typedef int row[4]"})json", kStructured},
    {"a parameter", "int f(int $0k)\n{\n  return k;\n}\n",
     R"json({"kind": "parameter", "declaration": "int k", "slot": 0})json"},
    {"a macro with its value", "#define N (3 * 4)\nint f()\n{\n  return $0N;\n}\n",
     R"json({"kind": "macro", "declaration": "#define N (3 * 4)", "value": "12"})json",
     kStructured},
    {"a macro of another macro", "#define M 3\n#define N$0 (M + 1)\n",
     R"json({"kind": "macro", "value": "4"})json", kStructured},
    {"a macro with parameters", "#define TWICE(a) ((a) * 2)\nint f()\n{\n  return TWI$0CE(1);\n}\n",
     R"json({"kind": "macro", "declaration": "#define TWICE(a) ((a) * 2)", "value": null})json",
     kStructured},
    {"a constant variable", "const int a = 0x10;\nint f()\n{\n  return $0a;\n}\n",
     R"json({"kind": "global", "declaration": "const int a = 0x10", "value": "16"})json",
     kStructured},
    {"a constant of an enum", "enum { A = 4 };\nint f()\n{\n  return $0A;\n}\n",
     R"json({"kind": "constant", "declaration": "A = 4", "value": "4"})json", kStructured},
    {"a label", "int f()\n{\nend:\n  goto $0end;\n}\n",
     R"json({"kind": "label", "declaration": "end:", "function": "f"})json"},
    {"a thread function", "int $0f(int k)\n{\n  return 1;\n}\n",
     R"json({"kind": "function", "declaration": "int f(int k)", "thread_function": true})json"},
    {"a called function", "int g()\n{\n  return 1;\n}\nint f()\n{\n  return $0g();\n}\n",
     R"json({"kind": "function", "thread_function": false})json", kStructured},
    {"a member", "TTrapPrm t;\nint f()\n{\n  t.ac$0c = 1.0;\n}\n",
     R"json({"kind": "member", "declaration": "double acc",
             "markdown": "```c\ndouble acc  /* pulse/ms^2 */\n```\n"})json"},
    {"a number in hexadecimal", "int f()\n{\n  return 0x$0FFFFFFFF;\n}\n",
     R"json({"kind": "number", "value": "-1", "hex": "0xFFFFFFFF"})json"},
    {"a fixed-point number", "double d;\nint f()\n{\n  d = 0.$01;\n}\n",
     R"json({"kind": "number", "value": "0.100006103515625", "raw": 6554})json"},
    {"nothing in a comment", "int a; // a$0\n", "null"},
    {"nothing at a blank", "int a;\n$0\nint b;\n", "null"},
    {"nothing of an unknown name", "int f()\n{\n  x$0 = 1;\n}\n", "null"},
};

INSTANTIATE_TEST_SUITE_P(Rules, DescribeTest, testing::ValuesIn(kDescribeCases),
                         [](const auto& each) { return TestName(each.param.rule); });

TEST(CommandHelp, HasTheTableOfParameters) {
  const auto* command = gtcalls::GtsCatalogue().Find("GT_SetVel");
  EXPECT_EQ(CommandMarkdown(*command, Language::kEnglish),
            "```c\nGT_SetVel(short profile, double vel)\n```\n"
            "set the target velocity; for motion programs and host programs\n\n"
            "| parameter | type | unit, range |\n|---|---|---|\n"
            "| `profile` | `short` | [1, 12], a card may have fewer axes |\n"
            "| `vel` | `double` | pulse/ms, (-32767, 32767) |\n\n"
            "return codes: 0 done; 1 not possible now; 7 a parameter is out of range; they go to "
            "the status of the thread\n\nsource: GTS manual ch. 13; no. " +
                std::to_string(command->number) + ", tier A\n");
  EXPECT_THAT(CommandMarkdown(*command, Language::kChinese),
              HasSubstr("```\n设置目标速度；运动程序与主机程序均可调用\n\n"
                        "| 参数 | 类型 | 单位、范围 |"));
}

TEST(CommandHelp, SaysInTheLanguageOfTheClientWhatACommandDoes) {
  const AnalysedSource source("int f()\n{\n  GT_Set$0Vel(1, 2.0);\n}\n");
  const Json english = Describe(source.analysis(), source.cursor(), nullptr, Language::kEnglish);
  EXPECT_EQ(english["brief"], "set the target velocity");
  const Json chinese = Describe(source.analysis(), source.cursor(), nullptr, Language::kChinese);
  EXPECT_EQ(chinese["brief"], "设置目标速度");
  const AnalysedSource call("int f()\n{\n  GT_SetVel(1, $02.0);\n}\n");
  EXPECT_EQ(Signature(call.analysis(), call.cursor(), Language::kEnglish)["brief"],
            "set the target velocity");
  EXPECT_EQ(Signature(call.analysis(), call.cursor(), Language::kChinese)["brief"], "设置目标速度");
}

TEST(CommandHelp, DescribesEveryCommandInBothLanguages) {
  for (const gtcalls::Command& command : gtcalls::GtsCatalogue().commands()) {
    for (const Language language : {Language::kEnglish, Language::kChinese}) {
      EXPECT_THAT(CommandMarkdown(command, language), HasSubstr(Prototype(command)));
    }
  }
}

// --- Calls ---------------------------------------------------------------------------------------

struct SignatureCase {
  const char* rule;
  const char* source;
  const char* name;  ///< nullptr: there is no call
  int active;        ///< -1: beyond the last parameter
  bool structured = false;
};

std::ostream& operator<<(std::ostream& out, const SignatureCase& rule) { return out << rule.rule; }

class SignatureTest : public testing::TestWithParam<SignatureCase> {};

TEST_P(SignatureTest, FindsTheCallAndItsParameter) {
  const AnalysedSource source(
      std::string("int g(int a, int b);\n#define M(x, y) (x)\nint f()\n{\n") + GetParam().source +
          "\n  g = 2;\n}\n",
      GetParam().structured);
  const Json answer = Signature(source.analysis(), source.cursor(), Language::kEnglish);
  if (GetParam().name == nullptr) {
    EXPECT_EQ(answer, nullptr);
    return;
  }
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer["name"], GetParam().name);
  EXPECT_EQ(answer.value("active", -1), GetParam().active);
}

constexpr SignatureCase kSignatureCases[] = {
    {"before the first argument", "GT_SetVel($0);", "GT_SetVel", 0},
    {"in the first argument", "GT_SetVel(1$0, 2);", "GT_SetVel", 0},
    {"after a comma", "GT_SetVel(1,$0 2);", "GT_SetVel", 1},
    {"before the parenthesis", "GT_SetVel$0(1, 2);", nullptr, 0},
    {"after the parenthesis", "GT_SetVel(1, 2)$0;", nullptr, 0},
    {"at the closing parenthesis", "GT_SetVel(1, 2$0);", "GT_SetVel", 1},
    {"too many arguments", "GT_SetVel(1, 2, $0", "GT_SetVel", -1},
    {"without the closing parenthesis", "GT_SetVel(1, $0;", "GT_SetVel", 1},
    {"without anything after it", "GT_SetVel(1, $0", "GT_SetVel", 1},
    {"not in the next statement", "GT_SetVel(1; $0x = 2", nullptr, 0},
    {"an inner parenthesis", "GT_SetVel(1, (2 + $03));", "GT_SetVel", 1},
    {"a comma in an inner bracket", "GT_SetVel(a[1, 2$0], 3);", "GT_SetVel", 0},
    {"a function of the program", "g(1, $0);", "g", 1, kStructured},
    {"a macro", "M(1, $0);", "M", 1, kStructured},
    {"a call in a call", "g(1, g(2$0, 3));", "g", 0, kStructured},
    {"after a call in a call", "g(g(2, 3), $0);", "g", 1, kStructured},
    {"an unknown name", "h($0", nullptr, 0},
    {"a condition", "if ($0", nullptr, 0},
    {"a comment", "GT_SetVel(1, /* $0 */ 2);", nullptr, 0},
    {"over several lines", "GT_SetVel(1,\n  // speed\n  $0", "GT_SetVel", 1},
};

INSTANTIATE_TEST_SUITE_P(Rules, SignatureTest, testing::ValuesIn(kSignatureCases),
                         [](const auto& each) { return TestName(each.param.rule); });

TEST(Signature, HasTheParameters) {
  const AnalysedSource source("int f()\n{\n  GT_SetVel($0\n}\n");
  const Json answer = Signature(source.analysis(), source.cursor(), Language::kEnglish);
  EXPECT_EQ(answer["label"], "GT_SetVel(short profile, double vel)");
  EXPECT_EQ(answer["parameters"][1], Json::parse(R"json({
      "name": "vel", "label": "double vel", "type": "double", "unit": "pulse/ms",
      "range": "(-32767, 32767)", "note": "pulse/ms, (-32767, 32767)"
})json"));
}

TEST(Signature, OfAMacroHasItsParameters) {
  const AnalysedSource source("#define M(x, y) (x)\nint a = M($0", kStructured);
  const Json answer = Signature(source.analysis(), source.cursor(), Language::kEnglish);
  EXPECT_EQ(answer["label"], "M(x, y)");
}

}  // namespace
}  // namespace oncard::editor
