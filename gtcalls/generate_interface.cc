// Writes the files that are derived from the catalogue of a family, at build time:
//
//   generate_interface FAMILY header FILE               its header
//   generate_interface FAMILY module-header FILE        the header of its module
//   generate_interface FAMILY entry-points FILE         the library's functions
//   generate_interface FAMILY multi-entry-points FILE   the same with a card number
//   generate_interface FAMILY basic-entry-points FILE   the same for hosts of the vendor's header
//   generate_interface FAMILY multi-basic-entry-points FILE   the same with a card number
//   generate_interface FAMILY structures FILE           structures of the header as cells and back
//   generate_interface FAMILY exports-x64 FILE          what its library for Windows exports
//   generate_interface FAMILY multi-exports-x64 FILE    the same if plain names have a card number;
//                                                       x86: both for 32 bits
//   generate_interface FAMILY csharp FILE               its declarations for C#
//   generate_interface FAMILY multi-csharp FILE         the same with a card number
//   generate_interface FAMILY markdown FILE             its page in docs/, of which each form has
//                                                       the head
//   generate_interface FAMILY markdown-zh FILE          the same in Chinese, if it has one
//
// The header contains every prototype once. A family can have functions with a card number, too:
// defining GTS_MULTI_CARD before including gts.h adds `short cardNum` as the first parameter and
// renames the functions, GT_Update to GTM_Update, so that one library serves both generations and
// the functions cannot be confused.
//
// A host may be compiled with the vendor's own header, which is in the same folder as its source.
// Where a structure has another layout there (gts/basic_layouts.def), the commands that take it
// have two entry points: one with the plain name, for that header, and one with another prefix,
// GTX_ for GTS, which our header uses.
//
// With `long32-` before it, as in `long32-header`, a file is that of a library for declarations
// that were written for Windows, where a `long` has 32 bits. Only the library is compiled with that
// header.
//
// Every family defines its names, and which of these parts it has (interface_form.h).
//
// Tested by tests/gtcalls/interface_test.cc and, at compile time, interface_types_test.cc.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "gtcalls/csharp_declarations.h"
#include "gtcalls/interface_form.h"
#include "gtcalls/interface_parts.h"
#include "gtcalls/module_definition.h"

