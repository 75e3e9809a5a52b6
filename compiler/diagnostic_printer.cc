// The text format. Each diagnostic has a headline, the source line, or of a long one what is around
// the place, with a caret under the first
// character and tildes under the rest, its notes in the same format, and the lines with its fix-its
// applied, marked with +. The formats for programs are in diagnostic_export.cc.
// Tested by tests/compiler/printer_text_test.cc.
#include "compiler/diagnostic_printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "compiler/display_text.h"

namespace oncard::compiler {
namespace {

// ANSI select-graphic-rendition sequences, with the colours that clang uses.
constexpr std::string_view kReset = "\x1b[0m";
constexpr std::string_view kBold = "\x1b[1m";
constexpr std::string_view kRed = "\x1b[1;31m";
constexpr std::string_view kGreen = "\x1b[32m";
constexpr std::string_view kBoldGreen = "\x1b[1;32m";
constexpr std::string_view kMagenta = "\x1b[1;35m";
constexpr std::string_view kCyan = "\x1b[1;36m";

class TextPrinter {
 public:
  TextPrinter(const Compilation& compilation, const PrintOptions& options)
      : compilation_(compilation), options_(options) {}

  void Print(const Diagnostic& diagnostic) {
    const bool error = diagnostic.severity == Severity::kError;
    const Message label = error ? Message{"error", "错误"} : Message{"warning", "警告"};
    PrintHeadline(
        FileOf(diagnostic.range), diagnostic.range, error ? kRed : kMagenta,
        label.In(options_.language) + ' ' + DiagnosticName(diagnostic.info->code),
        fmt::format("{} [{}]", diagnostic.message.In(options_.language), diagnostic.info->slug));
    PrintSource(diagnostic.range);
    for (const Note& note : diagnostic.notes) {
      const Message note_label = {"note", "说明"};
      PrintHeadline(note.has_place ? FileOf(note.range) : nullptr, note.range, kCyan,
                    note_label.In(options_.language), note.message.In(options_.language));
      if (note.has_place) PrintSource(note.range);
    }
    PrintFixits(diagnostic.fixits);
  }

  void PrintSummary() {
    const auto count = [this](Severity severity) {
      return std::count_if(compilation_.diagnostics.begin(), compilation_.diagnostics.end(),
                           [severity](const auto& d) { return d.severity == severity; });
    };
    const auto errors = count(Severity::kError);
    const auto warnings = count(Severity::kWarning);
    std::vector<std::string> parts;
    const bool chinese = options_.language == Language::kChinese;
    const auto add = [&](auto number, std::string_view en, std::string_view zh) {
      if (number == 0) return;
      parts.push_back(chinese ? fmt::format("{} 个{}", number, zh)
                              : fmt::format("{} {}{}", number, en, number == 1 ? "" : "s"));
    };
    add(errors, "error", "错误");
    add(warnings, "warning", "警告");
    if (!parts.empty()) {
      text_ += fmt::format("{}\n", fmt::join(parts, chinese ? "，" : " and "));
    }
  }

  std::string Take() { return std::move(text_); }

 private:
  const SourceFile* FileOf(const SourceRange& range) const {
    const size_t index = static_cast<size_t>(range.file);
    return range.file >= 0 && index < compilation_.files.size() ? &compilation_.files[index]
                                                                : nullptr;
  }

  std::string Styled(std::string_view style, std::string_view text) const {
    if (!options_.color || text.empty()) return std::string(text);
    return fmt::format("{}{}{}", style, text, kReset);
  }

  void PrintHeadline(const SourceFile* file, const SourceRange& range, std::string_view style,
                     std::string_view label, std::string_view message) {
    if (file != nullptr) {
      text_ += Styled(kBold, fmt::format("{}:{}:{}:", DisplayText(file->path()),
                                         file->LineOf(range.begin), file->ColumnOf(range.begin)));
      text_ += ' ';
    }
    text_ += Styled(style, fmt::format("{}:", label));
    text_ += fmt::format(" {}\n", Styled(kBold, DisplayText(message)));
  }

