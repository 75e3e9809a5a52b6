// gts.h in a C++ host: values of the constants and order of the members, compared with the manuals;
// and the generated documentation, compared with the one in docs/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "vm/machine.h"

// Last, because its constants are macros.
#include "gts.h"

namespace oncard::gtcalls::gts {
namespace {

// --- Constants ----------------------------------------------------------------------------------

TEST(InterfaceTest, InputAndOutputTypes) {
  EXPECT_EQ(MC_NONE, -1);
  EXPECT_EQ(MC_LIMIT_POSITIVE, 0);
  EXPECT_EQ(MC_LIMIT_NEGATIVE, 1);
  EXPECT_EQ(MC_ALARM, 2);
  EXPECT_EQ(MC_HOME, 3);
  EXPECT_EQ(MC_GPI, 4);
  EXPECT_EQ(MC_ENABLE, 10);
  EXPECT_EQ(MC_CLEAR, 11);
  EXPECT_EQ(MC_GPO, 12);
}

TEST(InterfaceTest, MotionModes) {
  EXPECT_EQ(PT_MODE_STATIC, 0);
  EXPECT_EQ(PT_MODE_DYNAMIC, 1);
  EXPECT_EQ(PT_SEGMENT_NORMAL, 0);
  EXPECT_EQ(PT_SEGMENT_EVEN, 1);
  EXPECT_EQ(PT_SEGMENT_STOP, 2);
  EXPECT_EQ(GEAR_MASTER_ENCODER, 1);
  EXPECT_EQ(GEAR_MASTER_PROFILE, 2);
  EXPECT_EQ(GEAR_MASTER_AXIS, 3);
  EXPECT_EQ(FOLLOW_MASTER_ENCODER, 1);
  EXPECT_EQ(FOLLOW_MASTER_PROFILE, 2);
  EXPECT_EQ(FOLLOW_MASTER_AXIS, 3);
  EXPECT_EQ(FOLLOW_EVENT_START, 1);
  EXPECT_EQ(FOLLOW_EVENT_PASS, 2);
  EXPECT_EQ(FOLLOW_SEGMENT_NORMAL, 0);
  EXPECT_EQ(FOLLOW_SEGMENT_EVEN, 1);
  EXPECT_EQ(FOLLOW_SEGMENT_STOP, 2);
  EXPECT_EQ(FOLLOW_SEGMENT_CONTINUE, 3);
}

TEST(InterfaceTest, CrdBuffers) {
  EXPECT_EQ(CRD_FIFO_MAX, 4096);
  EXPECT_EQ(CRD_MAX, 2);
}

TEST(InterfaceTest, FaultsAreTheMachines) {
  EXPECT_EQ(GTS_FAULT_DIVISION_BY_ZERO, static_cast<int>(vm::Fault::kDivisionByZero));
  EXPECT_EQ(GTS_FAULT_INDEX_OUT_OF_BOUNDS, static_cast<int>(vm::Fault::kIndexOutOfBounds));
  EXPECT_EQ(GTS_FAULT_OUTPUT_BEYOND_STORAGE, static_cast<int>(vm::Fault::kOutputBeyondStorage));
}

// --- Structures: positional initialisers name the members in their order -------------------------

TEST(InterfaceTest, ThreadSts) {
  const TThreadSts status = {1, 2, 3.5, 4};
  EXPECT_EQ(status.run, 1);
  EXPECT_EQ(status.error, 2);
  EXPECT_EQ(status.result, 3.5);
  EXPECT_EQ(status.line, 4);
}

TEST(InterfaceTest, VarInfo) {
  const TVarInfo variable = {1, 2, "sum"};
  EXPECT_EQ(variable.id, 1);
  EXPECT_EQ(variable.dataType, 2);
  EXPECT_STREQ(variable.name, "sum");
  EXPECT_EQ(sizeof(variable.name), 32u);
}

TEST(InterfaceTest, CompileInfo) {
  char file[] = "sum.c";
  char message[] = "text";
  short line = 7;
  const TCompileInfo info = {file, &line, message};
  EXPECT_EQ(info.pFileName, file);
  EXPECT_EQ(*info.pLineNo, 7);
  EXPECT_EQ(info.pMessage, message);
}

TEST(InterfaceTest, TrapPrm) {
  const TTrapPrm trap = {0.25, 0.125, 1.5, 25};
  EXPECT_EQ(trap.acc, 0.25);
  EXPECT_EQ(trap.dec, 0.125);
  EXPECT_EQ(trap.velStart, 1.5);
  EXPECT_EQ(trap.smoothTime, 25);
}

TEST(InterfaceTest, JogPrm) {
  const TJogPrm jog = {0.0625, 0.125, 0.5};
  EXPECT_EQ(jog.acc, 0.0625);
  EXPECT_EQ(jog.dec, 0.125);
  EXPECT_EQ(jog.smooth, 0.5);
}

TEST(InterfaceTest, Pid) {
  const TPid pid = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(pid.kp, 1);
  EXPECT_EQ(pid.ki, 2);
  EXPECT_EQ(pid.kd, 3);
  EXPECT_EQ(pid.kvff, 4);
  EXPECT_EQ(pid.kaff, 5);
  EXPECT_EQ(pid.integralLimit, 6);
  EXPECT_EQ(pid.derivativeLimit, 7);
  EXPECT_EQ(pid.limit, 8);
}

TEST(InterfaceTest, CrdPrm) {
  const TCrdPrm crd = {2, {1, 2, 0, 0, 0, 0, 0, 9}, 500, 1, 50, 1, {100, 200, 0, 0, 0, 0, 0, 900}};
  EXPECT_EQ(crd.dimension, 2);
  EXPECT_EQ(crd.profile[1], 2);
  EXPECT_EQ(crd.profile[7], 9);
  EXPECT_EQ(crd.synVelMax, 500);
  EXPECT_EQ(crd.synAccMax, 1);
  EXPECT_EQ(crd.evenTime, 50);
  EXPECT_EQ(crd.setOriginFlag, 1);
  EXPECT_EQ(crd.originPos[0], 100);
  EXPECT_EQ(crd.originPos[7], 900);
}

// --- Documentation ------------------------------------------------------------------------------

std::string ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(InterfaceTest, TheCommandReferencesAreUpToDate) {
  for (const std::string page : {"/commands.md", "/commands.zh-CN.md", "/commands-gep.md",
                                 "/commands-ges.md", "/commands-gt400.md"}) {
    const std::string generated = ReadAll(ONCARD_GENERATED_PAGES + page);
    ASSERT_FALSE(generated.empty()) << page;
    EXPECT_TRUE(ReadAll(ONCARD_SOURCE_DIR "/docs" + page) == generated)
        << page << ": run `cmake --build . --target update_commands_page`";
  }
}

TEST(InterfaceTest, EveryTopicHasAChineseTitle) {
  std::istringstream page(ReadAll(ONCARD_GENERATED_PAGES "/commands.zh-CN.md"));
  int titles = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("## ")) continue;
    ++titles;
    const auto is_chinese = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
    EXPECT_TRUE(std::ranges::any_of(line, is_chinese)) << line;
  }
  EXPECT_EQ(titles, 30);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
