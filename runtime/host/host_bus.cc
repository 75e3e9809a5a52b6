#include "runtime/host/host_bus.h"

#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/path_bytes.h"
#include "runtime/host/eni_file.h"

namespace oncard::runtime {

namespace {

using motion::bus::Slaves;

/// The axes of the drives that a file describes; false if the card has too few.
bool NumberAxes(const std::vector<BusSlaveSetup>& connected, int axis_count,
                std::vector<BusSlaveSetup>* configured) {
  std::set<int> taken;
  std::vector<BusSlaveSetup*> others;
  for (size_t i = 0; i < configured->size(); ++i) {
    BusSlaveSetup& slave = (*configured)[i];
    if (slave.kind != motion::bus::SlaveKind::kDrive) continue;
    slave.axis = i < connected.size() ? connected[i].axis : 0;
    if (slave.axis > 0) {
      taken.insert(slave.axis);
    } else {
      others.push_back(&slave);
    }
  }
  for (BusSlaveSetup* slave : others) {
    slave->axis = 1;
    while (taken.contains(slave->axis)) ++slave->axis;
    taken.insert(slave->axis);
  }
  return taken.empty() || *taken.rbegin() <= axis_count;
}

}  // namespace

void TakeEni(const std::string& folder, Scenario* scenario) {
  const std::string path = FileNameOf(PathOf(folder) / kEniName);
  if (folder.empty() || !FileExists(path)) return;
  BusSetup& bus = scenario->bus;
  const auto text = ReadFile(path, kEniKind);
  const Result<Slaves> described = text.ok() ? ParseEni(text.value(), path) : text.error();
  if (!described.ok()) {
    bus.eni_error = described.error().message;
    return;
  }
  std::vector<BusSlaveSetup> configured;
  for (const motion::bus::Slave& slave : described.value()) configured.push_back(SetupOf(slave));
  if (!NumberAxes(bus.slaves, scenario->axis_count, &configured)) {
    bus.eni_error = MakeMessage(
        "{0} describes more drives than the card has axes, {1}: choose "
        "another card or more axes in the scenario",
        "{0} 描述的驱动器多于卡的轴数 {1}：请在场景中选择其它卡或更多轴", path,
        scenario->axis_count);
    return;
  }
  bus.configured = std::move(configured);
  if (bus.slaves.empty()) bus.slaves = bus.configured;
}

}  // namespace oncard::runtime
