#include "runtime/scenario/file/placed_errors.h"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "compiler/display_text.h"

namespace oncard::runtime {

TextFile::TextFile(std::string path, std::string_view text, TextMargin margin)
    : path_(std::move(path)), text_(text), margin_(margin), begins_{0} {
  for (size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n', end + 1)) {
    begins_.push_back(end + 1);
  }
}

std::string_view TextFile::Line(int number) const {
  if (number < 1 || static_cast<size_t>(number) > begins_.size()) return {};
  const size_t begin = begins_[static_cast<size_t>(number) - 1];
  const std::string_view rest = std::string_view(text_).substr(begin);
  return rest.substr(0, rest.find('\n'));
}

std::string TextPlace::Headline() const {
  if (file == nullptr) return {};
  if (line == 0) return fmt::format("{}: ", file->path());
  return fmt::format("{}:{}:{}: ", file->path(), line + file->margin().lines,
                     column + file->margin().columns);
}

std::string TextPlace::Excerpt() const {
  if (file == nullptr || line == 0) return {};
  const std::string_view text = file->Line(line);
  if (text.size() > kExcerptMax) return {};
  return '\n' + compiler::FormatExcerpt(text, line + file->margin().lines, begin, end);
}

void PlacedErrors::Add(TextPlace place, Message message) {
  errors_.push_back({std::move(place), std::move(message)});
}

std::optional<Error> PlacedErrors::Failure() const {
  if (errors_.empty()) return std::nullopt;
  std::vector<const PlacedError*> sorted;
  for (const PlacedError& error : errors_) sorted.push_back(&error);
  const auto key = [](const PlacedError* error) {
    const TextPlace& place = error->place;
    const bool nowhere = place.file == nullptr;
    return std::tuple(nowhere, nowhere ? std::string_view() : place.file->path(), place.line,
                      place.column);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto* a, const auto* b) { return key(a) < key(b); });
  Message all;
  for (size_t i = 0; i < std::min(sorted.size(), kShown); ++i) {
    const auto& [place, message] = *sorted[i];
    const std::string_view separator = i == 0 ? "" : "\n";
    all.en += fmt::format("{}{}{}{}", separator, place.Headline(), message.en, place.Excerpt());
    all.zh += fmt::format("{}{}{}{}", separator, place.Headline(), message.zh, place.Excerpt());
  }
  if (sorted.size() > kShown) {
    const Message more =
        MakeMessage("\n{0} more errors", "\n另有 {0} 个错误", sorted.size() - kShown);
    all.en += more.en;
    all.zh += more.zh;
  }
  return Error{1, std::move(all)};
}

}  // namespace oncard::runtime
