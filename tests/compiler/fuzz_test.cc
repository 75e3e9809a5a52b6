// No text may make the compiler crash, hang, or report a range outside the text; the machine's
// verifier must accept every program that the compiler accepts.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "base/files.h"
#include "compiler/diagnostic_printer.h"
#include "compiler/lowering/lowering.h"
#include "compiler/structured_source.h"
#include "compiler/syntax.h"
#include "compiler/tree_walk.h"
#include "tests/compiler/compiler_support.h"
#include "vm/verifier.h"

namespace oncard::compiler {
namespace {

constexpr uint32_t kSeed = 20090909;
constexpr int kMutationsPerProgram = 40;

// Structured C, too, has a tree and messages with places inside the text only.
void CheckStructured(const std::string& text, const MemoryFiles& files) {
  Reporter reporter;
  const StructuredSource source("test.c", text, {}, ReaderOf(files), reporter);
  source.AddMacroNotes(reporter);
  // A thousand messages about one long line take long to print.
  constexpr size_t kPrintedMax = 4000;
  Compilation printed;
  printed.files.assign(source.files().begin(), source.files().end());
  printed.diagnostics.assign(reporter.diagnostics().begin(), reporter.diagnostics().end());
  if (text.size() <= kPrintedMax) {
    ASSERT_EQ(PrintText(printed, {}).empty(), printed.diagnostics.empty());
  }
  const auto inside = [&source](const SourceRange& range) {
    return static_cast<size_t>(range.file) < source.files().size() && range.begin <= range.end &&
           range.end <= source.files()[static_cast<size_t>(range.file)].text().size();
  };
  for (const Diagnostic& diagnostic : reporter.diagnostics()) {
    ASSERT_TRUE(inside(diagnostic.range)) << DiagnosticName(diagnostic.info->code) << '\n' << text;
    for (const Note& note : diagnostic.notes) {
      ASSERT_TRUE(!note.has_place || inside(note.range)) << text;
    }
    for (const FixIt& edit : diagnostic.fixits) ASSERT_TRUE(inside(edit.range)) << text;
  }
  for (const StatementPtr& item : source.tree().items) {
    ForEachStatement(*item, [&](const Statement& statement) {
      EXPECT_TRUE(inside(statement.range)) << text;
      ForEachWholeExpression(statement, [&](const Expression& whole) {
        ForEachExpression(whole, [&](const Expression& expression) {
          EXPECT_TRUE(inside(expression.range)) << text;
        });
      });
    });
  }
}

// The lowering has a text exactly if it reports no error, and the text is a program of the card.
void CheckLowered(const std::string& text, const MemoryFiles& files) {
  const FileReader reader = ReaderOf(files);
  for (const bool optimize : {true, false}) {
    const Lowering lowering = LowerText("test.c", text, {}, {optimize, true}, reader);
    bool has_error = false;
    for (const Diagnostic& diagnostic : lowering.diagnostics) {
      has_error |= diagnostic.severity == Severity::kError;
      const SourceRange& range = diagnostic.range;
      ASSERT_LT(static_cast<size_t>(range.file), lowering.files.size()) << text;
      ASSERT_LE(range.end, lowering.files[static_cast<size_t>(range.file)].text().size()) << text;
    }
    ASSERT_NE(lowering.text.has_value(), has_error) << text;
    if (!lowering.object) continue;
    const CatalogueShapes shapes;
    const Result<void> verified = vm::Verify(*lowering.object, shapes);
    ASSERT_TRUE(verified.ok()) << verified.error().message.en << '\n' << text;
  }
}

void Check(const std::string& text) {
  const MemoryFiles files = {{"a.h", "#define A 1\nint t9() { return"}, {"b.h", text}};
  ASSERT_NO_FATAL_FAILURE(CheckStructured(text, files));
  ASSERT_NO_FATAL_FAILURE(CheckLowered(text, files));
  Options options;
  options.max_errors = 0;
  const Compilation compilation = CompileString(text, options, files);
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    const auto inside = [&compilation](const SourceRange& range) {
      return static_cast<size_t>(range.file) < compilation.files.size() &&
             range.begin <= range.end &&
             range.end <= compilation.files[static_cast<size_t>(range.file)].text().size();
    };
    ASSERT_NE(diagnostic.info, nullptr);
    ASSERT_TRUE(inside(diagnostic.range)) << DiagnosticName(diagnostic.info->code) << '\n' << text;
    for (const Note& note : diagnostic.notes) {
      ASSERT_TRUE(!note.has_place || inside(note.range)) << text;
    }
    std::vector<FixIt> edits = diagnostic.fixits;
    std::sort(edits.begin(), edits.end(), [](const FixIt& a, const FixIt& b) {
      return std::tuple(a.range.file, a.range.begin, a.range.end) <
             std::tuple(b.range.file, b.range.begin, b.range.end);
    });
    for (size_t i = 0; i < edits.size(); ++i) {
      ASSERT_TRUE(inside(edits[i].range)) << text;
      ASSERT_TRUE(i == 0 || edits[i - 1].range.file != edits[i].range.file ||
                  edits[i - 1].range.end <= edits[i].range.begin)
          << DiagnosticName(diagnostic.info->code) << " has edits that overlap\n"
          << text;
    }
  }
  ASSERT_NE(compilation.ok(),
            std::any_of(compilation.diagnostics.begin(), compilation.diagnostics.end(),
                        [](const Diagnostic& d) { return d.severity == Severity::kError; }));
  if (!compilation.ok()) return;
  const CatalogueShapes shapes;
  const Result<void> verified = vm::Verify(*compilation.object, shapes);
  ASSERT_TRUE(verified.ok()) << verified.error().message.en << '\n' << text;
}

std::vector<std::string> Corpus() {
  std::vector<std::string> paths;
  for (const char* folder : {"/tests/lang", "/samples"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(ONCARD_SOURCE_DIR) + folder)) {
      if (entry.path().extension() == ".c") paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const std::string& path : paths) texts.push_back(ReadFile(path).value());
  return texts;
}

TEST(Fuzz, MutatedPrograms) {
  static constexpr const char* kPieces[] = {"{",
                                            "}",
                                            "(",
                                            ")",
                                            ";",
                                            "[",
                                            "]",
                                            ",",
                                            ":",
                                            "=",
                                            "-",
                                            "*",
                                            "&",
                                            "++",
                                            "/*",
                                            "\"",
                                            "'",
                                            "#",
                                            "int ",
                                            "if (",
                                            "else ",
                                            "while (",
                                            "for (",
                                            "do ",
                                            "goto ",
                                            "x",
                                            "0",
                                            "1e9",
                                            "09",
                                            "return ",
                                            "switch ",
                                            "case ",
                                            "default:",
                                            "break;",
                                            "\n",
                                            "\\",
                                            "\xEF\xBC\x9B",
                                            "\xA3\xBB",
                                            "\xFF",
                                            "\x80",
                                            "GT_Update(",
                                            "struct ",
                                            "TPid ",
                                            "?",
                                            ".",
                                            "#include \"a.h\"\n",
                                            "#include \"b.h\"\n",
                                            "#define A 2\n",
                                            "#define F(a) a F(a) A\n",
                                            "F(",
                                            "#if 1\n",
                                            "#else\n",
                                            "#endif\n",
                                            "\\\n",
                                            "enum ",
                                            "sizeof(",
                                            "typedef ",
                                            "...",
                                            "long ",
                                            "void ",
                                            "double "};
  const std::vector<std::string> corpus = Corpus();
  ASSERT_GT(corpus.size(), 50u);
  std::mt19937 random(kSeed);
  const auto below = [&random](size_t limit) {
    return static_cast<size_t>(random()) % std::max<size_t>(1, limit);
  };
  for (size_t i = 0; i < corpus.size(); ++i) {
    for (int k = 0; k < kMutationsPerProgram; ++k) {
      std::string text = corpus[i];
      const size_t edits = 1 + below(4);
      for (size_t e = 0; e < edits && !text.empty(); ++e) {
        const size_t at = below(text.size());
        switch (below(5)) {
          case 0:
            text.erase(at, 1 + below(12));
            break;
          case 1:
            text.insert(at, kPieces[below(std::size(kPieces))]);
            break;
          case 2:
            text[at] = static_cast<char>(below(256));
            break;
          case 3:
            text.insert(at, text.substr(below(text.size()), below(60)));
            break;
          default: {
            const std::string& other = corpus[below(corpus.size())];
            if (!other.empty()) text.insert(at, other.substr(below(other.size()), below(80)));
          }
        }
      }
      ASSERT_NO_FATAL_FAILURE(Check(text)) << "seed " << kSeed;
    }
  }
}

TEST(Fuzz, RandomBytes) {
  std::mt19937 random(kSeed);
  for (int k = 0; k < 500; ++k) {
    std::string text(random() % 200, '\0');
    for (char& c : text) c = static_cast<char>(random());
    ASSERT_NO_FATAL_FAILURE(Check(text));
  }
}

TEST(Fuzz, RandomTokens) {
  static constexpr const char* kTokens[] = {
      "int",       "double",    "void",  "if",      "goto",  "return",   "else", "while", "for",
      "do",        "switch",    "case",  "default", "break", "continue", "a",    "b",     "f",
      "GT_Update", "GT_GetSts", "1",     "2.5",     "(",     ")",        "{",    "}",     "[",
      "]",         ";",         ",",     ":",       "=",     "+",        "-",    "*",     "&",
      "!",         "<",         "&&",    "++",      "+=",    "?",        ".",    "->",    "TPid",
      "struct",    "~",         "\"s\"", "abs",     "\n"};
  std::mt19937 random(kSeed);
  for (int k = 0; k < 3000; ++k) {
    std::string text = random() % 2 == 0 ? "int a, b; int f() { " : "";
    const size_t count = random() % 40;
    for (size_t i = 0; i < count; ++i) {
      text += kTokens[random() % std::size(kTokens)];
      text += ' ';
    }
    ASSERT_NO_FATAL_FAILURE(Check(text));
  }
}

// Long and deep input: the time must be proportional to the length, and the stack limited.
TEST(Fuzz, ManyOfOneThing) {
  for (const std::string piece : {"(",         ")",          "{",
                                  "}",         "[",          "]",
                                  "a[",        "-",          "!",
                                  "a+",        "a,",         "if(a)",
                                  "else ",     "while(a)",   "do ",
                                  "for(;;)",   "{int f(){",  "int f(){",
                                  "int a[1]",  "\"",         "'",
                                  "/*",        "//",         "#",
                                  "#define ",  "#if 1\n",    "sizeof(enum{a=",
                                  "F(",        "a:",         "case 1:",
                                  "goto ",     ";",          "int ",
                                  "a ",        "a=",         "a?",
                                  "a.b",       "&",          "0",
                                  ".",         "\xFF",       "= {",
                                  "int x = {", "switch(a){", "return "}) {
    std::string text = "int a; int t0() {\n";
    for (int i = 0; i < 3000; ++i) text += piece;
    ASSERT_NO_FATAL_FAILURE(Check(text)) << piece;
    ASSERT_NO_FATAL_FAILURE(Check(text.substr(18))) << piece;
  }
}

// Well-formed nesting up to the maximum depth, in every position that the rewriter handles
// specially: its work must not double with each level.
TEST(Fuzz, DeepButWellFormed) {
  struct Nest {
    const char* open;
    const char* middle;
    const char* close;
  };
  for (const Nest& nest :
       {Nest{"v ? 1 : ", "v", ""}, Nest{"v ? ", "v", " : 2"}, Nest{"(", "v", ")"},
        Nest{"a[", "v", "]"}, Nest{"v = ", "v", ""}, Nest{"-", "v", ""}, Nest{"abs(", "v", ")"},
        Nest{"v + (", "v", " * 2)"}, Nest{"(double) (", "v", ")"}, Nest{"(v, ", "v", ")"}}) {
    std::string expression = nest.middle;
    for (int i = 0; i < kDepthMax / 2 - 2; ++i) expression = nest.open + expression + nest.close;
    for (const char* form : {"v = ", "if (", "while (", "return "}) {
      std::string text = "int v, a[4]; int t0() { ";
      text += form;
      text += expression;
      text += form == std::string("if (") || form == std::string("while (") ? ") v = 1; }" : "; }";
      ASSERT_NO_FATAL_FAILURE(Check(text));
    }
  }
}

}  // namespace
}  // namespace oncard::compiler
