#include "compiler/lowering/kept_comments.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "compiler/dialect.h"
#include "compiler/text.h"
#include "compiler/tree_walk.h"

namespace oncard::compiler::lowering {
namespace {

constexpr std::string_view kBlanks = " \t\r";

bool IsDirective(std::string_view text) { return text.starts_with('#') || text.starts_with("%:"); }

// Whether a directive chooses what is read. A comment above it need not be about it alone.
bool IsCondition(std::string_view directive) {
  directive.remove_prefix(std::min(directive.find_first_not_of("#%: \t"), directive.size()));
  return directive.starts_with("if") || directive.starts_with("el") ||
         directive.starts_with("endif");
}

void Append(const Comments& more, Comments& comments) {
  comments.insert(comments.end(), more.begin(), more.end());
}

// Statements of C by their places.
class Statements {
 public:
  void Add(const SourceRange& place) { places_.emplace_back(place.file, place.begin); }
  void Sort() { std::ranges::sort(places_); }
  bool HasOneIn(const SourceRange& range) const {
    const auto found = std::ranges::lower_bound(places_, std::pair(range.file, range.begin));
    return found != places_.end() && *found < std::pair(range.file, range.end);
  }

 private:
  std::vector<std::pair<int, uint32_t>> places_;
};

}  // namespace

std::string CommentLine(std::string_view text) {
  std::string line(text.substr(0, text.find_first_of("\r\n")));
  line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
  // A backslash at the end, but not as half of a GBK character, would continue the comment.
  const bool utf8 = IsUtf8(line);
  size_t kept = 0;
  for (size_t at = 0; at < line.size();) {
    const std::string_view rest = std::string_view(line).substr(at);
    const std::string_view character = rest.substr(0, CharacterLength(rest, utf8));
    at += character.size();
    if (character != " " && character != "\t" && character != "\\") kept = at;
  }
  line.resize(kept);
  return line;
}

std::string_view WithoutMark(std::string_view line) {
  line = Trim(line);
  return line.starts_with("//") ? Trim(line.substr(2)) : line;
}

KeptComments::KeptComments(const Program& program, const Tree& tree,
                           const std::deque<SourceFile>& files,
                           std::span<const SourceComment> comments)
    : files_(files) {
  FindItems(program, tree);
  Distribute(comments);
  if (!comments.empty()) DropRemoved(program, tree);
}

void KeptComments::FindItems(const Program& program, const Tree& tree) {
  for (const StatementPtr& statement : tree.items) {
    Item item;
    item.range = statement->range;
    if (statement->kind == Statement::Kind::kFunction && !statement->function->prototype) {
      const Function& function = *statement->function;
      CommentedFunction& commented = functions_.emplace_back();
      item.function = static_cast<int>(functions_.size()) - 1;
      item.range.begin = std::min(item.range.begin, function.header.begin);
      const SourceRange& close = function.close_brace;
      if (close.file == item.range.file) item.range.end = std::max(item.range.end, close.end);
      commented.range = item.range;
      commented.body = function.body.empty() ? close.begin : function.body.front()->range.begin;
      commented.last = function.body.empty() ? close.begin : function.body.back()->range.begin;
    }
    items_.push_back(item);
  }
  std::ranges::stable_sort(
      items_, {}, [](const Item& item) { return std::pair(item.range.file, item.range.begin); });
  const auto mark = [this](const SourceRange& place, bool is_function) {
    const int number = ItemAround(place);
    if (number < 0) return;
    Item& item = items_[static_cast<size_t>(number)];
    if (is_function == (item.function >= 0)) item.printed = true;
  };
  for (const int global : program.globals) {
    const SourceRange& place = program.variables[static_cast<size_t>(global)].range;
    if (place.end > 0) mark(place, false);
  }
  for (const LoweredFunction& function : program.functions) mark(function.header, true);
}

void KeptComments::Distribute(std::span<const SourceComment> comments) {
  Comments paragraph;
  const auto end_paragraph = [this, &paragraph] {
    if (!paragraph.empty()) PlaceParagraph(paragraph);
    paragraph.clear();
  };
  for (const SourceComment& comment : comments) {
    const Line line = LineAt(comment.range.file, comment.range.begin);
    const int item = ItemAround(comment.range);
    const int function = item < 0 ? -1 : items_[static_cast<size_t>(item)].function;
    const bool follows = !paragraph.empty() && comment.alone && item < 0 &&
                         comment.range.file == paragraph.back()->range.file &&
                         line.second <= LineAt(line.first, paragraph.back()->range.end).second + 1;
    if (!follows) end_paragraph();
    if (function >= 0) {
      functions_[static_cast<size_t>(function)].comments.push_back(&comment);
    } else if (!comment.alone) {
      beside_[line].push_back(&comment);
    } else if (item < 0) {
      paragraph.push_back(&comment);
    }
  }
  end_paragraph();
}

// A paragraph belongs to the declaration below it, if no empty line parts them.
void KeptComments::PlaceParagraph(const Comments& paragraph) {
  const SourceComment& last = *paragraph.back();
  const int file = last.range.file;
  const bool first = file == 0 && last.before == 0 && title_.empty();
  const std::string_view behind = TextOf(file).substr(last.behind);
  const Line line = LineAt(file, last.behind);
  const bool attached = !behind.empty() && line.second == LineAt(file, last.range.end).second + 1;
  const int number = ItemAround({file, last.behind, last.behind});
  const Item* const item = number < 0 ? nullptr : &items_[static_cast<size_t>(number)];
  const bool declared = attached && item != nullptr;
  if (declared && item->function >= 0) {
    Append(paragraph, functions_[static_cast<size_t>(item->function)].comments);
  } else if (first && !(declared && item->printed)) {
    title_ = paragraph;
  } else if (declared || (attached && IsDirective(behind) && !IsCondition(behind))) {
    Append(paragraph, above_[line]);
  } else {
    LeaveFree(paragraph);
  }
}

// A paragraph that belongs to no declaration is printed above the next one that is printed.
void KeptComments::LeaveFree(const Comments& paragraph) {
  const SourceRange& range = paragraph.back()->range;
  auto item = std::ranges::upper_bound(
      items_, std::pair(range.file, range.begin), {},
      [](const Item& other) { return std::pair(other.range.file, other.range.begin); });
  while (item != items_.end() && item->range.file == range.file && !item->printed) ++item;
  const bool found = item != items_.end() && item->range.file == range.file;
  if (!found && range.file != 0) return;
  Append(paragraph, found ? above_[LineAt(range.file, item->range.begin)] : rest_);
}

// Leaves out what is said in and above statements of which nothing is left, and beside directives.
void KeptComments::DropRemoved(const Program& program, const Tree& tree) {
  Statements left;
  std::vector<char> used(program.statements.size());
  for (const LoweredFunction& function : program.functions) {
    for (const Instruction& instruction : function.code) {
      if (instruction.statement >= 0) used[static_cast<size_t>(instruction.statement)] = 1;
    }
  }
  for (size_t i = 0; i < used.size(); ++i) {
    if (used[i] != 0) left.Add(program.statements[i]);
  }
  left.Sort();
  size_t number = 0;
  for (const StatementPtr& item : tree.items) {
    if (item->kind != Statement::Kind::kFunction || item->function->prototype) continue;
    Comments& comments = functions_[number++].comments;
    if (comments.empty()) continue;
    // What removed code had is told by its expressions: `break;` is often left out.
    Statements expressions;
    const auto each_statement = [&item](const StatementVisitor& visit) {
      for (const StatementPtr& statement : item->function->body)
        ForEachStatement(*statement, visit);
    };
    each_statement([&expressions](const Statement& statement) {
      if (statement.kind == Statement::Kind::kExpression) expressions.Add(statement.range);
    });
    expressions.Sort();
    std::vector<SourceRange> removed;  // in order, without those in others
    each_statement([&](const Statement& statement) {
      const SourceRange& range = statement.range;
      if (!expressions.HasOneIn(range) || left.HasOneIn(range)) return;
      if (removed.empty() || range.begin >= removed.back().end) removed.push_back(range);
    });
    std::erase_if(comments, [this, &removed](const SourceComment* comment) {
      const uint32_t place = comment->alone ? comment->behind : comment->before;
      const auto after = std::ranges::upper_bound(removed, place, {}, &SourceRange::begin);
      return (after != removed.begin() && place < std::prev(after)->end) ||
             (!comment->alone && IsBesideDirective(*comment));
    });
  }
}

bool KeptComments::IsBesideDirective(const SourceComment& comment) const {
  const auto [file, line] = LineAt(comment.range.file, comment.range.begin);
  return IsDirective(Trim(files_[static_cast<size_t>(file)].Line(line)));
}

Comments KeptComments::TakeAbove(const SourceRange& place) {
  auto taken = above_.extract(LineAt(place.file, DeclarationAt(place).begin));
  return taken.empty() ? Comments() : std::move(taken.mapped());
}

std::string KeptComments::TakeBeside(const SourceRange& place) {
  const auto taken = beside_.extract(LineAt(place.file, place.begin));
  std::string text;
  if (taken.empty()) return text;
  for (const SourceComment* comment : taken.mapped()) text += "  " + Take(*comment);
  return text;
}

std::string KeptComments::Take(const SourceComment& comment) {
  taken_.emplace(LineAt(comment.range.file, comment.range.begin), comment.range.begin);
  std::string text;
  for (const std::string& line : LinesOf(comment)) {
    if (!text.empty()) text += ' ';
    text += text.empty() ? Trim(line) : WithoutMark(line);
  }
  return text;
}

std::string_view KeptComments::LineWithoutTaken(const SourceRange& place) const {
  const Line line = LineAt(place.file, place.begin);
  const std::string_view text = files_[static_cast<size_t>(place.file)].Line(line.second);
  const auto taken = taken_.find(line);
  if (taken == taken_.end() || taken->second < place.begin) return text;
  const auto begin = static_cast<uint32_t>(text.data() - TextOf(place.file).data());
  return text.substr(0, taken->second - begin);
}

int KeptComments::FunctionAt(const SourceRange& place) const {
  const int item = ItemAround(place);
  return item < 0 ? -1 : items_[static_cast<size_t>(item)].function;
}

SourceRange KeptComments::DeclarationAt(const SourceRange& place) const {
  const int item = ItemAround(place);
  return item < 0 ? place : items_[static_cast<size_t>(item)].range;
}

std::vector<std::string> KeptComments::LinesOf(const SourceComment& comment) const {
  const std::string_view text = TextOf(comment.range.file);
  const std::string_view before = text.substr(0, comment.range.begin);
  std::string_view rest = text.substr(comment.range.begin, comment.range.end - comment.range.begin);
  // Where the other lines of the comment may begin. Its own line may be very long.
  const bool one = rest.find('\n') == std::string_view::npos;
  const size_t column = one ? 0 : before.size() - (before.rfind('\n') + 1);
  const bool block = rest.starts_with("/*");
  std::vector<std::string> lines;
  bool dropped = false;
  while (!rest.empty()) {
    const size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    std::string words = CommentLine(line);
    if (words.starts_with(kToolComment)) {
      // The first one is behind another comment.
      if (lines.empty()) words.insert(2, " ");
      dropped |= !lines.empty();
      if (!lines.empty()) continue;
    }
    if (!lines.empty() && !words.empty()) {
      const size_t indent = std::min(line.find_first_not_of(kBlanks), column);
      line.remove_prefix(indent);
      const std::string_view blanks = line.substr(0, line.find_first_not_of(kBlanks));
      words.insert(0, block ? blanks : "// ");
    }
    lines.push_back(std::move(words));
  }
  if (!block) return lines;
  if (!lines.back().ends_with("*/") || lines.back() == "/*/") lines.emplace_back("*/");
  const bool empty = std::ranges::all_of(lines, [](const std::string& line) {
    return line.find_first_not_of("/* \t") == std::string::npos;
  });
  return dropped && empty ? std::vector<std::string>() : lines;
}

int KeptComments::ItemAround(const SourceRange& place) const {
  const auto after = std::ranges::upper_bound(
      items_, std::pair(place.file, place.begin), {},
      [](const Item& item) { return std::pair(item.range.file, item.range.begin); });
  if (after == items_.begin()) return -1;
  const auto item = std::prev(after);
  const bool around = item->range.file == place.file && place.begin < item->range.end;
  return around ? static_cast<int>(item - items_.begin()) : -1;
}

KeptComments::Line KeptComments::LineAt(int file, uint32_t offset) const {
  return {file, files_[static_cast<size_t>(file)].LineOf(offset)};
}

}  // namespace oncard::compiler::lowering
