// Program files through the C API: compiling, downloading, names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <string>

#include "host_fixture.h"

namespace oncard::runtime {
namespace {

using ::testing::StartsWith;

class HostPrograms : public OpenCard {
 protected:
  /// The result of GT_Compile for a program text.
  struct CompileAnswer {
    short code = 0;
    std::string file;
    short line = -1;
    std::string message;
  };
  CompileAnswer Compile(const std::string& path) const {
    // Known bytes after the documented sizes show a write beyond the end.
    std::array<char, 136> file;
    std::array<char, 136> message;
    file.fill('#');
    message.fill('#');
    file[0] = message[0] = '\0';  // on success they are not written
    CompileAnswer answer;
    TCompileInfo info = {file.data(), &answer.line, message.data()};
    answer.code = GT_Compile(path.c_str(), &info);
    EXPECT_EQ(std::count(file.begin() + 128, file.end(), '#'), 8);
    EXPECT_EQ(std::count(message.begin() + 128, message.end(), '#'), 8);
    answer.file = file.data();
    answer.message = message.data();
    return answer;
  }
  std::string ReadAll(const std::string& name) const {
    std::ifstream file(folder_ + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

// --- GT_Compile ----------------------------------------------------------------------------------

TEST_F(HostPrograms, CompilingWritesThePairBesideTheSource) {
  const CompileAnswer answer = Compile(WriteText("sum.c", kSumProgram));
  EXPECT_EQ(answer.code, 0);
  EXPECT_FALSE(ReadAll("sum.bin").empty());
  EXPECT_EQ(ReadAll("sum.ini").substr(0, 10), "[function]");
}

TEST_F(HostPrograms, ASuccessIsNotWrittenIntoTheInfo) {
  // Hosts do not initialise it: its pointers have any value.
  TCompileInfo info;
  std::memset(&info, 0x5A, sizeof info);
  EXPECT_EQ(GT_Compile(WriteText("sum.c", kSumProgram).c_str(), &info), 0);
}

TEST_F(HostPrograms, AnErrorComesWithFileLineAndToken) {
  const std::string path =
      WriteText("bad.c", "int sum;\nint add()\n{\n  sum = missing;\n  return sum;\n}\n");
  const CompileAnswer answer = Compile(path);
  EXPECT_EQ(answer.code, 1);
  EXPECT_EQ(answer.file, path);
  EXPECT_EQ(answer.line, 4);
  EXPECT_EQ(answer.message.substr(0, 9), "'missing'");
  EXPECT_GT(answer.message.size(), 9u);
}

TEST_F(HostPrograms, AFailedCompilationLeavesTheOldPair) {
  ASSERT_EQ(Compile(WriteText("sum.c", kSumProgram)).code, 0);
  const std::string bin = ReadAll("sum.bin");
  const std::string ini = ReadAll("sum.ini");
  EXPECT_EQ(Compile(WriteText("sum.c", "int add( {")).code, 1);
  EXPECT_EQ(ReadAll("sum.bin"), bin);
  EXPECT_EQ(ReadAll("sum.ini"), ini);
}

TEST_F(HostPrograms, AMissingSourceIsAFileThatIsNotThere) {
  const CompileAnswer answer = Compile(folder_ + "nothing.c");
  EXPECT_EQ(answer.code, 2007);
  EXPECT_EQ(answer.file, folder_ + "nothing.c");
  EXPECT_EQ(answer.line, 0);
  EXPECT_NE(answer.message, "");
}

TEST_F(HostPrograms, APairThatCannotBeWrittenIsRefused) {
  std::filesystem::create_directory(folder_ + "sum.bin");
  const CompileAnswer answer = Compile(WriteText("sum.c", kSumProgram));
  EXPECT_EQ(answer.code, 1);
  EXPECT_NE(answer.message, "");
}

TEST_F(HostPrograms, AnObjectFileIsNotTakenForASource) {
  ASSERT_EQ(Compile(WriteText("sum.c", kSumProgram)).code, 0);
  const std::string bin = ReadAll("sum.bin");
  TCompileInfo nowhere{};
  EXPECT_EQ(GT_Compile((folder_ + "sum.bin").c_str(), &nowhere), 2007);
  EXPECT_EQ(GT_Compile((folder_ + "sum.ini").c_str(), &nowhere), 2007);
  EXPECT_EQ(ReadAll("sum.bin"), bin);
}

TEST_F(HostPrograms, LongTextsAreCutToTheCallersBuffers) {
  // Wide characters, so that a cut at a fixed byte would leave half of one.
  std::string name;
  for (int i = 0; i < 60; ++i) name += "和";
  const CompileAnswer answer = Compile(folder_ + name + ".c");
  EXPECT_EQ(answer.code, 2007);
  EXPECT_LE(answer.file.size(), 127u);
  EXPECT_GE(answer.file.size(), 125u);
  EXPECT_THAT(folder_ + name, StartsWith(answer.file));
  EXPECT_EQ((answer.file.size() - folder_.size()) % 3, 0u);
}

TEST_F(HostPrograms, TheCallerMayLeaveOutWhatItDoesNotWant) {
  TCompileInfo nowhere{};
  EXPECT_EQ(GT_Compile(WriteText("bad.c", "int").c_str(), &nowhere), 1);
  EXPECT_EQ(GT_Compile(WriteText("good.c", kSumProgram).c_str(), &nowhere), 0);
}

// --- GT_Download ---------------------------------------------------------------------------------

TEST_F(HostPrograms, DownloadTellsWhatIsWrongWithTheFiles) {
  ASSERT_EQ(Compile(WriteText("sum.c", kSumProgram)).code, 0);
  const std::string bin = ReadAll("sum.bin");
  const std::string ini = ReadAll("sum.ini");
  WriteText("alone.bin", bin);
  WriteText("cut.bin", bin.substr(0, bin.size() / 2));
  WriteText("cut.ini", ini);
  WriteText("empty.bin", "");
  WriteText("empty.ini", ini);
  std::string program = "int g;\n";
  for (int i = 0; i < 32; ++i) {
    program += "int f" + std::to_string(i) + "()\n{\n  g = 1;\n  return g;\n}\n";
  }
  struct Case {
    const char* what;
    std::string path;
    short code;
  };
  const Case cases[] = {
      {"missing", folder_ + "nothing.bin", 2007},
      {"a name that is too long", folder_ + std::string(300, 'x') + ".bin", 2007},
      {"not a .bin", folder_ + "sum.c", 2007},
      {"empty name", "", 2007},
      {"no .ini beside it", folder_ + "alone.bin", 2008},
      {"cut off", folder_ + "cut.bin", 2008},
      {"empty", folder_ + "empty.bin", 2008},
      {"right", folder_ + "sum.bin", 0},
  };
  for (const Case& c : cases) EXPECT_EQ(GT_Download(c.path.c_str()), c.code) << c.what;
  TCompileInfo nowhere{};
  ASSERT_EQ(GT_Compile(WriteText("full.c", program).c_str(), &nowhere), 0);
  EXPECT_EQ(GT_Download((folder_ + "full.bin").c_str()), 0);  // 32 functions are allowed
}

TEST_F(HostPrograms, AFailedDownloadLeavesTheOldProgramRunning) {
  Download(kEndlessProgram);
  Run(0, 1, 0);
  const double before = ReadGlobal("count");
  EXPECT_EQ(GT_Download((folder_ + "nothing.bin").c_str()), 2007);
  WriteText("bad.bin", "not an object");
  WriteText("bad.ini", "");
  EXPECT_EQ(GT_Download((folder_ + "bad.bin").c_str()), 2008);
  for (int call = 0; call < 5; ++call) Clock();  // a cycle
  EXPECT_GT(ReadGlobal("count"), before);
  TThreadSts status{};
  ASSERT_EQ(GT_GetThreadSts(0, &status), 0);
  EXPECT_EQ(status.run, 1);
}

TEST_F(HostPrograms, ASuccessfulDownloadStopsUnbindsAndClears) {
  Download(kEndlessProgram);
  Run(0, 1, 0);
  for (int call = 0; call < 10; ++call) Clock();
  ASSERT_GT(ReadGlobal("count"), 0);
  ASSERT_EQ(GT_Download((folder_ + "p.bin").c_str()), 0);
  EXPECT_EQ(ReadGlobal("count"), 0);
  EXPECT_EQ(GT_RunThread(0), 1);
}

// --- Names ---------------------------------------------------------------------------------------

constexpr std::string_view kNamesProgram = R"(int count;
double speeds[3];
int first(int a)
{
  int b;
  b = a;
  return b;
}
double second(double a)
{
  TTrapPrm trap;
  trap.acc = a;
  return a;
}
)";

TEST_F(HostPrograms, FunctionsAreNumberedFromOne) {
  Download(kNamesProgram);
  short id = -1;
  EXPECT_EQ(GT_GetFunId("first", &id), 0);
  EXPECT_EQ(id, 1);
  EXPECT_EQ(GT_GetFunId("second", &id), 0);
  EXPECT_EQ(id, 2);
  id = -1;
  EXPECT_EQ(GT_GetFunId("third", &id), 2008);
  EXPECT_EQ(GT_GetFunId("", &id), 2008);
  EXPECT_EQ(GT_GetFunId("First", &id), 2008);
  EXPECT_EQ(id, -1);
}

TEST_F(HostPrograms, VariablesAreFoundByFunctionAndName) {
  Download(kNamesProgram);
  struct Case {
    const char* function;
    const char* name;
    short id;
    short type;
  };
  const Case cases[] = {
      {nullptr, "count", 0, 1},     {nullptr, "speeds", 1, 2},
      {"first", "a", 0, 1},         {"first", "b", 1, 1},
      {"second", "a", 0, 2},        {"second", "trap.acc", 1, 2},
      {"second", "trap.dec", 2, 2}, {"second", "trap.smoothTime", 4, 1},
  };
  for (const Case& c : cases) {
    TVarInfo info;
    std::memset(&info, '#', sizeof info);
    ASSERT_EQ(GT_GetVarId(c.function, c.name, &info), 0) << c.name;
    EXPECT_EQ(info.id, c.id) << c.name;
    EXPECT_EQ(info.dataType, c.type) << c.name;
    EXPECT_STREQ(info.name, c.name);
  }
}

TEST_F(HostPrograms, NamesThatDoNotExistAreNotFound) {
  Download(kNamesProgram);
  TVarInfo info{-1, -1, "?"};
  EXPECT_EQ(GT_GetVarId(nullptr, "a", &info), 2008);      // a local is no global
  EXPECT_EQ(GT_GetVarId("first", "count", &info), 2008);  // and a global no local
  EXPECT_EQ(GT_GetVarId("second", "b", &info), 2008);
  EXPECT_EQ(GT_GetVarId("third", "a", &info), 2008);
  EXPECT_EQ(GT_GetVarId("", "count", &info), 2008);
  EXPECT_EQ(info.id, -1);
  EXPECT_STREQ(info.name, "?");
}

TEST_F(HostPrograms, WithoutAProgramTheCodeIsThatOfTheDownload) {
  short id = 0;
  TVarInfo info{};
  EXPECT_EQ(GT_GetFunId("add", &id), 1);
  ASSERT_EQ(GT_Download((folder_ + "nothing.bin").c_str()), 2007);
  EXPECT_EQ(GT_GetFunId("add", &id), 2007);
  EXPECT_EQ(GT_GetVarId(nullptr, "sum", &info), 2007);
  WriteText("bad.bin", "x");
  ASSERT_EQ(GT_Download((folder_ + "bad.bin").c_str()), 2008);
  EXPECT_EQ(GT_GetVarId("add", "begin", &info), 2008);
  ASSERT_EQ(GT_Reset(), 0);
  EXPECT_EQ(GT_GetFunId("add", &id), 1);
}

TEST_F(HostPrograms, SixValuesTravelInOneCall) {
  Download("int a[6];\ndouble d[6];\nint f()\n{\n  a[0] = 1;\n  return a[0];\n}\n");
  TVarInfo ints = Global("a");
  const double values[6] = {1, -2, 3.9, -3.9, 2147483647, -2147483648.0};
  double written[6];
  std::copy(values, values + 6, written);
  ASSERT_EQ(GT_SetVarValue(-1, &ints, written, 6), 0);
  double read[6] = {};
  ASSERT_EQ(GT_GetVarValue(-1, &ints, read, 6), 0);
  const double truncated[6] = {1, -2, 3, -3, 2147483647, -2147483648.0};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(read[i], truncated[i]) << i;

  TVarInfo doubles = Global("d");
  ASSERT_EQ(GT_SetVarValue(-1, &doubles, written, 6), 0);
  ASSERT_EQ(GT_GetVarValue(-1, &doubles, read, 6), 0);
  EXPECT_EQ(read[1], -2);
  EXPECT_EQ(read[2], 3 + 58982 / 65536.0);  // 3.9 * 2^16 = 255590.4, truncated 255590
}

}  // namespace
}  // namespace oncard::runtime
