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

std::string Describe(const Parameter& parameter, const Command& command) {
  std::string text(SpellUnit(parameter.unit));
  const auto add = [&text](const std::string& part) {
    if (part.empty()) return;
    if (!text.empty()) text += ", ";
    text += part;
  };
  add(SpellRange(parameter));
  if (parameter.count_parameter >= 0) {
    const auto count = static_cast<size_t>(parameter.count_parameter);
    add(fmt::format("array of {}", command.parameters[count].name));
  }
  if (parameter.array_size > 1) add(fmt::format("array of {}", parameter.array_size));
  if (parameter.per_dimension) add("one per axis of the coordinate system");
  if (parameter.per_offset) add("one per offset of the list");
  if (parameter.per_axis) add("one per axis of the card");
  if (parameter.passing == Passing::kLent) add("not used by the simulated card");
  if (parameter.nullable) add("may be NULL");
  return text;
}

void AppendWrapped(std::string* out, std::string line, std::span<const std::string> words,
                   std::string_view indent) {
  constexpr size_t kWidth = 100;
  for (const std::string& word : words) {
    if (line.size() + word.size() > kWidth) {
      line.pop_back();
      *out += line + "\n";
      line = indent;
    }
    line += word + " ";
  }
  line.pop_back();
  *out += line + "\n";
}

}  // namespace oncard::gtcalls
