// Tested by tests/compiler/printer_display_test.cc.
#include "compiler/display_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "base/utf8.h"
#include "compiler/gbk_decoder.h"
#include "compiler/text.h"

namespace oncard::compiler {
namespace {

constexpr int kTabWidth = 8;
constexpr std::string_view kEllipsis = "...";

struct CodeRange {
  char32_t first;
  char32_t last;
};

// Unicode's East Asian Width classes W and F, as far as common fonts support them.
constexpr std::array kWide = {
    CodeRange{0x1100, 0x115F},   CodeRange{0x2E80, 0x303E},   CodeRange{0x3041, 0x4DBF},
    CodeRange{0x4E00, 0xA4CF},   CodeRange{0xA960, 0xA97C},   CodeRange{0xAC00, 0xD7A3},
    CodeRange{0xF900, 0xFAFF},   CodeRange{0xFE30, 0xFE6F},   CodeRange{0xFF00, 0xFF60},
    CodeRange{0xFFE0, 0xFFE6},   CodeRange{0x1F300, 0x1F64F}, CodeRange{0x1F900, 0x1F9FF},
    CodeRange{0x20000, 0x3FFFD},
};

// Combining marks and invisible joiners do not occupy a column.
constexpr std::array kZeroWidth = {
    CodeRange{0x0300, 0x036F},
    CodeRange{0x200B, 0x200F},
    CodeRange{0x20D0, 0x20FF},
    CodeRange{0xFE00, 0xFE0F},
};

// Characters that change how a terminal displays the following text: C1 controls, bidirectional
// overrides, the byte order mark.
constexpr std::array kUnsafe = {
    CodeRange{0x0080, 0x009F},
    CodeRange{0x202A, 0x202E},
    CodeRange{0x2066, 0x2069},
    CodeRange{0xFEFF, 0xFEFF},
};

template <size_t kSize>
bool Contains(const std::array<CodeRange, kSize>& ranges, char32_t code) {
  return std::any_of(ranges.begin(), ranges.end(), [code](const CodeRange& range) {
    return code >= range.first && code <= range.last;
  });
}

int WidthOf(char32_t code) {
  if (Contains(kZeroWidth, code)) return 0;
  return Contains(kWide, code) ? 2 : 1;
}

struct Character {
  size_t size = 1;  // number of bytes in the source
  char32_t code = 0;
};

// The UTF-8 character at `offset`; empty if the bytes are not well-formed.
std::optional<Character> DecodeUtf8(std::string_view text, size_t offset) {
  const auto byte = [&](size_t index) { return static_cast<uint8_t>(text[index]); };
  const uint8_t lead = byte(offset);
  if (lead < 0x80) return Character{1, lead};
  size_t size = 0;
  char32_t code = 0;
  char32_t smallest = 0;
  if (lead >= 0xC2 && lead <= 0xDF) {
    size = 2, code = lead & 0x1Fu, smallest = 0x80;
  } else if (lead >= 0xE0 && lead <= 0xEF) {
    size = 3, code = lead & 0x0Fu, smallest = 0x800;
  } else if (lead >= 0xF0 && lead <= 0xF4) {
    size = 4, code = lead & 0x07u, smallest = 0x10000;
  } else {
    return std::nullopt;
  }
  if (offset + size > text.size()) return std::nullopt;
  for (size_t i = 1; i < size; ++i) {
    if ((byte(offset + i) & 0xC0u) != 0x80u) return std::nullopt;
    code = (code << 6) | (byte(offset + i) & 0x3Fu);
  }
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < smallest || code > 0x10FFFF || surrogate) return std::nullopt;
  return Character{size, code};
}

// The same for GBK.
std::optional<Character> DecodeGbk(GbkDecoder& decoder, std::string_view text, size_t offset) {
  const uint8_t lead = static_cast<uint8_t>(text[offset]);
  if (lead < 0x80) return Character{1, lead};
  if (offset + 2 > text.size()) return std::nullopt;
  const auto code = decoder.Decode(text[offset], text[offset + 1]);
  return code ? std::optional(Character{2, *code}) : std::nullopt;
}

bool IsShown(char32_t code) { return code >= 0x20 && code != 0x7F && !Contains(kUnsafe, code); }

// Appends the text that the terminal shows for `size` bytes of `text` at `offset`, which form
// `character` or are invalid. Returns the number of columns.
int AppendShown(std::string& shown, std::string_view text, size_t offset, size_t size,
                const std::optional<Character>& character) {
  if (character && IsShown(character->code)) {
    AppendUtf8(shown, character->code);
    return WidthOf(character->code);
  }
  for (size_t i = 0; i < size; ++i) {
    shown += fmt::format("<{:02X}>", static_cast<uint8_t>(text[offset + i]));
  }
  return static_cast<int>(4 * size);
}

}  // namespace

