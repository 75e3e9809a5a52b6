#include "runtime/host/host_memory.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/path_bytes.h"
#include "runtime/host/library.h"

namespace oncard::runtime {
namespace {

/// The file of card 0, for any current folder; empty: none.
std::string NamedFile(const Scenario& scenario) {
  const char* named = std::getenv("ONCARD_MRAM");
  std::string path = named == nullptr ? "" : named;
  if (path.empty() && !scenario.mram.empty()) path = PathFromScenario(scenario, scenario.mram);
  if (path.empty()) return path;
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(PathOf(path), error);
  return error ? path : FileNameOf(absolute);
}

/// The memory in a file as the card writes it; clear if there is no file.
Result<std::string> ReadMemory(const std::string& path) {
  const gtcalls::Family& family = LibraryFamily();
  gtcalls::FamilyState state = family.new_state();
  const auto text = ReadFile(path);
  if (text.ok()) {
    const auto restored = family.restore_memory(text.value(), path, state);
    if (!restored.ok()) return restored.error();
  } else if (text.error().code != kNoSuchFile) {
    return text.error();
  }
  return family.memory_text(state);
}

}  // namespace

Result<void> CardMemory::Keep(const Controller& controller) const {
  const std::string text = controller.family().memory_text(controller.view().family_state);
  return text == before_ ? Result<void>() : WriteFileAtomically(path_, text);
}

Result<std::optional<CardMemory>> TakeMemory(int card, Scenario* scenario) {
  std::string path = NamedFile(*scenario);
  if (path.empty()) return std::optional<CardMemory>();
  if (card != 0) path += "." + std::to_string(card);
  auto text = ReadMemory(path);
  if (!text.ok()) return text.error();
  scenario->memory = text.value();
  return std::optional<CardMemory>(std::in_place, std::move(path), std::move(text).value());
}

}  // namespace oncard::runtime
