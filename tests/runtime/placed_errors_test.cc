// Errors with places in files (runtime/scenario/file/placed_errors.h).
#include "runtime/scenario/file/placed_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace oncard::runtime {
namespace {

using ::testing::EndsWith;

std::shared_ptr<const TextFile> FileOf(const std::string& path, const std::string& text) {
  return std::make_shared<const TextFile>(path, text);
}

TEST(TextFile, HasLinesFromOne) {
  const TextFile file("a.toml", "first\n\nthird");
  EXPECT_EQ(file.Line(1), "first");
  EXPECT_EQ(file.Line(2), "");
  EXPECT_EQ(file.Line(3), "third");
  for (const int none : {-1, 0, 4}) EXPECT_EQ(file.Line(none), "") << none;
}

TEST(TextPlace, ShowsItsLineWithACaret) {
  const TextPlace place = {FileOf("a.toml", "x = 1\nrate = 0\n"), 2, 8, 7, 8};
  EXPECT_EQ(place.Headline(), "a.toml:2:8: ");
  EXPECT_EQ(place.Excerpt(), "\n    2 | rate = 0\n      |        ^");
}

TEST(TextPlace, IsCountedAsTheFileCountsThatItsTextIsAPartOf) {
  const TextMargin margin = {3, 2};
  const TextPlace place = {std::make_shared<const TextFile>("a.schedule", "rate = 0\n", margin), 1,
                           8, 7, 8};
  EXPECT_EQ(place.Headline(), "a.schedule:4:10: ");
  EXPECT_EQ(place.Excerpt(), "\n    4 | rate = 0\n      |        ^");
}

TEST(TextPlace, AWholeFileHasNoLine) {
  const TextPlace place = {FileOf("a.toml", "x = 1\n")};
  EXPECT_EQ(place.Headline(), "a.toml: ");
  EXPECT_EQ(place.Excerpt(), "");
}

TEST(TextPlace, NowhereSaysNothing) {
  EXPECT_EQ(TextPlace().Headline(), "");
  EXPECT_EQ(TextPlace().Excerpt(), "");
}

TEST(TextPlace, ALongLineIsNotShown) {
  const auto excerpt = [](size_t length) {
    return TextPlace{FileOf("a.toml", std::string(length, 'x')), 1, 1, 0, 1}.Excerpt();
  };
  EXPECT_NE(excerpt(TextPlace::kExcerptMax), "");
  EXPECT_EQ(excerpt(TextPlace::kExcerptMax + 1), "");
}

TEST(PlacedErrors, WithoutOneThereIsNoFailure) {
  EXPECT_TRUE(PlacedErrors().empty());
  EXPECT_FALSE(PlacedErrors().Failure());
}

TEST(PlacedErrors, AreToldInTheOrderOfTheirPlaces) {
  const auto a = FileOf("a.toml", "one two\nthree\n");
  const auto b = FileOf("b.toml", "four\n");
  PlacedErrors errors;
  errors.Add({}, {"nowhere", "无位置"});
  errors.Add({b, 1, 1, 0, 4}, {"fifth", "五"});
  errors.Add({a, 2, 1, 0, 5}, {"third", "三"});
  errors.Add({a, 1, 5, 4, 7}, {"second", "二"});
  errors.Add({a, 2, 1, 0, 5}, {"fourth", "四"});
  errors.Add({a, 1, 1, 0, 3}, {"first", "一"});
  const Message all = errors.Failure()->message;
  EXPECT_EQ(all.en,
            "a.toml:1:1: first\n    1 | one two\n      | ^~~\n"
            "a.toml:1:5: second\n    1 | one two\n      |     ^~~\n"
            "a.toml:2:1: third\n    2 | three\n      | ^~~~~\n"
            "a.toml:2:1: fourth\n    2 | three\n      | ^~~~~\n"
            "b.toml:1:1: fifth\n    1 | four\n      | ^~~~\n"
            "nowhere");
  EXPECT_EQ(all.zh.substr(0, all.zh.find('\n')), "a.toml:1:1: 一");
}

TEST(PlacedErrors, ManyAreCounted) {
  PlacedErrors errors;
  for (size_t i = 0; i < PlacedErrors::kShown + 3; ++i) errors.Add({}, {"wrong", "有误"});
  const Message all = errors.Failure()->message;
  EXPECT_THAT(all.en, EndsWith("wrong\n3 more errors"));
  EXPECT_THAT(all.zh, EndsWith("有误\n另有 3 个错误"));
  EXPECT_EQ(std::count(all.en.begin(), all.en.end(), '\n'), std::ptrdiff_t{PlacedErrors::kShown});
}

}  // namespace
}  // namespace oncard::runtime
