// A card with drives on a bus, for tests.
#pragma once

#include <memory>
#include <utility>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"

namespace oncard::motion::bus {

/// A drive with process data for all that the commands of a card use.
inline Slave FullDrive(int axis) {
  Slave drive = DefaultSlave(SlaveKind::kDrive);
  drive.axis = static_cast<int8_t>(axis);
  drive.outputs = {{0x6040, 0, 16}, {0x607A, 0, 32}, {0x6060, 0, 8},
                   {0x60B8, 0, 16}, {0x60FF, 0, 32}, {0x6071, 0, 16}};
  drive.inputs = {{0x6041, 0, 16}, {0x6064, 0, 32}, {0x6061, 0, 8},  {0x60B9, 0, 16},
                  {0x60BA, 0, 32}, {0x60BB, 0, 32}, {0x60F4, 0, 32}, {0x606C, 0, 32}};
  return drive;
}

class BusCard {
 public:
  explicit BusCard(Slaves slaves, MotionConfig config = {}) : core(config) {
    auto shared = std::make_shared<const Slaves>(std::move(slaves));
    core.ConnectBus(shared, shared);
  }

  /// Events outside the card, in order of time.
  void Power(WorldEvents events = {}) {
    core.PowerOn(std::make_shared<const WorldEvents>(std::move(events)));
  }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) core.Tick();
  }
  /// Communication in OP, and started.
  void Up() {
    bus().Init(core.now());
    while (!bus().ready()) core.Tick();
    bus().Start();
  }
  /// The same, with the drives of all axes enabled.
  void Enable(size_t axes = 1) {
    Up();
    for (size_t i = 0; i < axes; ++i) core.AxisAt(i).ServoOn();
    Ticks(8);
  }
  Bus& bus() { return ChangeState(core).bus->line; }
  BusDrive& drive(size_t slave = 0) { return *bus().slave(slave).drive; }
  int64_t object(ObjectId id, size_t slave = 0) { return drive(slave).values()[id]; }
  Plant& motor(size_t axis = 0) { return ChangeState(core).plants[axis]; }
  Axis& axis(size_t number = 0) { return ChangeState(core).axes[number]; }
  BusAxis& link(size_t axis = 0) { return ChangeState(core).bus->axes[axis]; }
  double encoder(size_t axis = 0) { return core.state().encoders[axis].position; }

  MotionCore core;
};

}  // namespace oncard::motion::bus
