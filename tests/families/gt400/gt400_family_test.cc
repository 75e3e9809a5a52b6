// Hosts written for GT400 cards, from their headers to their output under `oncard exec`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/families/family_hosts.h"

namespace oncard::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// --- Headers -------------------------------------------------------------------------------------

class Gt400IsaHost : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Languages, Gt400IsaHost, testing::Values("c", "cpp"),
                         [](const auto& language) { return std::string(language.param); });

TEST_P(Gt400IsaHost, OpensItsCardWithAnAddressAndAnInterrupt) {
  const bool overloaded = std::string(GetParam()) == "cpp";
  const ProcessResult host = Exec(std::string("gt400_isa_") + GetParam());
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out, std::string("open: 0\nopen with another address: 0\naxis: 0\n") +
                          (overloaded ? "open without parameters: 0\n" : ""));
}

TEST(Gt400DosHost, OpensItsCardWithItsAddress) {
  const ProcessResult host = Exec("gt400_dos");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "address: 0, 0x300\n"
            "axis before: -1\n"
            "no card there: -1\n"
            "address: 0, 0x280\n"
            "axis before: -1\n"
            "set: 0\n"
            "set again: 0\n"
            "address: 0, 0x300\n"
            "axis: 0\n"
            "another card: -1\n");
}

// The manual: 4 + 4 * kinds + 16 * commands.
TEST(Gt400BackgroundSet, HasTheLayoutOfTheManual) {
  const ProcessResult host = Exec("gt400_background");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "02 00 00 00 01 00 02 00 41 00 01 00 02 00 00 00\n"
            "01 02 03 04 00 00 00 00 16 00 01 00 02 00 00 00\n"
            "00 00 00 00 00 00 00 00 20 00 01 00 4C 00 01 00\n"
            "02 00 FF FF 00 00 00 00 14 00 00 00\n"
            "1\n");
}

// --- Cards ---------------------------------------------------------------------------------------

// A card that is used late has the time of the others. A call takes 50 us, those that mean no card
// none; a cycle 200 us: the clock is read at 0.15 ms, 10.3 ms and 10.4 ms, after the reset at 0.1
// ms, and at 10.65 ms. After the second opening it begins anew.
TEST(Gt400Cards, AreOpenedAtOnce) {
  const ProcessResult host = Exec("gt400_cards");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "axis before opening: -1\n"
            "reset before opening: -1\n"
            "number before opening: -1\n"
            "switch before opening: -1\n"
            "close before opening: -1\n"
            "open: 0\n"
            "open again: 0\n"
            "card 0, position 5, clock 0\n"
            "switch: 0\n"
            "card 15, position 7, clock 51\n"
            "no such card: -1\n"
            "no such card: -1\n"
            "card 15, position 7, clock 52\n"
            "reset: 0\n"
            "card 0, position 0, clock 0\n"
            "card 15, position 7, clock 53\n"
            "close: 0\n"
            "axis after closing: -1\n"
            "close again: -1\n"
            "open once more: 0\n"
            "card 0, position 0, clock 0\n"
            "card 15, position 0, clock 1\n");
}

TEST(Gt400Cards, AreAsManyAsTheEnvironmentSays) {
  const ScratchFolder folder;
  folder.Write("log.txt", "");
  const ProcessResult host =
      Exec("gt400_cards", {}, {"ONCARD_CARDS=2", "ONCARD_LOG=calls:log.txt"}, folder);
  EXPECT_THAT(host.out, HasSubstr("\nswitch: -1\n"));
  EXPECT_THAT(folder.Read("log.txt"),
              HasSubstr("GT_SwitchtoCardNo(15) = -1: there is no card 15; the computer has cards 0 "
                        "to 1\n"));
}

TEST(Gt400Cards, AreNotOpenedWithAWrongNumber) {
  for (const char* number : {"0", "17", "two", "-1", "1.5"}) {
    const ProcessResult host = Exec("gt400_isa_c", {}, {std::string("ONCARD_CARDS=") + number});
    EXPECT_THAT(host.out, HasSubstr("open: -6\n")) << number;
    EXPECT_THAT(host.err, HasSubstr(std::string("ONCARD_CARDS is '") + number +
                                    "', expected a number from 1 to 16"));
  }
}

