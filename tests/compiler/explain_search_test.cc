// `oncard explain` finds a page by different kinds of search words.
#include "compiler/explain_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/diagnostic.h"
#include "compiler/explain.h"

namespace oncard::compiler {
namespace {

using testing::HasSubstr;

using Found = std::vector<int>;

TEST(ExplainSearch, TakesNumbers) {
  for (const char* text : {"MP027", "mp027", "Mp27", "27", "027"}) {
    EXPECT_EQ(SearchDiagnostics(text), Found{27}) << text;
  }
  for (const char* text : {"51", "MP999", "99999999999"}) {
    EXPECT_EQ(SearchDiagnostics(text), Found{}) << text;
  }
}

TEST(ExplainSearch, TakesEverySlug) {
  for (const DiagnosticInfo& info : DiagnosticTable()) {
    EXPECT_EQ(SearchDiagnostics(info.slug), Found{info.code}) << info.slug;
  }
  EXPECT_EQ(SearchDiagnostics("While Loop"), Found{101});
}

// Checked with the texts themselves: only they determine on which pages `goto` occurs.
TEST(ExplainSearch, FindsEachTextWithTheWord) {
  const Found found = SearchDiagnostics("GOTO");
  size_t in_messages = 0;
  for (const DiagnosticInfo& info : DiagnosticTable()) {
    const bool in_message = info.en.find("goto") != std::string_view::npos;
    const bool in_page = FindExplanation(info.code)->en.find("goto") != std::string_view::npos;
    const auto at = std::find(found.begin(), found.end(), info.code);
    EXPECT_EQ(at != found.end(), in_message || in_page) << info.slug;
    if (!in_message) continue;
    ++in_messages;
    EXPECT_LT(at - found.begin(), static_cast<std::ptrdiff_t>(in_messages)) << info.slug;
  }
  EXPECT_GT(in_messages, 5u);
  EXPECT_LT(in_messages, found.size());
}

TEST(ExplainSearch, AsksForTheBeginningsOfAllWords) {
  const auto has = [](std::string_view text, int code) {
    const Found found = SearchDiagnostics(text);
    return std::find(found.begin(), found.end(), code) != found.end();
  };
  EXPECT_TRUE(has("brace", 116));
  EXPECT_TRUE(has("braces block", 116));
  EXPECT_FALSE(has("braces switch", 116));
  EXPECT_FALSE(has("races", 116));
  EXPECT_TRUE(has("花括号", 116));
  EXPECT_TRUE(has("'{'", 40));
  EXPECT_EQ(SearchDiagnostics("  "), Found{});
  EXPECT_EQ(SearchDiagnostics("quaternion"), Found{});
}

TEST(ExplainSearch, SaysWhatToTry) {
  struct Case {
    const char* text;
    const char* advice;
  };
  const Case cases[] = {
      {"142", "there are MP000 to MP050, MP100 to MP141"},
      {"undeclard", "did you mean 'undeclared'?"},
      {"Wile-Loop", "did you mean 'while-loop'?"},
      {"quaternion", "a word such as goto"},
  };
  for (const Case& test : cases) {
    const Message advice = AdviseSearch(test.text);
    EXPECT_THAT(advice.en, HasSubstr(test.advice));
    EXPECT_NE(advice.en, advice.zh);
  }
}

TEST(ExplainSearch, ListsNumberSlugAndMessage) {
  EXPECT_EQ(ExplainList(Found{24, 27}, Language::kEnglish),
            "MP024 stray-brace\n    found '}' outside a function; it only ends a function\n"
            "MP027 undeclared\n    '...' is not declared; declare it before its first use\n");
  EXPECT_EQ(ExplainList(Found{24}, Language::kChinese),
            "MP024 stray-brace\n    函数之外出现 '}'；它只能用于结束函数\n");
}

}  // namespace
}  // namespace oncard::compiler
