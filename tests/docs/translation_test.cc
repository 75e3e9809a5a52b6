// The Chinese pages correspond to the English ones: the same headings, code blocks and tables in
// the same order, and the same links, whatever the text between them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "base/files.h"
#include "tests/docs/page.h"

namespace oncard::docs {
namespace {

using ::testing::Contains;
using ::testing::UnorderedElementsAreArray;

std::string English(const std::string& name) { return name + ".md"; }
std::string Chinese(const std::string& name) { return name + ".zh-CN.md"; }

std::string Page(const std::string& path) { return ReadFile(ONCARD_SOURCE_DIR "/" + path).value(); }

// The links, with those to Chinese pages replaced by links to their English originals.
// the originals.
std::vector<std::string> LinksInEnglish(const std::string& page) {
  std::vector<std::string> links = Links(page);
  for (std::string& link : links) {
    link = std::regex_replace(link, std::regex(R"(\.zh-CN\.md$)"), ".md");
  }
  return links;
}

class TranslationTest : public testing::TestWithParam<const char*> {};

TEST_P(TranslationTest, HasTheHeadingsCodeBlocksAndTablesOfTheOriginal) {
  EXPECT_EQ(Skeleton(Page(Chinese(GetParam()))), Skeleton(Page(English(GetParam()))));
}

TEST_P(TranslationTest, HasTheLinksOfTheOriginal) {
  EXPECT_THAT(LinksInEnglish(Page(Chinese(GetParam()))),
              UnorderedElementsAreArray(LinksInEnglish(Page(English(GetParam())))));
}

TEST_P(TranslationTest, AndOriginalLeadToEachOther) {
  const std::string name = std::string(GetParam()).substr(std::string(GetParam()).rfind('/') + 1);
  EXPECT_THAT(Links(Page(English(GetParam()))), Contains(Chinese(name)));
  EXPECT_THAT(Links(Page(Chinese(GetParam()))), Contains(English(name)));
}

INSTANTIATE_TEST_SUITE_P(Pages, TranslationTest,
                         testing::Values("README", "docs/dotnet", "docs/from-ge", "docs/from-gt400",
                                         "docs/install", "docs/language", "docs/structured",
                                         "docs/windows", "docs/tutorials/1-first-program",
                                         "docs/tutorials/2-first-axis", "docs/tutorials/3-threads",
                                         "docs/tutorials/4-explore", "docs/tutorials/5-rewind",
                                         "docs/tutorials/6-structured", "docs/tutorials/7-host",
                                         "docs/tutorials/8-python",
                                         "docs/tutorials/9-any-instant"));

constexpr const char* kPage =
    "# Title\n"
    "text\n"
    "## Part\n"
    "| a | b |\n"
    "|---|---|\n"
    "| c | d |\n"
    "```c\n"
    "int i;  // counts\n"
    "```\n";

TEST(SkeletonTest, HoldsHeadingsCodeAndTablesInOrder) {
  EXPECT_EQ(Skeleton(kPage),
            "heading of level 1\n"
            "heading of level 2\n"
            "table of 3 rows\n"
            "```c\n"
            "int i;\n"
            "```\n");
}

struct Change {
  const char* name;
  const char* from;
  const char* to;
  bool differs;
};

void PrintTo(const Change& change, std::ostream* stream) { *stream << change.name; }

class SkeletonChangeTest : public testing::TestWithParam<Change> {};

TEST_P(SkeletonChangeTest, IsNoticedWhereItIsNotWords) {
  std::string changed = kPage;
  changed.replace(changed.find(GetParam().from), std::string_view(GetParam().from).size(),
                  GetParam().to);
  EXPECT_EQ(Skeleton(changed) != Skeleton(kPage), GetParam().differs) << changed;
}

INSTANTIATE_TEST_SUITE_P(Changes, SkeletonChangeTest,
                         testing::Values(Change{"words", "text", "other words", false},
                                         Change{"words_of_a_heading", "Part", "Teil", false},
                                         Change{"words_of_a_table", "| c | d |", "| e | f |",
                                                false},
                                         Change{"comment", "// counts", "// zählt", false},
                                         Change{"level_of_a_heading", "## Part", "### Part", true},
                                         Change{"heading_that_is_missing", "## Part\n", "", true},
                                         Change{"heading_that_is_new", "text\n", "## Text\n", true},
                                         Change{"row_that_is_missing", "| c | d |\n", "", true},
                                         Change{"code", "int i;", "int j;", true},
                                         Change{"language_of_code", "```c", "```sh", true},
                                         Change{"code_block_that_is_missing",
                                                "```c\nint i;  // counts\n```\n", "", true}),
                         [](const auto& change) { return change.param.name; });

}  // namespace
}  // namespace oncard::docs
