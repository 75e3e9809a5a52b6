#include "compiler/rewriter.h"

#include <algorithm>

#include "compiler/tree_walk.h"

namespace oncard::compiler {
namespace {

SourceRange Between(SourceRange first, uint32_t begin, uint32_t end) {
  return {first.file, begin, std::max(begin, end)};
}

// True if a case of a switch is nested deeper than the switch's own block.
bool HasInnerCase(const Statement& statement, bool direct) {
  const bool is_case =
      statement.kind == Statement::Kind::kCase || statement.kind == Statement::Kind::kDefault;
  if (is_case) return !direct;
  if (statement.kind == Statement::Kind::kSwitch) return false;
  for (const Statement* below : {statement.body.get(), statement.else_body.get()}) {
    if (below != nullptr && HasInnerCase(*below, false)) return true;
  }
  return std::any_of(statement.items.begin(), statement.items.end(),
                     [](const StatementPtr& item) { return HasInnerCase(*item, false); });
}

// The comments in a part of the source. Text in quotes is not a comment.
std::vector<std::string_view> CommentsIn(std::string_view text) {
  std::vector<std::string_view> comments;
  for (size_t i = 0; i + 1 < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      for (++i; i < text.size() && text[i] != c && text[i] != '\n'; ++i) {
        if (text[i] == '\\') ++i;
      }
    } else if (c == '/' && (text[i + 1] == '/' || text[i + 1] == '*')) {
      const bool block = text[i + 1] == '*';
      const size_t close = block ? text.find("*/", i + 2) : text.find_first_of("\r\n", i);
      const size_t end = std::min(close, text.size() - (block ? 2 : 0)) + (block ? 2 : 0);
      comments.push_back(text.substr(i, end - i));
      i = end - 1;
    }
  }
  return comments;
}

bool IsBlock(const Statement* statement) {
  return statement != nullptr && statement->kind == Statement::Kind::kBlock;
}

}  // namespace

// A line end with the indentation of the line that contains the range.
std::string Rewriter::Separator(SourceRange range) const {
  const SourceFile& file = context_.files[static_cast<size_t>(range.file)];
  const std::string_view line = file.Line(file.LineOf(range.begin));
  const size_t indent = std::min(line.find_first_not_of(" \t"), line.size());
  const bool carriage_return = file.text().find("\r\n") != std::string::npos;
  return (carriage_return ? "\r\n" : "\n") + std::string(line.substr(0, indent));
}

// Adds the comments of a range that is replaced to the lines, unless they are there already.
void Rewriter::KeepComments(SourceRange range, Comments where, Lines* lines) const {
  std::vector<std::string> kept;
  for (const std::string_view comment : CommentsIn(Source(range))) {
    const bool there = std::any_of(
        lines->begin(), lines->end(),
        [comment](const std::string& line) { return line.find(comment) != std::string::npos; });
    if (!there) kept.emplace_back(comment);
  }
  lines->insert(where == Comments::kFirst ? lines->begin() : lines->end(), kept.begin(),
                kept.end());
}

// Replaces a range by lines, with `before` and `after` around them.
void Rewriter::Substitute(SourceRange range, const Lines& lines, const std::string& separator,
                          std::string_view before, std::string_view after) {
  std::string text(before);
  for (size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) text += separator;
    text += lines[i];
  }
  const bool open_comment = !lines.empty() && lines.back().starts_with("//");
  if (open_comment && !after.starts_with('\n') && !after.starts_with('\r')) text += separator;
  text += after;
  edits_.push_back({range, std::move(text)});
}

void Rewriter::Finish() {
  // Declarations of temporaries come before statements: edits are kept in the order of the text.
  if (!declarations_.empty() && context_.function != nullptr) {
    const SourceRange at = context_.function->declarations_end;
    const bool after_brace = at.begin == context_.function->syntax->open_brace.end;
    const std::vector<StatementPtr>& body = context_.function->syntax->body;
    std::string separator = body.empty() ? "\n" : Separator(body.front()->range);
    if (after_brace && !body.empty() && separator == Separator(context_.function->syntax->header)) {
      separator += "  ";
    }
    // One edit each: a declaration that two fix-its need is inserted once.
    std::vector<FixIt> declarations;
    for (const std::string& declaration : declarations_) {
      declarations.push_back({at, separator + declaration});
    }
    edits_.insert(edits_.begin(), declarations.begin(), declarations.end());
  }
  for (FixIt& edit : edits_) diagnostic_.fixits.push_back(std::move(edit));
  edits_.clear();
  declarations_.clear();
}

