// Console hosts in the style of Windows programs: built with the command in docs/host-api.md, in a
// folder beside the build, and run.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

/// The first line of the page that calls the compiler, without the name of the source.
std::string DocumentedCommand() {
  const auto page = ReadFile(ONCARD_SOURCE_DIR "/docs/host-api.md");
  if (!page.ok()) return "";
  const std::string& text = page.value();
  const size_t begin = text.find("    c++ ");
  if (begin == std::string::npos) return "";
  std::string line = text.substr(begin, text.find('\n', begin) - begin);
  const size_t source = line.find("host.cpp");
  return source == std::string::npos ? "" : line;
}

class HostBuild : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory_symlink(ONCARD_BUILD_DIR, folder_.path() + "/build");
  }

  /// Builds host.cpp in the folder; `more` are further options.
  ProcessResult Build(const std::string& source, const std::string& more = "") {
    folder_.Write("host.cpp", source);
    return RunProgram({"sh", "-c", DocumentedCommand() + " -w " + more}, folder_.path());
  }
  ProcessResult Run(const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments = {"exec"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.insert(arguments.end(), {"--", "./host"});
    return RunOncard(arguments, folder_.path());
  }

  const ScratchFolder folder_;
};

// --- Headers -------------------------------------------------------------------------------------

/// The part of such a host after the #include lines: waits for keys and answers in capitals.
constexpr const char* kEcho = R"(
void commandhandler(char *command, short error)
{
	if (error) printf("%s = %d\n", command, error);
}

int main(int argc, char* argv[])
{
	long sts;
	char key;
	commandhandler("GT_Open", GT_Open());
	commandhandler("GT_ClrSts", GT_ClrSts(1, 8));
	while (!kbhit()) Sleep(10);
	key = toupper(getch());
	commandhandler("GT_GetSts", GT_GetSts(1, &sts));
	printf("%c %d\n", key, TRUE);
	return 0;
}
)";

TEST_F(HostBuild, FindsTheHeadersOfAConsoleProject) {
  const char* const includes[] = {
      "#include \"stdafx.h\"\n#include \"conio.h\"\n#include \"windows.h\"\n#include \"gts.h\"\n",
      "#include \"StdAfx.h\"\n#include \"windows.h\"\n#include \"conio.h\"\n#include \"gts.h\"\n",
      "#include \"stdAfx.h\"\n#include <Windows.h>\n#include <CONIO.H>\n#include \"gts.h\"\n",
      "#include \"Stdafx.h\"\n#include <conio.h>\n#include \"gts.h\"\n",
      "#include \"STDAFX.H\"\n#include <MMSystem.h>\n#include <conio.h>\n#include <gts.h>\n",
      "#include <stdio.h>\n#include <WINDOWS.H>\n#include <Conio.h>\n#include <gts.h>\n",
      ("#include <iostream>\n#include <cmath>\n#include <windows.h>\n#include <conio.h>\n"
       "#include <stdio.h>\n#include \"gts.h\"\nusing namespace std;\n"),
  };
  for (const char* lines : includes) {
    const ProcessResult built = Build(std::string(lines) + kEcho);
    ASSERT_EQ(built.exit_code, 0) << lines << built.err;
    EXPECT_EQ(Run({"--keys=100:k"}).out, "K 1\n") << lines;
  }
}

TEST_F(HostBuild, KnowsTheMainFunctionOfVisualStudio) {
  const ProcessResult built = Build(
      "#include \"stdafx.h\"\n#include \"gts.h\"\n"
      "int _tmain(int argc, _TCHAR* argv[])\n{\n\t_tprintf(_T(\"%d\\n\"), GT_Open());\n\treturn "
      "0;\n"
      "}\n");
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_EQ(Run().out, "0\n");
}

