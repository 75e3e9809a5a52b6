// Statements: rewrites loops and branches with goto, and makes the edits of the text.
#include <algorithm>

#include "compiler/rewriter.h"

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

// True if the condition is one comparison or one variable.
bool IsOneCondition(const Expression& condition) {
  const Expression* inner = &condition;
  while (inner->kind == Expression::Kind::kParen ||
         (inner->kind == Expression::Kind::kUnary && inner->op == "!")) {
    inner = inner->operands[0].get();
  }
  return inner->op != "&&" && inner->op != "||" && inner->kind != Expression::Kind::kComma;
}

}  // namespace

// A line end with the indentation of the line that contains the range.
std::string Rewriter::Separator(SourceRange range) const {
  const SourceFile& file = checker_.files_[static_cast<size_t>(range.file)];
  const std::string_view line = file.Line(file.LineOf(range.begin));
  const size_t indent = std::min(line.find_first_not_of(" \t"), line.size());
  const bool carriage_return = file.text().find("\r\n") != std::string::npos;
  return (carriage_return ? "\r\n" : "\n") + std::string(line.substr(0, indent));
}

// Adds the comments of a range that is replaced to the collected lines.
void Rewriter::KeepComments(SourceRange range, Comments where) {
  std::vector<std::string> kept;
  for (const std::string_view comment : CommentsIn(Source(range))) {
    const bool there = std::any_of(
        lines_.begin(), lines_.end(),
        [comment](const std::string& line) { return line.find(comment) != std::string::npos; });
    if (!there) kept.emplace_back(comment);
  }
  lines_.insert(where == Comments::kFirst ? lines_.begin() : lines_.end(), kept.begin(),
                kept.end());
}

// Replaces a range by the collected lines, with `before` and `after` around them.
void Rewriter::Substitute(SourceRange range, const Statement& near, std::string_view before,
                          std::string_view after) {
  const std::string separator = Separator(near.range);
  std::string text(before);
  for (size_t i = 0; i < lines_.size(); ++i) {
    if (i > 0) text += separator;
    text += lines_[i];
  }
  const bool open_comment = !lines_.empty() && lines_.back().starts_with("//");
  if (open_comment && !after.starts_with('\n') && !after.starts_with('\r')) text += separator;
  text += after;
  lines_.clear();
  edits_.push_back({range, std::move(text)});
}

