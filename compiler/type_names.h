// The names of types that a program of structured C defines. In C a name is read differently when
// it is a type, so they are marked before the tokens are parsed. Tested by
// tests/compiler/structured_source_test.cc and tests/lang/structured/typedefs.c.
#pragma once

#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/syntax.h"

namespace oncard::compiler {

/// Makes structure names (Parser::token::kStructureName) of the names that stand for a type where
/// they stand: behind a typedef, in its block, and not where a variable hides it. A typedef of a
/// type that C's headers have too, such as `int32_t`, gets a name. Returns all names of types.
std::unordered_set<std::string_view> MarkTypeNames(std::vector<Token>& tokens);

}  // namespace oncard::compiler
