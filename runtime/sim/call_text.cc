#include "runtime/sim/call_text.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace oncard::runtime {
namespace {

using gtcalls::Parameter;
using gtcalls::Passing;
using gtcalls::Scalar;

std::string CString(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      quoted += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string ListOf(std::span<const double> cells) {
  return fmt::format("[{}]", fmt::join(cells, ", "));
}

/// The text of a scalar: masks and bit words as hexadecimal numbers with the width of their type.
std::string NumberOf(const Parameter& parameter, double value) {
  if (parameter.unit != gtcalls::Unit::kMask && parameter.unit != gtcalls::Unit::kBits) {
    return fmt::format("{}", value);
  }
  const auto bits = static_cast<uint32_t>(static_cast<int64_t>(value));
  const bool narrow = parameter.type == Scalar::kShort || parameter.type == Scalar::kUnsignedShort;
  return fmt::format("{:#x}", narrow ? bits & 0xFFFF : bits);
}

/// A structure's members with names, without those that are not cells; removes its cells from
/// `cells`.
std::string StructureOf(const gtcalls::Structure& structure, std::span<const double>* cells) {
  std::string text = "{";
  for (const gtcalls::Member& member : structure.members) {
    if (member.pointer || (member.type == Scalar::kChar && member.structure == nullptr)) continue;
    if (text.size() > 1) text += ", ";
    text += member.name;
    text += '=';
    if (member.structure != nullptr) {
      text += StructureOf(*member.structure, cells);
      continue;
    }
    const size_t count = member.array_size == 0 ? 1 : static_cast<size_t>(member.array_size);
    const auto part = cells->first(count);
    *cells = cells->subspan(count);
    text += member.array_size == 0 ? fmt::format("{}", part[0]) : ListOf(part);
  }
  return text + '}';
}

/// The values that a pointer refers to.
std::string ContentOf(const Parameter& parameter, const vm::CommandArgument& argument) {
  if (parameter.passing == Passing::kTextOutput) {
    return CString(*static_cast<const char* const*>(argument.host));
  }
  if (parameter.structure == nullptr) {
    std::vector<std::string> numbers;
    for (const double cell : argument.cells) numbers.push_back(NumberOf(parameter, cell));
    return fmt::format("[{}]", fmt::join(numbers, ", "));
  }
  std::span<const double> cells = argument.cells;
  if (parameter.count_parameter < 0) return StructureOf(*parameter.structure, &cells);
  std::string text = "[";
  while (!cells.empty()) {
    if (text.size() > 1) text += ", ";
    text += StructureOf(*parameter.structure, &cells);
  }
  return text + ']';
}

std::string ArgumentOf(const Parameter& parameter, const vm::CommandArgument& argument) {
  if (parameter.passing == Passing::kValue) return NumberOf(parameter, argument.value);
  // A pointer that was not read because its count is out of range is not NULL for the host.
  if (argument.null) return argument.host == nullptr ? "NULL" : std::string(parameter.name);
  switch (parameter.passing) {
    case Passing::kText:
      return CString(static_cast<const char*>(argument.host));
    case Passing::kInput:
      return ContentOf(parameter, argument);
    default:
      return std::string(parameter.name);
  }
}

/// True if the call has written an output that the log can show.
bool HasOutput(const Parameter& parameter, const vm::CommandArgument& argument) {
  if (argument.null) return false;
  return parameter.passing == Passing::kTextOutput ||
         (parameter.passing == Passing::kOutput && !argument.cells.empty());
}

}  // namespace

std::string FormatInputs(const gtcalls::Command& command,
                         std::span<const vm::CommandArgument> arguments) {
  std::string text = fmt::format("{}(", command.name);
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (i > 0) text += ", ";
    text += ArgumentOf(command.parameters[i], arguments[i]);
  }
  return text + ')';
}

std::string FormatOutputs(const gtcalls::Command& command,
                          std::span<const vm::CommandArgument> arguments) {
  std::string text;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = command.parameters[i];
    if (!HasOutput(parameter, arguments[i])) continue;
    text += fmt::format(", {}={}", parameter.name, ContentOf(parameter, arguments[i]));
  }
  return text;
}

std::string FormatCallAndCode(const gtcalls::Command& command,
                              std::span<const vm::CommandArgument> arguments, int16_t code,
                              const Message& reason, Language language) {
  const std::string text = fmt::format("{} = {}", FormatInputs(command, arguments), code);
  const std::string& why = reason.In(language);
  return why.empty() ? text : text + ": " + why;
}

std::string FormatCall(const LoggedCall& call, Language language) {
  std::string line =
      fmt::format("{}.{:03} card{} ", call.time_us / 1000, call.time_us % 1000, call.card);
  if (call.caller != vm::kHostCaller) line += fmt::format("thread {}: ", call.caller);
  line += FormatCallAndCode(call.command, call.arguments, call.code, call.reason, language);
  if (call.code != 0 || !call.reason.In(language).empty()) return line;
  return line + FormatOutputs(call.command, call.arguments);
}

std::string FormatHappening(int64_t time_us, int card, const Message& what, Language language) {
  return fmt::format("{}.{:03} card{}: {}", time_us / 1000, time_us % 1000, card,
                     what.In(language));
}

}  // namespace oncard::runtime
