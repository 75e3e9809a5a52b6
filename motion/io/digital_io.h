// The card's digital inputs and outputs as one plain value: pins, senses, filters, edge counters,
// output registers, timed reversals and pulse trains.
//
// An input goes from its pin through a filter (a new level is accepted after it has been sampled at
// a number of ticks in a row) and through its sense (inverted or not) to what GT_GetDi reads. Edges
// are counted after the filter and before the sense, so that a change of the sense counts no edge.
// A pin that has never been driven from outside has the level that reads 0, whatever its sense.
//
// Bits are numbered from 0 here (the commands number inputs and outputs from 1) and must be below
// the word's width.
// Tested by tests/motion/digital_io_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/common/card_defaults.h"

namespace oncard::motion {

/// Input words.
enum class DiType : uint8_t { kLimitPositive, kLimitNegative, kAlarm, kHome, kGpi, kArrive, kMpg };
inline constexpr int kDiTypeCount = 7;

/// Output words.
enum class DoType : uint8_t { kEnable, kClear, kGpo };
inline constexpr int kDoTypeCount = 3;

inline constexpr int kIoWidthMax = 16;
/// Words that belong to axes have one bit per axis of an 8-axis card.
/// Assumption: on 12-axis cards too, since GT_LmtSns has two bits per axis in 16.
inline constexpr int kAxisIoWidth = 8;

/// How many inputs or outputs a word has.
int DiWidth(DiType type);
int DoWidth(DoType type);

/// One word of inputs. Bit n of each mask belongs to input n.
struct DiWord {
  uint32_t driven = 0;             ///< the pin is driven from outside
  uint32_t pins = 0;               ///< level of the driven pins
  uint32_t inverted = 0;           ///< sense: 1 = low level reads 1
  uint32_t active = ~uint32_t{0};  ///< configuration: active inputs; all others read 0
  uint32_t levels = 0;             ///< pin levels after the filter
  std::array<uint16_t, kIoWidthMax>
      filter_ticks{};  ///< ticks that a new level must last; 0 acts as 1
  std::array<uint16_t, kIoWidthMax> held_ticks{};  ///< ticks the pin has differed from `levels`
  uint32_t held = 0;                               ///< bits whose held_ticks is not 0
  std::array<uint32_t, kIoWidthMax> edges{};       ///< changes of `levels`, modulo 2^32

  auto Fields(auto visit) const {
    return visit(driven, pins, inverted, active, levels, filter_ticks, held_ticks, held, edges);
  }
};

/// A timed reversal or a pulse train of one output: the output changes its level at the end of each
/// phase.
struct DoTiming {
  int64_t flips_left = 0;  ///< 0: none; kEndlessFlips: until stopped
  int64_t phase_us = 0;    ///< time left until the next flip
  int64_t high_us = 0;     ///< length of a high phase
  int64_t low_us = 0;      ///< length of a low phase

  auto Fields(auto visit) const { return visit(flips_left, phase_us, high_us, low_us); }
};
inline constexpr int64_t kEndlessFlips = -1;

/// One word of outputs.
struct DoWord {
  uint32_t value = 0;     ///< the register that GT_GetDo reads
  uint32_t inverted = 0;  ///< `reverse` of the configuration: the pin carries the complement
  uint32_t active =
      ~uint32_t{0};    ///< configuration: active outputs; the pins of all others stay low
  uint32_t timed = 0;  ///< bits with a running reversal or pulse train
  std::array<DoTiming, kIoWidthMax> timing{};

  auto Fields(auto visit) const { return visit(value, inverted, active, timed, timing); }
};

/// All digital inputs and outputs. Plain data: copy it to keep it.
class DigitalIo {
 public:
  DigitalIo();

  // --- Inputs ----------------------------------------------------------------------------------