// Cards 1 to 14 are open, too.
TEST(Gt400Cards, HaveALogAndARecordIfTheHostUsesThem) {
  const ScratchFolder folder;
  const ProcessResult host =
      Exec("gt400_cards", {"--record=host.calls"}, {"ONCARD_LOG=calls:log.txt"}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_THAT(folder.Read("log.txt"),
              AllOf(HasSubstr("10.200 card15 GT_SetPos(7) = 0\n"), Not(HasSubstr("card1 "))));
  ExpectReplay(folder);
}

// What the host expects of a card it can expect only of those that it uses.
TEST(Gt400Cards, MeetAScenarioIfTheHostUsesThem) {
  const ScratchFolder folder;
  folder.Write("cards.host.toml", "card = \"GT-400-SG\"\nexpect = [\"axis1.prfPos == 1\"]\n");
  const ProcessResult host = Exec("gt400_dos", {"--scenario=cards.host.toml"}, {}, folder);
  EXPECT_EQ(host.exit_code, 120);
  EXPECT_THAT(host.err, AllOf(HasSubstr("card 0: 'axis1.prfPos == 1' does not hold"),
                              Not(HasSubstr("card 1: "))));
}

TEST(Gt400Cards, AreNamedByTheEnvironment) {
  EXPECT_EQ(Exec("gt400_isa_c", {"--card=GT-400-SE"}).exit_code, 0);
  const ProcessResult other = Exec("gt400_isa_c", {"--card=GTS-800"});
  EXPECT_THAT(other.out, HasSubstr("open: -6\n"));
  EXPECT_THAT(other.err, HasSubstr("ONCARD_CARD is 'GTS-800', expected one of GT-400-SV"));
}

// --- Time ----------------------------------------------------------------------------------------

// The clock is read at 10.05 ms. The sample time is changed at 10.1 ms, so that the cycle in
// progress ends at 10.2 ms, and 24 others of 400 us before 20.15 ms. The reset at 20.2 ms begins 50
// of 200 us before 30.25 ms. Updates end with the ticks at 30.4 and 30.6 ms. The other reset is at
// 30.75 ms, and the clock is read after the tick at 30.8 ms.
TEST(Gt400Time, CountsSampleTimesWhateverTheyTake) {
  const ProcessResult host = Exec("gt400_sample_time");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "10 ms: 50\n"
            "10 ms of 400 us: 75\n"
            "10 ms after a reset: 50\n"
            "sample time: 200 us\n"
            "an update: 51\n"
            "another one: 52\n"
            "sample time: 200 us\n"
            "a hard reset: 1\n");
}

// --- Interrupts ----------------------------------------------------------------------------------

/// The home switch of axis 3.
constexpr const char* kHomeSwitch = R"(card = "GT-400-SV"
[[world.switch]]
axis = 3
type = "home"
from = 20000
active_low = true
)";

// The handler runs once at the home position, with axis 3 as the current one from then on; a
// handler of time interrupts runs every 2 ms, and needs no GT_ClearInt.
TEST(Gt400Interrupts, CallAHandler) {
  const ScratchFolder folder;
  folder.Write("home.host.toml", kHomeSwitch);
  const ProcessResult host =
      Exec("gt400_handler", {"--scenario=home.host.toml", "--record=host.calls"},
           {"ONCARD_LOG=calls:log.txt"}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "no card: 0\n"
            "first: 0\n"
            "word 0x2F08, current axis 3, captured 0\n"
            "once: 1\n"
            "hooked before: 1\n"
            "in 12 ms: 6\n"
            "no such card: -1\n"
            "card not used: -1\n"
            "unhook: 0\n"
            "unhook again: -1\n"
            "unhooked: 6\n");
  const std::string log = folder.Read("log.txt");
  EXPECT_THAT(log, AllOf(HasSubstr(" card0: irq axis 3 0x2F08\n"),
                         HasSubstr(" card0 GT_SetPos(20000) = 0\n"),
                         HasSubstr(" card0: irq time\n"), HasSubstr(" card0 GT_ClearInt(0) = 0\n"),
                         HasSubstr("no handler is hooked, call GT_HookIsr first")));
  ExpectReplay(folder);
}

// TmrIntr acts at 0.1 ms, before the first tick: time interrupts at ticks 100 and 200. The Update
// acts at tick 254, and 100 pulses with velocity and acceleration 1 take 101 ticks.
TEST(Gt400Interrupts, SetAnEventForWhichAThreadWaits) {
  const ScratchFolder folder;
  const ProcessResult host = Exec("gt400_events", {"--record=host.calls"}, {}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "no event: -1\n"
            "event: 0\n"
            "a thread: -1, 0\n"
            "1: 0x0000 at 100\n"
            "2: 0x0000 at 200\n"
            "too short: -1\n"
            "set: 0\n"
            "3: 0x1B01 at 355\n"
            "result: 0\n"
            "target 50, position 100\n"
            "closed: 1\n"
            "closed event: -1\n");
  ExpectReplay(folder);
}

TEST(Gt400Interrupts, AreTheSameInEveryRun) {
  for (const char* host : {"gt400_handler", "gt400_events"}) {
    std::vector<std::string> runs;
    for (int run = 0; run < 2; ++run) {
      const ScratchFolder folder;
      folder.Write("home.host.toml", kHomeSwitch);
      const ProcessResult ran = Exec(host, {"--scenario=home.host.toml", "--record=host.calls"},
                                     {"ONCARD_LOG=calls:log.txt"}, folder);
      runs.push_back(ran.out + folder.Read("log.txt") + folder.Read("host.calls"));
    }
    EXPECT_EQ(runs[0], runs[1]) << host;
  }
}

// The limit is active in the cycle from 55 ms on, which ends at 55.2 ms.
TEST(Gt400Warnings, TellWhatStopsAnAxisInTheTimeOfTheHost) {
  const ScratchFolder folder;
  folder.Write("limit.host.toml",
               "card = \"GT-400-SV\"\n[[world.input]]\ntype = \"limit_positive\"\nindex = 2\n"
               "value = 1\nat_ms = 55\n");
  const ProcessResult host = Exec("gt400_events", {"--scenario=limit.host.toml"}, {}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_THAT(host.err, AllOf(HasSubstr("axis 2 reached its positive limit switch"),
                              HasSubstr("(at 55.2 ms) [axis-stopped]")));
}

// --- The library ---------------------------------------------------------------------------------

TEST(Gt400Library, IsFoundByItsNameOnWindows) {
  const ScratchFolder folder;
  const ProcessResult host =
      RunFamilyOncard({"exec", "--", kHostFolder + "/gt400_loaded", ONCARD_GT400_DLL}, folder);
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out, "clock 5000\n");
}

}  // namespace
}  // namespace oncard::tools
