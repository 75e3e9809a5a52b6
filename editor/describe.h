// What stands at a place: the answer for a pointer that rests on a word, and the call around a
// place. Tested by tests/editor/describe_test.cc and signature_test.cc.
#pragma once

#include <map>

#include "editor/analysis.h"
#include "vm/object.h"

namespace oncard::editor {

/// What the name or number at a place is, with its range; null if there is neither. `object` is the
/// program if it compiles, from which the slots of variables are known, or nullptr.
Json Describe(const Analysis& analysis, Cursor cursor, const vm::Object* object, Language language);

/// The GT command, function or macro within whose parentheses a place is, also if they are not
/// closed; null if there is none.
Json Signature(const Analysis& analysis, Cursor cursor, Language language);

/// The call around a place.
struct CallAt {
  const Symbol* callee = nullptr;  ///< nullptr: none
  compiler::SourceRange name;
  size_t argument = 0;  ///< from 0
};
CallAt FindCall(const Analysis& analysis, Cursor cursor);

/// Whether threads begin with a function: in structured C those that no other one calls.
bool IsThreadFunction(const ProgramText& text, const Symbol& function);

/// What has the member that is named behind a `.` or `->`, as `a` of `a[i].x`, `m` of `a.m.x` and
/// `f` of `f().x`; `dot` is the index of that token in the file. nullptr if nothing known is there.
const Symbol* OperandBefore(const Analysis& analysis, int file, size_t dot);

/// The member of a structure of the card that the token at `name` is, as in `trap.acc`; nullptr if
/// it is none.
const gtcalls::Member* CardMemberAt(const Analysis& analysis, int file, size_t name);

/// The slots of variables in their data page or among the globals, by symbol; those of blocks that
/// share a name are missing, and so are those that the program does not need.
std::map<int, int> SlotsOf(const Analysis& analysis, const vm::Object& object);

}  // namespace oncard::editor
