// The text of a program, and the statements in it that its instructions belong to. Tested by
// tests/explore/statement_texts_test.cc.
#pragma once

#include <string>
#include <vector>

#include "compiler/compiler.h"
#include "runtime/observe/step_log.h"

namespace oncard::explore {

struct ProgramText {
  std::string text;       ///< empty: unknown
  std::string file = {};  ///< as vm::Function::file has it; empty: that of all functions
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
  /// comment; so is one with a part of a longer statement, or where it is not known which of
  /// several is meant. `file:line` for a function of an included file; empty without a source.
  std::string Of(const runtime::LoggedStep& step) const;
  /// True if both are known to belong to one statement.
  bool InOneStatement(const runtime::LoggedStep& one, const runtime::LoggedStep& other) const;

 private:
  /// Bytes of the program's text.
  struct Span {
    size_t begin = 0;
    size_t end = 0;

    bool Has(const Span& other) const { return begin <= other.begin && other.end <= end; }
  };
  struct Part {
    size_t begin = 0;  ///< of its labels
    Span statement;    ///< with its semicolon
    bool declares = false;
  };

  void FindParts();
  bool IsOfFile(const runtime::LoggedStep& step) const;
  /// Without its line end; empty for an unknown line.
  Span LineOf(const runtime::LoggedStep& step) const;
  const Part* PartOf(const runtime::LoggedStep& step) const;
  const Part* PartAt(size_t place) const;
  const Part* CountedPart(const runtime::LoggedStep& step) const;
  /// True if the line has nothing else.
  bool IsAlone(const Part& part, Span line) const;
  std::string Shown(Span span) const;

  const ProgramText& program_;
  const vm::Object& object_;
  std::string code_;         ///< the text with blanks for comments and directives
  std::vector<Span> lines_;  ///< element n: line n + 1
  std::vector<Part> parts_;  ///< in their order
};

}  // namespace oncard::explore
