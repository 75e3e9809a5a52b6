// A part of `oncard_bench run`: how fast `oncard exec` runs a host that polls eight moving axes
// every millisecond for ten minutes (bench/hosts/poll.cc). Wall-clock time, as threads work
// together.
#include <cstdio>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/tool.h"

namespace oncard::bench {
namespace {

constexpr double kMinutes = 10;

void MeasureHost(const char* what, const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {"exec", "--", ONCARD_POLL_HOST};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const double seconds = MeasureWall([&] { RunTool(command); });
  std::printf("host, 8 axes, a poll each ms, %s: %.2f s wall, %.0f x real time\n", what, seconds,
              kMinutes * 60 / seconds);
  std::fflush(stdout);
}

}  // namespace

void BenchHosts() {
  MeasureHost("one thread", {"1"});
  MeasureHost("beside a blocked thread", {"1", "blocked"});
  MeasureHost("four threads", {"4"});
}

}  // namespace oncard::bench