  // Prints the first line of the range with an underline, which ends at the end of the line at the
  // latest.
  void PrintSource(const SourceRange& range) {
    const SourceFile* file = FileOf(range);
    if (file == nullptr) return;
    const int number = file->LineOf(range.begin);
    const std::string_view line = file->Line(number);
    const uint32_t line_begin = LineBegin(*file, number);
    const size_t begin = range.begin - line_begin;
    const size_t end = std::max(range.begin, range.end) - line_begin;
    const bool color = options_.color;
    text_ += FormatExcerpt(line, number, begin, end, color ? kBoldGreen : "", color ? kReset : "");
    text_ += '\n';
  }

  // Prints, for each run of adjacent lines that the fix-its edit, the edited lines.
  void PrintFixits(std::vector<FixIt> fixits) {
    std::stable_sort(fixits.begin(), fixits.end(), [](const FixIt& a, const FixIt& b) {
      return std::pair(a.range.file, a.range.begin) < std::pair(b.range.file, b.range.begin);
    });
    for (size_t first = 0; first < fixits.size();) {
      const SourceFile* file = FileOf(fixits[first].range);
      size_t last = first + 1;
      if (file != nullptr) {
        while (last < fixits.size() && fixits[last].range.file == fixits[first].range.file &&
               file->LineOf(fixits[last].range.begin) <=
                   file->LineOf(fixits[last - 1].range.end) + 1) {
          ++last;
        }
        PrintEditedLines(*file, std::span(fixits).subspan(first, last - first));
      }
      first = last;
    }
  }

  void PrintEditedLines(const SourceFile& file, std::span<const FixIt> edits) {
    const int first_line = file.LineOf(edits.front().range.begin);
    const int last_line = file.LineOf(edits.back().range.end);
    const std::string_view source = file.text();
    const size_t block_end = LineBegin(file, last_line) + file.Line(last_line).size();
    std::string block;
    std::vector<std::pair<size_t, size_t>> edited;  // places in the block
    size_t position = LineBegin(file, first_line);
    for (const FixIt& edit : edits) {
      block += source.substr(position, edit.range.begin - position);
      edited.emplace_back(block.size(), block.size() + edit.text.size());
      block += edit.text;
      position = edit.range.end;
    }
    block += source.substr(position, std::max(block_end, position) - position);
    std::string gutter = fmt::format("{:5}", first_line);
    for (size_t begin = 0; begin <= block.size();) {
      const size_t end = std::min(block.find('\n', begin), block.size());
      std::string_view line = std::string_view(block).substr(begin, end - begin);
      if (line.ends_with('\r')) line.remove_suffix(1);
      const auto [from, to] = FirstIn(edited, begin, end);
      const std::string shown = Indented(ExcerptOf(line, from - begin, to - begin).text);
      text_ += fmt::format("{} {}\n", gutter, Styled(kGreen, fmt::format("+{}", shown)));
      gutter.assign(gutter.size(), ' ');
      begin = end + 1;
    }
  }

  // The part of the first place that is between two others; nothing at `begin`, if there is none.
  static std::pair<size_t, size_t> FirstIn(std::span<const std::pair<size_t, size_t>> places,
                                           size_t begin, size_t end) {
    const auto found = std::find_if(places.begin(), places.end(), [begin, end](const auto& place) {
      return place.first <= end && place.second >= begin;
    });
    if (found == places.end()) return {begin, begin};
    return {std::max(found->first, begin), std::min(found->second, end)};
  }

  static uint32_t LineBegin(const SourceFile& file, int line) {
    return static_cast<uint32_t>(file.Line(line).data() - file.text().data());
  }

  // One space before a line with text; empty lines have no trailing blank.
  static std::string Indented(const std::string& line) {
    return line.empty() ? line : fmt::format(" {}", line);
  }

  const Compilation& compilation_;
  const PrintOptions& options_;
  std::string text_;
};

}  // namespace

std::string PrintText(const Compilation& compilation, const PrintOptions& options) {
  TextPrinter printer(compilation, options);
  for (const Diagnostic& diagnostic : compilation.diagnostics) printer.Print(diagnostic);
  printer.PrintSummary();
  return printer.Take();
}

}  // namespace oncard::compiler
