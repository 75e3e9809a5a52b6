#include "gtcalls/interface_parts.h"

#include <algorithm>

namespace oncard::gtcalls {
namespace {

/// The name of a command with `prefix` instead of the family's prefix.
std::string Renamed(std::string_view prefix, const InterfaceForm& form, const Command& command) {
  std::string_view name = command.name;
  if (name.starts_with(form.command_prefix)) name.remove_prefix(form.command_prefix.size());
  return fmt::format("{}{}", prefix, name);
}

}  // namespace

std::string MultiCardName(const InterfaceForm& form, const Command& command) {
  return Renamed(form.multi_card_prefix, form, command);
}

std::string WideName(const InterfaceForm& form, const Command& command) {
  return Renamed(form.wide_prefix, form, command);
}

bool IsBasic(const InterfaceForm& form, const Parameter& parameter) {
  return parameter.structure != nullptr && parameter.passing != Passing::kLent &&
         std::any_of(form.basic_layouts.begin(), form.basic_layouts.end(),
                     [&](const Structure& s) { return s.name == parameter.structure->name; });
}

bool HasBasic(const InterfaceForm& form, const Command& command) {
  return std::any_of(command.parameters.begin(), command.parameters.end(),
                     [&](const Parameter& parameter) { return IsBasic(form, parameter); });
}

const Parameter* ResultOf(const Command& command) {
  if (command.parameters.empty() || command.parameters.back().IsArgument()) return nullptr;
  return &command.parameters.back();
}

std::span<const Parameter> ArgumentsOf(const Command& command) {
  return command.parameters.first(command.parameters.size() -
                                  (ResultOf(command) != nullptr ? 1 : 0));
}

}  // namespace oncard::gtcalls
