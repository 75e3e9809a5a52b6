// Sources of tests with places in them: `$0` to `$9` are not part of the text, but mark a place.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "editor/analysis.h"
#include "editor/places.h"

namespace oncard::editor {

/// For readable calls.
inline constexpr bool kStructured = true;

class MarkedSource {
 public:
  /// Files in the order of the texts; each begins with a line `=== path`, except that the first may
  /// go without: it is then `p.c`.
  explicit MarkedSource(std::string_view marked, bool structured = false);

  const std::string& main() const { return main_; }
  const std::map<std::string, std::string>& files() const { return files_; }
  compiler::FileReader Reader() const;
  compiler::Options Options() const;

  struct Mark {
    std::string path;
    uint32_t offset = 0;
    Place place;
  };
  const Mark& mark(int number = 0) const { return marks_.at(number); }
  /// nullptr if there is none.
  const Mark* FindMark(int number) const;

 private:
  std::string main_;
  std::map<std::string, std::string> files_;
  std::map<int, Mark> marks_;
  bool structured_;
};

/// A marked source with its names, and its object if it compiles.
class AnalysedSource : public MarkedSource {
 public:
  explicit AnalysedSource(std::string_view marked, bool structured = false);

  const Analysis& analysis() const { return analysis_; }
  const vm::Object* object() const { return compilation_.ok() ? &*compilation_.object : nullptr; }
  ProgramFiles program() const { return {main(), files().at(main()), Options(), Reader()}; }
  Cursor cursor(int number = 0) const;
  /// The text of the program after edits of it, which are in their order.
  std::string Apply(const Json& edits) const;

 private:
  Analysis analysis_;
  compiler::Compilation compilation_;
};

/// The name of a test from its rule.
std::string TestName(std::string_view rule);

}  // namespace oncard::editor
