#include "compiler/asserts.h"

#include <algorithm>
#include <optional>
#include <string>

#include "compiler/dialect.h"

namespace oncard::compiler {
namespace {

// The first statement of a function behind a comment. One that is several on the card begins with
// the first of these.
std::optional<size_t> StatementBehind(const SourceRange& comment,
                                      const std::vector<SourceRange>& statements) {
  std::optional<size_t> first;
  for (size_t i = 0; i < statements.size(); ++i) {
    const SourceRange& range = statements[i];
    if (range.file != comment.file || range.begin < comment.end) continue;
    if (!first || range.begin < statements[*first].begin) first = i;
  }
  return first;
}

}  // namespace

bool Contains(const SourceRange& outer, const SourceRange& inner) {
  return outer.file == inner.file && outer.begin <= inner.begin && inner.end <= outer.end;
}

std::vector<AssertComment> FindAsserts(const std::deque<SourceFile>& files) {
  std::vector<AssertComment> comments;
  for (size_t number = 0; number < files.size(); ++number) {
    const std::string_view text = files[number].text();
    ForEachAssertComment(text, [&](std::string_view line, std::string_view condition) {
      comments.push_back({RangeOf(number, text, line), std::string(condition)});
    });
  }
  return comments;
}

void ReportAssert(const AssertComment& comment, bool in_function, Reporter& reporter) {
  Message why = {"has no statement behind it in its function", "在所在函数中其后没有语句"};
  if (comment.condition.empty()) {
    why = {"has no condition", "没有条件"};
  } else if (!in_function) {
    why = {"stands outside of all functions", "位于所有函数之外"};
  }
  reporter.Report(Code::kMisplacedAssert, comment.range, why);
}

void PlaceAsserts(const std::deque<SourceFile>& files, const std::vector<FunctionPlaces>& places,
                  vm::Object* object, Reporter& reporter) {
  for (const AssertComment& comment : FindAsserts(files)) {
    const auto around = std::ranges::find_if(places, [&](const FunctionPlaces& function) {
      return Contains(function.body, comment.range);
    });
    const bool in_function = around != places.end();
    std::optional<size_t> position;
    if (in_function) position = StatementBehind(comment.range, around->statements);
    if (!position || comment.condition.empty()) {
      ReportAssert(comment, in_function, reporter);
      continue;
    }
    const auto function = static_cast<size_t>(around - places.begin());
    object->functions[function].asserts.push_back(
        {static_cast<uint16_t>(*position), comment.condition});
  }
  for (vm::Function& function : object->functions) {
    std::ranges::stable_sort(function.asserts, {}, &vm::Assert::position);
  }
}

}  // namespace oncard::compiler