lowering::FragmentContext Rewriter::Around() const {
  return {context_.options,
          context_.files,
          [this](std::string_view name) { return context_.Lookup(name); },
          context_.fresh,
          *context_.function->syntax,
          context_.function->is_void ? vm::DataType::kVoid : context_.function->out.return_type};
}

std::string Rewriter::OutputVariable(std::string_view base, vm::DataType type) {
  std::string name = context_.fresh.Make(base);
  AddDeclaration(fmt::format("{} {};", vm::TypeName(type), name));
  return name;
}

void Rewriter::Declare(lowering::Fragment& fragment) {
  for (std::string& declaration : fragment.declarations) AddDeclaration(std::move(declaration));
}

std::optional<lowering::Fragment> Rewriter::Initialise(
    const std::vector<const Declarator*>& declarators) {
  for (const Declarator* declarator : declarators) {
    const Entity* entity = context_.Lookup(declarator->name);
    if (entity == nullptr || entity->structure == nullptr) continue;
    AddNote(diagnostic_, MakeMessage("assign the members of '{0}' one by one in statements",
                                     "请用语句逐个给 '{0}' 的成员赋值", declarator->name));
    return std::nullopt;
  }
  std::optional<lowering::Fragment> fragment = lowering::LowerInitialValues(Around(), declarators);
  if (fragment) Declare(*fragment);
  return fragment;
}

bool Rewriter::InitialiseFirst(const std::vector<const Declarator*>& declarators) {
  const std::optional<lowering::Fragment> fragment = Initialise(declarators);
  if (!fragment) return false;
  SourceRange at = context_.function->statements_begin;
  at.end = at.begin;
  const bool at_end = at.begin == context_.function->syntax->close_brace.begin;
  const std::string separator = Separator(at);
  std::string text;
  for (const std::string& line : fragment->parts[0].lines) {
    if (at_end) text += "  ";
    text += line;
    text += separator;
  }
  if (!text.empty()) edits_.push_back({at, std::move(text)});
  return true;
}

void Rewriter::ReplaceDeclaration(const Statement& statement,
                                  const std::vector<const Declarator*>& declarators,
                                  const Place& place) {
  std::optional<lowering::Fragment> fragment = Initialise(declarators);
  if (!fragment) return;
  ReplaceWhole(statement.range, std::move(fragment->parts[0].lines), place);
  Finish();
}

// A return code that is never used can be dropped.
bool Rewriter::DropResult(const Expression& target) {
  const std::string_view name = BaseName(target);
  const Entity* entity = context_.Lookup(name);
  if (entity == nullptr || HasEffects(target)) return false;
  if (entity->storage == vm::Storage::kGlobal) {
    AddNote(diagnostic_,
            MakeMessage("the host may read the global '{0}'; let it read TThreadSts.error instead, "
                        "then remove '{0} ='",
                        "主机可能读取全局变量 '{0}'；请改为查看 TThreadSts.error，再去掉 '{0} ='",
                        name));
    return false;
  }
  const Expression* read = context_.UsesInFunction(name).first_read;
  if (read == nullptr) return true;
  AddNote(diagnostic_, read->range,
          MakeMessage("'{0}' is read here, but a motion program cannot see return codes; remove "
                      "this use, the host finds the code in TThreadSts.error",
                      "此处使用了 '{0}'，但运动程序看不到返回值；请去掉此处的使用，主机可在 "
                      "TThreadSts.error 中查看返回值",
                      name));
  return false;
}

// False if the code that a command returns is needed: the card does not give it.
bool Rewriter::DropResults(const Statement& statement) {
  if (statement.initial != nullptr && !DropResults(*statement.initial)) return false;
  bool good = true;
  ForEachWholeExpression(statement, [this, &good](const Expression& whole) {
    ForEachExpression(whole, [this, &good](const Expression& expression) {
      if (!good || expression.kind != Expression::Kind::kAssign) return;
      const Expression* value = expression.operands[1].get();
      while (value->kind == Expression::Kind::kParen) value = value->operands[0].get();
      const bool returned = value->kind == Expression::Kind::kCall &&
                            value->operands[0]->kind == Expression::Kind::kName &&
                            context_.catalogue.Find(value->operands[0]->text) != nullptr;
      if (returned) good = DropResult(*expression.operands[0]);
    });
  });
  return good;
}

