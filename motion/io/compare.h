// Position compare: pulses or level changes at the high-speed outputs (HSIO0, HSIO1) when encoders
// reach listed positions.
//
// There are two modules. Each processes a list of points in order; points are relative to the
// positions of the encoders at the start. The instant of a hit is computed on the straight line
// between two ticks, and one tick can have several hits. A point is hit when both coordinates are
// within the tolerance, at the position on the line that is nearest to the point. One-dimensional
// compare uses only Y. A point can represent a series of points at equal distances. A log of
// limited length keeps all hits; every edge of the outputs in the last tick is kept. Source:
// application notes on 2-D compare; public header. Tested by tests/gtcalls/compare_command_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "motion/common/sizes.h"

namespace oncard::motion {

inline constexpr size_t kHsioCount = 2;
/// Capacity in points of the hardware's FIFO, and of the card's queue behind it (assumption).
inline constexpr size_t kCompareFifoSize = 512;
inline constexpr size_t kCompareBufferSize = 4096;
/// Capacity of the log; later hits are only counted.
inline constexpr size_t kCompareLogSize = 4096;

/// Maximum number of output edges kept for one tick; later ones reach no capture and no trace.
inline constexpr size_t kHsioEdgesMax = 4096;

/// A high-speed output. A pulse inverts its level for a while.
struct HsioOutput {
  bool level = false;
  double pulse_end = 0;  ///< us since power-on; 0: no pulse
  bool shown = false;    ///< the level after its last edge

  bool Level(double instant) const { return level != (instant < pulse_end); }
  bool Level(Micros now) const { return Level(static_cast<double>(now)); }
  /// A pulse is to end, or a command's level has to be shown.
  bool changes() const { return pulse_end > 0 || level != shown; }

  auto Fields(auto visit) const { return visit(level, pulse_end, shown); }
};

/// A change of an output's level.
struct HsioEdge {
  uint8_t channel = 0;
  bool level = false;  ///< from now on
  double instant = 0;  ///< us since power-on

  auto Fields(auto visit) const { return visit(channel, level, instant); }
};

struct ComparePoint {
  int32_t x = 0;
  int32_t y = 0;

  auto Fields(auto visit) const { return visit(x, y); }
  bool operator==(const ComparePoint&) const = default;
};

/// One hit of a module: position and time.
struct CompareHit {
  uint8_t channel = 0;
  double instant = 0;  ///< us since power-on
  double x = 0;        ///< whole pulses of the encoders
  double y = 0;

  auto Fields(auto visit) const { return visit(channel, instant, x, y); }
};

/// T2DComparePrm, and the mode.
struct CompareParameters {
  bool two_dimensional = false;
  uint8_t x = 0;  ///< encoders, from 0
  uint8_t y = 0;
  int16_t source = 0;  ///< 0: pulse counter, 1: encoder
  bool level_output = false;
  bool start_level = false;
  int16_t time = 1;  ///< of a pulse, us
  int16_t max_error = 0;

  auto Fields(auto visit) const {
    return visit(two_dimensional, x, y, source, level_output, start_level, time, max_error);
  }
  bool operator==(const CompareParameters&) const = default;
};

struct CompareModule {
  CompareParameters parameters;
  std::vector<ComparePoint> points;
  uint32_t next = 0;     ///< the next point
  int32_t repeats = 0;   ///< how often the point is repeated after its hit, each time ...
  int32_t interval = 0;  ///< ... this number of pulses further along Y
  bool running = false;
  double origin_x = 0;
  double origin_y = 0;
  int32_t hits = 0;

  size_t waiting() const { return points.size() - next; }
  auto Fields(auto visit) const {
    return visit(parameters, points, next, repeats, interval, running, origin_x, origin_y, hits);
  }
};

/// The movement of all encoders in a tick, with fractions of pulses.
struct EncoderWay {
  std::array<double, kAxisMax> from{};
  std::array<double, kAxisMax> to{};
};

/// Where on the line from (x0, y0) to (x1, y1) a point is hit: a fraction in [`begin`, 1], or -1,
/// also if the end of the line is still approaching the point. `max_error` is in whole pulses;
/// without `use_x` only Y is compared.
double FindHit(double x0, double y0, double x1, double y1, bool use_x, ComparePoint point,
               int max_error, double begin);

class CompareUnit {
 public:
  const CompareModule& module(size_t channel) const { return modules_[channel]; }
  const HsioOutput& output(size_t channel) const { return outputs_[channel]; }
  const std::vector<CompareHit>& log() const { return log_; }
  /// The output edges of the last tick; those of one output are in order of time.
  const std::vector<HsioEdge>& edges() const { return edges_; }

  /// GT_Reset: no points, both outputs low.
  void Reset();

  /// Of a module that does not run; its points stay.
  void SetParameters(size_t channel, const CompareParameters& parameters) {
    modules_[channel].parameters = parameters;
  }
  void ClearHits(size_t channel) { modules_[channel].hits = 0; }
  /// A single pulse, or a level.
  void Pulse(size_t channel, Micros now, int16_t time_us);
  void SetLevel(size_t channel, bool level);
  /// Appends points; completed points free their space.
  void Append(size_t channel, const std::vector<ComparePoint>& points);
  /// Replaces all points by one along Y that is repeated `repeats` times at an `interval`.
  void Repeat(size_t channel, int32_t first, int32_t repeats, int32_t interval);
  /// Starts with the encoders at (x, y).
  void Start(size_t channel, double x, double y);
  void Stop(size_t channel);
  /// Removes all points.
  void Clear(size_t channel);

  bool running() const { return modules_[0].running || modules_[1].running; }
  /// True if the next tick has work: points are pending, or an output changes.
  bool active() const {
    return running() || !edges_.empty() || outputs_[0].changes() || outputs_[1].changes();
  }
  /// Processes a tick that begins at `begin`.
  void Advance(Micros begin, Micros length, const EncoderWay& way);

  auto Fields(auto visit) const { return visit(modules_, outputs_, log_, edges_); }

 private:
  void AdvanceModule(size_t channel, Micros begin, Micros length, const EncoderWay& way);
  void Fire(size_t channel, const CompareHit& hit);
  /// Ends a pulse whose time is over at `instant`.
  void EndPulse(size_t channel, double instant);
  /// Records an edge if the level at `instant` differs from the one before.
  void Show(size_t channel, double instant);

  std::array<CompareModule, kHsioCount> modules_;
  std::array<HsioOutput, kHsioCount> outputs_;
  std::vector<CompareHit> log_;
  std::vector<HsioEdge> edges_;
};

}  // namespace oncard::motion
