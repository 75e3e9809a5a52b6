// Digital inputs and outputs. Source: GTS manual chapters 4 and 9 for words and senses, the
// vendor's configuration files for the filter time, its public header for the timed outputs.
// Tested by tests/motion/digital_io_test.cc.
#include "motion/io/digital_io.h"

#include <algorithm>
#include <bit>

namespace oncard::motion {
namespace {

constexpr int kMpgWidth = 7;
constexpr int kGeneralIoWidth = 16;

constexpr std::array<int, kDiTypeCount> kDiWidths = {kAxisIoWidth, kAxisIoWidth,    kAxisIoWidth,
                                                     kAxisIoWidth, kGeneralIoWidth, kAxisIoWidth,
                                                     kMpgWidth};
constexpr std::array<int, kDoTypeCount> kDoWidths = {kAxisIoWidth, kAxisIoWidth, kGeneralIoWidth};

constexpr uint32_t BitMask(int bit) { return uint32_t{1} << bit; }
constexpr uint32_t WidthMask(int width) { return BitMask(width) - 1; }

constexpr uint32_t WithBit(uint32_t word, int bit, bool level) {
  return level ? word | BitMask(bit) : word & ~BitMask(bit);
}

/// An undriven pin has the level that reads 0: low, or high if the sense is inverted.
uint32_t PinLevels(const DiWord& word) {
  return (word.pins & word.driven) | (word.inverted & ~word.driven);
}

}  // namespace

int DiWidth(DiType type) { return kDiWidths[static_cast<size_t>(type)]; }

int DoWidth(DoType type) { return kDoWidths[static_cast<size_t>(type)]; }

DigitalIo::DigitalIo() { Reset(); }

void DigitalIo::SetPin(DiType type, int bit, bool level) {
  DiWord& word = At(type);
  word.driven |= BitMask(bit);
  word.pins = WithBit(word.pins, bit, level);
}

uint32_t DigitalIo::Pins(DiType type) const { return PinLevels(At(type)); }

void DigitalIo::SetInverted(DiType type, uint32_t mask) {
  DiWord& word = At(type);
  word.inverted = mask & WidthMask(DiWidth(type));
  // The level of an undriven pin follows its sense without the filter, because no signal has
  // changed.
  word.levels = (word.levels & word.driven) | (word.inverted & ~word.driven);
}

void DigitalIo::SetFilterTicks(DiType type, int bit, uint16_t ticks) {
  At(type).filter_ticks[static_cast<size_t>(bit)] = ticks;
}

uint32_t DigitalIo::Edges(DiType type, int bit) const {
  return At(type).edges[static_cast<size_t>(bit)];
}

void DigitalIo::SetEdges(DiType type, int bit, uint32_t count) {
  At(type).edges[static_cast<size_t>(bit)] = count;
}

uint32_t DigitalIo::OutputPins(DoType type) const {
  const DoWord& word = At(type);
  return (word.value ^ word.inverted) & word.active;
}

void DigitalIo::SetOutputInverted(DoType type, uint32_t mask) {
  At(type).inverted = mask & WidthMask(DoWidth(type));
}

void DigitalIo::Write(DoType type, uint32_t mask, uint32_t value) {
  DoWord& word = At(type);
  mask &= WidthMask(DoWidth(type));
  word.value = (word.value & ~mask) | (value & mask);
  for (uint32_t ended = mask & word.timed; ended != 0; ended &= ended - 1) {
    StopTiming(type, std::countr_zero(ended));
  }
}

void DigitalIo::WriteForAWhile(DoType type, int bit, bool level, int64_t delay_us) {
  Write(type, BitMask(bit), WithBit(0, bit, level));
  if (delay_us <= 0) return;
  SetTiming(type, bit, {.flips_left = 1, .phase_us = delay_us});
}

void DigitalIo::StartPulses(DoType type, int bit, int64_t high_us, int64_t low_us, int64_t pulses,
                            bool first_level) {
  Write(type, BitMask(bit), WithBit(0, bit, first_level));
  SetTiming(type, bit,
            {.flips_left = pulses == 0 ? kEndlessFlips : 2 * pulses - 1,
             .phase_us = first_level ? high_us : low_us,
             .high_us = high_us,
             .low_us = low_us});
}

void DigitalIo::StopTiming(DoType type, int bit) { SetTiming(type, bit, {}); }

void DigitalIo::SetTiming(DoType type, int bit, const DoTiming& timing) {
  DoWord& word = At(type);
  word.timing[static_cast<size_t>(bit)] = timing;
  word.timed = WithBit(word.timed, bit, timing.flips_left != 0);
}

bool DigitalIo::InputsSettled() const {
  return std::ranges::all_of(
      inputs_, [](const DiWord& word) { return word.held == 0 && PinLevels(word) == word.levels; });
}

bool DigitalIo::HasTimedOutputs() const {
  return std::ranges::any_of(outputs_, [](const DoWord& word) { return word.timed != 0; });
}

void DigitalIo::SampleInputs() {
  for (DiWord& word : inputs_) {
    const uint32_t pins = PinLevels(word);
    if (pins != word.levels || word.held != 0) SampleWord(word, pins);
  }
}

void DigitalIo::SampleWord(DiWord& word, uint32_t pins) {
  const uint32_t differing = pins ^ word.levels;
  for (uint32_t bits = differing | word.held; bits != 0; bits &= bits - 1) {
    const int number = std::countr_zero(bits);
    const auto bit = static_cast<size_t>(number);
    if ((differing >> bit & 1) == 0) {
      word.held_ticks[bit] = 0;
    } else if (++word.held_ticks[bit] >= word.filter_ticks[bit]) {
      word.held_ticks[bit] = 0;
      word.levels ^= BitMask(number);
      ++word.edges[bit];
    }
    word.held = WithBit(word.held, number, word.held_ticks[bit] != 0);
  }
}

void DigitalIo::AdvanceOutputs(int64_t microseconds) {
  for (DoWord& word : outputs_) {
    for (uint32_t bits = word.timed; bits != 0; bits &= bits - 1) {
      const int number = std::countr_zero(bits);
      const auto bit = static_cast<size_t>(number);
      DoTiming& timing = word.timing[bit];
      timing.phase_us -= microseconds;
      // A cycle can be longer than a phase; the remainder is carried over, so that pulse trains do
      // not drift.
      while (timing.flips_left != 0 && timing.phase_us <= 0) {
        word.value ^= BitMask(number);
        if (timing.flips_left != kEndlessFlips) --timing.flips_left;
        timing.phase_us += (word.value >> bit & 1) != 0 ? timing.high_us : timing.low_us;
      }
      if (timing.flips_left == 0) {
        timing = {};
        word.timed = WithBit(word.timed, number, false);
      }
    }
  }
}

void DigitalIo::Settle() {
  for (DiWord& word : inputs_) {
    word.levels = PinLevels(word);
    word.held_ticks.fill(0);
    word.held = 0;
  }
}

void DigitalIo::Reset(uint16_t filter_ticks) {
  for (DiWord& word : inputs_) {
    const DiWord before = word;
    word = {};
    word.driven = before.driven;
    word.pins = before.pins;
    word.filter_ticks.fill(filter_ticks);
  }
  outputs_ = {};
  Settle();
}

}  // namespace oncard::motion
