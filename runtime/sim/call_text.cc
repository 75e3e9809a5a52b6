#include "runtime/sim/call_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string_view>

namespace oncard::runtime {
namespace {

using gtcalls::Parameter;
using gtcalls::Passing;
using gtcalls::Scalar;

// Each function appends to the line. A host may make millions of calls.

void AppendText(std::string_view text, std::string* line) {
  *line += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      *line += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      *line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      *line += c;
    }
  }
  *line += '"';
}

void AppendInteger(int64_t value, std::string* line) {
  const fmt::format_int number(value);
  line->append(number.data(), number.size());
}

/// Bits as `0x1f`.
void AppendHex(uint32_t bits, std::string* line) {
  std::array<char, 8> digits;
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), bits, 16).ptr;
  *line += "0x";
  line->append(digits.data(), end);
}

/// When, in milliseconds, and on which card: `12.250 card0`.
void AppendPlace(int64_t time_us, int card, std::string* line) {
  AppendInteger(time_us / 1000, line);
  *line += '.';
  for (const int64_t unit : {100, 10, 1}) *line += static_cast<char>('0' + time_us / unit % 10);
  *line += " card";
  AppendInteger(card, line);
}

/// The shortest number that is this one. Whole ones, the usual case, without looking for it.
void AppendNumber(double value, std::string* line) {
  constexpr double kWithoutExponent = 1e15;
  if (std::fabs(value) < kWithoutExponent && value == std::trunc(value) &&
      !(value == 0 && std::signbit(value))) {
    return AppendInteger(static_cast<int64_t>(value), line);
  }
  fmt::format_to(std::back_inserter(*line), "{}", value);
}

/// Appends `[`, what `append` makes of each cell, and `]`.
template <typename Append>
void AppendList(std::span<const double> cells, const Append& append, std::string* line) {
  *line += '[';
  for (size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) *line += ", ";
    append(cells[i], line);
  }
  *line += ']';
}

/// A scalar: masks and bit words as hexadecimal numbers with the width of their type.
void AppendScalar(const Parameter& parameter, double value, std::string* line) {
  if (parameter.unit != gtcalls::Unit::kMask && parameter.unit != gtcalls::Unit::kBits) {
    return AppendNumber(value, line);
  }
  const auto bits = static_cast<uint32_t>(static_cast<int64_t>(value));
  const bool narrow = parameter.type == Scalar::kShort || parameter.type == Scalar::kUnsignedShort;
  AppendHex(narrow ? bits & 0xFFFF : bits, line);
}

/// A structure's members with names, without those that are not cells; removes its cells from
/// `cells`.
void AppendStructure(const gtcalls::Structure& structure, std::span<const double>* cells,
                     std::string* line) {
  *line += '{';
  for (const gtcalls::Member& member : structure.members) {
    if (member.pointer || (member.type == Scalar::kChar && member.structure == nullptr)) continue;
    if (line->back() != '{') *line += ", ";
    *line += member.name;
    *line += '=';
    const size_t count = member.array_size == 0 ? 1 : static_cast<size_t>(member.array_size);
    if (member.structure != nullptr) {
      for (size_t i = 0; i < count; ++i) AppendStructure(*member.structure, cells, line);
      continue;
    }
    const auto part = cells->first(count);
    *cells = cells->subspan(count);
    if (member.array_size == 0) {
      AppendNumber(part[0], line);
    } else {
      AppendList(part, AppendNumber, line);
    }
  }
  *line += '}';
}

/// The values that a pointer refers to.
void AppendContent(const Parameter& parameter, const vm::CommandArgument& argument,
                   std::string* line) {
  if (parameter.passing == Passing::kTextOutput) {
    return AppendText(*static_cast<const char* const*>(argument.host), line);
  }
  if (parameter.structure == nullptr) {
    return AppendList(
        argument.cells,
        [&parameter](double cell, std::string* to) { AppendScalar(parameter, cell, to); }, line);
  }
  std::span<const double> cells = argument.cells;
  if (parameter.count_parameter < 0) return AppendStructure(*parameter.structure, &cells, line);
  *line += '[';
  while (!cells.empty()) {
    if (line->back() != '[') *line += ", ";
    AppendStructure(*parameter.structure, &cells, line);
  }
  *line += ']';
}

void AppendArgument(const Parameter& parameter, const vm::CommandArgument& argument,
                    std::string* line) {
  if (parameter.passing == Passing::kValue) return AppendScalar(parameter, argument.value, line);
  if (argument.null && argument.host == nullptr) {
    *line += "NULL";
  } else if (!argument.null && parameter.passing == Passing::kText) {
    AppendText(static_cast<const char*>(argument.host), line);
  } else if (!argument.null && parameter.passing == Passing::kInput) {
    AppendContent(parameter, argument, line);
  } else {  // an output, or an input that was not read because its count is out of range
    *line += parameter.name;
  }
}

/// True if the call has written an output that the log can show.
bool HasOutput(const Parameter& parameter, const vm::CommandArgument& argument) {
  if (argument.null) return false;
  return parameter.passing == Passing::kTextOutput ||
         (parameter.passing == Passing::kOutput && !argument.cells.empty());
}

void AppendInputs(const gtcalls::Command& command, std::span<const vm::CommandArgument> arguments,
                  std::string* line) {
  *line += command.name;
  *line += '(';
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (!command.parameters[i].IsArgument()) continue;
    if (i > 0) *line += ", ";
    AppendArgument(command.parameters[i], arguments[i], line);
  }
  *line += ')';
}

void AppendOutputs(const gtcalls::Command& command, std::span<const vm::CommandArgument> arguments,
                   std::string* line) {
  for (size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = command.parameters[i];
    if (!HasOutput(parameter, arguments[i])) continue;
    *line += ", ";
    *line += parameter.name;
    *line += '=';
    AppendContent(parameter, arguments[i], line);
  }
}

void AppendCallAndCode(const gtcalls::Command& command,
                       std::span<const vm::CommandArgument> arguments, int16_t code,
                       const std::string& why, std::string* line) {
  AppendInputs(command, arguments, line);
  *line += " = ";
  AppendInteger(code, line);
  if (why.empty()) return;
  *line += ": ";
  *line += why;
}

}  // namespace

std::string FormatInputs(const gtcalls::Command& command,
                         std::span<const vm::CommandArgument> arguments) {
  std::string text;
  AppendInputs(command, arguments, &text);
  return text;
}

std::string FormatOutputs(const gtcalls::Command& command,
                          std::span<const vm::CommandArgument> arguments) {
  std::string text;
  AppendOutputs(command, arguments, &text);
  return text;
}

std::string FormatCallAndCode(const gtcalls::Command& command,
                              std::span<const vm::CommandArgument> arguments, int16_t code,
                              const Message& reason, Language language) {
  std::string text;
  AppendCallAndCode(command, arguments, code, reason.In(language), &text);
  return text;
}

void AppendCall(const LoggedCall& call, Language language, std::string* line) {
  AppendPlace(call.time_us, call.card, line);
  *line += ' ';
  if (call.caller != vm::kHostCaller) {
    *line += "thread ";
    AppendInteger(call.caller, line);
    *line += ": ";
  }
  const std::string& why = call.reason.In(language);
  AppendCallAndCode(call.command, call.arguments, call.code, why, line);
  if (call.code == 0 && why.empty()) AppendOutputs(call.command, call.arguments, line);
}

void AppendEvent(int64_t time_us, int card, const Message& what, Language language,
                 std::string* line) {
  AppendPlace(time_us, card, line);
  *line += ": ";
  *line += what.In(language);
}

}  // namespace oncard::runtime
