// A part of `oncard_bench run`: how fast `oncard exec` runs a host that polls eight moving axes
// every millisecond for ten minutes (bench/hosts/poll.cc), and what it costs to trace it, to log
// and to record its calls. Wall-clock time, as threads work together; what is written along takes
// turns with the plain run, and is processor time.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/tool.h"

namespace oncard::bench {
namespace {

constexpr double kMinutes = 10;

/// `oncard exec OPTIONS -- poll ARGUMENTS`.
void RunPoll(const std::vector<std::string>& options, const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {"exec"};
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), {"--", ONCARD_POLL_HOST});
  command.insert(command.end(), arguments.begin(), arguments.end());
  RunTool(command);
}

void MeasureHost(const char* what, const std::vector<std::string>& arguments) {
  const double seconds = MeasureWall([&] { RunPoll({}, arguments); });
  std::printf("host, 8 axes, a poll each ms, %s: %.2f s wall, %.0f x real time\n", what, seconds,
              kMinutes * 60 / seconds);
  std::fflush(stdout);
}

/// With a log of its calls in a file.
void RunLoggedPoll(const std::string& file) {
  setenv("ONCARD_LOG", ("calls:" + file).c_str(), 1);
  RunPoll({}, {"1"});
  unsetenv("ONCARD_LOG");
}

void MeasureWhatIsWritten(const std::string& folder) {
  const std::string trace = folder + "/trace.csv";
  const std::string log = folder + "/calls.log";
  const std::string record = folder + "/host.calls";
  const auto samples =
      MeasureInTurns(Clock::kChildren, {
                                           [] { RunPoll({}, {"1"}); },
                                           [&] { RunPoll({"--trace=" + trace}, {"1"}); },
                                           [&] { RunLoggedPoll(log); },
                                           [&] { RunPoll({"--record=" + record}, {"1"}); },
                                       });
  std::printf("the same host with one thread: %.2f s of processor time\n", Shortest(samples[0]));
  const struct {
    const char* what;
    const std::string& file;
  } written[] = {{"--trace", trace}, {"ONCARD_LOG", log}, {"--record", record}};
  for (size_t i = 0; i < std::size(written); ++i) {
    const Samples& with = samples[i + 1];
    const Ratio ratio = RatioOf(with, samples[0]);
    std::printf("  with %s: %.2f s, %.2f times as long (%.2f..%.2f), %ju KB\n", written[i].what,
                Shortest(with), ratio.shortest, ratio.low, ratio.high,
                std::filesystem::file_size(written[i].file) / 1024);
  }
  std::fflush(stdout);
}

}  // namespace

void BenchHosts(const std::string& folder) {
  MeasureHost("one thread", {"1"});
  MeasureHost("beside a blocked thread", {"1", "blocked"});
  MeasureHost("four threads", {"4"});
  MeasureWhatIsWritten(folder);
}

}  // namespace oncard::bench
