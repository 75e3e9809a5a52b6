// The EtherCAT bus of a card as a scenario describes it: the slaves that are connected, what their
// terminals show over time, and faults. Docs: docs/scenarios.md. Tested by
// tests/runtime/scenario_bus_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "motion/bus/slaves.h"

namespace oncard::runtime {

/// The only text of process data without entries.
inline constexpr std::string_view kNoEntries = "none";

/// A slave. In the order of the file they are numbered from 0, as commands count them.
struct BusSlaveSetup {
  motion::bus::SlaveKind kind = motion::bus::SlaveKind::kDrive;
  int axis = 0;  ///< of a drive, from 1; 0: none
  /// Process data: `6040`, `7010:1`; empty: those of the kind; kNoEntries alone: none.
  std::vector<std::string> outputs;
  std::vector<std::string> inputs;
  std::optional<int64_t> vendor;  ///< empty: that of the kind
  std::optional<int64_t> product;
  bool absent = false;                  ///< described, but not connected
  std::optional<int64_t> lost_at_us;    ///< from then on it does not answer
  std::optional<int64_t> silent_at_us;  ///< from then on the working counter is wrong
  bool operator==(const BusSlaveSetup&) const = default;
};

/// A terminal of a slave shows a value.
struct BusInputEvent {
  int64_t at_us = 0;
  int slave = 0;       ///< from 0
  std::string object;  ///< `6000:1`, `20F2`, `60FD`, `probe1`, `probe2`
  double value = 0;
  bool operator==(const BusInputEvent&) const = default;
};

struct BusSetup {
  std::vector<BusSlaveSetup> slaves;
  /// What the ENI file describes; empty: the slaves.
  std::vector<BusSlaveSetup> configured;
  std::vector<BusInputEvent> inputs;  ///< in order of time
  /// Why the ENI file of a host cannot be used; empty: it can, or there is none. No key of a
  /// scenario: records of host calls keep it.
  Message eni_error;

  bool operator==(const BusSetup& other) const {
    return slaves == other.slaves && configured == other.configured && inputs == other.inputs &&
           eni_error.en == other.eni_error.en;
  }
};

/// An entry of process data: `index[:subindex[:bits]]`, the index in hexadecimal, or `gap:bits`. An
/// object of a drive has the length of its dictionary, any other 16 bits unless it says otherwise.
Result<motion::bus::PdoEntry> ParsePdoEntry(std::string_view text, motion::bus::SlaveKind kind);
/// The text of an entry that is read back.
std::string FormatPdoEntry(const motion::bus::PdoEntry& entry);

/// The slave of a setup whose texts are valid.
motion::bus::Slave SlaveOf(const BusSlaveSetup& setup);
/// A setup that describes the slave.
BusSlaveSetup SetupOf(const motion::bus::Slave& slave);

/// What an input event sets: a touch probe, or an item of Bus::SetTerminal(); empty if the slave
/// has no such input.
struct BusTerminal {
  bool probe = false;
  uint16_t item = 0;
};
std::optional<BusTerminal> FindTerminal(const motion::bus::Slave& slave, std::string_view object);

}  // namespace oncard::runtime