namespace oncard::gtcalls {
namespace {

/// The beginning of the prototype.
std::string ApiOf(const InterfaceForm& form, const Command& command) {
  const Parameter* result = ResultOf(command);
  return result == nullptr ? std::string(form.api)
                           : fmt::format("{}({})", form.api_returning, result->type_name);
}

/// The parameters as declarations, or only their names, each after a comma.
std::string Declarations(const InterfaceForm& form, const Command& command) {
  std::string text;
  for (const Parameter& parameter : ArgumentsOf(command)) {
    text += ", " + DeclareParameter(parameter, form.spell);
  }
  return text;
}
std::string Names(const Command& command) {
  std::string text;
  for (const Parameter& parameter : ArgumentsOf(command)) Append(&text, ", {}", parameter.name);
  return text;
}

// --- The header ---------------------------------------------------------------------------------

void AppendMember(std::string* out, const InterfaceForm& form, const Member& member) {
  const std::string_view type =
      member.structure != nullptr ? member.structure->name : form.spell(member.type);
  Append(out, "  {} {}{}", type, member.pointer ? "*" : "", member.name);
  if (member.array_size > 0) Append(out, "[{}]", member.array_size);
  *out += ";\n";
}

void AppendComment(std::string* out, const Command& command) {
  Append(out, "\n/* {}", command.brief);
  for (const Parameter& parameter : command.parameters) {
    const std::string description = Describe(parameter, command);
    if (!description.empty()) Append(out, "\n     {}: {}", parameter.name, description);
  }
  Append(out, "\n   [{}] */\n", command.source);
}

void AppendPrototype(std::string* out, const InterfaceForm& form, const Command& command) {
  const std::string_view prefix = form.macro_prefix;
  const bool multi_card = !form.multi_card_prefix.empty();
  const std::string line = fmt::format("{} {}(", ApiOf(form, command), command.name);
  const std::span<const Parameter> parameters = ArgumentsOf(command);
  if (parameters.empty()) {
    *out += line + (multi_card ? fmt::format("{}CARD_ONLY_", prefix) : "void") + ");\n";
    return;
  }
  std::vector<std::string> words;
  for (const Parameter& parameter : parameters) {
    std::string word = DeclareParameter(parameter, form.spell);
    if (!parameter.default_text.empty()) {
      Append(&word, " {}DEFAULT_({})", prefix, parameter.default_text);
    }
    words.push_back(word + ",");
  }
  words.back().back() = ')';
  if (HasBasic(form, command))
    Append(&words.back(), " {}WIDE_({})", prefix, WideName(form, command));
  words.back() += ';';
  AppendWrapped(out, multi_card ? fmt::format("{}{}CARD_ ", line, prefix) : line, words, "    ");
}

bool IsOfModule(const InterfaceForm& form, const Structure& structure) {
  return form.module != nullptr && std::ranges::find(form.module->structures, structure.name) !=
                                       form.module->structures.end();
}

/// The commands of the module's header, or of the main one, with the topics before them.
std::vector<Line> LinesOf(const InterfaceForm& form, bool module) {
  std::vector<Line> lines;
  bool in_module = false;
  for (const Line& line : form.catalogue.lines()) {
    if (line.command == nullptr) {
      in_module = form.module != nullptr && line.topic == form.module->topic;
    }
    if (in_module == module) lines.push_back(line);
  }
  return lines;
}

void AppendStructures(std::string* out, const InterfaceForm& form, bool module) {
  *out += "\n/* --- Structures --- */\n";
  for (const Structure& structure : form.catalogue.structures()) {
    if (IsOfModule(form, structure) != module) continue;
    Append(out, "\ntypedef struct {} {{\n", structure.name);
    for (const Member& member : structure.members) AppendMember(out, form, member);
    Append(out, "}} {};\n", structure.name);
  }
}

/// The names of commands whose structures have two layouts. Compilers for Windows cannot name them
/// for the linker, or decorate names in 32 bits.
constexpr std::string_view kWideNames =
    R"(/* Commands that take a structure which the vendor's basic {1}.h lays out otherwise have a name of
   their own in the library; the plain name is for hosts that were compiled with that header. */
#if defined(__GNUC__) && !defined(_WIN32)
#define {0}WIDE_(name) __asm__(#name)
#else
#define {0}WIDE_(name)
)";

/// The switch between functions with a card number and without, for the commands of `lines`.
void AppendMultiCardSwitch(std::string* out, const InterfaceForm& form,
                           const std::vector<Line>& lines) {
  const auto listed = [&](const Command& command) {
    return command.on_host && std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
             return line.command == &command;
           });
  };
  const std::string_view prefix = form.macro_prefix;
  Append(out,
         "\n#ifdef {0}MULTI_CARD\n#define {0}CARD_ short cardNum,\n"
         "#define {0}CARD_ONLY_ short cardNum\n",
         prefix);
  for (const Command& command : form.catalogue.commands()) {
    if (listed(command)) Append(out, "#define {} {}\n", command.name, MultiCardName(form, command));
  }
  const bool has_basic = !form.basic_layouts.empty();
  if (has_basic) Append(out, "#define {}WIDE_(name)\n", prefix);
  Append(out, "#else\n#define {0}CARD_\n#define {0}CARD_ONLY_ void\n", prefix);
  if (has_basic) {
    Append(out, kWideNames, prefix, form.header);
    for (const Command& command : form.catalogue.commands()) {
      if (!listed(command) || !HasBasic(form, command)) continue;
      Append(out, "#define {} {}\n", command.name, WideName(form, command));
    }
    *out += "#endif\n";
  }
  *out += "#endif\n";
}

