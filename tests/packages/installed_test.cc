// What `cmake --install` leaves works without the tree that it came from: hosts of others find
// headers and libraries by CMake and by pkg-config, and run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::packages {
namespace {

using testing::HasSubstr;
using tools::ProcessResult;
using tools::RunProgram;
using tools::ScratchFolder;

namespace fs = std::filesystem;

constexpr const char* kFamilies[] = {"gts", "gep", "ges", "gt400"};

/// An installation that all tests of this file use, and a copy of a project of others.
class Installed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    installation_ = new ScratchFolder;
    const ProcessResult result =
        RunProgram({"cmake", "--install", ONCARD_BUILD_DIR, "--prefix", prefix()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  static void TearDownTestSuite() { delete installation_; }

  static std::string prefix() { return installation_->path() + "/oncard"; }
  static std::string lib() { return prefix() + "/" ONCARD_INSTALLED_LIBRARIES; }

  /// The installed files in a folder and below, with paths from there.
  static std::vector<std::string> FilesIn(const std::string& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(prefix() + '/' + folder)) {
      if (!entry.is_directory()) {
        files.push_back(entry.path().lexically_relative(prefix() + '/' + folder));
      }
    }
    std::ranges::sort(files);
    return files;
  }

  /// What a command says that has to succeed.
  std::string Run(const std::vector<std::string>& command,
                  const std::vector<std::string>& environment = {}) const {
    const ProcessResult result = RunProgram(command, project_.path(), environment);
    EXPECT_EQ(result.exit_code, 0) << command[0] << '\n' << result.out << result.err;
    return result.out;
  }

  /// Runs the hosts that the project has built in a folder.
  void RunHosts(const std::string& folder) const {
    for (const std::string family : kFamilies) {
      Run({folder + '/' + family}, {"LD_LIBRARY_PATH=" + lib()});
    }
    EXPECT_EQ(Run({prefix() + "/bin/oncard", "exec", "--", folder + "/move"}),
              "5000 pulses, 60000 ms\n");
  }

  void SetUp() override {
    fs::copy(ONCARD_SOURCE_DIR "/tests/packages/project", project_.path() + "/project");
  }

  static ScratchFolder* installation_;
  const ScratchFolder project_;
};

ScratchFolder* Installed::installation_ = nullptr;

TEST_F(Installed, IsFoundByCMake) {
  Run({"cmake", "-S", "project", "-B", "build", "-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + prefix(),
       "-DONCARD_VERSION=" ONCARD_VERSION});
  Run({"cmake", "--build", "build"});
  RunHosts("build");
}

TEST_F(Installed, IsFoundByNewProjects) {
  const std::string oncard = prefix() + "/bin/oncard";
  for (const std::string language : {"c", "cpp"}) {
    const std::string name = "in_" + language;
    Run({oncard, "new", name, "--host", language});
    Run({"cmake", "-S", name, "-B", name + "/build", "-DCMAKE_PREFIX_PATH=" + prefix()});
    Run({"cmake", "--build", name + "/build"});
    EXPECT_THAT(Run({oncard, "exec", "--", name + "/build/" + name + "_host"}),
                HasSubstr("at 50000"));
    EXPECT_THAT(Run({oncard, "test", name}), HasSubstr("2 passed"));
  }
}

TEST_F(Installed, HasAVersionForCMake) {
  const ProcessResult result =
      RunProgram({"cmake", "-S", "project", "-B", "build", "-G", "Ninja",
                  "-DCMAKE_PREFIX_PATH=" + prefix(), "-DONCARD_VERSION=1000"},
                 project_.path());
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("version: " ONCARD_VERSION));
}

TEST_F(Installed, IsFoundByPkgConfig) {
  const std::string path = "PKG_CONFIG_PATH=" + lib() + "/pkgconfig";
  Run({"make", "-C", "project"}, {path});
  RunHosts("project");
  EXPECT_EQ(Run({"pkg-config", "--modversion", "gts", "oncard-compat"}, {path}),
            ONCARD_VERSION "\n" ONCARD_VERSION "\n");
}

// Declarations of hosts, in C and C#. Headers of C++ are oncard's own, and change with every
// version.
TEST_F(Installed, HasTheDeclarationsOfHostsOnly) {
  EXPECT_THAT(FilesIn("include"), testing::UnorderedElementsAreArray({"GT400.H",
                                                                      "GT400.h",
                                                                      "GTDLL.h",
                                                                      "Gt400.h",
                                                                      "Gts.cs",
                                                                      "GtsMulti.cs",
                                                                      "LookAheadEx.h",
                                                                      "gep.h",
                                                                      "ges.h",
                                                                      "gt400.h",
                                                                      "gts.h",
                                                                      "gts_multi.h",
                                                                      "userlib.h",
                                                                      "oncard/compat/CONIO.H",
                                                                      "oncard/compat/Conio.h",
                                                                      "oncard/compat/DOS.H",
                                                                      "oncard/compat/Dos.h",
                                                                      "oncard/compat/MMSystem.h",
                                                                      "oncard/compat/Mmsystem.h",
                                                                      "oncard/compat/STDAFX.H",
                                                                      "oncard/compat/StdAfx.h",
                                                                      "oncard/compat/Stdafx.h",
                                                                      "oncard/compat/TCHAR.H",
                                                                      "oncard/compat/Tchar.h",
                                                                      "oncard/compat/WINDOWS.H",
                                                                      "oncard/compat/Windows.h",
                                                                      "oncard/compat/conio.h",
                                                                      "oncard/compat/dos.h",
                                                                      "oncard/compat/mmsystem.h",
                                                                      "oncard/compat/oncard_host.h",
                                                                      "oncard/compat/stdAfx.h",
                                                                      "oncard/compat/stdafx.h",
                                                                      "oncard/compat/tchar.h",
                                                                      "oncard/compat/windows.h"}));
}

TEST_F(Installed, LibrariesSayTheVersionOfTheirInterface) {
  for (const std::string family : kFamilies) {
    const std::string name = "lib" + family + ".so.1";
    EXPECT_THAT(Run({"readelf", "--dynamic", lib() + '/' + name}),
                HasSubstr("soname: [" + name + "]"));
    EXPECT_EQ(fs::read_symlink(lib() + "/lib" + family + ".so"), name);
  }
}

// What a host is linked with is found in the folder that `oncard exec` names, under every name.
TEST_F(Installed, TheFolderOfExecLeadsToTheLibraries) {
  for (const std::string family : kFamilies) {
    for (const std::string ending : {".so", ".so.1"}) {
      const std::string link = lib() + "/oncard/lib" + family + ending;
      EXPECT_EQ(fs::canonical(link), fs::canonical(lib()) / ("lib" + family + ".so.1"));
    }
  }
  EXPECT_EQ(fs::canonical(lib() + "/oncard/gt400.dll"), fs::canonical(lib()) / "libgt400.so.1");
}

// Paths of the build would end somewhere else on other computers.
TEST_F(Installed, NothingNamesTheTree) {
  for (const std::string& folder : {std::string("bin"), std::string(ONCARD_INSTALLED_LIBRARIES)}) {
    for (const std::string& file : FilesIn(folder)) {
      const std::string found = RunProgram({"grep", "-c", "-a", "-F", ONCARD_SOURCE_DIR,
                                            prefix() + '/' + folder + '/' + file})
                                    .out;
      EXPECT_EQ(found, "0\n") << file;
    }
  }
}

}  // namespace
}  // namespace oncard::packages