  /// Drives a pin from outside; the level takes effect after the filter.
  void SetPin(DiType type, int bit, bool level);
  /// The levels of the pins; a pin that is not driven has the level that reads 0.
  uint32_t Pins(DiType type) const;
  /// True if the pin is driven from outside.
  bool Driven(DiType type, int bit) const { return (At(type).driven >> bit & 1) != 0; }
  /// True if SampleInputs() changes nothing as long as the pins keep their levels.
  bool InputsSettled() const;
  /// Filtered levels with the senses applied: what GT_GetDi reads.
  uint32_t Read(DiType type) const {
    return (At(type).levels ^ At(type).inverted) & At(type).active;
  }
  /// True if an input of any word reads 1.
  bool AnyActive() const {
    uint32_t any = 0;
    for (const DiWord& word : inputs_) any |= (word.levels ^ word.inverted) & word.active;
    return any != 0;
  }
  /// Sets the senses of a whole word; takes effect at once.
  void SetInverted(DiType type, uint32_t mask);
  uint32_t inverted(DiType type) const { return At(type).inverted; }
  /// Inputs that are switched off in the configuration read 0.
  void SetInputsActive(DiType type, uint32_t mask) { At(type).active = mask; }
  /// Ticks that a new level must last; with 0 and 1 it is accepted at the first tick.
  void SetFilterTicks(DiType type, int bit, uint16_t ticks);
  /// Changes of the filtered level since reset or since the counter was set.
  uint32_t Edges(DiType type, int bit) const;
  void SetEdges(DiType type, int bit, uint32_t count);

  // --- Outputs. The last command that writes a bit ends its reversal or pulse train ------------

  /// The register that GT_GetDo reads.
  uint32_t Register(DoType type) const { return At(type).value; }
  /// Levels at the terminals: the register with the configured reversal.
  uint32_t OutputPins(DoType type) const;
  void SetOutputInverted(DoType type, uint32_t mask);
  /// The pins of outputs that are switched off in the configuration stay low.
  void SetOutputsActive(DoType type, uint32_t mask) { At(type).active = mask; }
  /// Writes the bits of `mask`.
  void Write(DoType type, uint32_t mask, uint32_t value);
  /// Writes a bit and inverts it after `delay_us`; 0: never.
  void WriteForAWhile(DoType type, int bit, bool level, int64_t delay_us);
  /// Starts a train of pulses: one high and one low phase each, the first with `first_level`.
  /// Afterwards the bit stays at the level of the last phase. `pulses` 0: endless. Both times are
  /// at least 1 us.
  void StartPulses(DoType type, int bit, int64_t high_us, int64_t low_us, int64_t pulses,
                   bool first_level);
  /// Ends a pulse train or a reversal; the bit keeps its level.
  void StopTiming(DoType type, int bit);

  // --- Time ------------------------------------------------------------------------------------

  /// One tick: samples the inputs and counts their edges.
  void SampleInputs();
  /// True if an output has a reversal or a pulse train.
  bool HasTimedOutputs() const;
  /// Advances the time of reversals and pulse trains.
  void AdvanceOutputs(int64_t microseconds);
  /// Treats the current levels of the pins as established: the filters accept them at once, and no
  /// edge is counted.
  void Settle();
  /// Sets registers, senses, counters and timings to 0, and the ticks of all filters. The pins keep
  /// their levels, and the filters accept them at once.
  void Reset(uint16_t filter_ticks = CardDefaults{}.filter_ticks);

  auto Fields(auto visit) const { return visit(inputs_, outputs_); }

 private:
  DiWord& At(DiType type) { return inputs_[static_cast<size_t>(type)]; }
  /// Starts a timing and replaces the bit's previous one; a timing without level changes ends it.
  void SetTiming(DoType type, int bit, const DoTiming& timing);
  static void SampleWord(DiWord& word, uint32_t pins);
  const DiWord& At(DiType type) const { return inputs_[static_cast<size_t>(type)]; }
  DoWord& At(DoType type) { return outputs_[static_cast<size_t>(type)]; }
  const DoWord& At(DoType type) const { return outputs_[static_cast<size_t>(type)]; }

  std::array<DiWord, kDiTypeCount> inputs_;
  std::array<DoWord, kDoTypeCount> outputs_;
};

}  // namespace oncard::motion
