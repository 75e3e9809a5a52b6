// The text of a program, and the statements in it that its instructions belong to. Tested by
// tests/explore/statement_texts_test.cc.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/compiler.h"
#include "runtime/observe/step_log.h"

namespace oncard::explore {

struct ProgramText {
  std::string text;  ///< empty: unknown
  /// As in compiler::Compilation; empty for a program that was not compiled now.
  std::vector<std::vector<compiler::SourceRange>> places = {};
};

/// The text of a program that was compiled; an object has none.
ProgramText TextOf(const compiler::Compilation& compilation);

/// Finds statements by the lines and places of their instructions.
class StatementTexts {
 public:
  /// Both must outlive it.
  StatementTexts(const ProgramText& program, const vm::Object& object);

  /// The text of a step's statement. A line that is a statement is shown as it is, with its
  /// comment; so is one with several where it is not known which of them is meant. Empty without a
  /// source.
  std::string Of(const runtime::LoggedStep& step) const;
  /// True if both are known to belong to one statement of one line.
  bool InOneStatement(const runtime::LoggedStep& one, const runtime::LoggedStep& other) const;

 private:
  /// A statement in the line's text.
  struct Part {
    size_t begin = 0;
    size_t end = 0;
    std::string statement;  ///< without what precedes it: braces, the head of a function, labels
    bool declares = false;
  };
  struct Line {
    size_t begin = 0;  ///< in the program's text
    std::string text;  ///< as it is shown
    std::vector<Part> parts;
    bool alone = false;  ///< it is one statement, and nothing else
  };

  static std::vector<Part> PartsOf(const std::string& code);
  const Line* LineOf(const runtime::LoggedStep& step) const;
  const Part* PartOf(const Line& line, const runtime::LoggedStep& step) const;
  const Part* PlacedPart(const Line& line, const compiler::SourceRange& place) const;

  const ProgramText& program_;
  const vm::Object& object_;
  std::vector<Line> lines_;  ///< element n: line n + 1
};

}  // namespace oncard::explore
