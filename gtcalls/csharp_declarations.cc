#include "gtcalls/csharp_declarations.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "base/markup.h"
#include "gtcalls/interface_parts.h"

namespace oncard::gtcalls {
namespace {

/// The type on Windows, where a `long` has 32 bits.
std::string_view SpellInCsharp(Scalar scalar) {
  switch (scalar) {
    case Scalar::kChar:
      return "sbyte";
    case Scalar::kUnsignedChar:
      return "byte";
    case Scalar::kShort:
      return "short";
    case Scalar::kUnsignedShort:
      return "ushort";
    case Scalar::kInt:
    case Scalar::kLong:
      return "int";
    case Scalar::kUnsignedLong:
      return "uint";
    case Scalar::kDouble:
      break;
  }
  return "double";
}

/// A name that is no word of C#.
std::string NameInCsharp(std::string_view name) {
  constexpr std::string_view kWords[] = {"base", "event",    "in",     "lock", "object",
                                         "out",  "override", "params", "ref"};
  const bool is_word = std::ranges::find(kWords, name) != std::end(kWords);
  return fmt::format("{}{}", is_word ? "@" : "", name);
}

// --- Structures ----------------------------------------------------------------------------------

/// The elements of an array are members with numbers, as hosts know them: profile1, profile2.
void AppendCsharpMember(std::string* out, const Member& member) {
  constexpr std::string_view kIndent = "            ";
  if (member.type == Scalar::kChar && !member.pointer && member.structure == nullptr) {
    Append(out, "{0}[MarshalAs(UnmanagedType.ByValTStr, SizeConst = {1})]\n{0}public string {2};\n",
           kIndent, member.array_size, NameInCsharp(member.name));
    return;
  }
  const std::string_view type = member.pointer                ? "IntPtr"
                                : member.structure != nullptr ? member.structure->name
                                                              : SpellInCsharp(member.type);
  if (member.array_size == 0) {
    Append(out, "{}public {} {};\n", kIndent, type, NameInCsharp(member.name));
    return;
  }
  const bool ends_with_digit = member.name.back() >= '0' && member.name.back() <= '9';
  for (int i = 1; i <= member.array_size; ++i) {
    Append(out, "{}public {} {}{}{};\n", kIndent, type, member.name, ends_with_digit ? "_" : "", i);
  }
}

void AppendCsharpStructures(std::string* out, const InterfaceForm& form, bool multi_card) {
  for (const Structure& structure : form.catalogue.structures()) {
    const auto basic = std::ranges::find(form.basic_layouts, structure.name, &Structure::name);
    const bool is_basic = !multi_card && basic != form.basic_layouts.end();
    Append(
        out,
        "\n        [StructLayout(LayoutKind.Sequential)]\n        public struct {}\n        {{\n",
        structure.name);
    for (const Member& member : is_basic ? basic->members : structure.members) {
      AppendCsharpMember(out, member);
    }
    *out += "        }\n";
  }
}

// --- Functions -----------------------------------------------------------------------------------

/// Several declarations of one function: C# has no pointers that may be anything.
struct Overload {
  bool arrays = false;     ///< arrays in place of their first element
  bool addresses = false;  ///< addresses, which may be zero, in place of what need not be given
};

bool IsPointer(const Parameter& parameter) {
  return parameter.type_name.empty() &&
         (parameter.passing == Passing::kInput || parameter.passing == Passing::kOutput ||
          parameter.passing == Passing::kLent);
}
bool IsArray(const Parameter& parameter) {
  return IsPointer(parameter) && (parameter.count_parameter >= 0 || parameter.array_size > 1 ||
                                  parameter.CountedByCard() || parameter.passing == Passing::kLent);
}
bool IsAddress(const Parameter& parameter) {
  return IsPointer(parameter) && !IsArray(parameter) && parameter.nullable;
}

/// The type with `ref` or `out` before it, or the brackets of an array after it.
std::string TypeOf(const Parameter& parameter, const Overload& overload) {
  if (!parameter.type_name.empty()) return std::string(parameter.type_name);
  const std::string_view type =
      parameter.structure != nullptr ? parameter.structure->name : SpellInCsharp(parameter.type);
  switch (parameter.passing) {
    case Passing::kText:
      return "string";
    case Passing::kTextOutput:
      return "out string";
    case Passing::kHostMemory:
      return fmt::format("ref {}", type);
    case Passing::kInput:
    case Passing::kOutput:
    case Passing::kLent:
      break;
    default:
      return std::string(type);
  }
  const bool output = parameter.passing == Passing::kOutput;
  if (overload.addresses && IsAddress(parameter)) return "IntPtr";
  if (overload.arrays && IsArray(parameter)) {
    return fmt::format("{}{}[]", output ? "[Out] " : "", type);
  }
  return fmt::format("{} {}", output ? "out" : "ref", type);
}

/// The value of a parameter that may be left out; empty if it may not.
std::string DefaultOf(const Parameter& parameter, const Overload& overload) {
  if (parameter.default_text.empty()) return {};
  if (parameter.passing == Passing::kValue) return std::string(parameter.default_text);
  if (overload.addresses && IsAddress(parameter)) return "default(IntPtr)";
  return {};
}

/// The parameters, each with its comma or the end of the declaration. Only the last ones may be
/// left out.
std::vector<std::string> Parameters(const Command& command, const Overload& overload,
                                    bool multi_card) {
  std::vector<std::string> words;
  if (multi_card) words.emplace_back("short cardNum");
  const std::span<const Parameter> arguments = ArgumentsOf(command);
  size_t required = arguments.size();
  while (required > 0 && !DefaultOf(arguments[required - 1], overload).empty()) --required;
  for (size_t i = 0; i < arguments.size(); ++i) {
    std::string word =
        fmt::format("{} {}", TypeOf(arguments[i], overload), NameInCsharp(arguments[i].name));
    if (i >= required) Append(&word, " = {}", DefaultOf(arguments[i], overload));
    words.push_back(std::move(word));
  }
  for (size_t i = 0; i + 1 < words.size(); ++i) words[i] += ',';
  if (words.empty()) words.emplace_back();
  words.back() += ");";
  return words;
}

/// Comments are XML.
void AppendSummary(std::string* out, const Command& command) {
  Append(out, "\n        /// <summary>{} [{}]</summary>\n", EscapeMarkup(command.brief),
         EscapeMarkup(command.source));
  for (const Parameter& parameter : ArgumentsOf(command)) {
    const std::string description = Describe(parameter, command);
    if (description.empty()) continue;
    Append(out, "        /// <param name=\"{}\">{}</param>\n", parameter.name,
           EscapeMarkup(description));
  }
}

void AppendFunction(std::string* out, const InterfaceForm& form, const Command& command,
                    const Overload& overload, bool multi_card) {
  const Parameter* result = ResultOf(command);
  const std::string entry_point =
      multi_card ? fmt::format(", EntryPoint = \"{}\"", MultiCardName(form, command)) : "";
  Append(out,
         "        [DllImport(Library{}, CharSet = CharSet.Ansi,\n"
         "            CallingConvention = CallingConvention.StdCall)]\n",
         entry_point);
  AppendWrapped(out,
                fmt::format("        public static extern {} {}(",
                            result == nullptr ? "short" : result->type_name, command.name),
                Parameters(command, overload, multi_card), "            ");
}

void AppendOverloads(std::string* out, const InterfaceForm& form, const Command& command,
                     bool multi_card) {
  AppendSummary(out, command);
  const bool has_arrays = std::ranges::any_of(command.parameters, IsArray);
  const bool has_addresses = std::ranges::any_of(command.parameters, IsAddress);
  for (const bool arrays : {false, true}) {
    if (arrays && !has_arrays) continue;
    for (const bool addresses : {false, true}) {
      if (addresses && !has_addresses) continue;
      AppendFunction(out, form, command, {arrays, addresses}, multi_card);
    }
  }
}

constexpr std::string_view kCsharpHead =
    R"(// The commands of {0}.dll{1} for C#. Generated: do not edit.
//
// A long has 32 bits, as on Windows: int. An array in a structure is a member for each element, with
// its number. A parameter that is an array can be given as its first element, with ref or out; one
// that need not be given can be an address, which may be zero. Optional arguments may be left out.
using System;
using System.Runtime.InteropServices;

namespace {0}
{{
    public class mc
    {{
        private const string Library = "{0}.dll";

)";

}  // namespace

std::string CsharpDeclarations(const InterfaceForm& form, bool multi_card) {
  std::string out;
  Append(&out, kCsharpHead, form.catalogue.name(), multi_card ? " with a card number" : "");
  for (const Constant& constant : form.catalogue.constants()) {
    const bool is_short = constant.value >= std::numeric_limits<int16_t>::min() &&
                          constant.value <= std::numeric_limits<int16_t>::max();
    Append(&out, "        public const {} {} = {};\n", is_short ? "short" : "int", constant.name,
           constant.value);
  }
  out += form.csharp_types;
  AppendCsharpStructures(&out, form, multi_card);
  for (const Line& line : form.catalogue.lines()) {
    if (line.command == nullptr) {
      Append(&out, "\n        // --- {} ---\n", line.topic);
    } else if (line.command->on_host) {
      AppendOverloads(&out, form, *line.command, multi_card);
    }
  }
  return out + "    }\n}\n";
}

}  // namespace oncard::gtcalls