/// What the prototypes of one header need, the prototypes, and the end of the header.
void AppendPrototypes(std::string* out, const InterfaceForm& form, bool module) {
  const std::vector<Line> lines = LinesOf(form, module);
  const bool multi_card = !form.multi_card_prefix.empty();
  if (multi_card) AppendMultiCardSwitch(out, form, lines);
  for (const Line& line : lines) {
    if (line.command == nullptr) {
      Append(out, "\n/* --- {} --- */\n", line.topic);
      continue;
    }
    const Command& command = *line.command;
    if (!command.on_host) continue;
    AppendComment(out, command);
    AppendPrototype(out, form, command);
  }
  if (!module && !form.overloads.empty()) {
    Append(out, "\n#ifdef __cplusplus\n{}#endif\n", form.overloads);
  }
  *out += '\n';
  std::vector<std::string_view> macros = {"DEFAULT_"};
  if (multi_card) macros.insert(macros.begin(), {"CARD_", "CARD_ONLY_"});
  if (!form.basic_layouts.empty()) macros.emplace_back("WIDE_");
  for (const std::string_view macro : macros) {
    Append(out, "#undef {}{}\n", form.macro_prefix, macro);
  }
  *out += "\n#endif\n";
}

std::string Header(const InterfaceForm& form) {
  const Catalogue& catalogue = form.catalogue;
  std::string out(form.head);
  out += "\n/* --- Constants --- */\n\n";
  for (const Constant& constant : catalogue.constants()) {
    if (constant.value < 0) {
      Append(&out, "#define {} ({})\n", constant.name, constant.value);
    } else {
      Append(&out, "#define {} {}\n", constant.name, constant.value);
    }
  }
  AppendStructures(&out, form, false);
  AppendPrototypes(&out, form, false);
  return out;
}

/// Empty without a module.
std::string ModuleHeader(const InterfaceForm& form) {
  if (form.module == nullptr) return {};
  std::string out(form.module->head);
  AppendStructures(&out, form, true);
  AppendPrototypes(&out, form, true);
  return out;
}

// --- Entry points -------------------------------------------------------------------------------

void AppendModuleInclude(std::string* out, const InterfaceForm& form) {
  if (form.module != nullptr) Append(out, "#include \"{}.h\"\n", form.module->file);
}

/// The functions of one generation, compiled with the prototypes of its header. For functions with
/// a card number the header does the renaming.
std::string EntryPoints(const InterfaceForm& form, bool multi_card) {
  std::string out;
  Append(&out,
         "// The library's entry points{}. Generated: do not edit.\n"
         "#include \"{}{}.h\"\n",
         multi_card ? " with a card number" : "", form.header, multi_card ? "_multi" : "");
  AppendModuleInclude(&out, form);
  out +=
      "#include \"runtime/host/host_api.h\"\n\n"
      "using oncard::runtime::CallFromHost;\n";
  for (const Command& command : form.catalogue.commands()) {
    if (!command.on_host) continue;
    std::string declarations = Declarations(form, command);
    if (multi_card) {
      declarations.insert(0, "short cardNum");
    } else if (!declarations.empty()) {
      declarations.erase(0, 2);
    }
    const std::string call = fmt::format("CallFromHost({}, {}{}",
                                         multi_card ? "cardNum" : "oncard::runtime::kSelectedCard",
                                         command.number, Names(command));
    Append(&out, "\n{} {}({}) {{\n", ApiOf(form, command), command.name, declarations);
    if (const Parameter* result = ResultOf(command); result != nullptr) {
      Append(&out, "  {} = nullptr;\n  {}, &{});\n  return {};\n}}\n",
             DeclareParameter(*result, form.spell), call, result->name, result->name);
    } else {
      Append(&out, "  return {});\n}}\n", call);
    }
  }
  return out;
}

