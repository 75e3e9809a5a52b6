// oncard new: what is in a new project, what is never overwritten, and which names are refused.
// Host programs are in new_hosts_test.cc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAreArray;

namespace fs = std::filesystem;

/// The files below a folder, by their path in it.
std::vector<std::string> NewFilesIn(const std::string& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.push_back(fs::relative(entry.path(), folder).string());
  }
  return files;
}

// --- What is made --------------------------------------------------------------------------------

const std::vector<std::string> kFilesOfEach = {".github/workflows/test.yml",
                                               ".gitignore",
                                               ".gitlab-ci.yml",
                                               ".vscode/scenario.schema.json",
                                               ".vscode/settings.json",
                                               "Dockerfile",
                                               "README.md",
                                               "drill.c",
                                               "drill.toml",
                                               "packages/install.sh",
                                               "test.sh"};

struct NewKind {
  const char* host;  ///< empty: none
  std::vector<std::string> files;
  const char* installs;  ///< with the packages of oncard
};

class NewKindTest : public testing::TestWithParam<NewKind> {
 protected:
  ProcessResult Make(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"new", "drill"};
    if (GetParam().host[0] != '\0') {
      arguments.insert(arguments.end(), {"--host", GetParam().host});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunOncard(arguments, folder_.path());
  }
  const ScratchFolder folder_;
};

TEST_P(NewKindTest, HasTheFilesThatItsReadmeNames) {
  const ProcessResult made = Make();
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, StartsWith("drill: begin with 'cd drill'"));
  std::vector<std::string> files = kFilesOfEach;
  files.insert(files.end(), GetParam().files.begin(), GetParam().files.end());
  EXPECT_THAT(NewFilesIn(folder_.path() + "/drill"), UnorderedElementsAreArray(files));
  for (const std::string& name : GetParam().files) {
    EXPECT_THAT(folder_.Read("drill/README.md"), HasSubstr('`' + name + '`'));
  }
}

TEST_P(NewKindTest, HasNoPlaceholderLeft) {
  for (const char* const language : {"--lang=en", "--lang=zh"}) {
    const ScratchFolder folder;
    std::vector<std::string> arguments = {"new", "drill", language};
    if (GetParam().host[0] != '\0') arguments.push_back(std::string("--host=") + GetParam().host);
    ASSERT_EQ(RunOncard(arguments, folder.path()).exit_code, 0);
    for (const std::string& name : NewFilesIn(folder.path() + "/drill")) {
      EXPECT_THAT(name, Not(HasSubstr("@")));
      const std::string text = folder.Read("drill/" + name);
      EXPECT_NE(text, "") << name;
      for (const char* const word :
           {"@NAME@", "@HOST@", "@LANGUAGE@", "@PACKAGES@", "@DEBS@", " \n"}) {
        EXPECT_THAT(text, Not(HasSubstr(word))) << name;
      }
    }
  }
}

TEST_P(NewKindTest, InstallsWhatItsTestsNeed) {
  Make();
  EXPECT_THAT(folder_.Read("drill/packages/install.sh"),
              HasSubstr(std::string("./*.deb") + GetParam().installs + '\n'));
}

TEST_P(NewKindTest, IsTestedByOneScriptEverywhere) {
  Make();
  for (const char* const name : {"Dockerfile", ".gitlab-ci.yml", ".github/workflows/test.yml"}) {
    const std::string text = folder_.Read(std::string("drill/") + name);
    EXPECT_THAT(text, HasSubstr("packages/install.sh")) << name;
    EXPECT_THAT(text, HasSubstr("test.sh")) << name;
  }
}

