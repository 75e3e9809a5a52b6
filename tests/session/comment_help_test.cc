#include "session/comment_help.h"

#include <gmock/gmock.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "explore/models/problem.h"
#include "session/arguments.h"

namespace oncard::session {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAreArray;

/// Asks at the place that `$` marks.
template <typename Ask>
std::optional<Json> AskAt(const std::string& marked, const Ask& ask,
                          Language language = Language::kEnglish) {
  const size_t at = marked.find('$');
  editor::Place place;
  for (const char c : marked.substr(0, at)) {
    place =
        c == '\n' ? editor::Place{place.line + 1, 1} : editor::Place{place.line, place.column + 1};
  }
  const compiler::SourceFile file("p.c", marked.substr(0, at) + marked.substr(at + 1));
  return ask(file, place, language);
}

std::vector<std::string> WordsAt(const std::string& marked) {
  std::vector<std::string> labels;
  const auto answer = AskAt(marked, CompleteComment);
  if (!answer) return {"no comment"};
  for (const Json& item : (*answer)["items"]) labels.push_back(item["label"]);
  return labels;
}

TEST(CommentHelp, OffersWhatTheExplorerReads) {
  const auto refused = explore::ReadCommentLines("p.c", "//@ nonsense\n");
  ASSERT_FALSE(refused.ok());
  // Three are comments of the compiler.
  std::set<std::string> known = {"assert", "depth", "structured"};
  const std::string& text = refused.error().message.en;
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
  for (size_t at = text.find("//@ "); at != std::string::npos; at = text.find("//@ ", at)) {
    at += 4;
    known.insert(text.substr(at, text.find_first_not_of(kLetters, at) - at));
  }
  known.erase("nonsense");
  const auto labels = WordsAt("int n;\n//@ $\n");
  EXPECT_THAT(labels, UnorderedElementsAreArray(known));
  EXPECT_EQ(WordsAt("  //@ne$"), labels);
}

TEST(CommentHelp, OffersTheValuesOfAWord) {
  EXPECT_THAT(WordsAt("//@ races: $"), ElementsAre("none", "benign"));
  EXPECT_THAT(WordsAt("//@ livelock: a$"), ElementsAre("any", "none"));
  EXPECT_THAT(WordsAt("//@ deadlock:$"), Contains("any"));
  EXPECT_THAT(WordsAt("//@ always: n$"), IsEmpty());
  EXPECT_THAT(WordsAt("//@ unknown: $"), IsEmpty());
}

TEST(CommentHelp, IsSilentElsewhere) {
  for (const char* marked : {"$", "int n;$", "// $", "/$/@ final: n", "n = 1; //@ $"}) {
    EXPECT_FALSE(AskAt(marked, CompleteComment)) << marked;
    EXPECT_FALSE(AskAt(marked, DescribeComment)) << marked;
  }
  EXPECT_THAT(WordsAt("//@ within 5 m$s: n == 1 -> n == 2"), IsEmpty());
}

TEST(CommentHelp, ReplacesTheWordAtThePlace) {
  const auto answer = AskAt("  //@ endl$ess\n", CompleteComment);
  ASSERT_TRUE(answer);
  const Json range = {
      {"file", "p.c"}, {"line", 1}, {"column", 7}, {"end_line", 1}, {"end_column", 14}};
  EXPECT_EQ((*answer)["range"], range);
}

TEST(CommentHelp, DescribesAWordInBothLanguages) {
  const auto within = AskAt("//@ with$in 5 ms: n == 1 -> n == 2", DescribeComment);
  ASSERT_TRUE(within);
  EXPECT_EQ((*within)["name"], "within");
  EXPECT_THAT((*within)["markdown"].get<std::string>(),
              HasSubstr("`//@ within 5 ms: CONDITION -> CONDITION`"));
  const auto chinese = AskAt("//@ $within 5 ms: n", DescribeComment, Language::kChinese);
  ASSERT_TRUE(chinese);
  EXPECT_THAT((*chinese)["markdown"].get<std::string>(), HasSubstr("须在此时间内成立"));
  EXPECT_FALSE(AskAt("//@ within 5 ms: n$ == 1", DescribeComment));
  EXPECT_FALSE(AskAt("//@ unk$nown: n", DescribeComment));
}

}  // namespace
}  // namespace oncard::session
