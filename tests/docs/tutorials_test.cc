// The tutorials do what they show. A block with a title is a file that the reader saves, a block of
// `sh` is typed in the folder of the project, and the block of text after it is what appears then.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "base/files.h"
#include "tests/docs/page.h"
#include "tests/tools/process.h"

namespace oncard::docs {
namespace {

using ::testing::SizeIs;
using tools::ProcessResult;
using tools::RunProgram;
using tools::ScratchFolder;

namespace fs = std::filesystem;

const fs::path kTutorials = ONCARD_SOURCE_DIR "/docs/tutorials";

std::vector<std::string> Tutorials() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kTutorials)) {
    if (entry.path().extension() == ".md") names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  return names;
}

/// The name of the file that a block is saved as; empty if it is not.
std::string TitleOf(const CodeBlock& block) {
  static const std::regex kTitle(R"re( title="([^"]+)")re");
  std::smatch match;
  return std::regex_search(block.info, match, kTitle) ? match[1].str() : "";
}

/// A folder that looks like that of the project after `./x build`.
class Tutorial : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    fs::create_directory_symlink(ONCARD_BUILD_DIR, folder_.path() + "/build");
    if (GetParam().find("python") != std::string::npos && !folder_.Has("build/python/oncard")) {
      GTEST_SKIP() << "the package for Python is not built: ./x python";
    }
  }

  /// What appears when the lines of a block are typed, in a language.
  ProcessResult Type(const std::string& lines, const std::string& locale = "C") {
    // The package is for the system's Python.
    return RunProgram(
        {"sh", "-c", "exec 2>&1\nexport LC_ALL=" + locale + " PATH=/usr/bin:$PATH\n" + lines},
        folder_.path());
  }

  const ScratchFolder folder_;
};

TEST_P(Tutorial, ShowsWhatAppears) {
  const std::vector<CodeBlock> blocks = CodeBlocks(ReadFile(kTutorials / GetParam()).value());
  size_t commands = 0;
  for (size_t i = 0; i < blocks.size(); ++i) {
    const CodeBlock& block = blocks[i];
    if (const std::string title = TitleOf(block); !title.empty()) {
      folder_.Write(title, block.text);
    } else if (block.info == "sh") {
      ++commands;
      const ProcessResult result = Type(block.text);
      const bool shown = i + 1 < blocks.size() && blocks[i + 1].info == "text";
      EXPECT_EQ(result.out, shown ? blocks[i + 1].text : "") << block.text;
      if (!shown) {
        EXPECT_EQ(result.exit_code, 0) << block.text;
      }
    }
  }
  EXPECT_GT(commands, 0u);
}

// What selects lines of an output finds them in both languages.
TEST_P(Tutorial, ShowsAsMuchInChinese) {
  const std::vector<CodeBlock> blocks = CodeBlocks(ReadFile(kTutorials / GetParam()).value());
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (const std::string title = TitleOf(blocks[i]); !title.empty()) {
      folder_.Write(title, blocks[i].text);
    } else if (blocks[i].info == "sh") {
      const std::string out = Type(blocks[i].text, "zh_CN.UTF-8").out;
      const bool shown = i + 1 < blocks.size() && blocks[i + 1].info == "text";
      const std::string expected = shown ? blocks[i + 1].text : "";
      EXPECT_EQ(std::ranges::count(out, '\n'), std::ranges::count(expected, '\n')) << out;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, Tutorial, testing::ValuesIn(Tutorials()), [](const auto& page) {
  return std::regex_replace(page.param, std::regex("[^A-Za-z0-9]"), "_");
});

TEST(TutorialsTest, ExistInBothLanguages) { EXPECT_THAT(Tutorials(), SizeIs(2 * 9)); }

TEST(CodeBlocksTest, HaveTheirLanguageAndText) {
  const std::vector<CodeBlock> blocks =
      CodeBlocks("a\n```c title=\"b.c\"\nint b;\n\n```\n```\nc\n```\n");
  ASSERT_THAT(blocks, SizeIs(2));
  EXPECT_EQ(blocks[0].info, "c title=\"b.c\"");
  EXPECT_EQ(blocks[0].text, "int b;\n\n");
  EXPECT_EQ(TitleOf(blocks[0]), "b.c");
  EXPECT_EQ(blocks[1].info, "");
  EXPECT_EQ(blocks[1].text, "c\n");
  EXPECT_EQ(TitleOf(blocks[1]), "");
}

}  // namespace
}  // namespace oncard::docs
