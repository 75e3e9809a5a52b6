// Position capture: an edge of an input or an index pulse latches an encoder's position.
//
// Each encoder has a capture (GT_SetCaptureMode) and each number a trigger (GT_SetTrigger); they
// are independent. Captures look at the pins, without filter and sense. An edge that the moving
// machine makes is latched where it happens, whatever the cycle; an edge that the world makes at
// some time is latched at the tick that samples it.
//
// Assumptions: the probe and the high-speed inputs are general inputs 1, 2 and 3 (EXI0 to EXI2; the
// GE manual has the probe on EXI0); an index pulse has no sense; the status is 1 from the first of
// several captures on; a list of offsets that is used up adds nothing more.
// Source: public header; GE manual (probe). Tested by
// tests/gtcalls/capture_command_test.cc.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <tuple>
#include <vector>

#include "motion/digital_io.h"
#include "motion/sizes.h"

namespace oncard::motion {

/// Numbered as CAPTURE_HOME ... CAPTURE_HOME_GPI.
enum class CaptureSource : uint8_t {
  kNone = 0,
  kHome = 1,
  kIndex = 2,
  kProbe = 3,
  kHsio0 = 6,
  kHsio1 = 7,
  kHomeGpi = 8  ///< the home input or the general input of the same number
};
/// The source of a number; kNone when there is none.
CaptureSource CaptureSourceFromNumber(int number);

/// Most positions captured in a row (GT_SetCaptureRepeat).
inline constexpr uint16_t kCaptureRepeatMax = 256;

inline constexpr int kProbeInput = 0;
inline constexpr int kHsio0Input = 1;
inline constexpr int kHsio1Input = 2;

/// True when edges of the input reach a source; `index`, from 0, numbers the home input.
bool SourceListens(CaptureSource source, size_t index, DiType type, int bit);

struct Capture {
  // Registers.
  CaptureSource source = CaptureSource::kNone;
  uint16_t rising = 0;  ///< bit n: the sense of source n is the rising edge
  uint16_t repeat = 1;  ///< positions to capture in a row
  uint8_t encoder = 0;  ///< whose position is latched
  std::vector<int32_t> offsets;
  int32_t loop = 1;           ///< how often the list of offsets is used; 0: without end
  uint8_t offset_source = 0;  ///< whose list of offsets is used

  // State.
  bool armed = false;
  bool captured = false;
  double value = 0;               ///< the last captured position with its offset
  double raw = 0;                 ///< the same without it
  std::vector<double> positions;  ///< those captured in a row
  uint32_t offsets_used = 0;      ///< in the present loop
  int32_t loops_done = 0;

  bool Rising() const { return (rising >> static_cast<unsigned>(source) & 1) != 0; }

  auto Fields() const {
    return std::tie(source, rising, repeat, encoder, offsets, loop, offset_source, armed, captured,
                    value, raw, positions, offsets_used, loops_done);
  }
};

/// TTrigger and TTriggerStatus.
struct Trigger {
  uint8_t encoder = 0;
  CaptureSource source = CaptureSource::kNone;
  uint8_t input = 0;  ///< number of the home input or index pulse, from 0
  bool rising = false;
  int16_t offset = 0;
  uint32_t loop = 0;  ///< captures until it is done; 0 counts as 1
  bool window_only = false;
  int32_t first = 0;
  int32_t last = 0;

  bool armed = false;
  bool done = false;
  uint32_t count = 0;
  double position = 0;

  auto Fields() const {
    return std::tie(encoder, source, input, rising, offset, loop, window_only, first, last, armed,
                    done, count, position);
  }
};

class CaptureUnit {
 public:
  CaptureUnit() { Reset(); }
  void Reset();

  const Capture& capture(size_t index) const { return captures_[index]; }
  Capture& capture(size_t index) { return captures_[index]; }
  const Trigger& trigger(size_t index) const { return triggers_[index]; }

  /// Arms a capture; what it has captured before is forgotten.
  void Arm(size_t index, CaptureSource source, const DigitalIo& io);
  void Disarm(size_t index) { captures_[index].armed = false; }
  /// Forgets what has been captured.
  void Clear(size_t index);
  /// Sets the list of offsets, from the begin.
  void SetOffsets(size_t index, std::vector<int32_t> offsets, int32_t loop);
  void LinkOffsets(size_t index, size_t source);
  /// Arms a trigger with its registers.
  void SetTrigger(size_t index, const Trigger& registers, const DigitalIo& io);
  void ClearTrigger(size_t index);

  /// Something is armed.
  bool armed() const { return armed_; }
  /// Something waits for the index pulses of a machine.
  bool WaitsForIndex(size_t machine) const;

  /// An edge of a pin; `position(encoder)` is an encoder's position there.
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
  /// An index pulse of a machine.
  template <typename Position>
  void Index(size_t machine, Position position) {
    for (size_t i = 0; i < kAxisMax; ++i) {
      const Capture& c = captures_[i];
      if (c.armed && c.source == CaptureSource::kIndex && i == machine) {
        Take(i, position(c.encoder));
      }
      const Trigger& t = triggers_[i];
      if (t.armed && t.source == CaptureSource::kIndex && t.input == machine) {
        TakeTrigger(i, position(t.encoder));
      }
    }
  }
  /// Edges that pins have made since the last look, other than by the moving machine.
  template <typename Position>
  void SampleEdges(const DigitalIo& io, Position position) {
    for (const DiType type : {DiType::kHome, DiType::kGpi}) {
      const uint32_t pins = io.Pins(type);
      uint32_t changed = pins ^ Seen(type);
      for (; changed != 0; changed &= changed - 1) {
        const int bit = std::countr_zero(changed);
        Edge(type, bit, (pins >> bit & 1) != 0, position);
      }
    }
    Look(io);
  }
  /// Takes the pins as they are: what has changed is no edge.
  void Look(const DigitalIo& io);

  auto Fields() const { return std::tie(captures_, triggers_, armed_, home_seen_, gpi_seen_); }

 private:
  uint32_t Seen(DiType type) const { return type == DiType::kHome ? home_seen_ : gpi_seen_; }
  void Take(size_t index, double position);
  void TakeTrigger(size_t index, double position);
  double NextOffset(size_t index);
  void Arming(const DigitalIo& io);
  void CountArmed();

  std::array<Capture, kAxisMax> captures_;
  std::array<Trigger, kAxisMax> triggers_;
  bool armed_ = false;
  uint32_t home_seen_ = 0;
  uint32_t gpi_seen_ = 0;
};

}  // namespace oncard::motion
