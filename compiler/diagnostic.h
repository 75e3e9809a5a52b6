// Diagnostics of the compiler, as data. diagnostic_printer.h prints them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace oncard::compiler {

/// A file that took part in a compilation, with its lines found once.
class SourceFile {
 public:
  SourceFile(std::string path, std::string text);

  const std::string& path() const { return path_; }
  /// Its name as the `.ini` contains it: without folders, in one line.
  std::string IniName() const;
  /// The text as read, without a UTF-8 byte order mark.
  const std::string& text() const { return text_; }
  int line_count() const { return static_cast<int>(line_starts_.size()); }
  /// A line (from 1) without its line end; empty past the last one.
  std::string_view Line(int line) const;
  /// Line (from 1) of a byte offset.
  int LineOf(uint32_t offset) const;
  /// Column (from 1) of a byte offset, counted in characters: a UTF-8 or GBK sequence is one.
  int ColumnOf(uint32_t offset) const;

 private:
  void FindTrailBytes();

  std::string path_;
  std::string text_;
  std::vector<uint32_t> line_starts_;
  std::vector<uint32_t> trail_bytes_;  ///< offsets of bytes that do not begin a character
};

/// A range of a file's text: bytes [begin, end).
struct SourceRange {
  int file = 0;  ///< index into Compilation::files
  uint32_t begin = 0;
  uint32_t end = 0;
  bool operator==(const SourceRange&) const = default;
};

/// Where a part of the text of a file stands.
inline SourceRange RangeOf(size_t file, std::string_view text, std::string_view part) {
  const auto begin = static_cast<uint32_t>(part.data() - text.data());
  return {static_cast<int>(file), begin, begin + static_cast<uint32_t>(part.size())};
}

enum class Severity : uint8_t { kError, kWarning };

/// An edit: replaces the range by the text. Applying all fix-its of a diagnostic (they do not
/// overlap) results in the source that the message describes.
struct FixIt {
  SourceRange range;
  std::string text;
};

/// An additional remark, with a place or (line 0) without one.
struct Note {
  SourceRange range;
  bool has_place = false;
  Message message;
};

/// A row of diagnostics.def.
struct DiagnosticInfo {
  int code;  ///< 27 is printed MP027
  Severity severity;
  std::string_view slug;  ///< the word in brackets, such as `undeclared`
  std::string_view en;    ///< message with {0}, {1}, ...
  std::string_view zh;
};

struct Diagnostic {
  const DiagnosticInfo* info = nullptr;
  /// The severity of the row, unless warnings are errors.
  Severity severity = Severity::kError;
  SourceRange range;
  Message message;
  std::vector<Note> notes;
  std::vector<FixIt> fixits;
};

/// All rows, by code.
std::span<const DiagnosticInfo> DiagnosticTable();
/// The row of a code, or nullptr.
const DiagnosticInfo* FindDiagnostic(int code);
/// "MP027".
std::string DiagnosticName(int code);

}  // namespace oncard::compiler
