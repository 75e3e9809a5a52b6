// The script ./x where another program installs packages at the same time: it waits for its end.
// Commands of the system are replaced by small scripts that come first in PATH.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

/// A copy of the script in a folder of its own; the formatting of no file, which needs packages.
class XScript : public testing::Test {
 protected:
  XScript() {
    std::filesystem::copy_file(ONCARD_SOURCE_DIR "/x", scratch_.path() + "/x");
    Command("dpkg-query", "exit 1");
    Command("id", "echo 0");
    Command("git", "echo none.cc");
    Command("clang-format", "true");
    Command("sleep", "true");
    scratch_.Write("calls", "");
  }

  void Command(const std::string& name, const std::string& body) const {
    const std::string path = scratch_.Write(name, "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }

  ProcessResult Format() const {
    return RunProgram({"env", "PATH=" + scratch_.path() + ":/usr/bin:/bin", "./x", "fmt"},
                      scratch_.path());
  }

  const ScratchFolder scratch_;
};

TEST_F(XScript, WaitsForAnotherAptToEnd) {
  // apt-get calls its first two attempts off, one for the lists and one for the archives.
  Command("apt-get",
          "echo \"$*\" >>calls\n"
          "case $(wc -l <calls) in 1 | 3)\n"
          "  echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7' >&2\n"
          "  exit 100 ;;\n"
          "esac");
  const ProcessResult result = Format();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(scratch_.Read("calls"),
            "-qq -o DPkg::Lock::Timeout=600 update\n"
            "-qq -o DPkg::Lock::Timeout=600 update\n"
            "-qq -o DPkg::Lock::Timeout=600 install -y --no-install-recommends clang clang-format "
            "clang-tidy\n"
            "-qq -o DPkg::Lock::Timeout=600 install -y --no-install-recommends clang clang-format "
            "clang-tidy\n");
}

TEST_F(XScript, SaysWhatElseAptComplainsAbout) {
  Command("apt-get", "echo 'E: Unable to locate package clang' >&2\nexit 100");
  const ProcessResult result = Format();
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("E: Unable to locate package clang"));
}

}  // namespace
}  // namespace oncard::tools
