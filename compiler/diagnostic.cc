// The table of diagnostics, and source files with their lines and columns.
#include "compiler/diagnostic.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/files.h"
#include "compiler/text.h"

namespace oncard::compiler {
namespace {

constexpr DiagnosticInfo kDiagnostics[] = {
#define DIAGNOSTIC(code, name, severity, slug, en, zh) {code, Severity::severity, slug, en, zh},
#include "compiler/diagnostics.def"
};

}  // namespace

SourceFile::SourceFile(std::string path, std::string text)
    : path_(std::move(path)), text_(std::move(text)) {
  if (text_.starts_with(kByteOrderMark)) text_.erase(0, kByteOrderMark.size());
  line_starts_.push_back(0);
  for (size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(static_cast<uint32_t>(i + 1));
  }
  // The line end of the last line does not begin a new line.
  if (line_starts_.size() > 1 && line_starts_.back() == text_.size()) line_starts_.pop_back();
  FindTrailBytes();
}

void SourceFile::FindTrailBytes() {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  for (int line = 1; line <= line_count(); ++line) {
    const std::string_view content = Line(line);
    if (std::ranges::all_of(content, is_ascii)) continue;
    const bool utf8 = IsUtf8(content);
    const uint32_t begin = line_starts_[static_cast<size_t>(line - 1)];
    for (size_t position = 0; position < content.size();) {
      const size_t next =
          std::min(position + CharacterLength(content.substr(position), utf8), content.size());
      while (++position < next) trail_bytes_.push_back(begin + static_cast<uint32_t>(position));
    }
  }
}

std::string SourceFile::IniName() const {
  std::string name = path_.substr(path_.find_last_of("/\\") + 1);
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '_');
  return name;
}

std::string_view SourceFile::Line(int line) const {
  if (line < 1 || line > line_count()) return {};
  const size_t index = static_cast<size_t>(line - 1);
  const size_t begin = line_starts_[index];
  const size_t end = index + 1 < line_starts_.size() ? line_starts_[index + 1] : text_.size();
  std::string_view content = std::string_view(text_).substr(begin, end - begin);
  if (content.ends_with('\n')) content.remove_suffix(1);
  if (content.ends_with('\r')) content.remove_suffix(1);
  return content;
}

int SourceFile::LineOf(uint32_t offset) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  return static_cast<int>(after - line_starts_.begin());
}

int SourceFile::ColumnOf(uint32_t offset) const {
  const uint32_t begin = line_starts_[static_cast<size_t>(LineOf(offset) - 1)];
  offset = std::min(offset, static_cast<uint32_t>(text_.size()));
  const auto trail_bytes = std::ranges::upper_bound(trail_bytes_, offset) -
                           std::ranges::upper_bound(trail_bytes_, begin);
  return static_cast<int>(offset - begin) - static_cast<int>(trail_bytes) + 1;
}

std::span<const DiagnosticInfo> DiagnosticTable() { return kDiagnostics; }

const DiagnosticInfo* FindDiagnostic(int code) {
  const auto row =
      std::lower_bound(std::begin(kDiagnostics), std::end(kDiagnostics), code,
                       [](const DiagnosticInfo& info, int wanted) { return info.code < wanted; });
  return row != std::end(kDiagnostics) && row->code == code ? row : nullptr;
}

std::string DiagnosticName(int code) { return fmt::format("MP{:03}", code); }

}  // namespace oncard::compiler