// False for a block without a closing brace, which ends at the end of the file.
bool Rewriter::HasBothBraces(const Statement& block) const {
  const std::string_view text = Source(block.range);
  return text.size() >= 2 && text.front() == '{' && text.back() == '}';
}

// False for a block whose braces cannot be removed.
bool Rewriter::CanOpen(const Statement* body) const {
  return !IsBlock(body) || (HasBothBraces(*body) && !context_.NeedsBraces(*body));
}

void Rewriter::Rewrite(const Statement& statement, const Place& place) {
  if (!CanOpen(statement.body.get()) || !CanOpen(statement.else_body.get())) return;
  if (statement.kind == Statement::Kind::kSwitch &&
      std::any_of(statement.body->items.begin(), statement.body->items.end(),
                  [](const StatementPtr& item) { return HasInnerCase(*item, true); })) {
    AddNote(diagnostic_,
            MakeMessage("this case is inside another statement; move it into the block of the "
                        "switch itself",
                        "有 case 位于其它语句内部；请把它移到 switch 自己的语句块中"));
    return;
  }
  if (!DropResults(statement)) return;
  std::optional<lowering::Fragment> fragment = lowering::LowerFragment(Around(), statement);
  if (!fragment) return;
  Declare(*fragment);
  // A label needs a statement after it.
  Lines& last = fragment->parts.back().lines;
  if (!place.followed && !last.empty() && last.back().ends_with(':')) last.emplace_back("return;");
  if (fragment->parts.size() == 1) {
    ReplaceWhole(statement.range, std::move(last), place);
  } else {
    ReplaceAround(statement, std::move(*fragment), place);
  }
  Finish();
}

void Rewriter::ReplaceWhole(SourceRange range, Lines lines, const Place& place) {
  // A label before it needs a statement.
  if (lines.empty()) lines.emplace_back(";");
  KeepComments(range, Comments::kFirst, &lines);
  const bool braces = place.single && lines.size() > 1;
  Substitute(range, lines, Separator(range), braces ? "{ " : "", braces ? " }" : "");
}

// Replaces what is before, between and after the bodies of a statement, with the bodies' braces.
void Rewriter::ReplaceAround(const Statement& statement, lowering::Fragment fragment,
                             const Place& place) {
  const std::string separator = Separator(statement.range);
  const std::string open = place.single ? "{ " : "";
  const std::string close = place.single ? " }" : "";
  const Statement* previous = nullptr;
  for (lowering::Fragment::Part& part : fragment.parts) {
    const Statement* const next = part.body;
    const uint32_t begin = previous == nullptr ? statement.range.begin
                           : IsBlock(previous) ? previous->range.end - 1
                                               : previous->range.end;
    const uint32_t end = next == nullptr ? statement.range.end
                         : IsBlock(next) ? next->range.begin + 1
                                         : next->range.begin;
    const SourceRange range = Between(statement.range, begin, end);
    KeepComments(range, next != nullptr ? Comments::kLast : Comments::kFirst, &part.lines);
    // Braces leave line ends, bodies without them do not.
    const std::string line_end = part.lines.empty() ? "" : separator;
    const std::string before = previous == nullptr ? open : IsBlock(previous) ? "" : line_end;
    const std::string after = next == nullptr ? close : IsBlock(next) ? "" : line_end;
    Substitute(range, part.lines, separator, before, after);
    previous = next;
  }
  std::move(fragment.edits.begin(), fragment.edits.end(), std::back_inserter(edits_));
  std::stable_sort(edits_.begin(), edits_.end(),
                   [](const FixIt& a, const FixIt& b) { return a.range.begin < b.range.begin; });
}

void Rewriter::RewriteBlock(const Statement& statement) {
  if (!HasBothBraces(statement) || context_.NeedsBraces(statement)) return;
  edits_.push_back(
      {Between(statement.range, statement.range.begin, statement.range.begin + 1), ""});
  edits_.push_back({Between(statement.range, statement.range.end - 1, statement.range.end), ""});
  Finish();
}

}  // namespace oncard::compiler
