// The lines of the README's first steps can be pasted: each does what it says in a fresh folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "base/files.h"
#include "tests/docs/page.h"
#include "tests/tools/process.h"

namespace oncard::docs {
namespace {

using tools::ProcessResult;
using tools::RunProgram;
using tools::ScratchFolder;

namespace fs = std::filesystem;

/// The lines of the block of commands that contains a text.
std::vector<std::string> LinesOfBlockWith(const std::string& page, const std::string& text) {
  const auto page_text = ReadFile(ONCARD_SOURCE_DIR "/" + page);
  std::vector<std::string> lines;
  for (const CodeBlock& block : CodeBlocks(page_text.value())) {
    if (block.info != "sh" || block.text.find(text) == std::string::npos) continue;
    std::istringstream stream(block.text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
  }
  return lines;
}

bool IsInstalled(const std::string& program) {
  return RunProgram({"sh", "-c", "command -v " + program}).exit_code == 0;
}

class FirstSteps : public testing::TestWithParam<const char*> {};

TEST_P(FirstSteps, CanBePasted) {
  // A folder that looks like the project's after `./x build`, with a folder for what is written.
  const ScratchFolder folder;
  fs::create_directory(folder.path() + "/build");
  for (const char* part : {"bin", "include", "lib"}) {
    fs::create_directory_symlink(std::string(ONCARD_BUILD_DIR "/") + part,
                                 folder.path() + "/build/" + part);
  }
  for (const char* part : {"samples", "tests"}) {
    fs::create_directory_symlink(std::string(ONCARD_SOURCE_DIR "/") + part,
                                 folder.path() + '/' + part);
  }
  const std::vector<std::string> lines = LinesOfBlockWith(GetParam(), "oncard run");
  EXPECT_GE(lines.size(), 10u);
  for (const std::string& line : lines) {
    if (line.find("--plot") != std::string::npos && !IsInstalled("gnuplot")) continue;
    const ProcessResult result = RunProgram({"sh", "-c", line}, folder.path());
    // The sample's schedule that fails is found.
    const bool finds = line.find("lost.toml") != std::string::npos;
    EXPECT_EQ(result.exit_code, finds ? 1 : 0) << line << '\n' << result.out << result.err;
  }
  for (const char* file : {"card.c", "sum.bin", "sum.ini", "lines", "jog"}) {
    EXPECT_TRUE(folder.Has(std::string("build/") + file)) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, FirstSteps, testing::Values("README.md", "README.zh-CN.md"),
                         [](const auto& page) {
                           const std::string name = page.param;
                           return std::string(name == "README.md" ? "English" : "Chinese");
                         });

}  // namespace
}  // namespace oncard::docs
