// `oncard exec --record` and `oncard replay` of what it wrote: the samples and clients of the
// tests.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <csignal>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/files.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

std::string HostOfTests(const std::string& name) {
  return std::string(ONCARD_BUILD_DIR "/tests/runtime/") + name;
}

/// How often `part` is in a text.
int CountOf(std::string_view part, std::string_view text) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// A folder in which a host has been recorded in `host.calls`.
class Recorded {
 public:
  /// `options` of `oncard exec` besides --record.
  explicit Recorded(const std::vector<std::string>& command,
                    std::vector<std::string> options = {}) {
    folder_.Write("sum.c", ReadFile(ONCARD_SOURCE_DIR "/samples/01_sum/sum.c").value());
    options.insert(options.begin(), {"exec", "--record=host.calls"});
    options.emplace_back("--");
    options.insert(options.end(), command.begin(), command.end());
    exec_ = RunOncard(options, folder_.path());
  }

  const ProcessResult& exec() const { return exec_; }
  std::string text() const { return folder_.Read("host.calls"); }
  void Change(const std::string& from, const std::string& to) {
    std::string text = this->text();
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    folder_.Write("host.calls", text.replace(at, from.size(), to));
  }
  void Cut(size_t bytes) { folder_.Write("host.calls", text().substr(0, text().size() - bytes)); }
  ProcessResult Replay(const std::vector<std::string>& options = {}) const {
    return RunWithRecord("replay", options);
  }
  ProcessResult Explore(const std::vector<std::string>& options = {}) const {
    return RunWithRecord("explore", options);
  }

 private:
  ProcessResult RunWithRecord(const std::string& command,
                              const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {command, "host.calls"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunOncard(arguments, folder_.path());
  }

  ScratchFolder folder_;
  ProcessResult exec_;
};

// --- The same card without the host --------------------------------------------------------------

class RecordedSample : public testing::TestWithParam<std::string> {};

TEST_P(RecordedSample, EndsInTheSameState) {
  const std::string folder = GetParam();
  const std::string scenario =
      std::string(ONCARD_SOURCE_DIR "/samples/") + folder + "/" + folder.substr(3) + ".host.toml";
  const Recorded host({ONCARD_BUILD_DIR "/samples/sample_" + folder}, {"--scenario=" + scenario});
  EXPECT_EQ(host.exec().exit_code, 0) << host.exec().err;
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_THAT(replay.out, MatchesRegex("card 0, opening 1: [0-9]+ calls in [0-9.]+ ms as recorded, "
                                       "hash [0-9a-f]{16}\n"));
}

INSTANTIATE_TEST_SUITE_P(Samples, RecordedSample,
                         testing::Values("14_pt_dynamic", "15_pvt", "19_arcs", "20_look_ahead",
                                         "22_homing", "23_compare", "24_servo", "34_bus_homing",
                                         "35_bus_probe", "36_bus_io"));

class RecordedClient : public testing::TestWithParam<std::string> {};

TEST_P(RecordedClient, EndsInTheSameState) {
  const Recorded host({HostOfTests(GetParam()), "sum.c"});
  EXPECT_EQ(host.exec().exit_code, 0) << host.exec().err;
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_THAT(replay.out, StartsWith("card 0, opening 1: "));
}

INSTANTIATE_TEST_SUITE_P(Clients, RecordedClient,
                         testing::Values("sample_01_sum_host", "one_thread_c", "two_threads_c",
                                         "trap_move", "refused", "logged"));

TEST(RecordCalls, KeepsEveryCardOfAHost) {
  const Recorded host({HostOfTests("two_cards_c"), "sum.c"});
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_THAT(replay.out, HasSubstr("card 0, opening 1: "));
  EXPECT_THAT(replay.out, HasSubstr("card 1, opening 1: "));
}

TEST(RecordCalls, KeepsTheProgramAndItsSource) {
  const Recorded host({HostOfTests("one_thread_c"), "sum.c"});
  EXPECT_THAT(host.text(), HasSubstr("\"call\":\"GT_Download\""));
  EXPECT_THAT(host.text(), HasSubstr("/sum.c\",\"text\":"));
}

// --- Records that are not as they were -----------------------------------------------------------

TEST(RecordCalls, AnAnswerThatIsNotTheRecordedOneIsAFailure) {
  Recorded host({HostOfTests("one_thread_c"), "sum.c"});
  // Binding thread 0 succeeded; binding thread 40 cannot.
  host.Change("\"call\":\"GT_Bind\",\"in\":[0,", "\"call\":\"GT_Bind\",\"in\":[40,");
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_THAT(replay.err, HasSubstr("GT_Bind(40, "));
  EXPECT_THAT(replay.err, HasSubstr("returns 7 (parameter thread is 40; the range is [0, 31]) "
                                    "instead of 0 as in the record"));
}

TEST(RecordCalls, AnotherStateAtTheEndIsAFailure) {
  Recorded host({HostOfTests("one_thread_c"), "sum.c"});
  const std::string text = host.text();
  const std::string digit = text.substr(text.find("\"hash\":\"") + 8, 1);
  host.Change("\"hash\":\"" + digit, digit == "0" ? "\"hash\":\"1" : "\"hash\":\"0");
  EXPECT_EQ(host.Replay().exit_code, 1);
  EXPECT_THAT(host.Replay().err, HasSubstr("the card is in another state than it was"));
}

TEST(RecordCalls, ALineThatWasCutIsLeftOut) {
  Recorded host({HostOfTests("one_thread_c"), "sum.c"});
  host.Cut(5);
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_THAT(replay.err, HasSubstr("the record ends before the host closed the card"));
}

TEST(RecordCalls, ARecordWithoutItsEndIsAFailure) {
  Recorded host({HostOfTests("one_thread_c"), "sum.c"});
  const std::string text = host.text();
  host.Cut(text.size() - text.rfind("{\"close\""));
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_THAT(replay.err, HasSubstr("the record ends before the host closed the card"));
}

TEST(RecordCalls, AnOldRecordDoesNotStayWhenTheHostOpensNoCard) {
  Recorded host({"true"});
  EXPECT_EQ(host.exec().exit_code, 0) << host.exec().err;
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 3);
  EXPECT_THAT(replay.err, HasSubstr("the host has opened no card"));
}

