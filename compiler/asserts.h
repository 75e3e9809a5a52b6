// Comments `//@ assert: CONDITION`: which statement each of them stands before. What the condition
// means is not known here (runtime/scenario/run/assert_watch.h). Tested by
// tests/compiler/asserts_test.cc and tests/lang/asserts.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "compiler/flow_warnings.h"
#include "compiler/reporter.h"
#include "vm/object.h"

namespace oncard::compiler {

/// A comment `//@ assert`.
struct AssertComment {
  SourceRange range;      ///< the comment
  std::string condition;  ///< empty: it has none
};

/// Those of all files, in order.
std::vector<AssertComment> FindAsserts(const std::deque<SourceFile>& files);

/// Reports a comment that has no condition, or no statement behind it in a function.
void ReportAssert(const AssertComment& comment, bool in_function, Reporter& reporter);

/// True if a place lies in another one.
bool Contains(const SourceRange& outer, const SourceRange& inner);

/// Gives each function of an object its asserts: each belongs to the first statement behind it in
/// the function. Reports those that have none.
void PlaceAsserts(const std::deque<SourceFile>& files, const std::vector<FunctionPlaces>& places,
                  vm::Object* object, Reporter& reporter);

}  // namespace oncard::compiler
