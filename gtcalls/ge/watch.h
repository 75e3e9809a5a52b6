// The watch (GT_SetWatch and others): chosen values of the axes, sampled at control cycles into two
// banks. A full bank is given to the host as a batch; while both are full, samples are lost.
// Source: GE manual 10.1. Tested by tests/gtcalls/ge/watch_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "gtcalls/ge/limits.h"

namespace oncard::gtcalls {
struct CardView;
}  // namespace oncard::gtcalls

namespace oncard::gtcalls::ge {

/// The values of an axis, in the order of a sample, as the bits of GT_SetWatch.
enum WatchedValue : uint16_t {
  kWatchPrfPos = 1u << 0,
  kWatchAtlPos = 1u << 1,
  kWatchPrfVel = 1u << 2,
  kWatchAtlVel = 1u << 3,
  kWatchVoltage = 1u << 6,
};
inline constexpr WatchedValue kWatchedValues[] = {kWatchPrfPos, kWatchAtlPos, kWatchPrfVel,
                                                  kWatchAtlVel, kWatchVoltage};

/// Assumption: the words of a bank. Positions and velocities take two, a voltage one.
inline constexpr size_t kWatchWords = 8192;

/// What is watched of each axis.
using WatchConfig = std::array<uint16_t, kAxisMax>;

/// The words and the values of one sample.
size_t WordsOf(const WatchConfig& config);
size_t ValuesOf(const WatchConfig& config);

struct Watch {
  WatchConfig config{};
  uint16_t size = 0;     ///< samples of a batch; 0: not set up
  bool started = false;  ///< since it was set up
  bool running = false;
  uint16_t interval = 0;        ///< cycles left out between two samples
  uint16_t left_out = 0;        ///< still to be left out
  std::vector<double> samples;  ///< at most two batches, the older one first

  /// Ends what runs.
  void SetUp(const WatchConfig& chosen, uint16_t batch);
  /// Begins anew; to be called after SetUp(). The first sample is that of the next cycle.
  void Start(uint16_t cycles_between);
  void Stop() { running = false; }
  /// One control cycle.
  void Advance(const CardView& card);
  /// The values of the oldest full batch, sample by sample; empty if there is none.
  std::span<const double> Batch() const;
  /// Frees it.
  void DropBatch();

  auto Fields() const {
    return std::tie(config, size, started, running, interval, left_out, samples);
  }

 private:
  size_t BatchValues() const { return size * ValuesOf(config); }
};

}  // namespace oncard::gtcalls::ge
