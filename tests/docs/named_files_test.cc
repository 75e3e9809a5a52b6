// Files that pages and headers name by their path exist: a file that was moved is still named by
// those who sent readers to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "base/files.h"
#include "tests/docs/own_files.h"

namespace oncard::docs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

const fs::path kRoot = ONCARD_SOURCE_DIR;

/// The first group of each match.
std::set<std::string> Matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator each(text.begin(), text.end(), pattern), end; each != end; ++each) {
    found.insert((*each)[1]);
  }
  return found;
}

/// Paths from the root to sources, in backquotes. Those in the README of a folder can begin there.
std::vector<std::string> MissingFiles(const std::string& page, const fs::path& folder) {
  static const std::regex kSource(R"(`([a-z0-9_]+(?:/[a-zA-Z0-9_.]+)+\.(?:cc|h|def|re|yy|inc))`)");
  std::vector<std::string> missing;
  for (const std::string& name : Matches(page, kSource)) {
    if (!fs::exists(kRoot / name) && !fs::exists(folder / name)) missing.push_back(name);
  }
  return missing;
}

TEST(NamedFiles, AreLookedForFromTheRootAndFromTheFolder) {
  EXPECT_THAT(
      MissingFiles("`base/files.h` `files.h` `docs/page.h` `base/nothing.h`", kRoot / "tests"),
      ElementsAre("base/nothing.h"));
}

TEST(NamedFiles, OfPagesExist) {
  for (const fs::path& page : OwnFiles(".md")) {
    EXPECT_THAT(MissingFiles(ReadFile(page).value(), page.parent_path()), IsEmpty()) << page;
  }
}

TEST(NamedFiles, ThatTestAHeaderExist) {
  static const std::regex kTest(R"(Tested by(?:\n//)? (tests/[a-z0-9_/]+\.cc))");
  size_t tests = 0;
  for (const fs::path& header : OwnFiles(".h")) {
    for (const std::string& test : Matches(ReadFile(header).value(), kTest)) {
      ++tests;
      EXPECT_TRUE(fs::exists(kRoot / test)) << header << " names " << test;
    }
  }
  EXPECT_GT(tests, 0u);
}

}  // namespace
}  // namespace oncard::docs
