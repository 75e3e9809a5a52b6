// The watch (GT_SetWatch and others): chosen values of the axes, sampled at control cycles. A full
// bank of the recorder is given to the host as a batch. Source: GE manual 10.1. Tested by
// tests/gtcalls/ge/watch_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gtcalls/ge/limits.h"
#include "motion/common/recorder.h"

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

/// The samples that the next GT_GetWatch gives to the host (Family::array_elements).
size_t SamplesForHost(const CardView& card);

struct Watch {
  WatchConfig config{};
  uint16_t size = 0;     ///< samples of a batch
  bool started = false;  ///< since it was set up
  motion::Recorder batches;

  /// Ends what runs. Nothing is set up if nothing is chosen.
  void SetUp(const WatchConfig& chosen, uint16_t batch);
  /// Begins anew, leaving cycles out between two samples; to be called after SetUp().
  void Start(uint16_t left_out);
  /// One control cycle.
  void Advance(const CardView& card);

  auto Fields(auto visit) const { return visit(config, size, started, batches); }
};

}  // namespace oncard::gtcalls::ge
