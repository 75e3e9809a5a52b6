#include "bench/measure.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "base/large_array.h"

namespace oncard::bench {
namespace {

constexpr int kRepetitions = 7;

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

double Now(Clock clock) {
  switch (clock) {
    case Clock::kCpu:
      return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    case Clock::kChildren: {
      rusage usage;
      ::getrusage(RUSAGE_CHILDREN, &usage);
      return Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
    }
    case Clock::kWall:
      break;
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Uses memory and frees it.
void UseMemory(size_t size) {
  LargeBlock memory;
  memory.Grow(size);
  std::memset(memory.data(), 1, size);
}

double Measure(Clock clock, const std::function<void()>& work) {
  return Shortest(MeasureInTurns(clock, {work}).front());
}

}  // namespace

void Fail(const std::string& why) {
  std::fprintf(stderr, "oncard_bench: %s\n", why.c_str());
  std::exit(1);
}

double MeasureCpu(const std::function<void()>& work) { return Measure(Clock::kCpu, work); }

double MeasureWall(const std::function<void()>& work) { return Measure(Clock::kWall, work); }

std::vector<Samples> MeasureInTurns(Clock clock,
                                    const std::vector<std::function<void()>>& contenders,
                                    size_t memory) {
  std::vector<Samples> samples(contenders.size());
  for (int i = 0; i < kRepetitions; ++i) {
    for (size_t contender = 0; contender < contenders.size(); ++contender) {
      if (memory > 0) UseMemory(memory);
      const double start = Now(clock);
      contenders[contender]();
      samples[contender].push_back(Now(clock) - start);
    }
  }
  return samples;
}

double Shortest(const Samples& samples) { return *std::ranges::min_element(samples); }

Ratio RatioOf(const Samples& samples, const Samples& reference) {
  std::vector<double> ratios;
  for (size_t i = 0; i < samples.size(); ++i) ratios.push_back(samples[i] / reference[i]);
  const auto [low, high] = std::ranges::minmax_element(ratios);
  return {Shortest(samples) / Shortest(reference), *low, *high};
}

double GeometricMean(const std::vector<double>& values) {
  double logarithms = 0;
  for (const double value : values) logarithms += std::log(value);
  return std::exp(logarithms / static_cast<double>(values.size()));
}

}  // namespace oncard::bench
