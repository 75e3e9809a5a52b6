// Structured C to the card's language (docs/structured.md). Like compiler.h: text in, text and
// diagnostics out, no files of its own, no exceptions, no global state, usable from any thread.
// The parts: lowerer.h translates the syntax tree to the program of ir.h, passes/ shortens it,
// printer.h writes it. Tested by tests/compiler/lowering_test.cc,
// tests/lang/structured and tests/differential/lowered_test.cc.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/compiler.h"
#include "vm/limits.h"

namespace oncard::compiler {

struct LoweringOptions {
  /// Calls are jumps where that is shorter, constants are folded, copies propagated, jumps
  /// threaded, and what has no effect is removed.
  bool optimize = true;
  /// Comments on statements of C that read and write a global in different statements of the card,
  /// and on calls that are jumps.
  bool annotate = false;
  /// The comments of C, and its lines as comments.
  bool comments = true;
  /// When optimising, so many slots may a thread function take before its locals share them, and
  /// the globals before constant tables move to pages. Tests take fewer than the card has.
  int slots = vm::kSlotCount;
};

/// A function whose statements stand once in a thread function, for several calls.
struct JumpCalls {
  std::string name;
  int calls = 0;
};

/// What the calls of recursive functions that wait for another one take. The page has it.
struct FramesCost {
  std::string name;  ///< of the first of the functions that call each other
  int count = 0;     ///< one less than the depth
  int slots = 0;     ///< of each
};

/// Variables that have the slots of another one, because their lives do not overlap.
struct SharedSlotsCost {
  std::string name;
  std::vector<std::string> others;
};

/// What a thread function takes on the card.
struct FunctionCost {
  std::string name;
  int statements = 0;
  int labels = 0;
  int temporaries = 0;
  int page_slots = 0;            ///< parameters, locals and temporaries
  std::vector<JumpCalls> jumps;  ///< calls that are jumps; all others are inlined
  std::vector<FramesCost> frames;
  std::vector<SharedSlotsCost> shared_slots;
  std::vector<std::string> tables;  ///< globals of C that are in the page
};

/// The statement or declaration of C that became a line of the lowered program.
struct StatementOfC {
  SourceRange range;   ///< file -1: none
  bool moved = false;  ///< it stands elsewhere in C than what is around the line
};

struct Lowering {
  /// The files of the structured program, [0] the program itself; diagnostics index them.
  std::vector<SourceFile> files;
  /// Errors of lowering, or all that the compiler says about the lowered text, at the places of C.
  std::vector<Diagnostic> diagnostics;
  /// The lowered program. Present when there is no error.
  std::optional<std::string> text;
  /// What the compiler makes of that text; the lines of its functions are those of C.
  std::optional<vm::Object> object;
  /// As in Compilation, in C.
  std::vector<std::vector<SourceRange>> places;
  /// For each line of the text the place in C that it comes from; file -1: none.
  std::vector<SourceRange> origins;
  /// The same for whole statements. A label has the one behind it, or at whose end it stands.
  std::vector<StatementOfC> statements;
  std::vector<FunctionCost> costs;
  int global_slots = 0;
  /// Statements that were translated and given to the passes to find out which calls should be
  /// jumps. It grows with the program as the time for that does.
  int64_t tried_statements = 0;
};

/// Lowers a program that is in memory under the name `path`; includes go through `reader`.
Lowering LowerText(const std::string& path, std::string text, const Options& options,
                   const LoweringOptions& lowering_options, const FileReader& reader);

/// Takes what a compilation has out of it.
Compilation TakeCompilation(Lowering& lowering);

}  // namespace oncard::compiler
