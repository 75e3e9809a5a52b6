// The body of a card (CardBody) in parts: its clock, its inputs and outputs, each axis, the events
// outside that are still to come, and the rest. Bodies of cards with the same events are equal, as
// BodyHash() compares them, exactly if all their parts are. Who has many bodies keeps each part
// once: those of independent axes are few.
//
// Plain functions of values. Tested by tests/runtime/body_parts_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <variant>

#include "motion/common/state_hash.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

class BodyDivision {
 public:
  // The numbers of the parts.
  static constexpr size_t kClock = 0;  ///< cycles, and what is pending of the next one
  static constexpr size_t kIo = 1;     ///< digital and analogue inputs and outputs
  static constexpr size_t kRest = 2;
  static constexpr size_t kWorld = 3;  ///< events that are still to come
  static constexpr size_t kFirstAxis = 4;

  /// One part of a body as a value of its own.
  class Part;

  /// For cards with so many axes.
  explicit BodyDivision(size_t axis_count) : axis_count_(axis_count) {}

  size_t axis_count() const { return axis_count_; }
  size_t part_count() const { return kFirstAxis + axis_count_; }
  /// Adds the values of a part: those of equal parts are equal.
  void AddValues(const CardBody& body, size_t part, motion::StateWords* words) const;
  Part PartOf(const CardBody& body, size_t part) const;
  /// Makes the part of the body equal to a part with this number. As many events of the body are
  /// then to come as of the part: they have to be the same.
  void Put(const Part& value, size_t part, CardBody* body) const;
  /// True if nothing in the part lets an axis of the card depend on another: no master, no path, no
  /// gantry, no bus, no mapping but that of an axis to its own profile, encoder and controller.
  bool LeavesAxesApart(const CardBody& body, size_t part) const;

 private:
  size_t axis_count_;
};

class BodyDivision::Part {
 private:
  friend BodyDivision;
  struct Clock {
    int64_t cycle;
    int64_t clock_cycle;
    int64_t pending_ns;
    int64_t pending_statements;
  };
  struct Io {
    motion::DigitalIo digital;
    std::array<motion::Adc, motion::kAdcCount> adcs;
    std::array<motion::ExtensionModule, motion::kModuleCount> modules;
  };
  struct World {
    uint64_t left;  ///< the number of events
  };
  /// The elements of AxisArrays().
  struct Axis {
    motion::Profile profile;
    motion::Axis axis;
    motion::Compensation compensation;
    motion::Encoder encoder;
    motion::EncoderFault encoder_fault;
    motion::Drive drive;
    motion::Plant plant;
    motion::Step step;
    motion::Control control;
    motion::Dac dac;
    motion::IndexMarks marks;
    motion::Homing homing;

    auto Elements() {
      return std::tie(profile, axis, compensation, encoder, encoder_fault, drive, plant, step,
                      control, dac, marks, homing);
    }
    auto Elements() const {
      return std::tie(profile, axis, compensation, encoder, encoder_fault, drive, plant, step,
                      control, dac, marks, homing);
    }
  };
  /// Of the whole body, only the rest matters.
  using Rest = std::unique_ptr<const CardBody>;

  using Value = std::variant<Clock, Io, World, Axis, Rest>;
  explicit Part(Value value) : value_(std::move(value)) {}

  Value value_;
};

}  // namespace oncard::runtime
