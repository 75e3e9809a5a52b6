// What the files that the generator writes have in common: the names of functions, their arguments,
// and which structures have two layouts. Read-only; thread-safe.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {

template <typename... Args>
void Append(std::string* out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(*out), format, std::forward<Args>(args)...);
}

/// The name of a command with `short cardNum` in front.
std::string MultiCardName(const InterfaceForm& form, const Command& command);

/// The name of a command that takes a structure which has another layout in the vendor's basic
/// header.
std::string WideName(const InterfaceForm& form, const Command& command);

/// What stands before the name with a card number where a function takes the structures of the
/// basic header. A library for Windows exports it with the plain name.
inline constexpr std::string_view kMultiBasicPrefix = "Basic";

/// True for a parameter whose memory has another layout in the basic header. Memory that is only
/// lent has no layout.
bool IsBasic(const InterfaceForm& form, const Parameter& parameter);

/// True for a command with such a parameter.
bool HasBasic(const InterfaceForm& form, const Command& command);

/// What a command returns in place of its code; nullptr for most commands.
const Parameter* ResultOf(const Command& command);

/// The parameters of its function in C.
std::span<const Parameter> ArgumentsOf(const Command& command);

/// What the documentation says about a parameter: unit, range, NULL.
std::string Describe(const Parameter& parameter, const Command& command);

/// Appends `line` with these words after it, with a blank between two of them. A line ends before a
/// word that would make it longer than 100 characters; the next one begins with `indent`.
void AppendWrapped(std::string* out, std::string line, std::span<const std::string> words,
                   std::string_view indent);

}  // namespace oncard::gtcalls
