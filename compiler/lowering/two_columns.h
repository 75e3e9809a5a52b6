// A lowered program beside its C, for people: each statement of C in the rows of the statements of
// the card that it became. Tested by tests/compiler/two_columns_test.cc and
// tests/tools/lower_command_test.cc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/lowering/lowering.h"

namespace oncard::compiler {

/// A line of C, a line of the lowered program, or both side by side.
struct TwoColumnsRow {
  int file = -1;  ///< of Lowering::files; -1: no line of C
  int line = 0;
  bool again = false;  ///< the line of C is in an earlier row, too
  std::string_view card;
  int card_line = 0;  ///< of Lowering::text; 0: no line of it
};

/// All lines of the program and of its text, which must live on; of included files those that
/// became something. Use LoweringOptions::comments = false: a line of C is in the row anyway.
std::vector<TwoColumnsRow> RowsOf(const Lowering& lowering);

struct TwoColumnsOptions {
  int width = 120;  ///< at least kTwoColumnsMin
  bool color = false;
};

inline constexpr int kTwoColumnsMin = 40;
inline constexpr int kTwoColumnsMax = 1000;

/// The rows as text with the line numbers of C. A line that is longer than its column goes on in
/// the next row behind a `\`.
std::string FormatTwoColumns(const Lowering& lowering, const TwoColumnsOptions& options);

}  // namespace oncard::compiler
