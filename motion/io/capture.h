// Position capture: an edge of an input or an index pulse latches an encoder's position.
//
// Each encoder has a capture (GT_SetCaptureMode) and each number a trigger (GT_SetTrigger); they
// are independent. Captures see the pins directly, without filter and sense. An edge latches the
// position at the exact instant of the edge, also between two cycles, whether it is caused by the
// moving mechanics, by a scheduled event, or by the card's own high-speed outputs (compare.h).
//
// Assumptions: the probe is general input 1 (EXI0, as in the GE manual); HSIO0 and HSIO1 are the
// outputs of position compare (a public sample captures the pulse that compare puts out); an index
// pulse has no sense; the status is 1 from the first of several captures on; after the last offset
// of a list, nothing is added. Source: public header and samples; GE manual (probe). Tested by
// tests/gtcalls/capture_command_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "motion/common/sizes.h"
#include "motion/io/digital_io.h"

namespace oncard::motion {

enum class CaptureSource : uint8_t {
  kNone,
  kHome,
  kIndex,
  kProbe,
  kHsio0,
  kHsio1,
  kHomeGpi,  ///< the home input or the general input of the same number
};

inline constexpr int kProbeInput = 0;

/// True if edges of the input can trigger a source; `index`, from 0, numbers the home input.
bool SourceListens(CaptureSource source, size_t index, DiType type, int bit);

struct Capture {
  // Registers.
  CaptureSource source = CaptureSource::kNone;
  uint16_t rising = 0;  ///< bit n: the sense of the nth CaptureSource is the rising edge
  uint16_t repeat = 1;  ///< positions to capture in a row
  uint8_t encoder = 0;  ///< the encoder whose position is latched
  std::vector<int32_t> offsets;
  int32_t loop = 1;           ///< how often the list of offsets is used; 0: endlessly
  uint8_t offset_source = 0;  ///< the encoder whose list of offsets is used

  // State.
  bool armed = false;
  bool captured = false;
  double value = 0;               ///< the last captured position with its offset
  double raw = 0;                 ///< the same without it
  std::vector<double> positions;  ///< those captured in a row
  uint32_t offsets_used = 0;      ///< in the present loop
  int32_t loops_done = 0;

  /// The sense of the present source, and that of any.
  bool Rising() const { return RisesOf(source); }
  bool RisesOf(CaptureSource of) const { return (rising & BitOf(of)) != 0; }
  /// Sets the sense of a source, which need not be the present one.
  void SetRising(CaptureSource of, bool edge_rises);

  auto Fields(auto visit) const {
    return visit(source, rising, repeat, encoder, offsets, loop, offset_source, armed, captured,
                 value, raw, positions, offsets_used, loops_done);
  }

 private:
  static uint16_t BitOf(CaptureSource of) {
    return static_cast<uint16_t>(1u << static_cast<unsigned>(of));
  }
};

/// TTrigger and TTriggerStatus.
struct Trigger {
  uint8_t encoder = 0;
  CaptureSource source = CaptureSource::kNone;
  uint8_t input = 0;  ///< number of the home input or index pulse, from 0
  bool rising = false;
  int16_t offset = 0;
  uint32_t loop = 0;  ///< captures until it is complete; 0 counts as 1
  bool window_only = false;
  int32_t first = 0;
  int32_t last = 0;

  bool armed = false;
  bool done = false;
  uint32_t count = 0;
  double position = 0;

  auto Fields(auto visit) const {
    return visit(encoder, source, input, rising, offset, loop, window_only, first, last, armed,
                 done, count, position);
  }
};

class CaptureUnit {
 public:
  CaptureUnit() { Reset(); }
  void Reset();

  const Capture& capture(size_t index) const { return captures_[index]; }
  const Trigger& trigger(size_t index) const { return triggers_[index]; }

  /// Sets the sense of a source, which need not be the present one.
  void SetSense(size_t index, CaptureSource source, bool rising) {
    captures_[index].SetRising(source, rising);
  }
  /// Chooses the encoder whose position a disarmed capture latches.
  void SetEncoder(size_t index, size_t encoder) {
    captures_[index].encoder = static_cast<uint8_t>(encoder);
  }
  /// Arms a capture; earlier captured positions are discarded.
  void Arm(size_t index, CaptureSource source);
  void Disarm(size_t index) { captures_[index].armed = false; }
  /// Sets how many positions are captured in a row; an armed capture that already has as many is
  /// complete.
  void SetRepeat(size_t index, uint16_t repeat);
  /// Discards the captured positions.
  void Clear(size_t index);
  /// Sets the list of offsets; its use starts from the first one.
  void SetOffsets(size_t index, std::vector<int32_t> offsets, int32_t loop);
  void LinkOffsets(size_t index, size_t source);
  /// Arms a trigger with its registers.
  void SetTrigger(size_t index, const Trigger& registers);
  void ClearTrigger(size_t index);

  /// True if something may be armed.
  bool armed() const { return armed_; }
  /// Checks whether something is still armed; called once per tick.
  void CountArmed();
  /// True if something waits for the index pulses of an encoder.
  bool WaitsForIndex(size_t motor) const;

  /// An edge of a pin; `position(encoder)` gives an encoder's position at that instant.
  template <typename Position>
  void Edge(DiType type, int bit, bool rising, Position position) {
    for (size_t i = 0; i < kAxisMax; ++i) {
      const Capture& c = captures_[i];
      if (c.armed && c.Rising() == rising && SourceListens(c.source, i, type, bit)) {
        Take(i, position(c.encoder));
      }
      const Trigger& t = triggers_[i];
      if (t.armed && t.rising == rising && SourceListens(t.source, t.input, type, bit)) {
        TakeTrigger(i, position(t.encoder));
      }
    }
  }
  /// An index pulse of an encoder.
  template <typename Position>
  void Index(size_t motor, Position position) {
    for (size_t i = 0; i < kAxisMax; ++i) {
      const Capture& c = captures_[i];
      if (c.armed && c.source == CaptureSource::kIndex && i == motor) {
        Take(i, position(c.encoder));
      }
      const Trigger& t = triggers_[i];
      if (t.armed && t.source == CaptureSource::kIndex && t.input == motor) {
        TakeTrigger(i, position(t.encoder));
      }
    }
  }
  /// An edge of a high-speed output.
  template <typename Position>
  void OutputEdge(size_t channel, bool rising, Position position) {
    const CaptureSource source = channel == 0 ? CaptureSource::kHsio0 : CaptureSource::kHsio1;
    for (size_t i = 0; i < kAxisMax; ++i) {
      const Capture& c = captures_[i];
      if (c.armed && c.source == source && c.Rising() == rising) Take(i, position(c.encoder));
      const Trigger& t = triggers_[i];
      if (t.armed && t.source == source && t.rising == rising) TakeTrigger(i, position(t.encoder));
    }
  }

  auto Fields(auto visit) const { return visit(captures_, triggers_, armed_); }

 private:
  void Take(size_t index, double position);
  void TakeTrigger(size_t index, double position);
  double NextOffset(size_t index);

  std::array<Capture, kAxisMax> captures_;
  std::array<Trigger, kAxisMax> triggers_;
  bool armed_ = false;
};

}  // namespace oncard::motion
