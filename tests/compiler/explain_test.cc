// Every diagnostic has a page in both languages, and its programs behave as the page says.
#include "compiler/explain.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "base/files.h"
#include "base/limits.h"
#include "compiler/compiler.h"
#include "compiler/dialect.h"
#include "compiler/display_text.h"
#include "compiler/lowering/lowering.h"
#include "compiler/lowering/overview.h"

namespace oncard::compiler {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr size_t kPageWidth = 80;

// Codes whose pages have no programs, with the reason.
const std::map<int, std::string> kWithoutPrograms = {
    {0, "this compiler never reports it"},
    {8, "takes 1025 macros"},
    {9, "takes 1025 labels"},
    {10, "takes 33 functions"},
    {122, "takes 32768 statements"},
    {130, "takes hundreds of parentheses"},
    {138, "takes a thousand operators"},
    {238, "takes hundreds of loops"},
    {239, "takes thousands of calls"},
};

// Nothing is included, so the use of the included name is a second error.
const std::set<int> kFollowedByUndeclared = {21, 22, 36, 37};

Compilation CompileStructured(const std::string& program, const FileReader& reader) {
  Lowering lowering = LowerText("program.c", program, {}, {}, reader);
  return TakeCompilation(lowering);
}

Compilation CompileExample(int code, std::string_view program) {
  const FileReader reader = [code](const std::string& path) -> Result<std::string> {
    for (const ExplanationFile& file : ExplanationFiles(code)) {
      if (file.name == path) return std::string(file.text);
    }
    return MakeError(kNoSuchFile, "no such file", "没有该文件");
  };
  if (WantsStructured(program)) return CompileStructured(std::string(program), reader);
  return CompileText("program.c", std::string(program), {}, reader);
}

// The codes that a compilation reports, in order: `MP027 MP041`.
std::string Codes(const Compilation& compilation) {
  std::string codes;
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    if (!codes.empty()) codes += ' ';
    codes += DiagnosticName(diagnostic.info->code);
  }
  return codes;
}

class ExplainTest : public testing::TestWithParam<int> {};

TEST_P(ExplainTest, HasAPageInBothLanguages) {
  const std::string title =
      fmt::format("{} {} (", DiagnosticName(GetParam()), FindDiagnostic(GetParam())->slug);
  const auto english = ExplainPage(GetParam(), Language::kEnglish);
  const auto chinese = ExplainPage(GetParam(), Language::kChinese);
  ASSERT_TRUE(english && chinese);
  EXPECT_TRUE(english->starts_with(title)) << *english;
  EXPECT_TRUE(chinese->starts_with(title)) << *chinese;
  EXPECT_NE(*english, *chinese);
}

void ExpectPlainText(std::string_view page) {
  ASSERT_THAT(page, EndsWith("\n"));
  EXPECT_THAT(page, Not(EndsWith("\n\n")));
  size_t begin = 0;
  while (begin < page.size()) {
    const size_t end = page.find('\n', begin);
    const std::string line(page.substr(begin, end - begin));
    const DisplayLine shown(line);
    EXPECT_EQ(shown.text(), line) << "not plain text";
    EXPECT_LE(shown.ColumnOf(line.size()), static_cast<int>(kPageWidth)) << line;
    EXPECT_THAT(line, Not(EndsWith(" ")));
    begin = end + 1;
  }
}

TEST_P(ExplainTest, PageIsPlainTextOf80Columns) {
  for (const Language language : {Language::kEnglish, Language::kChinese}) {
    ExpectPlainText(ExplainPage(GetParam(), language).value_or(""));
  }
}

TEST_P(ExplainTest, FailingProgramHasTheDiagnosticAndNoOther) {
  const Explanation* page = FindExplanation(GetParam());
  ASSERT_NE(page, nullptr);
  if (kWithoutPrograms.contains(GetParam())) {
    EXPECT_EQ(page->failing, "") << "kWithoutPrograms says: " << kWithoutPrograms.at(GetParam());
    return;
  }
  const std::string expected =
      DiagnosticName(GetParam()) + (kFollowedByUndeclared.contains(GetParam()) ? " MP027" : "");
  EXPECT_EQ(Codes(CompileExample(GetParam(), page->failing)), expected) << page->failing;
}

TEST_P(ExplainTest, FixedProgramHasNone) {
  const Explanation* page = FindExplanation(GetParam());
  ASSERT_NE(page, nullptr);
  if (kWithoutPrograms.contains(GetParam())) {
    EXPECT_EQ(page->fixed, "");
    return;
  }
  const Compilation compilation = CompileExample(GetParam(), page->fixed);
  EXPECT_EQ(Codes(compilation), "") << page->fixed;
  EXPECT_TRUE(compilation.ok());
}

std::vector<int> AllCodes() {
  std::vector<int> codes;
  for (const DiagnosticInfo& info : DiagnosticTable()) codes.push_back(info.code);
  return codes;
}

INSTANTIATE_TEST_SUITE_P(Diagnostics, ExplainTest, testing::ValuesIn(AllCodes()),
                         [](const auto& code) { return DiagnosticName(code.param); });

TEST(ExplainPageTest, OverviewOfStructuredCIsPlainTextOf80Columns) {
  for (const Language language : {Language::kEnglish, Language::kChinese}) {
    ExpectPlainText(StructuredOverview(language));
  }
}

TEST(ExplainPageTest, UnknownCodesHaveNone) {
  for (const int code : {-1, 51, 99, 142, 1000}) {
    EXPECT_EQ(ExplainPage(code, Language::kEnglish), std::nullopt) << code;
    EXPECT_EQ(ExplainPage(code, Language::kChinese), std::nullopt) << code;
  }
}

TEST(ExplainPageTest, SourcesHaveTheLimitsOfTheirPage) {
  for (const std::string_view text : {FindExplanation(22)->en, FindExplanation(22)->zh}) {
    EXPECT_THAT(text, HasSubstr(std::to_string(kSourceKind.bytes_max)));
    EXPECT_THAT(text, HasSubstr(std::to_string(kTokenMax)));
  }
}

TEST(ExplainPageTest, MessageStandsWithoutWhatTheCompilerFillsIn) {
  EXPECT_EQ(MessagePattern(27).en, "'...' is not declared; declare it before its first use");
  EXPECT_EQ(MessagePattern(24).en, "found '}' outside a function; it only ends a function");
  EXPECT_EQ(MessagePattern(40).zh, "此处是 ...，应为函数体的 '{'");
}

std::string ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ExplainPageTest, DiagnosticsReferenceIsUpToDate) {
  const std::string generated = ReadAll(ONCARD_GENERATED_DIAGNOSTICS);
  ASSERT_FALSE(generated.empty());
  EXPECT_TRUE(ReadAll(ONCARD_SOURCE_DIR "/docs/diagnostics.md") == generated)
      << "run `cmake --build . --target update_diagnostics_page`";
}

TEST(ExplainPageTest, ProgramsOfThePagesOfStructuredCAreUpToDate) {
  for (const char* name : {"/structured.md", "/structured.zh-CN.md"}) {
    const std::string generated = ReadAll(std::string(ONCARD_GENERATED_FOLDER) + name);
    ASSERT_FALSE(generated.empty());
    EXPECT_TRUE(ReadAll(std::string(ONCARD_SOURCE_DIR "/docs") + name) == generated)
        << "run `cmake --build . --target update_structured_page`";
  }
}

}  // namespace
}  // namespace oncard::compiler
