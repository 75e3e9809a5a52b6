#include "gtcalls/ge/watch.h"

#include <array>
#include <iterator>
#include <span>

#include "gtcalls/card.h"
#include "gtcalls/ge/ge_state.h"
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

size_t SamplesForHost(const CardView& card) {
  const Watch& watch = card.state<GeState>().watch;
  return watch.batches.FullBank().empty() ? 0 : watch.size;
}

void Watch::SetUp(const WatchConfig& chosen, uint16_t batch) {
  *this = {};
  config = chosen;
  size = batch;
  if (ValuesOf(config) > 0) batches.SetUp(ValuesOf(config), batch);
}

void Watch::Start(uint16_t left_out) {
  started = true;
  batches.Start(left_out);
}

void Watch::Advance(const CardView& card) {
  if (!batches.Due()) return;
  std::array<double, kAxisMax * std::size(kWatchedValues)> row;
  size_t values = 0;
  for (size_t axis = 0; axis < config.size(); ++axis) {
    for (const WatchedValue value : kWatchedValues) {
      if ((config[axis] & value) != 0) row[values++] = ValueOf(card.motion, axis, value);
    }
  }
  batches.Append(std::span(row).first(values));
}

}  // namespace oncard::gtcalls::ge
