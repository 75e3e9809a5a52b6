#include "editor/places.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/files.h"
#include "compiler/fix_it_applier.h"
#include "compiler/lexer.h"
#include "compiler/parser.hh"
#include "compiler/reporter.h"
#include "vm/limits.h"

namespace oncard::editor {
namespace {

using compiler::SourceRange;

std::string_view AccessName(Reference::Access access) {
  switch (access) {
    case Reference::Access::kRead:
      return "read";
    case Reference::Access::kWrite:
      return "write";
    case Reference::Access::kReadWrite:
      return "read-write";
    case Reference::Access::kCall:
      return "call";
    case Reference::Access::kDeclaration:
      break;
  }
  return "declaration";
}

/// The symbols that the name at a place means: several in a macro that is used in several places.
std::vector<int> SymbolsAt(const Analysis& analysis, Cursor cursor) {
  std::vector<int> symbols;
  const Reference* reference = analysis.names.At(cursor.file, cursor.offset);
  if (reference == nullptr || InComment(analysis.text, cursor)) return symbols;
  for (const Reference& each : analysis.names.Meanings(*reference)) symbols.push_back(each.symbol);
  return symbols;
}

// --- New names -----------------------------------------------------------------------------------

Error Refuse(Message why) { return Error{1, std::move(why)}; }

/// Why a text cannot be a name at all.
std::optional<Error> RefuseWord(const Analysis& analysis, const std::string& name) {
  compiler::Reporter reporter;
  const compiler::SourceFile file("", name);
  const auto tokens =
      compiler::Tokenize(file, 0, 2, analysis.text.catalogue(), reporter, analysis.text.dialect());
  const bool word = tokens.size() == 1 && tokens[0].text == name && compiler::IsWord(tokens[0]);
  if (!word) {
    return Refuse(
        MakeMessage("'{0}' is no name: a name has letters, digits and '_', and does not "
                    "begin with a digit",
                    "“{0}”不是名称：名称由字母、数字和“_”组成，且不以数字开头", name));
  }
  if (tokens[0].kind != compiler::Parser::token::kName) {
    return Refuse(MakeMessage("'{0}' is a word of the language; choose another name",
                              "“{0}”是语言的保留字；请换一个名称", name));
  }
  if (analysis.text.catalogue().Find(name) != nullptr) {
    return Refuse(MakeMessage("'{0}' is a GT command; choose another name",
                              "“{0}”是 GT 指令；请换一个名称", name));
  }
  if (!analysis.text.structured() && name.size() > vm::kNameLengthMax) {
    return Refuse(MakeMessage("'{0}' has {1} characters; a name has at most {2}",
                              "“{0}”有 {1} 个字符；名称最多 {2} 个字符", name, name.size(),
                              vm::kNameLengthMax));
  }
  return std::nullopt;
}

int ErrorCount(const compiler::Compilation& compilation) {
  return static_cast<int>(std::ranges::count(compilation.diagnostics, compiler::Severity::kError,
                                             &compiler::Diagnostic::severity));
}

/// Where a name means something else after it was changed; empty if every one means the same.
std::optional<Error> RefuseOtherMeaning(const Analysis& before, const Analysis& after,
                                        const std::string& name) {
  const auto& old_places = before.names.references();
  const auto& new_places = after.names.references();
  std::map<int, int> to_new;
  std::map<int, int> to_old;
  for (size_t i = 0; i < std::max(old_places.size(), new_places.size()); ++i) {
    const bool both = i < old_places.size() && i < new_places.size();
    const bool same =
        both && old_places[i].range.file == new_places[i].range.file &&
        to_new.try_emplace(old_places[i].symbol, new_places[i].symbol).first->second ==
            new_places[i].symbol &&
        to_old.try_emplace(new_places[i].symbol, old_places[i].symbol).first->second ==
            old_places[i].symbol;
    if (same) continue;
    const Analysis& shown = i < new_places.size() ? after : before;
    const SourceRange range = i < new_places.size() ? new_places[i].range : old_places[i].range;
    const compiler::SourceFile& file = shown.text.file(range.file).file;
    return Refuse(
        MakeMessage("'{0}' would mean something else in line {1} of {2}: the name is "
                    "taken; choose another one",
                    "名称“{0}”已被使用，{2} 第 {1} 行的含义会因此改变；请换一个名称", name,
                    file.LineOf(range.begin), file.path()));
  }
  return std::nullopt;
}

}  // namespace

Json Definition(const Analysis& analysis, Cursor cursor) {
  Json places = Json::array();
  for (const int index : SymbolsAt(analysis, cursor)) {
    const Symbol& symbol = analysis.names.symbol(index);
    const bool defined = std::ranges::any_of(symbol.declarations, &Symbol::Declaration::definition);
    for (const Symbol::Declaration& declaration : symbol.declarations) {
      if (defined && !declaration.definition) continue;
      places.push_back(RangeJson(analysis.text, declaration.name));
    }
  }
  return places;
}

Json References(const Analysis& analysis, Cursor cursor, bool declarations) {
  const std::vector<int> symbols = SymbolsAt(analysis, cursor);
  Json places = Json::array();
  for (const Reference& each : analysis.names.references()) {
    if (std::ranges::find(symbols, each.symbol) == symbols.end()) continue;
    if (each.access == Reference::Access::kDeclaration && !declarations) continue;
    places.push_back(RangeJson(analysis.text, each.range));
    places.back()["access"] = AccessName(each.access);
  }
  return places;
}

Result<Json> Rename(const Analysis& analysis, const ProgramFiles& program, Cursor cursor,
                    const std::string& name) {
  const std::vector<int> symbols = SymbolsAt(analysis, cursor);
  if (symbols.empty()) {
    return Refuse({"there is no name here that the program declares", "此处没有程序所声明的名称"});
  }
  const Symbol& symbol = analysis.names.symbol(symbols.front());
  if (symbol.kind == Symbol::Kind::kCommand) {
    return Refuse(MakeMessage("'{0}' is a GT command: its name cannot be changed",
                              "“{0}”是 GT 指令，不能重命名", symbol.name));
  }
  if (auto refused = RefuseWord(analysis, name)) return *std::move(refused);
  Json edits = Json::array();
  if (symbol.name == name) return edits;

  std::map<int, std::vector<compiler::FixIt>> edits_of_file;
  for (const Reference& each : analysis.names.references()) {
    if (each.symbol != symbols.front()) continue;
    if (analysis.names.Meanings(each).size() > 1 || symbols.size() > 1) {
      return Refuse(
          MakeMessage("'{0}' stands in a macro that is used where it means different things",
                      "“{0}”出现在宏中，而该宏在不同位置所指的含义不同", symbol.name));
    }
    edits_of_file[each.range.file].push_back({each.range, name});
    edits.push_back(RangeJson(analysis.text, each.range));
    edits.back()["text"] = name;
  }

  std::map<std::string, std::string> changed;
  for (auto& [file, list] : edits_of_file) {
    const compiler::SourceFile& source = analysis.text.file(file).file;
    changed[source.path()] = compiler::ApplyEdits(source.text(), std::move(list));
  }
  const auto reader = [&](const std::string& path) -> Result<std::string> {
    const auto found = changed.find(path);
    if (found != changed.end()) return found->second;
    return program.reader ? program.reader(path)
                          : Result<std::string>(MakeError(kNoSuchFile, "no file", "没有文件"));
  };
  const auto main = changed.find(program.path);
  const std::string text = main != changed.end() ? main->second : program.text;
  const Analysis renamed(program.path, text, program.options, reader);
  if (auto refused = RefuseOtherMeaning(analysis, renamed, name)) return *std::move(refused);

  // Errors that are not shown, or one in place of all the others, would hide those of the new name.
  compiler::Options options = program.options;
  options.max_errors = 0;
  options.recognize_structured = false;
  const auto before = compiler::CompileText(program.path, program.text, options, program.reader);
  const auto after = compiler::CompileText(program.path, text, options, reader);
  if (ErrorCount(after) > ErrorCount(before)) {
    const auto first =
        std::ranges::find_if(after.diagnostics, [&name](const compiler::Diagnostic& each) {
          return each.severity == compiler::Severity::kError &&
                 each.message.en.find(name) != std::string::npos;
        });
    const compiler::Diagnostic& shown =
        first != after.diagnostics.end() ? *first : after.diagnostics.front();
    return Refuse(shown.message);
  }
  return edits;
}

}  // namespace oncard::editor
