// Names of variables as people write them, and what they name among the symbols of a program: those
// of the program itself, `x`, `a[3]`, `axis_target[2]`, and those of the structured C that it comes
// from, `axis[2].target`, `m[1][2]` (Symbol::written).
//
// What names a symbol itself, with at most one index, means that; any other name is C's. So `m[5]`
// is the sixth element of `int m[2][3]`, as on the card, and `m[1]` the second one; `m[1][2]` is
// C's. A name of C may stop before the end: `axis[2]` names all members, `axis` all elements.
//
// Pure functions, safe in any thread. Tested by tests/vm/symbol_names_test.cc.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "vm/object.h"

namespace oncard::vm {

/// True for a name of C of any length, without indices and members.
bool IsIdentifier(std::string_view text);

/// True for a text that has the form of a name: indices are numbers in brackets.
bool IsName(std::string_view text);

/// True if `written` is a name that C can have for the symbol: as many elements, if it is an array.
bool IsWrittenName(const Symbol& symbol);

/// Consecutive slots of a symbol.
struct NamedSlots {
  const Symbol* symbol = nullptr;
  uint16_t first = 0;  ///< from the first one of the symbol
  uint16_t count = 1;
  bool is_number = true;  ///< the name is that of one number, and not of what has one element
};

/// What a name names, in the order of C; empty if nothing is named so there. Fails for an element
/// that its array does not have, and for a member that its structure does not have, with a similar
/// one.
Result<std::vector<NamedSlots>> FindNamed(std::span<const Symbol> symbols, std::string_view name);

/// All slots of symbols, in the order of C: those of a structure stand together.
std::vector<NamedSlots> AllInOrder(std::span<const Symbol> symbols);

/// How an element of a symbol is called in its source: `axis[2].target`; of one that is no array
/// the name of the symbol. `element` counts from 0.
std::string NameOfElement(const Symbol& symbol, int element);

/// The name with which a variable begins in its source: `axis` of `axis[3].target`.
std::string_view NameOfVariable(const Symbol& symbol);

}  // namespace oncard::vm
