#include "gtcalls/ge/watch.h"

#include "gtcalls/card.h"
#include "motion/common/rounding.h"
#include "motion/common/state_hash.h"

namespace oncard::gtcalls::ge {
namespace {

static_assert(motion::kFieldsComplete<Watch>);

double ValueOf(const motion::MotionCore& core, size_t axis, WatchedValue value) {
  switch (value) {
    case kWatchPrfPos:
      return motion::Whole(core.profile(axis).now.position);
    case kWatchAtlPos:
      return core.encoder(axis).position;
    case kWatchPrfVel:
      return core.profile(axis).now.velocity;
    case kWatchAtlVel:
      return core.encoder(axis).velocity;
    case kWatchVoltage:
      break;
  }
  return core.state().dacs[axis].Output();
}

}  // namespace

size_t WordsOf(const WatchConfig& config) {
  size_t words = 0;
  for (const uint16_t chosen : config) {
    for (const WatchedValue value : kWatchedValues) {
      if ((chosen & value) != 0) words += value == kWatchVoltage ? 1 : 2;
    }
  }
  return words;
}

size_t ValuesOf(const WatchConfig& config) {
  size_t values = 0;
  for (const uint16_t chosen : config) {
    for (const WatchedValue value : kWatchedValues) values += (chosen & value) != 0 ? 1u : 0u;
  }
  return values;
}

void Watch::SetUp(const WatchConfig& chosen, uint16_t batch) {
  *this = {};
  config = chosen;
  size = batch;
}

void Watch::Start(uint16_t cycles_between) {
  started = true;
  running = true;
  interval = cycles_between;
  left_out = 0;
  samples.clear();
  // Reserved here, so that a cycle does not allocate.
  samples.reserve(2 * BatchValues());
}

void Watch::Advance(const CardView& card) {
  if (!running) return;
  if (left_out > 0) {
    --left_out;
    return;
  }
  left_out = interval;
  if (samples.size() == 2 * BatchValues()) return;
  for (size_t axis = 0; axis < config.size(); ++axis) {
    for (const WatchedValue value : kWatchedValues) {
      if ((config[axis] & value) != 0) samples.push_back(ValueOf(card.motion, axis, value));
    }
  }
}

std::span<const double> Watch::Batch() const {
  const size_t values = BatchValues();
  return std::span(samples).first(samples.size() >= values ? values : 0);
}

void Watch::DropBatch() {
  samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(BatchValues()));
}

}  // namespace oncard::gtcalls::ge
