// A card with a bus for command tests.
#pragma once

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/bus/bus_card.h"

namespace oncard::gtcalls::gts {

/// A drive whose process data contain every object that a command uses.
inline motion::bus::Slave CompleteDrive(int axis) {
  motion::bus::Slave drive = motion::bus::FullDrive(axis);
  drive.outputs.push_back({0x60FE, 1, 32});
  const motion::bus::PdoEntry more[] = {{0x60BC, 0, 32}, {0x60BD, 0, 32}, {0x60FD, 0, 32},
                                        {0x6077, 0, 16}, {0x6078, 0, 16}, {0x20F2, 0, 16},
                                        {0x20F9, 0, 16}};
  drive.inputs.insert(drive.inputs.end(), std::begin(more), std::end(more));
  return drive;
}

class BusCommandCard : public CommandTestCard {
 public:
  using Slaves = motion::bus::Slaves;

  explicit BusCommandCard(Slaves slaves, motion::WorldEvents events = {},
                          const motion::MotionConfig& config = {})
      : CommandTestCard(config) {
    auto shared = std::make_shared<const Slaves>(std::move(slaves));
    motion.ConnectBus(shared, shared);
    motion.PowerOn(std::make_shared<const motion::WorldEvents>(std::move(events)));
  }

  /// The start-up of the manual's example 5-5.
  void Up() {
    Expect(0, "GT_InitEcatComm");
    while (Read("GT_IsEcatReady") == 0) Cycle();
    Expect(0, "GT_StartEcatComm");
  }
  /// The same, with axis 1 enabled.
  void Enable() {
    Up();
    Expect(0, "GT_AxisOn", {1});
    Cycles(8);
    Expect(0, "GT_ClrSts", {1, 1});
  }
  /// The output of a command with no other argument, or behind those.
  double Read(std::string_view name, std::vector<Argument> arguments = {}) {
    std::vector<double> cell(1);
    arguments.emplace_back(&cell);
    EXPECT_EQ(Call(name, arguments), 0) << name << ": " << reason.en;
    return cell[0];
  }
  uint32_t Status(int axis = 1) { return card.view().StatusWord(static_cast<size_t>(axis - 1)); }
  motion::bus::Bus& bus() { return *motion.bus_line(); }
  double motor(size_t axis = 0) { return motion.state().plants[axis].position; }
};

}  // namespace oncard::gtcalls::gts
