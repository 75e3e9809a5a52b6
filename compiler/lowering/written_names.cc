#include "compiler/lowering/written_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "vm/symbol_names.h"

namespace oncard::compiler::lowering {
namespace {

// The symbols of a variable, whose slots are not known yet.
std::vector<vm::Symbol> SymbolsOf(const Variable& variable) {
  vm::Symbol symbol;
  symbol.name = variable.name;
  symbol.array_size = static_cast<uint16_t>(variable.size);
  symbol.written = variable.written;
  if (variable.structure == nullptr) return {symbol};
  if (variable.member > 0) return {};
  std::vector<vm::Symbol> members;
  for (const gtcalls::Member& member : variable.structure->members) {
    symbol.name = fmt::format("{}.{}", variable.name, member.name);
    if (!variable.written.empty()) {
      symbol.written = fmt::format("{}.{}", variable.written, member.name);
    }
    members.push_back(symbol);
  }
  return members;
}

// How the lowered program calls what a name of C names: an element, or whole variables. Empty for
// what it has no name for.
std::string LoweredName(const std::vector<vm::Symbol>& symbols, std::string_view name) {
  const auto found = vm::FindNamed(symbols, name);
  if (!found.ok() || found.value().empty()) return {};
  const vm::NamedSlots& first = found.value().front();
  if (first.is_number) {
    const bool one = std::ranges::all_of(found.value(), [&first](const vm::NamedSlots& slots) {
      return slots.symbol->name == first.symbol->name;
    });
    if (!one) return {};
    return first.symbol->array_size == 0 ? first.symbol->name
                                         : fmt::format("{}[{}]", first.symbol->name, first.first);
  }
  std::vector<std::string_view> names;
  int named = 0;
  int all = 0;
  for (const vm::NamedSlots& slots : found.value()) {
    named += slots.count;
    if (std::ranges::find(names, slots.symbol->name) != names.end()) continue;
    names.emplace_back(slots.symbol->name);
    all += slots.symbol->slots();
  }
  return named == all ? fmt::to_string(fmt::join(names, ", ")) : std::string();
}

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The length of the name with members and indices with which a text begins; 0 for another text.
size_t NameLength(std::string_view text) {
  size_t length = 0;
  while (length < text.size()) {
    const char c = text[length];
    const bool first = length == 0 || text[length - 1] == '.';
    const bool dot = c == '.' && length + 1 < text.size() && IsLetter(text[length + 1]);
    if (IsLetter(c) || (!first && (dot || IsDigit(c)))) {
      ++length;
    } else if (c == '[' && !first) {
      const size_t close = text.find_first_not_of("0123456789", length + 1);
      if (close == std::string_view::npos || close == length + 1 || text[close] != ']') break;
      length = close + 1;
    } else {
      break;
    }
  }
  return length;
}

// The part `page3.` of a name; empty if there is none.
std::string_view PagePart(std::string_view name) {
  constexpr std::string_view kPage = "page";
  const size_t dot = name.find('.');
  if (!name.starts_with(kPage) || dot == std::string_view::npos || dot == kPage.size()) return {};
  const std::string_view number = name.substr(kPage.size(), dot - kPage.size());
  return std::ranges::all_of(number, IsDigit) ? name.substr(0, dot + 1) : std::string_view();
}

}  // namespace

void WriteNames(const Program& program, const std::vector<int>& variables,
                std::vector<vm::Symbol>* symbols) {
  std::unordered_map<std::string, std::string> written;
  for (const int number : variables) {
    const Variable& variable = program.variables[static_cast<size_t>(number)];
    if (variable.written.empty()) continue;
    for (vm::Symbol& symbol : SymbolsOf(variable)) {
      written.emplace(std::move(symbol.name), std::move(symbol.written));
    }
  }
  for (vm::Symbol& symbol : *symbols) {
    const auto found = written.find(symbol.name);
    if (found != written.end()) symbol.written = found->second;
  }
}

std::string NameAsLowered(const Program& program, std::string_view comment) {
  std::vector<vm::Symbol> globals;
  std::vector<vm::Symbol> locals;
  for (const Variable& variable : program.variables) {
    std::vector<vm::Symbol>& scope = variable.role == Variable::Role::kGlobal ? globals : locals;
    for (vm::Symbol& symbol : SymbolsOf(variable)) scope.push_back(std::move(symbol));
  }
  // What must hold stands behind a key.
  const size_t key = std::min(comment.find(':'), comment.size());
  std::string text(comment.substr(0, key));
  comment.remove_prefix(key);
  while (!comment.empty()) {
    const size_t length = NameLength(comment);
    const std::string_view name = comment.substr(0, length);
    if (length == 0) {
      // A number with its letters is no name.
      const size_t digits = IsDigit(comment[0]) ? comment.find_first_of(" =<>+-*!)&|,", 1) : 1;
      const size_t end = std::min(digits, comment.size());
      text += comment.substr(0, end);
      comment.remove_prefix(end);
      continue;
    }
    const std::string_view page = PagePart(name);
    const std::string lowered =
        LoweredName(page.empty() ? globals : locals, name.substr(page.size()));
    text += lowered.empty() ? std::string(name) : fmt::format("{}{}", page, lowered);
    comment.remove_prefix(length);
  }
  return text;
}

}  // namespace oncard::compiler::lowering
