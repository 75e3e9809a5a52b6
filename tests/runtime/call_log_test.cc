#include "runtime/host/call_log.h"
#include "gtcalls/gts/catalogue.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>

#include "base/files.h"

namespace oncard::runtime {
namespace {

using Arguments = std::array<vm::CommandArgument, gtcalls::kParameterMax>;

std::string Line(const LoggedCall& call, Language language = Language::kEnglish) {
  std::string line;
  AppendCall(call, language, &line);
  return line;
}

/// The log line of a call of card 0 after 12.25 ms.
std::string Line(std::string_view name, const Arguments& arguments, int16_t code = 0,
                 const Message& reason = {}, Language language = Language::kEnglish) {
  const gtcalls::Command& command = *gtcalls::GtsCatalogue().Find(name);
  return Line({12'250, 0, vm::kHostCaller, command,
               std::span(arguments).first(command.parameters.size()), code, reason},
              language);
}

vm::CommandArgument Value(double value) {
  vm::CommandArgument argument;
  argument.value = value;
  return argument;
}
vm::CommandArgument Cells(std::span<double> cells) {
  vm::CommandArgument argument;
  argument.cells = cells;
  return argument;
}
vm::CommandArgument Text(const char* text) {
  vm::CommandArgument argument;
  argument.host = const_cast<char*>(text);
  return argument;
}
vm::CommandArgument Null() {
  vm::CommandArgument argument;
  argument.null = true;
  return argument;
}

TEST(CallTextTest, NoArguments) { EXPECT_EQ(Line("GT_Reset", {}), "12.250 card0 GT_Reset() = 0"); }

TEST(CallTextTest, ValuesAsShortAsTheyCanBe) {
  EXPECT_EQ(Line("GT_SetDoubleVar", {Value(3), Value(0.1)}),
            "12.250 card0 GT_SetDoubleVar(3, 0.1) = 0");
}

TEST(CallTextTest, MasksAndBitWordsInHexAsWideAsTheirTypes) {
  EXPECT_EQ(Line("GT_SetDo", {Value(12), Value(-1)}), "12.250 card0 GT_SetDo(12, 0xffffffff) = 0");
  EXPECT_EQ(Line("GT_Update", {Value(5)}), "12.250 card0 GT_Update(0x5) = 0");
  EXPECT_EQ(Line("GT_CrdStart", {Value(3), Value(-1)}),
            "12.250 card0 GT_CrdStart(0x3, 0xffff) = 0");
  double inputs = 0x8001;
  EXPECT_EQ(Line("GT_GetDi", {Value(4), Cells({&inputs, 1})}),
            "12.250 card0 GT_GetDi(4, pValue) = 0, pValue=[0x8001]");
}

TEST(CallTextTest, ArraysOfStructuresOneAfterTheOther) {
  std::array<double, 4> points = {1, 2, 3, 4};
  EXPECT_EQ(Line("GT_2DCompareData", {Value(0), Value(2), Cells(points), Value(1)}),
            "12.250 card0 GT_2DCompareData(0, 2, [{px=1, py=2}, {px=3, py=4}], 1) = 0");
}

TEST(CallTextTest, TheThreadThatWasRefused) {
  const Message reason = {"axis 1 is not in Trap mode", "轴 1 不在点位模式"};
  const gtcalls::Command& update = *gtcalls::GtsCatalogue().Find("GT_Update");
  std::array<vm::CommandArgument, 1> mask = {Value(1)};
  EXPECT_EQ(Line({12'250, 0, 3, update, mask, 1, reason}),
            "12.250 card0 thread 3: GT_Update(0x1) = 1: axis 1 is not in Trap mode");
}

TEST(CallTextTest, OutputsByNameAndThenWithTheirContent) {
  double clock = 12;
  EXPECT_EQ(Line("GT_GetClock", {Cells({&clock, 1}), Null()}),
            "12.250 card0 GT_GetClock(pClock, NULL) = 0, pClock=[12]");
  std::array<double, 4> status = {0, 0, 5050, 21};
  EXPECT_EQ(Line("GT_GetThreadSts", {Value(0), Cells(status)}),
            "12.250 card0 GT_GetThreadSts(0, pThreadSts) = 0, "
            "pThreadSts={run=0, error=0, result=5050, line=21}");
}

TEST(CallTextTest, InputsWithTheirContent) {
  std::array<double, 2> info = {4, 1};
  std::array<double, 3> values = {1, 2.5, -3};
  EXPECT_EQ(Line("GT_SetVarValue", {Value(-1), Cells(info), Cells(values), Value(3)}),
            "12.250 card0 GT_SetVarValue(-1, {id=4, dataType=1}, [1, 2.5, -3], 3) = 0");
}

TEST(CallTextTest, TextIsQuotedWithControlCharactersVisible) {
  EXPECT_EQ(Line("GT_Download", {Text("a\\b\"c\n\x7F.bin")}),
            "12.250 card0 GT_Download(\"a\\\\b\\\"c\\x0a\\x7f.bin\") = 0");
  EXPECT_EQ(Line("GT_Download", {Text("程序.bin")}), "12.250 card0 GT_Download(\"程序.bin\") = 0");
}

TEST(CallTextTest, ATextOutputWithItsText) {
  const char* version = "010260101010260101";
  Arguments arguments;
  arguments[0].host = &version;
  EXPECT_EQ(Line("GT_GetVersion", arguments),
            "12.250 card0 GT_GetVersion(pVersion) = 0, pVersion=\"010260101010260101\"");
}

TEST(CallTextTest, ARefusalWithItsReasonAndWithoutOutputs) {
  double clock = 99;
  const Message reason = {"card 0 is not open", "卡 0 未打开"};
  EXPECT_EQ(Line("GT_GetClock", {Cells({&clock, 1}), Null()}, -1, reason),
            "12.250 card0 GT_GetClock(pClock, NULL) = -1: card 0 is not open");
  EXPECT_EQ(Line("GT_GetClock", {Cells({&clock, 1}), Null()}, -1, reason, Language::kChinese),
            "12.250 card0 GT_GetClock(pClock, NULL) = -1: 卡 0 未打开");
  EXPECT_EQ(Line("GT_Reset", {}, 1), "12.250 card0 GT_Reset() = 1");
}

TEST(CallTextTest, TimeInMillisecondsWithThreeDecimals) {
  const Message reason;
  const gtcalls::Command& reset = *gtcalls::GtsCatalogue().Find("GT_Reset");
  EXPECT_EQ(Line({50, 15, vm::kHostCaller, reset, {}, 0, reason}), "0.050 card15 GT_Reset() = 0");
  EXPECT_EQ(Line({3'600'000'007, 3, vm::kHostCaller, reset, {}, 0, reason}),
            "3600000.007 card3 GT_Reset() = 0");
}

TEST(CallLogTest, IsOffUnlessAskedFor) { EXPECT_FALSE(CallLog("", Language::kEnglish).enabled()); }

TEST(CallLogTest, WritesToStandardErrorOrToAFile) {
  const Message reason;
  const LoggedCall call = {50, 0, vm::kHostCaller, *gtcalls::GtsCatalogue().Find("GT_Reset"),
                           {}, 0, reason};
  testing::internal::CaptureStderr();
  CallLog("calls", Language::kEnglish).Write(call);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "0.050 card0 GT_Reset() = 0\n");

  const std::string path = testing::TempDir() + "oncard_call_log_test.log";
  for (int run = 0; run < 2; ++run) {  // the second run replaces the log of the first
    CallLog log("calls:" + path, Language::kEnglish);
    ASSERT_TRUE(log.enabled());
    log.Write(call);
    log.Write(call);
  }
  EXPECT_EQ(ReadFile(path).value(), "0.050 card0 GT_Reset() = 0\n0.050 card0 GT_Reset() = 0\n");
  std::remove(path.c_str());
}

TEST(CallLogTest, KnowsWhenALineIsLost) {
  const Message reason;
  const LoggedCall call = {50, 0, vm::kHostCaller, *gtcalls::GtsCatalogue().Find("GT_Reset"),
                           {}, 0, reason};
  CallLog log("calls:/dev/full", Language::kEnglish);
  EXPECT_FALSE(log.lost());
  log.Write(call);
  EXPECT_TRUE(log.lost());
}

TEST(CallLogTest, ASettingItDoesNotKnowIsSaidInTheLog) {
  for (const char* setting : {"call", "calls:", "Calls", "1"}) {
    testing::internal::CaptureStderr();
    const CallLog log(setting, Language::kEnglish);
    EXPECT_TRUE(log.enabled());
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "ONCARD_LOG is '" + std::string(setting) + "', expected calls or calls:FILE\n");
  }
}

TEST(CallLogTest, AFileThatCannotBeWrittenIsSaidInTheLog) {
  testing::internal::CaptureStderr();
  const CallLog log("calls:/nowhere/x.log", Language::kEnglish);
  EXPECT_TRUE(log.enabled());
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "cannot write the call log '/nowhere/x.log': No such file or directory\n");
}

}  // namespace
}  // namespace oncard::runtime
