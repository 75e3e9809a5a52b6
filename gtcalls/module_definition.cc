#include "gtcalls/module_definition.h"

#include <string_view>

#include "gtcalls/interface_parts.h"

namespace oncard::gtcalls {
namespace {

/// A word of the stack in 32 bits. Everything else takes one.
constexpr int kWord = 4;

int BytesOf(const Parameter& parameter) {
  return parameter.passing == Passing::kValue && parameter.type == Scalar::kDouble ? 2 * kWord
                                                                                   : kWord;
}

/// `@` and the bytes of the arguments.
std::string Decoration(const Command& command, bool card_number, const ExportedNames& names) {
  if (!names.decorated) return {};
  int bytes = card_number ? kWord : 0;
  for (const Parameter& parameter : ArgumentsOf(command)) bytes += BytesOf(parameter);
  return fmt::format("@{}", bytes);
}

/// The plain name, and which function has it.
void AppendPlainName(std::string* out, const InterfaceForm& form, const Command& command,
                     const ExportedNames& names) {
  const std::string decoration = Decoration(command, names.multi_card, names);
  Append(out, "  {}{}", command.name, decoration);
  if (names.multi_card) {
    Append(out, " = {}{}{}", HasBasic(form, command) ? kMultiBasicPrefix : "",
           MultiCardName(form, command), decoration);
  }
  *out += '\n';
}

}  // namespace

std::string ModuleDefinition(const InterfaceForm& form, const ExportedNames& names) {
  std::string out;
  Append(&out, "; Generated: do not edit.\nLIBRARY \"{}.dll\"\nEXPORTS\n", form.catalogue.name());
  for (const Command& command : form.catalogue.commands()) {
    if (!command.on_host) continue;
    AppendPlainName(&out, form, command, names);
    if (HasBasic(form, command)) {
      Append(&out, "  {}{}\n", WideName(form, command), Decoration(command, false, names));
    }
    if (!form.multi_card_prefix.empty()) {
      Append(&out, "  {}{}\n", MultiCardName(form, command), Decoration(command, true, names));
    }
  }
  return out;
}

}  // namespace oncard::gtcalls
