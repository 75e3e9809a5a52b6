#include "editor/places.h"

#include <gmock/gmock.h>

#include "tests/editor/marked_source.h"

namespace oncard::editor {
namespace {

using ::testing::HasSubstr;

// --- Declarations --------------------------------------------------------------------------------

struct DefinitionCase {
  const char* rule;
  const char* source;  ///< asked at `$0`; the answer is `$1`, or nothing if there is none
  bool structured = false;
};

std::ostream& operator<<(std::ostream& out, const DefinitionCase& rule) { return out << rule.rule; }

class DefinitionTest : public testing::TestWithParam<DefinitionCase> {};

TEST_P(DefinitionTest, IsWhereTheNameIsDeclared) {
  const AnalysedSource source(GetParam().source, GetParam().structured);
  const Json answer = Definition(source.analysis(), source.cursor());
  const MarkedSource::Mark* mark = source.FindMark(1);
  if (mark == nullptr) {
    EXPECT_EQ(answer, Json::array());
    return;
  }
  ASSERT_EQ(answer.size(), 1u) << answer;
  EXPECT_EQ(answer[0]["file"], mark->path);
  EXPECT_EQ(answer[0]["line"], mark->place.line);
  EXPECT_EQ(answer[0]["column"], mark->place.column);
}

constexpr DefinitionCase kDefinitionCases[] = {
    {"a use", "int $1a;\nint f()\n{\n  a$0 = 1;\n}\n"},
    {"the declaration itself", "int $1a$0;\n"},
    {"another file", "#include \"h.h\"\nint f()\n{\n  return $0A;\n}\n=== h.h\n#define $1A 1\n"},
    {"the definition of a function, not its prototype",
     "int g();\nint f()\n{\n  return $0g();\n}\nint $1g()\n{\n  return 1;\n}\n", kStructured},
    {"the prototype if there is no definition", "int $1g();\nint f()\n{\n  return $0g();\n}\n",
     kStructured},
    {"columns are characters", "/* 轴 */ int $1a;\nint f()\n{\n  a$0 = 1;\n}\n"},
    {"no definition of a command", "int f()\n{\n  GT_Axis$0On(1);\n}\n"},
    {"nothing in a comment", "int a;\n// a$0\n"},
};

INSTANTIATE_TEST_SUITE_P(Rules, DefinitionTest, testing::ValuesIn(kDefinitionCases),
                         [](const auto& each) { return TestName(each.param.rule); });

// --- Uses ----------------------------------------------------------------------------------------

struct AccessCase {
  const char* statement;
  const char* access;
  bool structured = false;
};

class AccessTest : public testing::TestWithParam<AccessCase> {};

TEST_P(AccessTest, IsKnown) {
  const AnalysedSource source(
      std::string("int a$0;\nint b;\nTTrapPrm t;\nint f()\n{\n  ") + GetParam().statement + "\n}\n",
      GetParam().structured);
  const Json answer = References(source.analysis(), source.cursor(), false);
  ASSERT_EQ(answer.size(), 1u) << answer;
  EXPECT_EQ(answer[0]["access"], GetParam().access);
}

constexpr AccessCase kAccessCases[] = {
    {"a = 1;", "write"},
    {"b = a;", "read"},
    {"b[a] = 1;", "read"},
    {"a[b] = 1;", "write"},
    {"a.x = 1;", "write"},
    {"a += 1;", "read-write", kStructured},
    {"a++;", "read-write", kStructured},
    {"--a;", "read-write", kStructured},
    {"GT_GetClock(&a);", "write"},
    {"GT_GetClock(a);", "write"},
    {"GT_SetPos(1, a);", "read"},
    {"b = b & a;", "read"},
    {"g(&a);", "read-write", kStructured},
    {"if (a) return;", "read"},
    {"a == b;", "read"},
};

INSTANTIATE_TEST_SUITE_P(Rules, AccessTest, testing::ValuesIn(kAccessCases));

TEST(References, AreThoseOfAllFiles) {
  const AnalysedSource source("#include \"h.h\"\nint f()\n{\n  $0a = 1;\n}\n=== h.h\nint a;\n");
  const Json all = References(source.analysis(), source.cursor(), true);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0]["file"], "p.c");
  EXPECT_EQ(all[1]["file"], "h.h");
  EXPECT_EQ(all[1]["access"], "declaration");
  EXPECT_EQ(References(source.analysis(), source.cursor(), false).size(), 1u);
}

// --- New names -----------------------------------------------------------------------------------

struct RenameCase {
  const char* rule;
  const char* source;
  const char* name;
  const char* text;  ///< of the first file afterwards, or the beginning of the error
  bool structured = false;
};

std::ostream& operator<<(std::ostream& out, const RenameCase& rule) { return out << rule.rule; }

class RenameTest : public testing::TestWithParam<RenameCase> {};

TEST_P(RenameTest, ChangesEveryPlaceOrRefuses) {
  const AnalysedSource source(GetParam().source, GetParam().structured);
  const auto edits = Rename(source.analysis(), source.program(), source.cursor(), GetParam().name);
  if (!edits.ok()) {
    EXPECT_EQ(edits.error().message.en, GetParam().text);
    EXPECT_FALSE(edits.error().message.zh.empty());
    return;
  }
  EXPECT_EQ(source.Apply(edits.value()), GetParam().text);
}