void Rewriter::Finish() {
  if (!ok_) return;
  // Declarations of temporaries come before statements: edits are kept in the order of the text.
  if (!declarations_.empty() && checker_.function_ != nullptr) {
    const SourceRange at = checker_.function_->declarations_end;
    const bool after_brace = at.begin == checker_.function_->syntax->open_brace.end;
    const std::vector<StatementPtr>& body = checker_.function_->syntax->body;
    std::string separator = body.empty() ? "\n" : Separator(body.front()->range);
    if (after_brace && !body.empty() &&
        separator == Separator(checker_.function_->syntax->header)) {
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

void Rewriter::AddDeclaration(std::string text) { declarations_.push_back(std::move(text)); }

void Rewriter::InsertAtFirstStatement() {
  SourceRange at = checker_.function_->statements_begin;
  at.end = at.begin;
  const bool at_end = at.begin == checker_.function_->syntax->close_brace.begin;
  const std::string separator = Separator(at);
  std::string text;
  for (const std::string& line : lines_) {
    if (at_end) text += "  ";
    text += line;
    text += separator;
  }
  lines_.clear();
  if (!text.empty()) edits_.push_back({at, std::move(text)});
  Finish();
}

void Rewriter::ReplaceStatement(SourceRange range, const Place& place) {
  if (!ok_) return;
  Statement near;
  near.range = range;
  // A label before it needs a statement.
  if (lines_.empty()) lines_.emplace_back(";");
  KeepComments(range, Comments::kFirst);
  if (place.single && lines_.size() > 1) {
    Substitute(range, near, "{ ", " }");
  } else {
    Substitute(range, near, "", "");
  }
  Finish();
}

void Rewriter::EmitEndLabel(const std::string& label, const Place& place) {
  EmitLabel(label);
  if (!place.followed) Emit("return;");
}

void Rewriter::RewriteSimple(const Statement& statement, const Place& place) {
  switch (statement.kind) {
    case Statement::Kind::kExpression:
      LowerEffect(*statement.value);
      break;
    case Statement::Kind::kReturn: {
      Value value = Lower(*statement.value);
      if (!ok_) return;
      value = Operand(Converted(std::move(value), checker_.function_->out.return_type));
      Emit(fmt::format("return {};", value.text));
      break;
    }
    case Statement::Kind::kIf: {
      const Statement& body = *statement.body;
      if (body.kind == Statement::Kind::kGoto) {
        JumpIf(*statement.value, false, std::string(body.name));
        break;
      }
      const vm::DataType type = checker_.function_->out.return_type;
      const bool plain_value =
          body.value == nullptr || (IsPlainOperand(*body.value) && TypeOf(*body.value) == type);
      if (plain_value && IsOneCondition(*statement.value)) {
        const Condition condition = LowerCondition(*statement.value, false);
        if (!ok_) return;
        std::string text(Source(body.range));
        if (text.back() != ';') text += ';';
        if (!condition.constant) {
          Emit(fmt::format("if ({}) {}", condition.variable, text));
        } else if (condition.truth) {
          Emit(std::move(text));
        }
        break;
      }
      // The value of `return` must not be computed if the condition does not hold.
      const std::string skip = Label("lbl_skip");
      JumpIf(*statement.value, true, skip);
      if (body.value == nullptr) {
        Emit("return;");
      } else {
        Value value = Lower(*body.value);
        if (!ok_) return;
        value = Operand(Converted(std::move(value), type));
        Emit(fmt::format("return {};", value.text));
      }
      EmitLabel(skip);
      break;
    }
    default:
      ok_ = false;
  }
  ReplaceStatement(statement.range, place);
}

// False for a block without a closing brace, which ends at the end of the file.
bool Rewriter::HasBothBraces(const Statement& block) const {
  const std::string_view text = Source(block.range);
  return text.size() >= 2 && text.front() == '{' && text.back() == '}';
}

// From `first` to the beginning of the body, including a block's brace.
SourceRange Rewriter::Head(SourceRange first, const Statement& body) {
  const bool block = body.kind == Statement::Kind::kBlock;
  if (block && (!HasBothBraces(body) || checker_.NeedsBraces(body))) ok_ = false;
  return Between(first, first.begin, block ? body.range.begin + 1 : body.range.begin);
}

// From the end of the body to the end of `last`, including a block's brace.
SourceRange Rewriter::Tail(const Statement& body, SourceRange last) {
  const bool block = body.kind == Statement::Kind::kBlock;
  if (block && (!HasBothBraces(body) || checker_.NeedsBraces(body))) ok_ = false;
  return Between(body.range, block ? body.range.end - 1 : body.range.end, last.end);
}

void Rewriter::SubstituteHead(const Statement& statement, const Statement& body,
                              std::string_view before, std::string_view after) {
  const SourceRange head = Head(statement.range, body);
  KeepComments(head, Comments::kLast);
  Substitute(head, statement, before, after);
}

void Rewriter::SubstituteTail(const Statement& body, const Statement& statement,
                              std::string_view before, std::string_view after) {
  const SourceRange tail = Tail(body, statement.range);
  KeepComments(tail, Comments::kFirst);
  Substitute(tail, statement, before, after);
}

void Rewriter::FindJumps(const Statement& statement, const std::string& break_label,
                         const std::string& continue_label, Jumps* jumps) {
  const bool is_break = statement.kind == Statement::Kind::kBreak && !break_label.empty();
  const bool is_continue = statement.kind == Statement::Kind::kContinue && !continue_label.empty();
  if (is_break || is_continue) {
    (is_break ? jumps->breaks : jumps->continues) = true;
    edits_.push_back(
        {statement.range, fmt::format("goto {};", is_break ? break_label : continue_label)});
    return;
  }
  const bool loop = statement.kind == Statement::Kind::kWhile ||
                    statement.kind == Statement::Kind::kDo ||
                    statement.kind == Statement::Kind::kFor;
  if (loop) return;
  // A switch is the target of `break`, but not of `continue`.
  const std::string inner_break =
      statement.kind == Statement::Kind::kSwitch ? std::string() : break_label;
  if (statement.body != nullptr) {
    FindJumps(*statement.body, inner_break, continue_label, jumps);
  }
  if (statement.else_body != nullptr) {
    FindJumps(*statement.else_body, inner_break, continue_label, jumps);
  }
  for (const StatementPtr& item : statement.items) {
    FindJumps(*item, inner_break, continue_label, jumps);
  }
}

Rewriter::Jumps Rewriter::ReplaceJumps(const Statement& body, const std::string& break_label,
                                       const std::string& continue_label) {
  Jumps jumps;
  FindJumps(body, break_label, continue_label, &jumps);
  return jumps;
}

void Rewriter::RewriteLoop(const Statement& statement, const Place& place) {
  const std::string_view open = place.single ? "{ " : "";
  const std::string_view close = place.single ? " }" : "";
  const Statement& body = *statement.body;
  const bool is_do = statement.kind == Statement::Kind::kDo;
  const bool is_while = statement.kind == Statement::Kind::kWhile;
  const std::string separator = Separator(statement.range);
  const std::string loop = Label("lbl_loop");
  const std::string end = Label("lbl_end");
  const std::string next = is_while ? loop : Label("lbl_next");

  if (statement.initial != nullptr) {
    const Statement& initial = *statement.initial;
    if (initial.kind == Statement::Kind::kExpression) LowerEffect(*initial.value);
    for (const Declarator& declarator : initial.declarators) {
      const Entity* entity = checker_.function_->locals.Find(declarator.name);
      if (entity == nullptr) {
        ok_ = false;
      } else if (declarator.initialiser != nullptr) {
        Initialise(declarator, *entity);
      }
    }
  }
  EmitLabel(loop);
  bool leaves = false;  // the condition can jump to the end
  if (!is_do && statement.value != nullptr) {
    const size_t before = lines_.size();
    JumpIf(*statement.value, true, end);
    leaves = lines_.size() > before;
  }
  if (!ok_) return;
  const bool block = body.kind == Statement::Kind::kBlock;
  SubstituteHead(statement, body, open, block ? "" : separator);
  const Jumps jumps = ReplaceJumps(body, end, next);

  if (jumps.continues && !is_while) EmitLabel(next);
  if (is_do) {
    JumpIf(*statement.value, false, loop);
  } else {
    if (statement.step != nullptr) LowerEffect(*statement.step);
    Emit(fmt::format("goto {};", loop));
  }
  if (!ok_) return;
  if (lines_.empty() || lines_.back().back() == ':' || jumps.breaks || leaves) {
    EmitEndLabel(end, place);
  }
  SubstituteTail(body, statement, block ? "" : separator, close);
  Finish();
}

void Rewriter::RewriteIf(const Statement& statement, const Place& place) {
  const std::string_view open = place.single ? "{ " : "";
  const std::string_view close = place.single ? " }" : "";
  const Statement& body = *statement.body;
  const bool block = body.kind == Statement::Kind::kBlock;
  const std::string separator = Separator(statement.range);
  const std::string end = Label("lbl_end");
  if (statement.else_body == nullptr) {
    JumpIf(*statement.value, true, end);
    if (!ok_) return;
    SubstituteHead(statement, body, open, block ? "" : separator);
    EmitEndLabel(end, place);
    SubstituteTail(body, statement, block ? "" : separator, close);
    Finish();
    return;
  }
  const Statement& other = *statement.else_body;
  const bool other_block = other.kind == Statement::Kind::kBlock;
  const std::string otherwise = Label("lbl_else");
  JumpIf(*statement.value, true, otherwise);
  if (!ok_) return;
  SubstituteHead(statement, body, open, block ? "" : separator);
  Emit(fmt::format("goto {};", end));
  EmitLabel(otherwise);
  const SourceRange middle = Between(body.range, block ? body.range.end - 1 : body.range.end,
                                     other_block ? other.range.begin + 1 : other.range.begin);
  KeepComments(middle, Comments::kLast);
  Substitute(middle, statement, block ? "" : separator, other_block ? "" : separator);
  EmitEndLabel(end, place);
  SubstituteTail(other, statement, other_block ? "" : separator, close);
  Finish();
}

void Rewriter::RewriteSwitch(const Statement& statement, const Place& place) {
  const std::string_view open = place.single ? "{ " : "";
  const std::string_view close = place.single ? " }" : "";
  const Statement& body = *statement.body;
  if (std::any_of(body.items.begin(), body.items.end(),
                  [](const StatementPtr& item) { return HasInnerCase(*item, true); })) {
    Refuse(MakeMessage(
        "this case is inside another statement; move it into the block of the switch itself",
        "有 case 位于其它语句内部；请把它移到 switch 自己的语句块中"));
    return;
  }
  const std::string end = Label("lbl_end");
  Value value = Operand(Lower(*statement.value));
  if (!ok_ || value.type != vm::DataType::kInt) return;
  if (value.literal) {
    const std::string variable = Temporary("tmp", vm::DataType::kInt);
    Emit(fmt::format("{} = {};", variable, value.text));
    value.text = variable;
  }
  const std::string condition = ConditionVariable();
  std::string otherwise;
  std::vector<FixIt> labels;
  for (const StatementPtr& item : body.items) {
    if (item->kind == Statement::Kind::kCase) {
      const std::optional<Constant> number = checker_.FoldHere(*item->value);
      if (!number || number->is_double) return;
      const std::string_view written = Source(item->value->range);
      const bool constant = checker_.ConstantOf(*item->value).has_value();
      const std::string label = Label("lbl_case");
      Emit(fmt::format("{} = {} == {};", condition, value.text,
                       constant ? std::string(written) : number->Text()));
      Emit(fmt::format("if ({}) goto {};", condition, label));
      labels.push_back({item->range, label + ":"});
    } else if (item->kind == Statement::Kind::kDefault) {
      otherwise = Label("lbl_default");
      labels.push_back({item->range, otherwise + ":"});
    }
  }
  Emit(fmt::format("goto {};", otherwise.empty() ? end : otherwise));
  SubstituteHead(statement, body, open, "");
  for (FixIt& label : labels) edits_.push_back(std::move(label));
  ReplaceJumps(body, end, {});
  EmitEndLabel(end, place);
  SubstituteTail(body, statement, "", close);
  Finish();
}

void Rewriter::RewriteBlock(const Statement& statement) {
  if (!HasBothBraces(statement) || checker_.NeedsBraces(statement)) return;
  edits_.push_back(
      {Between(statement.range, statement.range.begin, statement.range.begin + 1), ""});
  edits_.push_back({Between(statement.range, statement.range.end - 1, statement.range.end), ""});
  Finish();
}

}  // namespace oncard::compiler
