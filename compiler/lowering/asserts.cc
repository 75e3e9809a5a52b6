// Comments `//@ assert` of structured C. Each belongs to the next statement of its block, which
// emits it where its own statements begin, a loop where each pass begins. The names of a condition
// become those of the lowered variables.
#include <algorithm>

#include "compiler/asserts.h"
#include "compiler/lowering/lowerer.h"
#include "compiler/tree_walk.h"

namespace oncard::compiler::lowering {
namespace {

using StatementKind = Statement::Kind;

// Statements that a thread executes. Labels and the braces of a block are none.
bool IsExecuted(StatementKind kind) {
  return kind <= StatementKind::kContinue && kind != StatementKind::kCase &&
         kind != StatementKind::kDefault && kind != StatementKind::kLabel;
}

// The statement behind a comment in a function, in the innermost block around the comment.
const Statement* StatementBehind(const SourceRange& comment, const Function& function) {
  const Statement* behind = nullptr;
  uint32_t block_end = function.close_brace.begin;
  for (const StatementPtr& item : function.body) {
    ForEachStatement(*item, [&](const Statement& statement) {
      const SourceRange& range = statement.range;
      if (range.file != comment.file) return;
      if (statement.kind == StatementKind::kBlock && Contains(range, comment)) {
        block_end = std::min(block_end, range.end);
      }
      if (!IsExecuted(statement.kind) || range.begin < comment.end) return;
      if (behind == nullptr || range.begin < behind->range.begin) behind = &statement;
    });
  }
  return behind != nullptr && behind->range.begin < block_end ? behind : nullptr;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || IsDigit(c);
}

// The length of the name, or number with its fraction, with which a text begins; of other
// characters 1.
size_t WordLength(std::string_view text) {
  const bool number = IsDigit(text[0]);
  size_t length = 0;
  while (length < text.size() &&
         (IsNameCharacter(text[length]) || (number && text[length] == '.'))) {
    ++length;
  }
  return std::max(length, size_t{1});
}

// The next `[3]` of a text, which is then behind it.
std::optional<int64_t> TakeIndex(std::string_view* text) {
  constexpr size_t kDigitsMax = 9;
  std::string_view rest = *text;
  const auto skip_blanks = [&rest] {
    while (!rest.empty() && (rest[0] == ' ' || rest[0] == '\t')) rest.remove_prefix(1);
  };
  skip_blanks();
  if (!rest.starts_with('[')) return std::nullopt;
  rest.remove_prefix(1);
  skip_blanks();
  int64_t index = 0;
  size_t digits = 0;
  for (; !rest.empty() && IsDigit(rest[0]) && digits < kDigitsMax; ++digits) {
    index = index * 10 + (rest[0] - '0');
    rest.remove_prefix(1);
  }
  skip_blanks();
  if (digits == 0 || !rest.starts_with(']')) return std::nullopt;
  rest.remove_prefix(1);
  *text = rest;
  return index;
}

// The next `.m` of a text, which is then behind it; empty if there is none.
std::string_view TakeMember(std::string_view* text) {
  if (!text->starts_with('.') || text->size() == 1) return {};
  const std::string_view name = text->substr(1, WordLength(text->substr(1)));
  text->remove_prefix(1 + name.size());
  return name;
}

}  // namespace

void Lowerer::PlaceAsserts(const Tree& tree, const std::vector<AssertComment>& asserts) {
  for (const AssertComment& comment : asserts) {
    const auto around = std::ranges::find_if(tree.items, [&comment](const StatementPtr& item) {
      if (item->kind != StatementKind::kFunction || item->function->prototype) return false;
      SourceRange body = item->function->header;
      body.end = item->function->close_brace.end;
      return Contains(body, comment.range);
    });
    const bool in_function = around != tree.items.end();
    const Statement* behind =
        in_function ? StatementBehind(comment.range, *(*around)->function) : nullptr;
    if (behind == nullptr || comment.condition.empty()) {
      ReportAssert(comment, in_function, reporter_);
    } else {
      asserts_[behind].push_back(comment);
    }
  }
}

// True for a statement whose assert needs it, or a block with nothing else.
bool Lowerer::HasAssert(const Statement& statement) const {
  if (statement.kind == StatementKind::kBlock && statement.items.size() == 1) {
    return HasAssert(*statement.items[0]);
  }
  return asserts_.contains(&statement);
}

// What the indices and members behind a name name, without them; nullopt if that is no number
// whose place is known.
std::optional<ArrayPlace> Lowerer::NamedPlace(const Symbol& symbol, std::string_view* text) {
  if (!symbol.dimensions.empty() && !symbol.offset.IsConstant()) return std::nullopt;
  ArrayPlace place = {symbol.variable, symbol.offset, symbol.dimensions, symbol.type, {}};
  for (;;) {
    int64_t element = 0;
    for (const int64_t size : place.dimensions) {
      const std::optional<int64_t> index = TakeIndex(text);
      if (!index || (size > 0 && *index >= size)) return std::nullopt;
      element = element * size + *index;
    }
    place.offset.value += element;
    place.dimensions.clear();
    if (place.element.own == nullptr) return place;
    const std::string_view name = TakeMember(text);
    const OwnMember* const member = MemberOf(*place.element.own, name);
    if (member == nullptr) return std::nullopt;
    Narrow(place, *member, symbol.range);
  }
}

void Lowerer::EmitAsserts(const Statement& statement) {
  const auto found = asserts_.find(&statement);
  if (found == asserts_.end()) return;
  for (const AssertComment& comment : found->second) {
    Assertion assertion;
    assertion.comment = comment.range;
    assertion.written = comment.condition;
    Instruction instruction;
    instruction.kind = Instruction::Kind::kAssert;
    instruction.assertion = static_cast<int>(program_.assertions.size());
    std::string text;
    bool member = false;  // behind a '.', where names are not those of variables
    for (std::string_view rest = comment.condition; !rest.empty();) {
      const std::string_view word = rest.substr(0, WordLength(rest));
      const std::string_view from = rest;
      rest.remove_prefix(word.size());
      const bool name = IsNameCharacter(word[0]) && !IsDigit(word[0]) && !member;
      const Symbol* symbol = name ? Lookup(word) : nullptr;
      member = word == ".";
      const bool part = symbol != nullptr && rest.starts_with('.');
      const bool known = symbol != nullptr && IsUsable(*symbol, word) &&
                         symbol->kind != Symbol::Kind::kFunction &&
                         (!part || symbol->type.basic == BasicType::kStructure);
      if (!known) {
        text += word;
        continue;
      }
      if (symbol->kind == Symbol::Kind::kConstant) {
        text += '(' + symbol->constant.value.Text() + ')';
        continue;
      }
      const std::optional<ArrayPlace> place = NamedPlace(*symbol, &rest);
      if (!place) {
        Report(Code::kMisplacedAssert, comment.range,
               MakeMessage("names no element of '{0}' whose place is known",
                           "没有指明 '{0}' 中位置已知的元素", word));
        return;
      }
      Operand operand = VariableOperand(place->variable);
      int64_t element = -1;
      if (program_.variables[static_cast<size_t>(place->variable)].size > 0) {
        operand.kind = Operand::Kind::kElement;
        operand.value = element = place->offset.value;
      }
      assertion.texts.push_back(std::exchange(text, {}));
      assertion.names.emplace_back(from.substr(0, from.size() - rest.size()));
      assertion.elements.push_back(element);
      instruction.arguments.push_back(operand);
    }
    assertion.texts.push_back(std::move(text));
    program_.assertions.push_back(std::move(assertion));
    // It is no part of a full expression, whose accesses are a matter of atomicity.
    Emit(std::move(instruction), statement.range).statement = -1;
  }
}

}  // namespace oncard::compiler::lowering