TEST_F(HostBuild, AHeaderBesideTheHostWins) {
  folder_.Write("stdafx.h", "#include <stdio.h>\n#define ITS_OWN 1\n");
  folder_.Write("gts.h",
                "#pragma once\n#define GT_API extern \"C\" short __stdcall\n"
                "GT_API GT_Open(short channel=0,short param=1);\n"
                "GT_API GT_GetClock(unsigned long *pClock,unsigned long *pLoop=NULL);\n");
  const ProcessResult built = Build(
      "#include \"stdafx.h\"\n#include \"windows.h\"\n#include \"gts.h\"\n"
      "int main()\n{\n\tDWORD clock;\n\tGT_Open();\n\tSleep(500);\n\tGT_GetClock(&clock);\n"
      "\tprintf(\"%d %lu\\n\", ITS_OWN, clock);\n\treturn 0;\n}\n");
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_EQ(Run().out, "1 500\n");
}

TEST_F(HostBuild, AVendorHeaderBeforeEverythingNeedsOneOption) {
  folder_.Write("gts.h",
                "#pragma once\n#define GT_API extern \"C\" short __stdcall\n"
                "GT_API GT_Open(short channel=0,short param=1);\n");
  const char* const host = "#include \"gts.h\"\nint main()\n{\n\treturn GT_Open();\n}\n";
  EXPECT_NE(Build(host).exit_code, 0);
  const ProcessResult built = Build(host, "-D__stdcall=");
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_EQ(Run().exit_code, 0);
}

TEST_F(HostBuild, ALaterVendorHeaderNeedsTheNamesOfOurs) {
  folder_.Write("gts.h",
                "#pragma once\n#define GT_API extern \"C\" short __stdcall\n"
                "typedef struct Trigger\n{\n\tshort encoder;\n\tshort probeType;\n"
                "\tshort probeIndex;\n\tshort sense;\n\tshort offset;\n\tunsigned long loop;\n"
                "\tshort windowOnly;\n\tlong firstPosition;\n\tlong lastPosition;\n} TTrigger;\n"
                "GT_API GT_Open(short channel=0,short param=1);\n"
                "GT_API GT_SetTrigger(short i,TTrigger *pTrigger);\n"
                "GT_API GT_GetTrigger(short i,TTrigger *pTrigger);\n");
  const ProcessResult built = Build(
      "#include \"stdafx.h\"\n#include \"gts.h\"\n"
      "int main()\n{\n\tTTrigger set = {2, 1, 3, 1, 40, 5, 1, -7, 8}, got;\n"
      "\tGT_Open();\n\tif (GT_SetTrigger(1, &set) != 0) return 1;\n"
      "\tif (GT_GetTrigger(1, &got) != 0) return 2;\n"
      "\tprintf(\"%d %d %lu %ld\\n\", got.sense, got.offset, got.loop, got.lastPosition);\n"
      "\treturn 0;\n}\n",
      "-DGT_SetTrigger=GTX_SetTrigger -DGT_GetTrigger=GTX_GetTrigger");
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_EQ(Run().out, "1 40 5 8\n");
}

// --- GBK -----------------------------------------------------------------------------------------

// "位置", and a comment whose last byte is 0x5C, a backslash.
constexpr const char* kGbkHost =
    "#include \"stdafx.h\"\n#include \"windows.h\"\n#include \"conio.h\"\n#include \"gts.h\"\n"
    "int main()\n{\n"
    "\tint sum = 1;\n"
    "\tsum = 2; // \x81\\\n"
    "\tsum = 3;\n"
    "\tprintf(\"\xCE\xBB\xD6\xC3 %d\\n\", sum);\n"
    "\treturn 0;\n}\n";

TEST_F(HostBuild, SourcesInGbkAreReadWithTheOptionOfTheCompiler) {
  ProcessResult built = Build(kGbkHost, "-finput-charset=GBK");
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_EQ(Run().out, "位置 3\n");
  // Without the option the host is built too, but the backslash in the comment removes the next
  // line: the page warns of this.
  built = Build(kGbkHost);
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_EQ(Run().out, "\xCE\xBB\xD6\xC3 2\n");
}

}  // namespace
}  // namespace oncard::tools
