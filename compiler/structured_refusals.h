// What structured C cannot have, as far as the text alone shows it: pointers, strings, types with
// 64 bits and the like. Reports each with its reason. What needs names and types to be known is
// left to compiler/lowering. Tested by tests/lang/structured.
#pragma once

#include <string_view>
#include <unordered_set>

#include "compiler/compiler.h"
#include "compiler/reporter.h"
#include "compiler/syntax.h"

namespace oncard::compiler {

/// Reports what cannot be translated, about a static function that nothing calls in a remark alone.
/// If nothing is reported:
/// - the words of every type are `void`, `bool`, an integer type with or without a sign and size,
///   `double`, one of `type_names` alone, a type of C's headers with at most 32 bits, an enum or a
///   structure of the catalogue, perhaps with `const`, `static` or another qualifier, `extern` not
///   in parameters and casts; an enum is defined in a declaration only;
/// - there are no pointers but parameters with one star, of numbers; functions are called by name;
/// - numbers fit their types; `-2147483648` is the only use of a decimal 2147483648.
/// Nothing is said about types with `skipped_names`, which may have been defined in text with
/// errors.
void RefuseUntranslatable(const Tree& tree, const std::unordered_set<std::string_view>& type_names,
                          const std::unordered_set<std::string_view>& skipped_names,
                          const Options& options, Reporter& reporter);

}  // namespace oncard::compiler
