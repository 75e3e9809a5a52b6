#include "compiler/lowering/two_columns.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/trim.h"
#include "compiler/display_text.h"

namespace oncard::compiler {
namespace {

using Place = std::pair<int, int>;  // a file and a line

class RowMaker {
 public:
  explicit RowMaker(const Lowering& lowering) : lowering_(lowering) {
    FindLines();
    FindOthers();
  }

  std::vector<TwoColumnsRow> Run() {
    for (size_t begin = 0; begin < lines_.size();) {
      size_t end = begin + 1;
      while (end < lines_.size() && Continues(lines_[begin], lines_[end])) ++end;
      AddGroup(begin, end);
      begin = end;
    }
    for (const int line : last_) Add({0, line});
    return std::move(rows_);
  }

 private:
  // A line of the lowered program, and the lines of C from which it comes.
  struct Line {
    std::string_view text;
    int number = 0;
    int file = -1;
    int first = 0;
    int last = 0;
    bool moved = false;
    bool IsLabel() const { return text.ends_with(':'); }
  };

  void FindLines() {
    const std::string_view text = *lowering_.text;
    size_t begin = 0;
    int number = 0;
    for (const auto& [statement, moved] : lowering_.statements) {
      Line line;
      line.number = ++number;
      line.text = text.substr(begin, text.find('\n', begin) - begin);
      begin += line.text.size() + 1;
      if (line.text.empty()) continue;
      if (statement.file >= 0) {
        const SourceFile& file = lowering_.files[static_cast<size_t>(statement.file)];
        line.file = statement.file;
        line.first = file.LineOf(statement.begin);
        line.last = line.IsLabel() ? line.first : file.LineOf(statement.end);
        line.moved = moved;
      }
      lines_.push_back(line);
    }
  }

  // The lines of C that became nothing: those up to the end of a block stand behind the line
  // before, the others above the next one.
  void FindOthers() {
    std::set<int> own;
    std::set<int> moved;
    for (const Line& line : lines_) {
      for (int each = line.first; line.file == 0 && each <= line.last; ++each) {
        (line.moved ? moved : own).insert(each);
      }
    }
    const SourceFile& program = lowering_.files[0];
    const int count = program.line_count() - (program.Line(program.line_count()).empty() ? 1 : 0);
    int before = 0;
    for (int line = 1; line <= count; ++line) {
      if (own.contains(line)) {
        above_[line] = std::exchange(last_, {});
        before = line;
        continue;
      }
      if (moved.contains(line)) continue;
      last_.push_back(line);
      if (before == 0 || !Trim(program.Line(line)).starts_with('}')) continue;
      std::vector<int>& behind = behind_[before];
      behind.insert(behind.end(), last_.begin(), last_.end());
      last_.clear();
    }
  }

  // A label continues what stands above it, unless its line of C comes next.
  bool Continues(const Line& first, const Line& next) const {
    if (next.file == first.file && next.first == first.first) return true;
    if (!next.IsLabel()) return false;
    return next.file < 0 || next.file != first.file || next.first < first.first ||
           shown_.contains({next.file, next.first});
  }

  void AddGroup(size_t begin, size_t end) {
    const Line& group = lines_[begin];
    std::vector<int> left;
    for (size_t i = begin; i < end; ++i) {
      if (lines_[i].file != group.file || lines_[i].first != group.first) continue;
      for (int line = group.first + static_cast<int>(left.size());
           group.file >= 0 && line <= lines_[i].last; ++line) {
        left.push_back(line);
      }
    }
    const bool first =
        !group.moved && shown_.emplace(group.file, group.first).second && group.file == 0;
    if (first) {
      for (const int line : above_[group.first]) Add({0, line});
    }
    // Where the labels begin with which the rows end.
    size_t labels = end;
    while (labels > begin + 1 && lines_[labels - 1].IsLabel()) --labels;
    std::vector<int> closing;
    if (first) {
      for (const int line : left) {
        const std::vector<int>& behind = behind_[line];
        closing.insert(closing.end(), behind.begin(), behind.end());
      }
    }
    size_t row = begin;
    for (const int line : left) Add({group.file, line}, row < end ? &lines_[row++] : nullptr);
    for (; row < labels; ++row) Add({-1, 0}, &lines_[row]);
    for (const int line : closing) Add({0, line}, row < end ? &lines_[row++] : nullptr);
    for (; row < end; ++row) Add({-1, 0}, &lines_[row]);
  }

