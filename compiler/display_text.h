// A line of source as a terminal shows it: tabs are expanded, wide characters count as two columns,
// GBK text is converted, and bytes that are not printable text are made visible instead of being
// sent to the terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace oncard::compiler {

/// A line, and where each of its bytes appears.
class DisplayLine {
 public:
  /// A line that is valid UTF-8 is taken as UTF-8, any other as GBK. Bytes that are neither, and
  /// control characters, show as `<1B>`.
  explicit DisplayLine(std::string_view line);

  /// UTF-8, without tabs and control characters.
  const std::string& text() const { return text_; }
  /// Terminal column (from 0) at which the character that holds byte `offset` begins; offsets at or
  /// past the end give the width of the whole line.
  int ColumnOf(size_t offset) const;
  /// The byte at which the first character begins that is at a column or behind it.
  size_t OffsetOf(int column) const;
  /// What is shown for the bytes from `begin` to `end`, which do not part a character.
  std::string_view Shown(size_t begin, size_t end) const;

 private:
  std::string text_;
  std::vector<int> columns_;     // of each byte, then of the end
  std::vector<size_t> offsets_;  // the same in text_
};

/// Longer lines are shown only around what is marked in them, with `...` for the rest.
inline constexpr int kExcerptColumns = 120;

/// A line, or the part around the bytes from `begin` to `end`: UTF-8, and the columns in it at
/// which these bytes begin and end.
struct Excerpt {
  std::string text;
  int begin = 0;
  int end = 0;
};
Excerpt ExcerptOf(std::string_view line, size_t begin, size_t end);

/// A name or message made safe for a terminal: bytes that are not UTF-8 and control characters show
/// as `<1B>`.
std::string DisplayText(std::string_view text);

/// An excerpt of a line of source and below it a caret with an underline, for the bytes from
/// `begin` to `end`:
///
///     2 | rate = 0
///       |        ^
///
/// without a line end. `style` and `reset` enclose the underline.
std::string FormatExcerpt(std::string_view line, int number, size_t begin, size_t end,
                          std::string_view style = {}, std::string_view reset = {});

}  // namespace oncard::compiler
