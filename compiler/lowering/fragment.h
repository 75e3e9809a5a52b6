// Statements of C in a program of the card, as the simple statements that the card has: what a
// fix-it writes in their place (compiler/rewriter.h). The lowerer translates them as it does whole
// programs of structured C, with these differences:
// - The types are those of the card: `short` and `long` are ints of 32 bits.
// - Bodies of branches and loops are not translated. They stay in the source, where comments and
//   mistakes of their own are; only their `break`, `continue` and `case` become labels and jumps.
// - Constants keep their spelling, and nothing is computed in advance.
// - `&&` and `||` stay operators where their right side may be computed in any case.
// Tested by tests/compiler/rewriter_test.cc and tests/differential/structured_test.cc.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/symbols.h"
#include "compiler/syntax.h"

namespace oncard::compiler::lowering {

/// What is around a fragment. All of it must outlive the call.
struct FragmentContext {
  const Options& options;
  const std::deque<SourceFile>& files;
  /// What a name means there; nullptr: nothing.
  std::function<const Entity*(std::string_view name)> lookup;
  FreshNames& fresh;
  const Function& function;
  vm::DataType return_type;
};

struct Fragment {
  struct Part {
    std::vector<std::string> lines;
    const Statement* body = nullptr;  ///< the body that follows them; nullptr in the last part
  };
  /// The statements before the first body, between bodies, and after the last one.
  std::vector<Part> parts;
  /// Of jumps and labels in the bodies, in the order of the text.
  std::vector<FixIt> edits;
  /// Declarations of the temporaries.
  std::vector<std::string> declarations;
};

/// Empty if the statement has no equivalent on the card.
std::optional<Fragment> LowerFragment(const FragmentContext& context, const Statement& statement);

/// The statements that give variables of the function their initial values.
std::optional<Fragment> LowerInitialValues(const FragmentContext& context,
                                           const std::vector<const Declarator*>& declarators);

}  // namespace oncard::compiler::lowering