  void Add(const Place& place, const Line* card = nullptr) {
    TwoColumnsRow row;
    row.file = place.first;
    row.line = place.second;
    if (card != nullptr) {
      row.card = card->text;
      row.card_line = card->number;
    }
    row.again = row.file >= 0 && !added_.insert(place).second;
    rows_.push_back(row);
  }

  const Lowering& lowering_;
  std::vector<Line> lines_;
  std::map<int, std::vector<int>> above_;
  std::map<int, std::vector<int>> behind_;
  std::vector<int> last_;  // behind everything
  std::set<Place> shown_;  // where groups began
  std::set<Place> added_;
  std::vector<TwoColumnsRow> rows_;
};

// A line in pieces that fit a column; all but the last end with a `\` in its last place.
std::vector<std::string> PiecesOf(std::string_view line, int width) {
  const DisplayLine shown(line);
  std::vector<std::string> pieces;
  size_t begin = 0;
  while (shown.ColumnOf(line.size()) - shown.ColumnOf(begin) > width) {
    const int limit = shown.ColumnOf(begin) + width - 1;
    size_t end = shown.OffsetOf(limit);
    // A wide character may not fit.
    if (shown.ColumnOf(end) > limit) end = shown.OffsetOf(limit - 1);
    if (end <= begin) break;
    std::string piece(shown.Shown(begin, end));
    piece.append(static_cast<size_t>(limit - shown.ColumnOf(end)), ' ');
    pieces.push_back(piece + '\\');
    begin = end;
  }
  pieces.emplace_back(shown.Shown(begin, line.size()));
  return pieces;
}

int WidthShown(std::string_view text) { return DisplayLine(text).ColumnOf(text.size()); }

}  // namespace

std::vector<TwoColumnsRow> RowsOf(const Lowering& lowering) { return RowMaker(lowering).Run(); }

std::string FormatTwoColumns(const Lowering& lowering, const TwoColumnsOptions& options) {
  constexpr std::string_view kDim = "\x1b[2m";
  constexpr std::string_view kReset = "\x1b[0m";
  constexpr std::string_view kGap = "  ";
  constexpr std::string_view kBar = " | ";
  const std::vector<TwoColumnsRow> rows = RowsOf(lowering);
  int highest = 1;
  for (const TwoColumnsRow& row : rows) highest = std::max(highest, row.line);
  const int digits = static_cast<int>(std::to_string(highest).size());
  const int both = std::max(options.width, kTwoColumnsMin) - digits -
                   static_cast<int>(kGap.size() + kBar.size());
  const int left_width = both / 2;
  const auto dim = [&](std::string_view text, bool wanted = true) {
    return options.color && wanted && !text.empty() ? fmt::format("{}{}{}", kDim, text, kReset)
                                                    : std::string(text);
  };
  std::string text;
  const auto add = [&](const std::string& number, const std::string& left, bool again,
                       const std::string& right) {
    std::string row;
    if (!number.empty() || !left.empty() || !right.empty()) {
      row = dim(fmt::format("{:>{}}", number, digits));
    }
    if (!left.empty() || !right.empty()) row.append(kGap).append(dim(left, again));
    if (!right.empty()) {
      row.append(static_cast<size_t>(std::max(left_width - WidthShown(left), 0)), ' ');
      row.append(dim(kBar)).append(right);
    }
    text.append(row).append("\n");
  };
  int file = 0;
  for (const TwoColumnsRow& row : rows) {
    const bool has_line = row.file >= 0;
    if (has_line && row.file != file) {
      file = row.file;
      add("", DisplayText(lowering.files[static_cast<size_t>(file)].path()) + ":", true, "");
    }
    const std::vector<std::string> left =
        has_line
            ? PiecesOf(lowering.files[static_cast<size_t>(row.file)].Line(row.line), left_width)
            : std::vector<std::string>{""};
    const std::vector<std::string> right = PiecesOf(row.card, both - left_width);
    for (size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
      add(has_line && i == 0 ? std::to_string(row.line) : "", i < left.size() ? left[i] : "",
          row.again, i < right.size() ? right[i] : "");
    }
  }
  return text;
}

}  // namespace oncard::compiler