// --- Hosts that do not end, and records that cannot be written -----------------------------------

TEST(RecordCalls, AllCallsOfAHostThatIsKilledAreThere) {
  constexpr int kTimes = 20'000;  // more than is mapped at a time
  const Recorded host({HostOfTests("endless"), std::to_string(kTimes)});
  EXPECT_EQ(host.exec().exit_code, 128 + SIGKILL);
  EXPECT_EQ(CountOf("\"call\":\"GT_ClrSts\"", host.text()), kTimes);
  const ProcessResult replay = host.Replay();
  EXPECT_EQ(replay.exit_code, 1);
  EXPECT_THAT(replay.err, HasSubstr("the record ends before the host closed the card"));
  EXPECT_EQ(host.Explore({"--max-states=100"}).exit_code, 2) << "it starts no thread";
}

TEST(RecordCalls, AHostThatEndsInOrderLeavesOnlyItsCalls) {
  const Recorded host({HostOfTests("one_thread_c"), "sum.c"});
  EXPECT_EQ(host.text().find('\0'), std::string::npos);
}

TEST(RecordCalls, AChildRecordsNothing) {
  const Recorded host({HostOfTests("memory"), "child"});
  EXPECT_EQ(host.exec().exit_code, 0) << host.exec().err;
  EXPECT_THAT(host.text(), Not(HasSubstr("\"call\"")));
  EXPECT_EQ(CountOf("\"close\"", host.text()), 1);
  EXPECT_EQ(host.Replay().exit_code, 0);
}

/// A host that writes the record `path`, and the call log on standard error.
ProcessResult RecordTo(const std::string& path) {
  return RunOncard({"exec", "--", HostOfTests("trap_move")}, {},
                   {"ONCARD_RECORD=" + path, "ONCARD_LOG=calls"});
}

TEST(RecordCalls, ARecordThatCannotBeWrittenFailsTheOpeningOfTheCard) {
  EXPECT_THAT(RecordTo("/nowhere/host.calls").err,
              HasSubstr("GT_Open(0, 1) = -6: cannot write the record of calls "
                        "'/nowhere/host.calls': No such file or directory"));
}

TEST(RecordCalls, ARecordIsWrittenByOneHostAtATime) {
  const ScratchFolder folder;
  const std::string path = folder.Write("host.calls", "of another\n");
  const Descriptor other(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  ASSERT_EQ(::flock(other.get(), LOCK_EX), 0);
  EXPECT_THAT(RecordTo(path).err, HasSubstr("= -6: cannot write the record of calls '" + path +
                                            "': another process is writing it"));
  EXPECT_EQ(folder.Read("host.calls"), "of another\n");
}

TEST(RecordCalls, ARecordThatIsNotCompleteIsAFailure) {
  const ProcessResult result = RecordTo("/dev/full");
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_THAT(result.err, HasSubstr("the record of calls could not be written completely"));
}

// --- Options -------------------------------------------------------------------------------------

TEST(RecordCalls, ANameThatIsNoRecordsNameIsRefused) {
  const ProcessResult result = RunOncard({"exec", "--record=x.schedule", "--", "true"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("the name of a record ends in .calls"));
}

TEST(RecordCalls, OptionsOfASchedulesReplayAreRefused) {
  const Recorded host({"true"});
  const ProcessResult replay = host.Replay({"--show=sum"});
  EXPECT_EQ(replay.exit_code, 2);
  EXPECT_THAT(replay.err, HasSubstr("--show is not for the record of a host program"));
}

TEST(RecordCalls, OptionsThatAnExplorationOfAHostDoesNotHaveAreRefused) {
  const Recorded host({"true"});
  for (const char* option : {"--save=a.schedule", "--regression=a.toml", "--search=a.search",
                             "--shard=1/2", "--structured", "--races", "--benign"}) {
    const ProcessResult result = host.Explore({option});
    EXPECT_EQ(result.exit_code, 2) << option;
    EXPECT_THAT(result.err, HasSubstr("is not for the record of a host program")) << option;
  }
}

TEST(RecordCalls, ARecordWithoutCallsIsNotExplored) {
  const ProcessResult result = Recorded({"true"}).Explore();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("the host has opened no card"));
}

TEST(RecordCalls, TheThreadsOfAHostAreExplored) {
  const Recorded host({HostOfTests("two_threads_c"), "sum.c"});
  EXPECT_EQ(host.exec().exit_code, 0) << host.exec().err;
  const ProcessResult result = host.Explore({"--max-states=100"});
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_THAT(result.out, HasSubstr("host of host.calls"));
}

}  // namespace
}  // namespace oncard::tools