/// The declaration of a basic layout, with the structure's name in a namespace of its own, and the
/// conversions between it and our layout.
void AppendBasicLayout(std::string* out, const InterfaceForm& form, const Structure& layout) {
  Append(out, "namespace basic {{\nstruct {} {{\n", layout.name);
  for (const Member& member : layout.members) AppendMember(out, form, member);
  *out += "};\n}  // namespace basic\n\n";
  for (const bool widen : {true, false}) {
    Append(out, "[[maybe_unused]] static void Copy(const {0}{2}& from, {1}{2}* to) {{\n",
           widen ? "basic::" : "::", widen ? "::" : "basic::", layout.name);
    for (const Member& member : layout.members) {
      if (member.array_size > 0) {
        Append(out, "  std::copy_n(from.{0}, {1}, to->{0});\n", member.name, member.array_size);
      } else {
        Append(out, "  to->{0} = from.{0};\n", member.name);
      }
    }
    *out += "}\n\n";
  }
}

/// The parameters as a host that uses the basic header passes them.
std::string BasicDeclarations(const InterfaceForm& form, const Command& command, bool multi_card) {
  std::string text = multi_card ? "short cardNum" : "";
  for (const Parameter& parameter : command.parameters) {
    text += text.empty() ? "" : ", ";
    if (IsBasic(form, parameter)) text += "basic::";
    text += DeclareParameter(parameter, form.spell);
  }
  return text;
}

void AppendBasicEntryPoint(std::string* out, const InterfaceForm& form, const Command& command,
                           bool multi_card) {
  const std::string ours = multi_card ? MultiCardName(form, command) : WideName(form, command);
  Append(out, "extern \"C\" short {2}CALL_ {0}({1});\nshort {2}CALL_ {0}({1}) {{\n",
         multi_card ? fmt::format("{}{}", kMultiBasicPrefix, ours) : command.name,
         BasicDeclarations(form, command, multi_card), form.macro_prefix);
  std::string before;
  std::string names = multi_card ? "cardNum" : "";
  std::string after;
  for (const Parameter& parameter : command.parameters) {
    names += names.empty() ? "" : ", ";
    if (!IsBasic(form, parameter)) {
      names += parameter.name;
      continue;
    }
    Append(&names, "Wide({0}, &wide_{0})", parameter.name);
    Append(&before, "  {0} wide_{1}{{}};\n", parameter.structure->name, parameter.name);
    if (parameter.passing == Passing::kInput) {
      Append(&before, "  if (IsAddress({0})) Copy(*{0}, &wide_{0});\n", parameter.name);
    } else {
      Append(&after, "  if (code == 0) Copy(wide_{0}, {0});\n", parameter.name);
    }
  }
  Append(out, "{}  const short code = {}({});\n{}  return code;\n}}\n\n", before, ours, names,
         after);
}

constexpr std::string_view kBasicHead =
    R"(// The library's entry points for hosts that were compiled with the vendor's basic {0}.h, where its
// structures differ. Generated: do not edit.
#include <algorithm>

{1}#include "runtime/host/host_api.h"

