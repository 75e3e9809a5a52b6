// The files that `oncard exec` needs beside the command: the 64-bit libraries, and for 32-bit hosts
// the 32-bit ones. tests/runtime/host32 runs such hosts.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLibrary = "liboncard_host.so";
/// The exit code of the shell, to which execvp() passes files that the system cannot execute.
constexpr int kNoProgram = 127;

/// A separate installation, at first with only the 64-bit libraries.
class InstalledExec : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(root() / "bin");
    fs::create_directories(root() / "lib");
    fs::copy(ONCARD_BUILD_DIR "/bin/oncard", root() / "bin");
    fs::copy(fs::path(ONCARD_BUILD_DIR "/lib") / kLibrary, root() / "lib");
  }

  fs::path root() const { return folder_.path(); }

  /// Installs a substitute for the 32-bit libraries; no 32-bit program loads them here.
  void InstallLibrariesOf32Bits(const fs::path& folder = "lib32") const {
    fs::create_directories(root() / folder);
    folder_.Write((folder / kLibrary).string(), "");
  }

  ProcessResult Exec(const std::vector<std::string>& host, const std::string& path = "") const {
    std::vector<std::string> command = {(root() / "bin/oncard").string(), "exec", "--"};
    command.insert(command.end(), host.begin(), host.end());
    std::vector<std::string> environment;
    if (!path.empty()) environment.push_back("PATH=" + path);
    return RunProgram(command, folder_.path(), environment);
  }

  /// Writes the beginning of a program file; `word` is 1 for 32 bits and 2 for 64.
  void WriteProgram(const std::string& name, char word) const {
    folder_.Write(name, std::string("\x7F"
                                    "ELF") +
                            word + "\x01\x01" + std::string(9, '\0'));
    fs::permissions(root() / name, fs::perms::owner_all);
  }

  const ScratchFolder folder_;
};

TEST_F(InstalledExec, NeedsItsLibrary) {
  fs::remove(root() / "lib" / kLibrary);
  const ProcessResult result = Exec({"true"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err,
            "oncard: liboncard_host.so is neither beside oncard nor in ../lib; install it there\n");
}

// In the first folder packages of Debian have it, in the second one other installations.
TEST_F(InstalledExec, FindsItsLibraryWhereItIsInstalled) {
  for (const std::string folder : {"lib/" ONCARD_LIBRARY_ARCHITECTURE "/oncard", "lib/oncard"}) {
    fs::create_directories(root() / folder);
    fs::rename(root() / "lib" / kLibrary, root() / folder / kLibrary);
    const ProcessResult result = Exec({"sh", "-c", "echo $LD_LIBRARY_PATH"});
    EXPECT_EQ(result.out, (root() / folder).string() + '\n');
    EXPECT_EQ(result.err, "");
    fs::rename(root() / folder / kLibrary, root() / "lib" / kLibrary);
    fs::remove_all(root() / folder);
  }
}

TEST_F(InstalledExec, RefusesAHostOf32BitsWithoutLibrariesOf32Bits) {
  WriteProgram("host", 1);
  for (const std::string& name : {std::string("./host"), std::string("host")}) {
    const ProcessResult result = Exec({name}, "/usr/bin:" + folder_.path());
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err, "oncard: '" + name +
                              "' is a 32-bit program, and there is no 32-bit liboncard_host.so in "
                              "../lib32 beside oncard; './x host32' in oncard's sources "
                              "builds it, or compile the host without -m32\n");
  }
}

TEST_F(InstalledExec, StartsAHostOf32BitsWithThem) {
  InstallLibrariesOf32Bits();
  WriteProgram("host", 1);
  EXPECT_EQ(Exec({"./host"}).exit_code, kNoProgram);
}

TEST_F(InstalledExec, StartsEveryOtherFile) {
  WriteProgram("host", 2);
  EXPECT_EQ(Exec({"./host"}).exit_code, kNoProgram);
  EXPECT_EQ(Exec({"./nothing"}).err, "oncard: cannot run './nothing': No such file or directory\n");
  EXPECT_EQ(Exec({"sh", "-c", "echo $LD_PRELOAD"}).out, "liboncard_host.so\n");
}

TEST_F(InstalledExec, ProgramsFindTheLibrariesOfTheirWordLength) {
  const std::string own = folder_.path() + "/lib";
  const std::vector<std::string> host = {"sh", "-c", "echo $LD_LIBRARY_PATH"};
  EXPECT_EQ(Exec(host).out, own + "\n");
  InstallLibrariesOf32Bits();
  const ProcessResult result = Exec(host);
  EXPECT_EQ(result.out, own + ":" + own + "32\n");
  EXPECT_EQ(result.err, "");
}

TEST_F(InstalledExec, FindsInstalledLibrariesOf32Bits) {
  InstallLibrariesOf32Bits("lib32/oncard");
  const std::string own = folder_.path() + "/lib";
  EXPECT_EQ(Exec({"sh", "-c", "echo $LD_LIBRARY_PATH"}).out, own + ":" + own + "32/oncard\n");
}

TEST_F(InstalledExec, AFolderMayHaveABlank) {
  fs::create_directories(root() / "with blank/bin");
  fs::rename(root() / "lib", root() / "with blank/lib");
  fs::rename(root() / "bin/oncard", root() / "with blank/bin/oncard");
  const ProcessResult result =
      RunProgram({folder_.path() + "/with blank/bin/oncard", "exec", "--", "true"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
}

}  // namespace
}  // namespace oncard::tools