DisplayLine::DisplayLine(std::string_view line) {
  const bool utf8 = IsUtf8(line);
  std::optional<GbkDecoder> gbk;
  if (!utf8) gbk.emplace();
  int column = 0;
  for (size_t offset = 0; offset < line.size();) {
    const auto character = utf8 ? DecodeUtf8(line, offset) : DecodeGbk(*gbk, line, offset);
    const size_t size = character ? character->size : 1;
    columns_.insert(columns_.end(), size, column);
    offsets_.insert(offsets_.end(), size, text_.size());
    if (line[offset] == '\t') {
      const int width = kTabWidth - column % kTabWidth;
      text_.append(static_cast<size_t>(width), ' ');
      column += width;
    } else {
      column += AppendShown(text_, line, offset, size, character);
    }
    offset += size;
  }
  columns_.push_back(column);
  offsets_.push_back(text_.size());
}

int DisplayLine::ColumnOf(size_t offset) const {
  return columns_[std::min(offset, columns_.size() - 1)];
}

size_t DisplayLine::OffsetOf(int column) const {
  const auto found = std::lower_bound(columns_.begin(), columns_.end(), column);
  return std::min(static_cast<size_t>(found - columns_.begin()), columns_.size() - 1);
}

std::string_view DisplayLine::Shown(size_t begin, size_t end) const {
  return std::string_view(text_).substr(offsets_[begin], offsets_[end] - offsets_[begin]);
}

Excerpt ExcerptOf(std::string_view line, size_t begin, size_t end) {
  const DisplayLine shown(line);
  const int first = shown.ColumnOf(begin);
  const int last = std::max(first, shown.ColumnOf(end));
  const int width = shown.ColumnOf(line.size());
  if (width <= kExcerptColumns) return {shown.text(), first, last};
  // What is marked stands in the middle, but the room is used up; what does not fit is cut.
  const int ellipsis = static_cast<int>(kEllipsis.size());
  const int room = kExcerptColumns - 2 * ellipsis;
  const int marked = std::min(last - first, room);
  const int left = std::clamp(first - (room - marked) / 2, 0, width - room);
  const size_t from = shown.OffsetOf(left);
  size_t to = shown.OffsetOf(left + room);
  // Half of a wide character does not fit.
  if (shown.ColumnOf(to) > left + room) to = shown.OffsetOf(shown.ColumnOf(to - 1));
  Excerpt excerpt;
  if (from > 0) excerpt.text = kEllipsis;
  const int moved = static_cast<int>(excerpt.text.size()) - shown.ColumnOf(from);
  excerpt.text += shown.Shown(from, to);
  if (to < line.size()) excerpt.text += kEllipsis;
  excerpt.begin = first + moved;
  excerpt.end = std::min(last, shown.ColumnOf(to)) + moved;
  return excerpt;
}

std::string DisplayText(std::string_view text) {
  std::string shown;
  for (size_t offset = 0; offset < text.size();) {
    const auto character = DecodeUtf8(text, offset);
    const size_t size = character ? character->size : 1;
    AppendShown(shown, text, offset, size, character);
    offset += size;
  }
  return shown;
}

std::string FormatExcerpt(std::string_view line, int number, size_t begin, size_t end,
                          std::string_view style, std::string_view reset) {
  const Excerpt excerpt = ExcerptOf(line, begin, end);
  const int width = excerpt.end - excerpt.begin;
  std::string underline = "^";
  if (width > 1) underline.append(static_cast<size_t>(width - 1), '~');
  const std::string margin = excerpt.text.empty() ? "" : " ";
  return fmt::format("{:5} |{}{}\n      | {}{}{}{}", number, margin, excerpt.text,
                     std::string(static_cast<size_t>(excerpt.begin), ' '), style, underline, reset);
}

}  // namespace oncard::compiler
