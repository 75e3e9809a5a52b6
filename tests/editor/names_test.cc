// Which declaration a name means, and where it is used. In each source `@` stands before all places
// of one symbol.
#include "editor/names.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/editor/marked_source.h"

namespace oncard::editor {
namespace {

struct NamesCase {
  const char* rule;
  const char* source;
  bool structured = false;
};

std::ostream& operator<<(std::ostream& out, const NamesCase& rule) { return out << rule.rule; }

class NamesTest : public testing::TestWithParam<NamesCase> {};

TEST_P(NamesTest, FindsExactlyThePlacesOfASymbol) {
  const MarkedSource source(GetParam().source, GetParam().structured);
  // The marks of places are taken out first.
  std::map<std::string, std::string> files;
  std::map<std::string, std::vector<uint32_t>> marks;
  for (const auto& [path, marked] : source.files()) {
    for (const char c : marked) {
      if (c == '@') {
        marks[path].push_back(static_cast<uint32_t>(files[path].size()));
      } else {
        files[path] += c;
      }
    }
  }
  const auto reader = [&files](const std::string& path) -> Result<std::string> {
    if (!files.contains(path)) return MakeError(kNoSuchFile, "no {}", "没有 {}", path);
    return files[path];
  };
  const ProgramText text(source.main(), files[source.main()], source.Options(), reader);
  const Names names(text);
  ASSERT_FALSE(marks.empty());
  const Reference* at = nullptr;
  for (const auto& [path, offsets] : marks) {
    const auto file = text.Find(path);
    ASSERT_TRUE(file) << path;
    at = names.At(*file, offsets.front());
    ASSERT_NE(at, nullptr) << path << " " << offsets.front();
    std::vector<uint32_t> found;
    for (const Reference& each : names.references()) {
      if (each.symbol == at->symbol && each.range.file == *file) found.push_back(each.range.begin);
    }
    EXPECT_EQ(found, offsets) << path;
  }
  for (size_t file = 0; file < text.files().size(); ++file) {
    const std::string& path = text.file(static_cast<int>(file)).file.path();
    for (const Reference& each : names.references()) {
      if (each.symbol != at->symbol || each.range.file != static_cast<int>(file)) continue;
      EXPECT_TRUE(marks.contains(path)) << path;
    }
  }
}

constexpr NamesCase kNamesCases[] = {
    {"global", "int @a;\nint f()\n{\n  @a = 1;\n  b = @a;\n}\nint g()\n{\n  return @a;\n}\n"},
    {"local", "int f()\n{\n  int @a;\n  @a = 1;\n}\nint g()\n{\n  int a;\n  a = 1;\n}\n"},
    {"local hides global",
     "int @a;\nint f()\n{\n  int a;\n  a = 1;\n}\nint g()\n{\n  @a = 1;\n}\n"},
    {"parameter", "int f(int @a, int b)\n{\n  b = @a;\n}\nint g(int a)\n{\n  return a;\n}\n"},
    {"labels belong to their function",
     "int f()\n{\n@a:\n  goto @a;\n}\nint g()\n{\na:\n  goto a;\n}\n"},
    {"a label is no variable", "int f()\n{\n  int a;\n@a:\n  a = 1;\n  if (a) goto @a;\n}\n"},
    {"function", "int f();\nint @g()\n{\n  return 1;\n}\n"},
    {"prototype and definition", "int @g(int a);\nint f()\n{\n  @g(1);\n}\nint @g(int b)\n{\n}\n",
     true},
    {"a parameter of a prototype is its own", "int g(int @a);\nint g(int a)\n{\n  a = 1;\n}\n",
     true},
    {"macro", "#define @N 4\nint a[@N];\nint f()\n{\n  a[0] = @N;\n}\n"},
    {"macro in a macro", "#define @N 4\n#define M (@N + 1)\nint f()\n{\n  int a = M;\n}\n", true},
    {"macro until #undef",
     "#define @N 4\nint f()\n{\n  int a = @N;\n}\n#undef @N\nint g()\n{\n  int N;\n  N = 1;\n}\n",
     true},
    {"macro in conditions",
     "#define @N 4\n#if @N > 3 && defined(@N)\nint a;\n#endif\n#ifdef @N\n#endif\n", true},
    {"macro parameter", "#define M(@a, b) (@a + b * @a)\nint a;\n", true},
    {"a macro with parameters is used with them",
     "#define @M(a) (a)\nint f()\n{\n  return @M(1);\n}\n", true},
    {"global in the body of a macro", "int @a;\n#define M (@a + 1)\nint f()\n{\n  return M;\n}\n",
     true},
    {"local in the body of a macro",
     "int a;\n#define M (@a + 1)\nint f()\n{\n  int @a = 2;\n  return M;\n}\n", true},
    {"argument of a macro", "#define M(x) (x)\nint f(int @a)\n{\n  return M(@a + 1);\n}\n", true},
    {"blocks", "int f()\n{\n  int a = 1;\n  {\n    int @a = 2;\n    @a = 3;\n  }\n  a = 4;\n}\n",
     true},
    {"before the inner declaration it is the outer one",
     "int f()\n{\n  int @a = 1;\n  {\n    @a = 2;\n    int a = 3;\n    a = 4;\n  }\n}\n", true},
    {"variable of a loop",
     "int f()\n{\n  for (int @i = 0; @i < 3; @i++) g(@i);\n  for (int i = 0; i < 3; ++i) { g(i); "
     "}\n}\n",
     true},
    {"loop with if and else as its body",
     "int i;\nint f()\n{\n  for (int @i = 0; @i < 3; ++@i) if (@i) g(@i); else g(@i);\n  i = "
     "1;\n}\n",
     true},
    {"constant of an enum", "enum E { A, @B = 4, C };\nint f()\n{\n  return @B + C;\n}\n", true},
    {"name of an enum", "enum @E { A };\nenum @E x;\n", true},
    {"name of a structure, and a variable called so",
     "struct @s { int x; };\nstruct @s s;\nint f(struct @s *p)\n{\n  return s.x + sizeof(struct "
     "@s);\n}\n",
     true},
    {"member of a structure",
     "struct s { int @x; };\nstruct t { struct s in[2]; int x; };\nstruct t a[3];\nint x;\n"
     "int f(struct s *p)\n{\n  x = p->@x + (*p).@x;\n  return a[x].in[1].@x + a[x].x;\n}\n",
     true},
    {"member of a type", "typedef struct { int @x; } s;\ns a;\nint f(s b)\n{\n  a.@x = b.@x;\n}\n",
     true},
    {"name of a typedef",
     "typedef struct { int x; } @s;\n@s a;\nint f(const @s *b)\n{\n  @s c;\n  c.x = b->x;\n}\n",
     true},
    {"after a structure that is not closed",
     "struct s {\n  int x;\nint @f()\n{\n  return 1;\n}\nint g()\n{\n  return @f();\n}\n", true},
    {"two in one declaration", "int a, @b[3], c;\nint f()\n{\n  @b[0] = a;\n}\n"},
    {"in a dimension and in an initial value",
     "#define @N 3\nint a[@N];\nint f()\n{\n  int b[2] = {@N, a[@N - 1]};\n}\n", true},
    {"members are no variables", "int @acc;\nTTrapPrm t;\nint f()\n{\n  t.acc = @acc;\n}\n"},
    {"structure", "TTrapPrm @t;\nint f()\n{\n  @t.acc = 1.0;\n  GT_SetTrapPrm(1, &@t);\n}\n"},
    {"command", "int f()\n{\n  @GT_AxisOn(1);\n  @GT_AxisOn(2);\n  GT_AxisOff(1);\n}\n"},
    {"conditional operator", "int f(int a)\n{\n  int @b = 1;\n  return a ? @b : 2;\n}\n", true},
    {"case", "enum { @A };\nint f(int x)\n{\n  switch (x) {\n    case @A:\n      x = 1;\n  }\n}\n",
     true},
    {"cast", "int f()\n{\n  int @a;\n  double d;\n  d = (double)@a;\n}\n"},
    {"included file", "#include \"h.h\"\nint f()\n{\n  @a = 1;\n}\n=== h.h\nint @a;\n"},
    {"file in another folder",
     "=== sub/p.c\n#include \"h.h\"\nint f()\n{\n  return @a;\n}\n=== sub/h.h\n#define @a 1\n"},
    {"file that is included twice",
     "#include \"h.h\"\n#include \"h.h\"\nint f()\n{\n  return @A;\n}\n=== h.h\n#define @A 1\n",
     true},
    {"branches that are not compiled",
     "#define X 0\n#if X\nint @a;\n#else\nint @a;\n#endif\nint f()\n{\n  @a = 1;\n}\n", true},
    // Mistakes in the text.
    {"missing semicolon", "int @a\nint b;\nint f()\n{\n  b = @a\n  @a = b\n  int c;\n}\n"},
    {"missing semicolon before a label", "int f()\n{\n  int x;\n  x = 1\n@a:\n  goto @a;\n}\n"},
    {"missing parenthesis", "int f(int @a)\n{\n  GT_AxisOn(@a;\n  g((@a + 1;\n  @a = 2;\n}\n"},
    {"missing brace", "int f()\n{\n  int @a;\n  @a = 1;\n\nint g()\n{\n  int a;\n  a = 1;\n}\n"},
    {"superfluous brace", "int @a;\nint f()\n{\n  @a = 1;\n}\n}\nint g()\n{\n  @a = 2;\n}\n"},
    {"half a function", "int @a;\nint f(int b\n{\n  @a = b;\n}\nint g()\n{\n  @a = 2;\n}\n"},
    {"characters that the language does not have",
     "int @a;\nint f()\n{\n  @a = $ 1;\n  @a ` 2；\n}\n"},
};

INSTANTIATE_TEST_SUITE_P(Rules, NamesTest, testing::ValuesIn(kNamesCases),
                         [](const auto& each) { return TestName(each.param.rule); });

}  // namespace
}  // namespace oncard::editor
