// The comments of C that a lowered program keeps, and what they are printed above or beside. What
// C says about something that the lowered program does not have, such as a type, is left out.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/lowering/ir.h"
#include "compiler/source_comments.h"
#include "compiler/syntax.h"

namespace oncard::compiler::lowering {

using Comments = std::vector<const SourceComment*>;

/// A function of C with its comments, in their order. Those right above it come first.
struct CommentedFunction {
  SourceRange range;  ///< to its closing brace
  uint32_t body = 0;  ///< where its first statement begins, or its closing brace
  uint32_t last = 0;  ///< where its last statement begins
  Comments comments;
};

class KeptComments {
 public:
  /// The references must outlive this object.
  KeptComments(const Program& program, const Tree& tree, const std::deque<SourceFile>& files,
               std::span<const SourceComment> comments);

  /// The first comment of the program, if it is about no single part of it.
  const Comments& title() const { return title_; }
  /// Those behind everything else.
  const Comments& rest() const { return rest_; }
  /// Those above what is declared at a place outside of functions, when they are first asked for.
  Comments TakeAbove(const SourceRange& place);
  /// Those beside it, each in one line.
  std::string TakeBeside(const SourceRange& place);
  /// One of them.
  std::string Take(const SourceComment& comment);
  /// A line of C without what was taken from beside it.
  std::string_view LineWithoutTaken(const SourceRange& place) const;

  const std::vector<CommentedFunction>& functions() const { return functions_; }
  /// The one of the functions in which a place is; -1: none.
  int FunctionAt(const SourceRange& place) const;
  /// Where the declaration outside of functions begins in which a place is, or the place itself.
  SourceRange DeclarationAt(const SourceRange& place) const;

  /// The lines of a comment, each of which ends as a comment of the card's language does. Without
  /// those that are for tools, which would be read twice.
  std::vector<std::string> LinesOf(const SourceComment& comment) const;

 private:
  using Line = std::pair<int, int>;  // a file and a line in it

  // What C declares outside of functions.
  struct Item {
    SourceRange range;
    int function = -1;     // of functions_
    bool printed = false;  // it is a global or a function of the lowered program
  };

  void FindItems(const Program& program, const Tree& tree);
  void Distribute(std::span<const SourceComment> comments);
  void PlaceParagraph(const Comments& paragraph);
  void LeaveFree(const Comments& paragraph);
  void DropRemoved(const Program& program, const Tree& tree);
  bool IsBesideDirective(const SourceComment& comment) const;
  // The number of the item in which a place is; -1: none.
  int ItemAround(const SourceRange& place) const;
  Line LineAt(int file, uint32_t offset) const;
  std::string_view TextOf(int file) const { return files_[static_cast<size_t>(file)].text(); }

  const std::deque<SourceFile>& files_;
  std::vector<Item> items_;  // by file and place
  std::vector<CommentedFunction> functions_;
  std::map<Line, Comments> above_;   // by the line where the declaration begins
  std::map<Line, Comments> beside_;  // by their own
  std::map<Line, uint32_t> taken_;   // where what was taken from beside them begins
  Comments title_;
  Comments rest_;
};

/// The first line of a text without blanks around it, and without a backslash at its end, which
/// would continue a comment.
std::string CommentLine(std::string_view text);
/// A line of a comment without blanks around it and the `//` with which it begins.
std::string_view WithoutMark(std::string_view line);

}  // namespace oncard::compiler::lowering
