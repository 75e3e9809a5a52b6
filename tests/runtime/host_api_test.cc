// The refusals of the C API and their codes, tested with libgts itself.
#include <gtest/gtest.h>

#include <climits>
#include <functional>
#include <string>
#include <vector>

#include "host_fixture.h"

namespace oncard::runtime {
namespace {

struct Refusal {
  const char* what;
  short code;
  std::function<short()> call;
};

void ExpectAll(const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals) {
    EXPECT_EQ(refusal.call(), refusal.code) << refusal.what;
  }
}

/// Calls that need an open card, one of each kind.
std::vector<Refusal> CallsOfAClosedCard() {
  static unsigned long clock;
  static long bits;
  static short id;
  static TVarInfo info;
  static double value;
  static TThreadSts status;
  static TCompileInfo nowhere;
  static char* version;
  return {
      {"GT_Close", -1, [] { return GT_Close(); }},
      {"GT_Reset", -1, [] { return GT_Reset(); }},
      {"GT_GetVersion", -1, [] { return GT_GetVersion(&version); }},
      {"GT_GetClock", -1, [] { return GT_GetClock(&clock); }},
      {"GT_GetClock with NULL", -1, [] { return GT_GetClock(nullptr); }},
      {"GT_GetDi", -1, [] { return GT_GetDi(MC_GPI, &bits); }},
      {"GT_SetDo", -1, [] { return GT_SetDo(MC_GPO, 1); }},
      {"GT_Compile", -1, [] { return GT_Compile("sum.c", &nowhere); }},
      {"GT_Download", -1, [] { return GT_Download("sum.bin"); }},
      {"GT_GetFunId", -1, [] { return GT_GetFunId("add", &id); }},
      {"GT_GetVarId", -1, [] { return GT_GetVarId(nullptr, "sum", &info); }},
      {"GT_Bind", -1, [] { return GT_Bind(0, 1, 0); }},
      {"GT_RunThread", -1, [] { return GT_RunThread(0); }},
      {"GT_RunThread out of range", -1, [] { return GT_RunThread(99); }},
      {"GT_GetThreadSts", -1, [] { return GT_GetThreadSts(0, &status); }},
      {"GT_SetVarValue", -1, [] { return GT_SetVarValue(-1, &info, &value); }},
      {"GT_GetVarValue", -1, [] { return GT_GetVarValue(-1, &info, &value); }},
  };
}

TEST(HostApiTest, NothingReachesACardThatIsNotOpen) { ExpectAll(CallsOfAClosedCard()); }

TEST(HostApiTest, NothingReachesACardThatHasBeenClosed) {
  setenv("ONCARD_CLOCK", "virtual", 1);
  ASSERT_EQ(GT_Open(), 0);
  ASSERT_EQ(GT_Close(), 0);
  ExpectAll(CallsOfAClosedCard());
}

TEST(HostApiTest, AClosedCardCanBeOpenedAgainAndIsNew) {
  setenv("ONCARD_CLOCK", "virtual", 1);
  ASSERT_EQ(GT_Open(), 0);
  ASSERT_EQ(GT_SetLongVar(0, 5), 0);
  ASSERT_EQ(GT_Close(), 0);
  ASSERT_EQ(GT_Open(), 0);
  long value = -1;
  EXPECT_EQ(GT_GetLongVar(0, &value), 0);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(GT_Close(), 0);
}

TEST(HostApiTest, AWrongClockSettingFailsTheOpening) {
  setenv("ONCARD_CLOCK", "sometimes", 1);
  EXPECT_EQ(GT_Open(), -6);
  EXPECT_EQ(GT_Reset(), -1);
  setenv("ONCARD_CLOCK", "virtual", 1);
  EXPECT_EQ(GT_Open(), 0);
  EXPECT_EQ(GT_Close(), 0);
}

TEST(HostApiTest, TheEnvironmentNamesTheCard) {
  setenv("ONCARD_CLOCK", "virtual", 1);
  const struct {
    const char* card;
    short axes;
  } cases[] = {{"GTS-400", 4}, {"GTS-800", 8}, {"GTS-1200", 12}, {"", 8}};
  for (const auto& c : cases) {
    setenv("ONCARD_CARD", c.card, 1);
    ASSERT_EQ(GT_Open(), 0);
    EXPECT_EQ(GT_AxisOn(c.axes), 0) << c.card;
    EXPECT_EQ(GT_AxisOn(static_cast<short>(c.axes + 1)), 7) << c.card;
    EXPECT_EQ(GT_Close(), 0);
  }
  unsetenv("ONCARD_CARD");
}

TEST(HostApiTest, AnUnknownCardFailsTheOpening) {
  setenv("ONCARD_CARD", "GTS-500", 1);
  EXPECT_EQ(GT_Open(), -6);
  unsetenv("ONCARD_CARD");
  EXPECT_EQ(GT_Open(), 0);
  EXPECT_EQ(GT_Close(), 0);
}

TEST(HostApiTest, ACardIsSelectedBeforeItIsOpened) {
  setenv("ONCARD_CLOCK", "virtual", 1);
  short selected = -1;
  EXPECT_EQ(GT_GetCardNo(&selected), 0);
  EXPECT_EQ(selected, 0);
  EXPECT_EQ(GT_SetCardNo(-1), 7);
  EXPECT_EQ(GT_SetCardNo(16), 7);
  EXPECT_EQ(GT_GetCardNo(nullptr), 7);
  ASSERT_EQ(GT_SetCardNo(15), 0);
  EXPECT_EQ(GT_GetCardNo(&selected), 0);
  EXPECT_EQ(selected, 15);
  ASSERT_EQ(GT_Open(), 0);
  EXPECT_EQ(GT_SetLongVar(0, 15), 0);
  ASSERT_EQ(GT_SetCardNo(0), 0);
  EXPECT_EQ(GT_SetLongVar(0, 1), -1);
  ASSERT_EQ(GT_SetCardNo(15), 0);
  EXPECT_EQ(GT_Close(), 0);
  ASSERT_EQ(GT_SetCardNo(0), 0);
}

TEST_F(OpenCard, RefusesASecondOpening) {
  EXPECT_EQ(GT_Open(), -6);
  EXPECT_EQ(GT_Reset(), 0);
}

TEST_F(OpenCard, RefusesNullWhereAPointerIsNeeded) {
  Download(kSumProgram);
  short id = 0;
  double value = 0;
  TVarInfo info = Global("sum");
  TCompileInfo nowhere{};
  ExpectAll({
      {"GT_GetVersion", 7, [] { return GT_GetVersion(nullptr); }},
      {"GetMacAddress", 7, [] { return GetMacAddress(0, nullptr, 6); }},
      {"GT_GetClock", 7, [] { return GT_GetClock(nullptr); }},
      {"GT_GetClockHighPrecision", 7, [] { return GT_GetClockHighPrecision(nullptr); }},
      {"GT_GetDi", 7, [] { return GT_GetDi(MC_GPI, nullptr); }},
      {"GT_GetDo", 7, [] { return GT_GetDo(MC_GPO, nullptr); }},
      {"GT_GetLongVar", 7, [] { return GT_GetLongVar(0, nullptr); }},
      {"GT_Compile file", 7, [&] { return GT_Compile(nullptr, &nowhere); }},
      {"GT_Compile info", 7, [] { return GT_Compile("sum.c", nullptr); }},
      {"GT_Download", 7, [] { return GT_Download(nullptr); }},
      {"GT_GetFunId name", 7, [&] { return GT_GetFunId(nullptr, &id); }},
      {"GT_GetFunId id", 7, [] { return GT_GetFunId("add", nullptr); }},
      {"GT_GetVarId name", 7, [&] { return GT_GetVarId("add", nullptr, &info); }},
      {"GT_GetVarId info", 7, [] { return GT_GetVarId("add", "begin", nullptr); }},
      {"GT_GetThreadSts", 7, [] { return GT_GetThreadSts(0, nullptr); }},
      {"GT_SetVarValue info", 7, [&] { return GT_SetVarValue(-1, nullptr, &value); }},
      {"GT_SetVarValue value", 7, [&] { return GT_SetVarValue(-1, &info, nullptr); }},
      {"GT_GetVarValue info", 7, [&] { return GT_GetVarValue(-1, nullptr, &value); }},
      {"GT_GetVarValue value", 7, [&] { return GT_GetVarValue(-1, &info, nullptr); }},
      {"GT_LoadPlcCommand", 7, [] { return GT_LoadPlcCommand(1, 1, nullptr); }},
      {"GT_BindDi", 7, [&] { return GT_BindDi(0, &info, nullptr); }},
  });
}

TEST_F(OpenCard, RefusesWhatIsOutOfRange) {
  Download(kSumProgram);
  double value = 0;
  long bits = 0;
  TVarInfo info = Global("sum");
  TThreadSts status{};
  std::vector<Refusal> refusals = {
      {"page of GT_Bind, -1", 7, [] { return GT_Bind(0, 1, -1); }},
      {"page of GT_Bind, 32", 7, [] { return GT_Bind(0, 1, 32); }},
      {"function 0", 7, [] { return GT_Bind(0, 0, 0); }},
      {"function 2 of 1", 7, [] { return GT_Bind(0, 2, 0); }},
      {"diType -1", 7, [&] { return GT_GetDi(-1, &bits); }},
      {"diType 7", 7, [&] { return GT_GetDi(7, &bits); }},
      {"doType 9", 7, [] { return GT_SetDo(9, 0); }},
      {"doType 13", 7, [] { return GT_SetDo(13, 0); }},
      {"output 0", 7, [] { return GT_SetDoBit(MC_GPO, 0, 1); }},
      {"output 17", 7, [] { return GT_SetDoBit(MC_GPO, 17, 1); }},
      {"user variable -1", 7, [] { return GT_SetLongVar(-1, 0); }},
      {"user variable 1024", 7, [] { return GT_SetLongVar(1024, 0); }},
      {"address of 5 bytes", 7,
       [] {
         unsigned char address[6];
         return GetMacAddress(0, address, 5);
       }},
  };
  for (const short thread : std::vector<short>{-1, 32, SHRT_MIN, SHRT_MAX}) {
    refusals.push_back({"thread of GT_Bind", 7, [=] { return GT_Bind(thread, 1, 0); }});
    refusals.push_back({"thread of GT_RunThread", 7, [=] { return GT_RunThread(thread); }});
    refusals.push_back({"thread of GT_StopThread", 7, [=] { return GT_StopThread(thread); }});
    refusals.push_back({"thread of GT_PauseThread", 7, [=] { return GT_PauseThread(thread); }});
    refusals.push_back({"thread of GT_GetThreadSts", 7,
                        [=, &status] { return GT_GetThreadSts(thread, &status); }});
  }
  for (const short page : std::vector<short>{-2, 32, SHRT_MIN, SHRT_MAX}) {
    refusals.push_back(
        {"page of GT_SetVarValue", 7, [&, page] { return GT_SetVarValue(page, &info, &value); }});
    refusals.push_back(
        {"page of GT_GetVarValue", 7, [&, page] { return GT_GetVarValue(page, &info, &value); }});
  }
  for (const short count : std::vector<short>{0, -1, 7, SHRT_MIN, SHRT_MAX}) {
    refusals.push_back({"count of GT_SetVarValue", 7,
                        [&, count] { return GT_SetVarValue(-1, &info, &value, count); }});
    refusals.push_back({"count of GT_GetVarValue", 7,
                        [&, count] { return GT_GetVarValue(-1, &info, &value, count); }});
  }
  for (const short id : std::vector<short>{-1, 1024, SHRT_MIN, SHRT_MAX}) {
    refusals.push_back({"variable id", 7, [&value, id] {
                          TVarInfo wrong{id, 1, ""};
                          return GT_GetVarValue(-1, &wrong, &value);
                        }});
  }
  ExpectAll(refusals);
}

TEST_F(OpenCard, RefusesWhatTheStateDoesNotAllow) {
  short id = 0;
  TVarInfo info{};
  ExpectAll({
      {"GT_GetFunId without a program", 1, [&] { return GT_GetFunId("add", &id); }},
      {"GT_GetVarId without a program", 1, [&] { return GT_GetVarId(nullptr, "sum", &info); }},
      {"GT_Bind without a program", 7, [] { return GT_Bind(0, 1, 0); }},
      {"GT_RunThread of an unbound thread", 1, [] { return GT_RunThread(0); }},
      {"GT_StopThread of an unbound thread", 1, [] { return GT_StopThread(0); }},
      {"GT_PauseThread of an unbound thread", 1, [] { return GT_PauseThread(0); }},
  });
  Download(kEndlessProgram);
  Run(0, 1, 0);
  ExpectAll({
      {"GT_RunThread of a running thread", 1, [] { return GT_RunThread(0); }},
      {"GT_Bind of a running thread", 1, [] { return GT_Bind(0, 1, 0); }},
      {"GT_Bind to a page in use", 1, [] { return GT_Bind(1, 1, 0); }},
  });
  ASSERT_EQ(GT_StopThread(0), 0);
  ExpectAll({{"GT_PauseThread of a stopped thread", 1, [] { return GT_PauseThread(0); }}});
}

TEST_F(OpenCard, ARefusedCommandChangesNothing) {
  Download(kSumProgram);
  TVarInfo info = Global("sum");
  double value = 42;
  ASSERT_EQ(GT_SetVarValue(-1, &info, &value), 0);
  double values[7] = {1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(GT_SetVarValue(-1, &info, values, 7), 7);
  EXPECT_EQ(ReadGlobal("sum"), 42);

  values[0] = -1;
  EXPECT_EQ(GT_GetVarValue(-2, &info, values), 7);
  EXPECT_EQ(values[0], -1);
  TThreadSts status{9, 9, 9, 9};
  EXPECT_EQ(GT_GetThreadSts(32, &status), 7);
  EXPECT_EQ(status.run, 9);
  EXPECT_EQ(status.result, 9);
}

TEST_F(OpenCard, CommandsThatNoFunctionImplementsSaySo) {
  short mode = 9;
  EXPECT_EQ(GT_SetAxisMode(1, 0), 8);
  EXPECT_EQ(GT_GetAxisMode(1, &mode), 8);
  EXPECT_EQ(mode, 9);
}

TEST_F(OpenCard, TheVersionHasEighteenCharacters) {
  char* version = nullptr;
  ASSERT_EQ(GT_GetVersion(&version), 0);
  const std::string text = version;
  ASSERT_EQ(text.size(), 18u);
  EXPECT_EQ(text.find_first_not_of("0123456789"), std::string::npos);
  std::free(version);
}

TEST_F(OpenCard, EachVersionIsMemoryThatTheHostMayFree) {
  char* first = nullptr;
  char* second = nullptr;
  ASSERT_EQ(GT_GetVersion(&first), 0);
  ASSERT_EQ(GT_GetVersion(&second), 0);
  EXPECT_NE(first, second);
  std::free(first);
  EXPECT_STREQ(second, "010260101010260101");
  std::free(second);
}

TEST_F(OpenCard, TheNetworkAddressIsLocalAndNamesTheCard) {
  unsigned char address[8] = {9, 9, 9, 9, 9, 9, 9, 9};
  ASSERT_EQ(GetMacAddress(0, address, 6), 0);
  EXPECT_EQ(std::vector(address, address + 8),
            (std::vector<unsigned char>{2, 0, 0, 0, 0, 0, 9, 9}));
}

// --- Time ----------------------------------------------------------------------------------------

TEST_F(OpenCard, ACallTakesFiftyMicroseconds) {
  // The clock counts 125 us and advances by a cycle of 250 us: two units for every five calls.
  std::vector<unsigned long> clocks;
  for (int call = 0; call < 11; ++call) clocks.push_back(Clock());
  EXPECT_EQ(clocks, (std::vector<unsigned long>{0, 0, 0, 0, 2, 2, 2, 2, 2, 4, 4}));
}

TEST_F(OpenCard, UpdateTakesAMillisecond) {
  for (const auto& start : std::vector<std::function<short()>>{
           [] { return GT_Update(1); }, [] { return GT_PtStart(1); },
           [] { return GT_GearStart(1); }, [] { return GT_FollowStart(1); }}) {
    const unsigned long before = Clock();
    start();
    EXPECT_GE(Clock() - before, 8u);  // 1 ms + 50 us
    EXPECT_LE(Clock() - before, 10u);
  }
}

TEST_F(OpenCard, ARefusedCallTakesItsTimeToo) {
  for (int call = 0; call < 20; ++call) EXPECT_EQ(GT_RunThread(99), 7);
  EXPECT_EQ(Clock(), 8u);  // 21 calls: four whole cycles
}

TEST_F(OpenCard, ADelayInAProgramTakesItsTime) {
  Download(R"(int done;
int wait()
{
  GT_Delay(10);
  done = 1;
  return done;
}
)");
  const TVarInfo done = Global("done");
  ASSERT_EQ(GT_Reset(), 0);
  Download(R"(int done;
int wait()
{
  GT_Delay(10);
  done = 1;
  return done;
}
)");
  Run(0, 1, 0);
  const unsigned long begin = Clock();
  TVarInfo variable = done;
  double value = 0;
  unsigned long now = begin;
  while (value == 0) {
    ASSERT_EQ(GT_GetVarValue(-1, &variable, &value), 0);
    now = Clock();
  }
  // 10 ms = 80 units; the host reads every 100 us, the thread runs in cycles.
  EXPECT_GE(now - begin, 80u);
  EXPECT_LE(now - begin, 84u);
}

TEST_F(OpenCard, ResetPutsEverythingBack) {
  Download(kEndlessProgram);
  Run(0, 1, 0);
  ASSERT_EQ(GT_SetLongVar(3, 33), 0);
  ASSERT_EQ(GT_SetDo(MC_GPO, 0xFF), 0);
  ASSERT_GT(Clock(), 0u);
  ASSERT_EQ(GT_Reset(), 0);
  EXPECT_EQ(Clock(), 0u);
  TThreadSts status{};
  EXPECT_EQ(GT_GetThreadSts(0, &status), 0);
  EXPECT_EQ(status.run, 0);
  EXPECT_EQ(GT_RunThread(0), 1);
  short id = 0;
  EXPECT_EQ(GT_GetFunId("run", &id), 1);
  long value = -1;
  EXPECT_EQ(GT_GetLongVar(3, &value), 0);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(GT_GetDo(MC_GPO, &value), 0);
  EXPECT_EQ(value, 0);
}

TEST(RealClockTest, TheCardRunsWhileTheHostPolls) {
  setenv("ONCARD_CLOCK", "real:1000", 1);
  ASSERT_EQ(GT_Open(), 0);
  unsigned long first = 0;
  unsigned long now = 0;
  ASSERT_EQ(GT_GetClock(&first), 0);
  // One millisecond of real time is one second of the card, so this ends soon on any machine.
  while (now < first + 1000) ASSERT_EQ(GT_GetClock(&now), 0);
  EXPECT_EQ(GT_Close(), 0);
}

}  // namespace
}  // namespace oncard::runtime
