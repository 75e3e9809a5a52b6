// Hosts written for GE cards, from gep.h to their output under `oncard exec`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/families/family_hosts.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

class GeHost : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Languages, GeHost, testing::Values("c", "cpp"),
                         [](const auto& language) { return std::string(language.param); });

// 10 ms and 50 pulses up and down, 9900 pulses at 10: 1010 ms.
TEST_P(GeHost, MovesAnAxisAndHearsOfItsCalls) {
  const ProcessResult host = Exec(std::string("ge_host_") + GetParam());
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "GT_SetAtlPos(1, 0) = 1, 2048\n"
            "GT_SetKp(9, 1) = 7, 2\n"
            "GT_GetPrfPos(1, NULL) = 7, 2\n"
            "1010 ms, position 10000, status 0xB80\n"
            "113 calls\n");
}

TEST_P(GeHost, RunsAListOfAPathCard) {
  const ProcessResult host = Exec(std::string("ge_path_") + GetParam());
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "open: 0\n"
            "no length: 3\n"
            "path status 0x2093, at (100, 0, 0)\n"
            "look-ahead: 0\n"
            "status 0x1A00\n");
}

TEST(GeCards, AreOpenedOneAfterTheOther) {
  const ProcessResult host = Exec("ge_cards");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "hard reset before opening: -1, card 0\n"
            "switch to a closed card: 0, card 2\n"
            "command of a closed card: -1, card 2\n"
            "open: 0, card 2\n"
            "set: 0, card 2\n"
            "open the lowest closed one: 0, card 0\n"
            "position 0\n"
            "switch back: 0, card 2\n"
            "position 22\n"
            "no such card: 7, card 2\n"
            "reset: 0, card 2\n"
            "position 0\n"
            "all are open: -1, card 15\n"
            "close: 0, card 7\n"
            "close again: -1, card 7\n"
            "open again: 0, card 7\n");
}

// A sample every 0.25 ms: the 100th is at 25 ms. 50 pulses in 10 ms, then 10 a ms; the update
// begins two cycles after the watch at most.
TEST(GeWatch, GivesBatchesToTheHost) {
  const ProcessResult host = Exec("ge_watch");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_THAT(host.out, HasSubstr("not started: 1\nno array: 7\n"));
  const auto lines = host.out.substr(host.out.find("no array: 7\n") + 12);
  EXPECT_EQ(lines, "200 10\n450 10\n700 10\n");
}

TEST(GeCards, AreNamedByTheEnvironmentOrTheScenario) {
  const ProcessResult two = Exec("ge_host_c", {"--card=GE-200-PV"});
  EXPECT_EQ(two.exit_code, 0) << two.err;
  EXPECT_THAT(two.out, HasSubstr("status 0xB80"));
  const ProcessResult other = Exec("ge_host_c", {"--card=GTS-800"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, HasSubstr("ONCARD_CARD is 'GTS-800', expected one of GE-800-PG"));
}

TEST(GeHostRecord, IsReplayed) {
  for (const char* host : {"ge_host_c", "ge_watch"}) {
    SCOPED_TRACE(host);
    const ScratchFolder folder;
    ASSERT_EQ(Exec(host, {"--record=host.calls"}, {}, folder).exit_code, 0);
    ExpectReplay(folder);
  }
}

TEST(GeCommands, AreAllImplemented) {
  const ScratchFolder folder;
  const ProcessResult doctor = RunFamilyOncard({"doctor", "--commands", "--family=gep"}, folder);
  EXPECT_THAT(doctor.out, HasSubstr("GT_Update"));
  EXPECT_THAT(doctor.out, testing::Not(HasSubstr("not supported")));
}

TEST(GeCommands, OfPathCardsLackOnlyWhatNoDocumentDescribes) {
  const ScratchFolder folder;
  const ProcessResult doctor = RunFamilyOncard({"doctor", "--commands", "--family=ges"}, folder);
  size_t lacking = 0;
  std::istringstream lines(doctor.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("implemented") == std::string::npos) ++lacking;
  }
  // The rows of priority 3 in the list of calls.
  EXPECT_EQ(lacking, 29u) << doctor.out;
}

}  // namespace
}  // namespace oncard::tools
