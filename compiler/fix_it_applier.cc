#include "compiler/fix_it_applier.h"

#include <algorithm>
#include <functional>
#include <set>

#include "compiler/reporter.h"

namespace oncard::compiler {
namespace {

// A correction can make the next one possible: each operation of a long expression takes a pass.
// Some mistakes stay what they are, and the text would grow for ever, such as a missing semicolon
// in the body of a macro.
constexpr int kPassesMax = 500;

// The part of a file that a diagnostic's edits cover. Insertions of declarations before the
// diagnostic itself do not conflict with others.
struct Stretch {
  int file = 0;
  uint32_t begin = UINT32_MAX;
  uint32_t end = 0;
};

bool IsDeclaration(const FixIt& edit, const Diagnostic& diagnostic) {
  return edit.range.begin == edit.range.end && edit.range.file == diagnostic.range.file &&
         edit.range.end < diagnostic.range.begin;
}

std::vector<Stretch> StretchesOf(const Diagnostic& diagnostic) {
  std::map<int, Stretch> by_file;
  std::vector<Stretch> stretches;
  for (const FixIt& edit : diagnostic.fixits) {
    if (IsDeclaration(edit, diagnostic)) {
      stretches.push_back({edit.range.file, edit.range.begin, edit.range.end});
      continue;
    }
    Stretch& stretch = by_file[edit.range.file];
    stretch.file = edit.range.file;
    stretch.begin = std::min(stretch.begin, edit.range.begin);
    stretch.end = std::max(stretch.end, edit.range.end);
  }
  for (const auto& [file, stretch] : by_file) stretches.push_back(stretch);
  return stretches;
}

// Two insertions of declarations at the same place do not conflict.
bool Touch(const Stretch& a, const Stretch& b) {
  const bool same_insertion = a.begin == a.end && b.begin == b.end && a.begin == b.begin;
  return a.file == b.file && a.begin <= b.end && b.begin <= a.end && !same_insertion;
}

bool Overlap(std::vector<FixIt> edits) {
  std::sort(edits.begin(), edits.end(), [](const FixIt& a, const FixIt& b) {
    return std::tuple(a.range.file, a.range.begin, a.range.end) <
           std::tuple(b.range.file, b.range.begin, b.range.end);
  });
  return std::adjacent_find(edits.begin(), edits.end(), [](const FixIt& a, const FixIt& b) {
           return a.range.file == b.range.file && a.range.end > b.range.begin;
         }) != edits.end();
}

// A hash by which texts that have already occurred are recognised.
size_t Fingerprint(const std::map<std::string, std::string>& files) {
  size_t value = 0;
  for (const auto& [path, text] : files) {
    for (const std::string* part : {&path, &text}) {
      value = value * 1'000'003 + std::hash<std::string>()(*part);
    }
  }
  return value;
}

// Selects the edits, by file, of as many diagnostics as can be corrected at once; returns their
// number.
int Choose(const Compilation& compilation, std::map<int, std::vector<FixIt>>* edits) {
  std::vector<Stretch> taken;
  int count = 0;
  std::vector<const Diagnostic*> order;
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    if (!diagnostic.fixits.empty() && !Overlap(diagnostic.fixits)) order.push_back(&diagnostic);
  }
  // Whether the type of a variable can change depends on other types: all of them change at once.
  std::stable_partition(order.begin(), order.end(), [](const Diagnostic* diagnostic) {
    const int code = diagnostic->info->code;
    return code == static_cast<int>(Code::kForeignType) ||
           code == static_cast<int>(Code::kReservedWord);
  });
  for (const Diagnostic* const chosen : order) {
    const Diagnostic& diagnostic = *chosen;
    const std::vector<Stretch> stretches = StretchesOf(diagnostic);
    const bool free = std::none_of(stretches.begin(), stretches.end(), [&](const Stretch& mine) {
      return std::any_of(taken.begin(), taken.end(),
                         [&mine](const Stretch& other) { return Touch(mine, other); });
    });
    if (!free) continue;
    taken.insert(taken.end(), stretches.begin(), stretches.end());
    for (const FixIt& edit : diagnostic.fixits) {
      std::vector<FixIt>& of_file = (*edits)[edit.range.file];
      // Two diagnostics may need the same declaration.
      const bool known = IsDeclaration(edit, diagnostic) &&
                         std::any_of(of_file.begin(), of_file.end(), [&edit](const FixIt& other) {
                           return other.range == edit.range && other.text == edit.text;
                         });
      if (!known) of_file.push_back(edit);
    }
    ++count;
  }
  return count;
}

}  // namespace

std::string ApplyEdits(const std::string& text, std::vector<FixIt> edits) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const FixIt& a, const FixIt& b) { return a.range.begin < b.range.begin; });
  std::string result;
  size_t position = 0;
  for (const FixIt& edit : edits) {
    result.append(text, position, edit.range.begin - position);
    result += edit.text;
    position = edit.range.end;
  }
  return result.append(text, position);
}

CorrectedProgram ApplyAllFixIts(const std::string& path, std::string text, const Options& options,
                                const FileReader& reader) {
  CorrectedProgram corrected;
  const FileReader corrected_reader = [&](const std::string& name) -> Result<std::string> {
    const auto found = corrected.files.find(name);
    if (found != corrected.files.end()) return found->second;
    return reader(name);
  };
  Options all = options;
  all.max_errors = 0;
  all.recognize_structured = false;
  std::set<size_t> seen;
  for (int pass = 0; pass < kPassesMax; ++pass) {
    const Compilation compilation = CompileText(path, text, all, corrected_reader);
    std::map<int, std::vector<FixIt>> edits;
    const int count = Choose(compilation, &edits);
    std::map<std::string, std::string> files = corrected.files;
    for (const auto& [file, of_file] : edits) {
      const SourceFile& source = compilation.files[static_cast<size_t>(file)];
      files[source.path()] = ApplyEdits(source.text(), of_file);
    }
    if (count == 0 || !seen.insert(Fingerprint(files)).second) break;
    corrected.files = std::move(files);
    corrected.count += count;
    const auto program = corrected.files.find(path);
    if (program != corrected.files.end()) text = program->second;
  }
  all.max_errors = options.max_errors;
  corrected.compilation = CompileText(path, std::move(text), all, corrected_reader);
  return corrected;
}

}  // namespace oncard::compiler
