// Time, digital inputs and outputs, user variables.
// Tested by tests/motion/motion_core_test.cc.
#include "motion/motion_core.h"

#include "motion/state_hash.h"

namespace oncard::motion {
namespace {

/// GT_GetClockHighPrecision counts in steps of this many microseconds (two servo sub-steps of a
/// 250 us profile cycle).
constexpr int64_t kFineClockUs = 125;

void AddIo(const DigitalIo& io, StateHash* hash) {
  for (const DiWord& word : io.inputs()) {
    hash->Add(word.driven).Add(word.pins).Add(word.inverted).Add(word.levels);
    for (size_t bit = 0; bit < kIoWidthMax; ++bit) {
      hash->Add(word.filter_ticks[bit]).Add(word.held_ticks[bit]).Add(word.edges[bit]);
    }
  }
  for (const DoWord& word : io.outputs()) {
    hash->Add(word.value).Add(word.inverted);
    for (const DoTiming& timing : word.timing) {
      hash->Add(timing.flips_left).Add(timing.phase_us).Add(timing.high_us).Add(timing.low_us);
    }
  }
}

}  // namespace

MotionCore::MotionCore(const MotionConfig& config) : config_(config) {}

void MotionCore::Tick() {
  state_.io.SampleInputs();
  state_.io.AdvanceOutputs(config_.cycle_us);
  ++state_.cycle;
  ++state_.clock_cycle;
}

void MotionCore::Reset() {
  state_.clock_cycle = 0;
  state_.io.Reset();
  state_.long_vars.fill(0);
  state_.double_vars.fill(0);
}

int64_t MotionCore::ClockMs() const { return state_.clock_cycle * config_.cycle_us / 1000; }

int64_t MotionCore::Clock125us() const {
  return state_.clock_cycle * config_.cycle_us / kFineClockUs;
}

uint64_t MotionCore::Hash() const {
  StateHash hash;
  hash.Add(state_.cycle).Add(state_.clock_cycle);
  AddIo(state_.io, &hash);
  for (int32_t value : state_.long_vars) hash.Add(value);
  for (double value : state_.double_vars) hash.Add(value);
  return hash.value();
}

}  // namespace oncard::motion
