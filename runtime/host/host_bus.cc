#include "runtime/host/host_bus.h"

#include <filesystem>
#include <system_error>

#include "base/files.h"
#include "runtime/host/eni_file.h"

namespace oncard::runtime {

Message TakeEni(const std::string& folder, Scenario* scenario) {
  const std::string path = (std::filesystem::path(folder) / kEniName).string();
  if (folder.empty() || !FileExists(path)) return {};
  const auto text = ReadFile(path, kEniKind);
  if (!text.ok()) return text.error().message;
  const auto described = ParseEni(text.value(), path);
  if (!described.ok()) return described.error().message;
  BusSetup& bus = scenario->bus;
  bus.configured.clear();
  for (size_t i = 0; i < described.value().size(); ++i) {
    bus.configured.push_back(SetupOf(described.value()[i]));
    // A drive that is connected says which motor it moves.
    const bool connected = i < bus.slaves.size() && bus.slaves[i].axis > 0;
    if (connected && bus.configured[i].axis > 0) bus.configured[i].axis = bus.slaves[i].axis;
  }
  if (bus.slaves.empty()) bus.slaves = bus.configured;
  return {};
}

std::string FolderOfProgram() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::string() : program.parent_path().string();
}

}  // namespace oncard::runtime