TEST_P(NewKindTest, HasScriptsThatAShellCanRead) {
  Make();
  for (const char* const name : {"test.sh", "packages/install.sh"}) {
    const ProcessResult read = RunProgram({"sh", "-n", folder_.path() + "/drill/" + name});
    EXPECT_EQ(read.exit_code, 0) << name << read.err;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, NewKindTest,
    testing::Values(
        NewKind{"", {}, ""},
        NewKind{"c",
                {"CMakeLists.txt", "drill.host.toml", "drill_host.c"},
                " cmake gcc libc6-dev make"},
        NewKind{"cpp", {"CMakeLists.txt", "drill.host.toml", "drill_host.cpp"}, " cmake g++ make"},
        NewKind{"cs", {"drill.host.toml", "drill_host.cs"}, " mono-mcs mono-runtime"},
        NewKind{"python", {"drive_drill.py", "test_drill.py"}, " python3-pytest"}),
    [](const auto& kind) {
      return std::string(kind.param.host[0] == '\0' ? "none" : kind.param.host);
    });

TEST(New, PassesItsTest) {
  const ScratchFolder folder;
  ASSERT_EQ(RunOncard({"new", "drill"}, folder.path()).exit_code, 0);
  const ProcessResult tested = RunOncard({"test", "drill"}, folder.path());
  EXPECT_EQ(tested.exit_code, 0);
  EXPECT_EQ(tested.out, "ok   drill/drill.toml\n1 passed, 0 failed\n");
  // The expectations are about the program: another one fails.
  std::string program = folder.Read("drill/drill.c");
  program.replace(program.find("GT_SetVel(1, 50)"), 16, "GT_SetVel(1, 49)");
  folder.Write("drill/drill.c", program);
  EXPECT_EQ(RunOncard({"test", "drill"}, folder.path()).exit_code, 1);
}

TEST(New, HasAProgramWithoutWarnings) {
  const ScratchFolder folder;
  ASSERT_EQ(RunOncard({"new", "drill"}, folder.path()).exit_code, 0);
  const ProcessResult checked = RunOncard({"check", "-Werror", "drill/drill.c"}, folder.path());
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_EQ(checked.err, "");
}

TEST(New, HasTheSchemaThatItsScenarioNames) {
  const ScratchFolder folder;
  ASSERT_EQ(RunOncard({"new", "drill", "--lang=zh"}, folder.path()).exit_code, 0);
  EXPECT_THAT(folder.Read("drill/drill.toml"),
              StartsWith("#:schema ./.vscode/scenario.schema.json\n"));
  EXPECT_EQ(folder.Read("drill/.vscode/scenario.schema.json"),
            RunOncard({"schema", "--lang=zh"}).out);
}

TEST(New, HasItsReadmeInTheLanguageOfTheCall) {
  const ScratchFolder folder;
  RunOncard({"new", "english", "--host=c"}, folder.path());
  const ProcessResult made = RunOncard({"--lang=zh", "new", "chinese", "--host=c"}, folder.path());
  EXPECT_THAT(made.out, StartsWith("chinese：先执行"));
  EXPECT_THAT(folder.Read("english/README.md"), HasSubstr("\n## Host program\n"));
  EXPECT_THAT(folder.Read("chinese/README.md"), HasSubstr("\n## 主机程序\n"));
}

// CI tells what is missing before it installs anything. The only programs that the script finds
// here are those of a folder: it must not reach the packages of this computer.
TEST(New, SaysThatItsPackagesAreMissing) {
  const ScratchFolder folder;
  ASSERT_EQ(RunOncard({"new", "drill"}, folder.path()).exit_code, 0);
  folder.Write("bin/apt-get", "#!/bin/sh\necho \"$@\"\n");
  fs::permissions(folder.path() + "/bin/apt-get", fs::perms::owner_all);
  for (const char* const program : {"dirname", "ls"}) {
    fs::create_symlink(std::string("/usr/bin/") + program, folder.path() + "/bin/" + program);
  }
  const std::vector<std::string> install = {"env", "-i", "PATH=" + folder.path() + "/bin",
                                            "/bin/sh",
                                            folder.path() + "/drill/packages/install.sh"};
  const ProcessResult empty = RunProgram(install);
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_THAT(empty.err, StartsWith("packages/ holds no .deb files of oncard: put them there"));
  EXPECT_EQ(empty.out, "");
  folder.Write("drill/packages/oncard.deb", "");
  const ProcessResult filled = RunProgram(install);
  EXPECT_EQ(filled.exit_code, 0) << filled.err;
  EXPECT_EQ(filled.out, "update\ninstall --yes --no-install-recommends ./oncard.deb\n");
}

// --- What is there -------------------------------------------------------------------------------

TEST(New, OverwritesNothing) {
  const ScratchFolder folder;
  folder.Write("drill/test.sh", "mine");
  const ProcessResult made = RunOncard({"new", "drill", "--host=c"}, folder.path());
  EXPECT_EQ(made.exit_code, 3);
  EXPECT_EQ(made.out, "");
  EXPECT_EQ(made.err,
            "oncard: 'drill/test.sh' exists already; nothing was written: choose another name, or "
            "move it away\n");
  EXPECT_EQ(folder.Read("drill/test.sh"), "mine");
  EXPECT_THAT(NewFilesIn(folder.path()), UnorderedElementsAreArray({"drill/test.sh"}));
}

TEST(New, SaysInChineseWhatIsThere) {
  const ScratchFolder folder;
  folder.Write("drill/drill.c", "");
  const ProcessResult made = RunOncard({"--lang=zh", "new", "drill"}, folder.path());
  EXPECT_EQ(made.exit_code, 3);
  EXPECT_THAT(made.err, HasSubstr("“drill/drill.c”已存在"));
}

TEST(New, IsMadeInAFolderThatIsThere) {
  const ScratchFolder folder;
  folder.Write("drill/notes.txt", "mine");
  EXPECT_EQ(RunOncard({"new", "drill"}, folder.path()).exit_code, 0);
  EXPECT_EQ(folder.Read("drill/notes.txt"), "mine");
  EXPECT_THAT(NewFilesIn(folder.path() + "/drill"), IsSupersetOf(kFilesOfEach));
}

TEST(New, LeavesNothingWhenItCannotBeWritten) {
  const ScratchFolder folder;
  folder.Write("drill/.github", "a file, no folder");
  const ProcessResult made = RunOncard({"new", "drill"}, folder.path());
  EXPECT_EQ(made.exit_code, 3);
  EXPECT_THAT(made.err, StartsWith("oncard: cannot make the folder 'drill/.github/workflows': "));
  EXPECT_THAT(NewFilesIn(folder.path()), UnorderedElementsAreArray({"drill/.github"}));
}

TEST(New, NeedsAFolderAndNoFileOfItsName) {
  const ScratchFolder folder;
  folder.Write("drill", "mine");
  const ProcessResult made = RunOncard({"new", "drill"}, folder.path());
  EXPECT_EQ(made.exit_code, 3);
  EXPECT_THAT(made.err, HasSubstr("'drill'"));
  EXPECT_EQ(folder.Read("drill"), "mine");
}

// --- Names ---------------------------------------------------------------------------------------

class BadNewNameTest : public testing::TestWithParam<std::string> {};

TEST_P(BadNewNameTest, IsRefusedWithAReason) {
  const ScratchFolder folder;
  const ProcessResult made = RunOncard({"new", "--", GetParam()}, folder.path());
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_EQ(made.out, "");
  EXPECT_THAT(made.err, testing::ContainsRegex("use (letters|another|at most)"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_THAT(RunOncard({"--lang=zh", "new", "--", GetParam()}, folder.path()).err,
              HasSubstr("项目名称"));
}

INSTANTIATE_TEST_SUITE_P(Names, BadNewNameTest,
                         testing::Values("", ".", "..", "a b", "a/b", "/tmp", "a-b", "2axes", "_a",
                                         "a.c", "-a", "钻", "a\nb", "nul", "CON", "Lpt1",
                                         std::string(65, 'a')));

TEST(New, TakesTheLongestName) {
  const ScratchFolder folder;
  const std::string name(64, 'a');
  EXPECT_EQ(RunOncard({"new", name, "--host=cpp"}, folder.path()).exit_code, 0);
  EXPECT_TRUE(folder.Has(name + "/" + name + ".host.toml"));
}

TEST(New, KnowsNoOtherLanguage) {
  const ScratchFolder folder;
  const ProcessResult made = RunOncard({"new", "drill", "--host=java"}, folder.path());
  EXPECT_EQ(made.exit_code, 2);
  EXPECT_THAT(made.err, HasSubstr("java"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace oncard::tools
