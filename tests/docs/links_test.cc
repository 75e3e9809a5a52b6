// Every link in the documentation refers to a file, every table has a heading, and every folder in
// the root README's table has a README.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "base/files.h"
#include "tests/docs/own_files.h"
#include "tests/docs/page.h"

namespace oncard::docs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

namespace fs = std::filesystem;

const fs::path kRoot = ONCARD_SOURCE_DIR;

std::vector<std::string> FoldersOf(const std::string& readme) {
  static const std::regex kRow(R"(\n\| `([a-z/]+)/` \|)");
  std::vector<std::string> folders;
  for (std::sregex_iterator row(readme.begin(), readme.end(), kRow), end; row != end; ++row) {
    folders.push_back((*row)[1]);
  }
  return folders;
}

TEST(LinksTest, AreThoseOutsideOfCode) {
  EXPECT_THAT(Links("[a](a.md), [b](b/b.md#part)\n"
                    "```\n"
                    "[c](c.md)\n"
                    "```\n"
                    "[web](https://example.com) [here](#here)\n"
                    "![d](d.svg)\n"),
              ElementsAre("a.md", "b/b.md", "d.svg"));
}

TEST(LinksTest, LeadToFiles) {
  size_t links = 0;
  for (const fs::path& page : OwnFiles(".md")) {
    for (const std::string& link : Links(ReadFile(page).value())) {
      ++links;
      EXPECT_TRUE(fs::exists(page.parent_path() / link)) << page << " leads to " << link;
    }
  }
  EXPECT_GT(links, 0u);
}

/// The numbers of lines at which a table begins without a line of dashes below its heading.
std::vector<size_t> HeadlessTables(const std::string& page) {
  std::vector<size_t> lines;
  std::istringstream text(page);
  std::string before;
  std::string line;
  bool begins = false;
  bool is_code = false;
  for (size_t number = 1; std::getline(text, line); ++number) {
    const bool headed = line.starts_with("|--") || line.starts_with("| --");
    if (begins && !headed) lines.push_back(number - 1);
    if (line.starts_with("```")) is_code = !is_code;
    begins = !is_code && line.starts_with("|") && !before.starts_with("|");
    before = line;
  }
  return lines;
}

TEST(TablesTest, AreCutByABlankLine) {
  EXPECT_THAT(HeadlessTables("| a | b |\n|---|---|\n| 1 | 2 |\n\n| 3 | 4 |\n| 5 | 6 |\n"
                             "```\n| code |\n```\n"),
              ElementsAre(5));
}

TEST(TablesTest, HaveHeadings) {
  for (const fs::path& page : OwnFiles(".md")) {
    EXPECT_THAT(HeadlessTables(ReadFile(page).value()), IsEmpty()) << page;
  }
}

TEST(ReadmeTest, EveryFolderHasTheOneThatItsRowPromises) {
  const std::vector<std::string> folders = FoldersOf(ReadFile(kRoot / "README.md").value());
  EXPECT_THAT(folders, SizeIs(testing::Ge(1u)));
  for (const std::string& folder : folders) {
    EXPECT_TRUE(fs::exists(kRoot / folder / "README.md")) << folder;
  }
}

TEST(ReadmeTest, EveryFolderHasARow) {
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(kRoot)) {
    const std::string name = entry.path().filename();
    if (entry.is_directory() && !name.starts_with('.') && name != "build") folders.push_back(name);
  }
  EXPECT_THAT(FoldersOf(ReadFile(kRoot / "README.md").value()), testing::IsSupersetOf(folders));
}

}  // namespace
}  // namespace oncard::docs