namespace oncard::runtime {{
namespace {{

/// What is passed on for a pointer to a basic structure; what cannot be one is left to be refused.
template <typename Basic, typename Ours>
Ours* Wide(Basic* host, Ours* wide) {{
  return IsAddress(host) ? wide : reinterpret_cast<Ours*>(host);
}}

}}  // namespace

)";

/// The header, with the plain names of the functions free for those that follow.
std::string IncludeForBasic(const InterfaceForm& form, bool multi_card) {
  if (multi_card) return fmt::format("#include \"{}_multi.h\"\n", form.header);
  std::string rename;
  std::string restore;
  for (const Command& command : form.catalogue.commands()) {
    if (!command.on_host || !HasBasic(form, command)) continue;
    Append(&rename, "#define {} {}\n", command.name, WideName(form, command));
    Append(&restore, "#undef {}\n", command.name);
  }
  return fmt::format(
      "// With these macros the header declares only the functions with the other prefix.\n"
      "{}#include \"{}.h\"\n{}",
      rename, form.header, restore);
}

/// The functions as the vendor's basic header declares them, with plain names or, with a card
/// number, with names that only a library for several cards exports. They call ours.
std::string BasicEntryPoints(const InterfaceForm& form, bool multi_card) {
  std::string out;
  Append(&out, kBasicHead, form.header, IncludeForBasic(form, multi_card));
  for (const Structure& layout : form.basic_layouts) AppendBasicLayout(&out, form, layout);
  for (const Command& command : form.catalogue.commands()) {
    if (!command.on_host || !HasBasic(form, command)) continue;
    AppendBasicEntryPoint(&out, form, command, multi_card);
  }
  return out + "}  // namespace oncard::runtime\n";
}

// --- Structures as cells ------------------------------------------------------------------------

constexpr std::string_view kStructuresHead =
    R"(// The structures of {0}.h as cells and back. Generated: do not edit.
#include "runtime/host/host_structures.h"

#include "{1}"
#include "{0}.h"
{2}
namespace oncard::runtime {{
namespace {{

/// Takes the scalars of a structure one after the other.
struct Reader {{
  double* next;
  template <typename T>
  void operator()(const T& scalar) {{
    *next++ = static_cast<double>(scalar);
  }}
  void operator()(const long& scalar) {{ *next++ = LongCell(scalar, false); }}
  void operator()(const unsigned long& scalar) {{
    *next++ = LongCell(static_cast<int64_t>(scalar), true);
  }}
}};

/// Gives them back.
struct Writer {{
  const double* next;
  template <typename T>
  void operator()(T& scalar) {{
    scalar = FromCell<T>(*next++);
  }}
}};

/// Takes the pointers of a structure one after the other.
struct ArrayReader {{
  void** next;
  void operator()(void* array) {{ *next++ = array; }}
}};

)";

void AppendVisit(std::string* out, const Member& member) {
  if (member.pointer || member.type == Scalar::kChar) return;
  if (member.structure != nullptr && member.array_size > 0) {
    Append(out, "  for (auto& element : structure.{}) Visit{}(element, visit);\n", member.name,
           member.structure->name);
  } else if (member.structure != nullptr) {
    Append(out, "  Visit{}(structure.{}, visit);\n", member.structure->name, member.name);
  } else if (member.array_size > 0) {
    Append(out, "  for (auto& element : structure.{}) visit(element);\n", member.name);
  } else {
    Append(out, "  visit(structure.{});\n", member.name);
  }
}

/// The same for pointers to arrays.
void AppendVisitOfArrays(std::string* out, const Member& member) {
  const bool several = member.array_size > 0;
  const std::string each = several ? "element" : fmt::format("structure.{}", member.name);
  std::string visit;
  if (member.pointer) visit = fmt::format("visit({})", each);
  if (member.structure != nullptr && !ArraysOf(*member.structure).empty()) {
    visit = fmt::format("Visit{}Arrays({}, visit)", member.structure->name, each);
  }
  if (visit.empty()) return;
  const std::string loop = fmt::format("for (auto& element : structure.{}) ", member.name);
  Append(out, "  {}{};\n", several ? loop : "", visit);
}

std::string StructureConversions(const InterfaceForm& form) {
  const Catalogue& catalogue = form.catalogue;
  std::string out;
  std::string module;
  AppendModuleInclude(&module, form);
  Append(&out, kStructuresHead, form.header, form.catalogue_file, module);
  std::string read_cases;
  std::string write_cases;
  std::string size_cases;
  std::string array_cases;
  for (const Structure& structure : catalogue.structures()) {
    const std::string_view name = structure.name;
    Append(&out,
           "template <typename S, typename Visitor>\n"
           "void Visit{}([[maybe_unused]] S& structure, [[maybe_unused]] Visitor& visit) {{\n",
           name);
    for (const Member& member : structure.members) AppendVisit(&out, member);
    out += "}\n\n";
    const bool has_arrays = !ArraysOf(structure).empty();
    if (has_arrays) {
      Append(&out,
             "template <typename S, typename Visitor>\n"
             "void Visit{}Arrays(const S& structure, Visitor& visit) {{\n",
             name);
      for (const Member& member : structure.members) AppendVisitOfArrays(&out, member);
      out += "}\n\n";
    }
    const auto number = &structure - catalogue.structures().data();
    Append(&read_cases,
           "    case {0}:\n      return Visit{1}(*static_cast<const {1}*>(host), visit);\n", number,
           name);
    Append(&write_cases, "    case {0}:\n      return Visit{1}(*static_cast<{1}*>(host), visit);\n",
           number, name);
    Append(&size_cases, "    case {}:\n      return sizeof({});\n", number, name);
    if (!has_arrays) continue;
    Append(&array_cases,
           "    case {0}:\n      return Visit{1}Arrays(*static_cast<const {1}*>(host), visit);\n",
           number, name);
  }
  const std::string position =
      fmt::format("&structure - gtcalls::{}().structures().data()", form.catalogue_function);
  Append(&out,
         "}}  // namespace\n\n"
         "size_t LongSize() {{ return sizeof({5}); }}\n\n"
         "void StructureToCells(const gtcalls::Structure& structure,\n"
         "                      [[maybe_unused]] const void* host, std::span<double> cells) {{\n"
         "  [[maybe_unused]] Reader visit{{cells.data()}};\n"
         "  switch ({3}) {{\n{0}    default:\n      return;\n"
         "  }}\n}}\n\n"
         "void StructureFromCells(const gtcalls::Structure& structure,\n"
         "                        std::span<const double> cells, [[maybe_unused]] void* host) {{\n"
         "  [[maybe_unused]] Writer visit{{cells.data()}};\n"
         "  switch ({3}) {{\n{1}    default:\n      return;\n"
         "  }}\n}}\n\n"
         "size_t StructureSize(const gtcalls::Structure& structure) {{\n"
         "  switch ({3}) {{\n{2}    default:\n      return 0;\n"
         "  }}\n}}\n\n"
         "void ArraysOfHost(const gtcalls::Structure& structure,\n"
         "                  [[maybe_unused]] const void* host, std::span<void*> arrays) {{\n"
         "  [[maybe_unused]] ArrayReader visit{{arrays.data()}};\n"
         "  switch ({3}) {{\n{4}    default:\n      return;\n"
         "  }}\n}}\n\n}}  // namespace oncard::runtime\n",
         read_cases, write_cases, size_cases, position, array_cases, form.spell(Scalar::kLong));
  return out;
}

// --- The page of the documentation --------------------------------------------------------------

std::string_view SpellCallers(const Command& command) {
  if (!command.in_motion_program) return "host";
  return command.on_host ? "host, program" : "program";
}

std::string Prototype(const InterfaceForm& form, const Command& command) {
  std::string prototype = std::string(command.name) + "(";
  for (const Parameter& parameter : ArgumentsOf(command)) {
    if (!prototype.ends_with("(")) prototype += ", ";
    prototype += DeclareParameter(parameter, form.spell);
    if (!parameter.default_text.empty()) Append(&prototype, " = {}", parameter.default_text);
  }
  return prototype + ")";
}

void AppendRow(std::string* out, const InterfaceForm& form, const Command& command) {
  std::string parameters;
  for (const Parameter& parameter : ArgumentsOf(command)) {
    const std::string description = Describe(parameter, command);
    if (description.empty()) continue;
    Append(&parameters, "{}`{}` {}", parameters.empty() ? "" : "<br>", parameter.name, description);
  }
  Append(out, "| {} | `{}` | {} | {} | {} | {} | {} |\n", command.number, Prototype(form, command),
         SpellCallers(command),
         command.tier == Tier::kA   ? "A"
         : command.tier == Tier::kB ? "B"
                                    : "X",
         command.brief, parameters, command.source);
}

/// The notes on a topic, a paragraph each.
void AppendNotes(std::string* out, const InterfaceForm& form, std::string_view topic) {
  bool of_topic = false;
  for (const TopicLine& line : form.topics) {
    if (!line.topic.empty()) of_topic = line.topic == topic;
    if (of_topic && !line.note.empty()) Append(out, "{}\n\n", line.note);
  }
}

std::string Markdown(const InterfaceForm& form) {
  std::string out(form.page_head);
  for (const Line& line : form.catalogue.lines()) {
    if (line.command != nullptr) {
      AppendRow(&out, form, *line.command);
      continue;
    }
    Append(&out, "\n## {}\n\n", line.topic);
    AppendNotes(&out, form, line.topic);
    out += "| no. | command | where | tier | what it does | parameters | source |\n";
    out += "|---|---|---|---|---|---|---|\n";
  }
  return out;
}

std::string_view SpellCallersZh(const Command& command) {
  if (!command.in_motion_program) return "主机";
  return command.on_host ? "主机、程序" : "程序";
}

/// The page in Chinese; a topic without a Chinese title keeps its own.
std::string MarkdownZh(const InterfaceForm& form) {
  std::string out(form.page_head_zh);
  for (const Line& line : form.catalogue.lines()) {
    if (line.command == nullptr) {
      const auto title = std::ranges::find(form.topics_zh, line.topic, &TopicTitle::topic);
      Append(&out, "\n## {}\n\n", title == form.topics_zh.end() ? line.topic : title->zh);
      out += "| 编号 | 指令 | 调用 | 功能 |\n|---|---|---|---|\n";
      continue;
    }
    const Command& command = *line.command;
    Append(&out, "| {} | `{}` | {} | {} |\n", command.number, Prototype(form, command),
           SpellCallersZh(command), command.brief_zh);
  }
  return out;
}

/// The types of the interface with a `long` of 32 bits.
std::string_view SpellWithLong32(Scalar scalar) {
  switch (scalar) {
    case Scalar::kLong:
      return "int";
    case Scalar::kUnsignedLong:
      return "unsigned";
    default:
      return SpellScalar(scalar);
  }
}

/// Empty for an unknown word.
std::string Write(const InterfaceForm& form, std::string_view what) {
  constexpr std::string_view kLong32 = "long32-";
  if (what.starts_with(kLong32)) {
    InterfaceForm narrow = form;
    narrow.spell = SpellWithLong32;
    return Write(narrow, what.substr(kLong32.size()));
  }
  if (what == "header") return Header(form);
  if (what == "module-header") return ModuleHeader(form);
  if (what == "entry-points") return EntryPoints(form, false);
  if (what == "multi-entry-points") return EntryPoints(form, true);
  if (what == "basic-entry-points") return BasicEntryPoints(form, false);
  if (what == "multi-basic-entry-points") return BasicEntryPoints(form, true);
  if (what == "exports-x64") return ModuleDefinition(form, {});
  if (what == "exports-x86") return ModuleDefinition(form, {.decorated = true});
  if (what == "multi-exports-x64") return ModuleDefinition(form, {.multi_card = true});
  if (what == "multi-exports-x86") {
    return ModuleDefinition(form, {.multi_card = true, .decorated = true});
  }
  if (what == "structures") return StructureConversions(form);
  if (what == "csharp") return CsharpDeclarations(form, false);
  if (what == "multi-csharp") return CsharpDeclarations(form, true);
  if (what == "markdown") return Markdown(form);
  if (what == "markdown-zh") return MarkdownZh(form);
  return {};
}

int Main(int argc, char** argv) {
  std::string text;
  for (const InterfaceForm* form : InterfaceForms()) {
    if (argc == 4 && form->catalogue.name() == argv[1]) text = Write(*form, argv[2]);
  }
  if (text.empty()) {
    fmt::print(stderr, "usage: generate_interface FAMILY WHAT FILE\n");
    return 2;
  }
  if (auto written = WriteFileAtomically(argv[3], text); !written.ok()) {
    fmt::print(stderr, "generate_interface: {}\n", written.error().message.en);
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace oncard::gtcalls

int main(int argc, char** argv) { return oncard::gtcalls::Main(argc, argv); }