constexpr RenameCase kRenameCases[] = {
    {"a variable", "int a$0;\nint f()\n{\n  a = a + 1;\n}\n", "speed",
     "int speed;\nint f()\n{\n  speed = speed + 1;\n}\n"},
    {"a member of a structure", "struct s { int x; } a;\nint x;\nvoid f()\n{\n  a.$0x = x;\n}\n",
     "speed", "struct s { int speed; } a;\nint x;\nvoid f()\n{\n  a.speed = x;\n}\n", kStructured},
    {"a function with its prototype", "int $0g();\nint g()\n{\n}\nint f()\n{\n  g();\n}\n", "h",
     "int h();\nint h()\n{\n}\nint f()\n{\n  h();\n}\n", kStructured},
    {"in the body of a macro", "#define M (a + 1)\nint f()\n{\n  int $0a = 1;\n  return M;\n}\n",
     "b", "#define M (b + 1)\nint f()\n{\n  int b = 1;\n  return M;\n}\n", kStructured},
    {"in a program with a mistake", "int a$0;\nint f()\n{\n  a = ;\n  b = a\n}\n", "c",
     "int c;\nint f()\n{\n  c = ;\n  b = c\n}\n"},
    {"a label with the name of another function's",
     "int f()\n{\n$0x:\n  goto x;\n}\nint g()\n{\ny:\n  goto y;\n}\n", "y",
     "int f()\n{\ny:\n  goto y;\n}\nint g()\n{\ny:\n  goto y;\n}\n"},
    {"the same name", "int a$0;\n", "a", "int a;\n"},
    {"no name", "int a$0;\n", "2a",
     "'2a' is no name: a name has letters, digits and '_', and does not begin with a digit"},
    {"two words", "int a$0;\n", "a b",
     "'a b' is no name: a name has letters, digits and '_', and does not begin with a digit"},
    {"a keyword", "int a$0;\n", "goto", "'goto' is a word of the language; choose another name"},
    {"a type", "int a$0;\n", "TTrapPrm",
     "'TTrapPrm' is a word of the language; choose another name"},
    {"a command", "int a$0;\n", "GT_AxisOn", "'GT_AxisOn' is a GT command; choose another name"},
    {"too long", "int a$0;\n", "a23456789012345678901234567890123",
     "'a23456789012345678901234567890123' has 33 characters; a name has at most 31"},
    {"of a command", "int f()\n{\n  GT_AxisOn$0(1);\n}\n", "x",
     "'GT_AxisOn' is a GT command: its name cannot be changed"},
    {"of nothing", "int f()\n{\n  $0\n}\n", "x", "there is no name here that the program declares"},
    {"taken in the same scope", "int a$0;\nint b;\n", "b",
     "'b' would mean something else in line 2 of p.c: the name is taken; choose another one"},
    {"taken by a macro", "#define b 1\nint a$0;\n", "b",
     "'b' is defined twice; choose another name"},
    {"a use would mean an inner variable", "int a$0;\nint f()\n{\n  int b = 1;\n  a = b;\n}\n", "b",
     "'b' would mean something else in line 5 of p.c: the name is taken; choose another one",
     kStructured},
    {"a name that is not declared", "int a$0;\nint f()\n{\n  b = 1;\n}\n", "b",
     "'b' would mean something else in line 4 of p.c: the name is taken; choose another one"},
    {"a rule of the compiler", "int a;\nint f()\n{\n  int b$0;\n  b = 1;\n}\n", "a",
     "the local 'a' has the name of a global variable; choose another name"},
    {"a rule of the compiler in structured C that does not say so",
     "int a;\nint c;\nvoid f()\n{\n  int b$0;\n  b = 1;\n  b++;\n  b++;\n  b++;\n  b++;\n  b++;\n"
     "  b++;\n  c = b;\n}\n",
     "a", "the local 'a' has the name of a global variable; choose another name"},
    {"a rule of the compiler behind all errors that are shown",
     "int a;\nvoid f()\n{\n  int b$0;\n"
     "  b++; b++; b++; b++; b++; b++; b++; b++; b++; b++;\n"
     "  b++; b++; b++; b++; b++; b++; b++; b++; b++; b++;\n"
     "  b++; b++; b++; b++; b++; b++; b++; b++; b++; b++;\n"
     "  b++; b++; b++; b++; b++; b++; b++; b++; b++; b++;\n"
     "  b++; b++; b++; b++; b++; b++; b++; b++; b++; b++;\n"
     "  b++; b++; b++; b++; b++; b++; b++; b++; b++; b++;\n"
     "}\n",
     "a", "the local 'a' has the name of a global variable; choose another name"},
    {"a word of structured C that does not say so",
     "int a$0;\nvoid f()\n{\n  a++;\n  a++;\n  a++;\n  a++;\n  a++;\n  a++;\n}\n", "bool",
     "int bool;\nvoid f()\n{\n  bool++;\n  bool++;\n  bool++;\n"
     "  bool++;\n  bool++;\n  bool++;\n}\n"},
    {"a macro that is used with two meanings",
     "#define M (a)\nint f(int $0a)\n{\n  return M;\n}\nint g(int a)\n{\n  return M;\n}\n", "b",
     "'a' stands in a macro that is used where it means different things", kStructured},
};

INSTANTIATE_TEST_SUITE_P(Rules, RenameTest, testing::ValuesIn(kRenameCases),
                         [](const auto& each) { return TestName(each.param.rule); });

TEST(Rename, EditsIncludedFiles) {
  const AnalysedSource source("#include \"h.h\"\nint f()\n{\n  a$0 = 1;\n}\n=== h.h\nint a;\n");
  const auto edits = Rename(source.analysis(), source.program(), source.cursor(), "b");
  ASSERT_TRUE(edits.ok());
  ASSERT_EQ(edits.value().size(), 2u);
  EXPECT_EQ(edits.value()[1]["file"], "h.h");
  EXPECT_EQ(edits.value()[1]["text"], "b");
}

}  // namespace
}  // namespace oncard::editor
