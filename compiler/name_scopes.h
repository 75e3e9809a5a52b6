// Resolves the names of a program by C's scope rules, before any correction. Tested by
// tests/compiler/rewriter_test.cc with the fix-its that use it.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/syntax.h"

namespace oncard::compiler {

struct VisibleName {
  const Declarator* declarator = nullptr;
  const Specifiers* specifiers = nullptr;
  bool local = false;
  SourceRange scope;  ///< of a local: from its name to the end of its block
};

class NameScopes {
 public:
  /// The tree must outlive this object.
  explicit NameScopes(const Tree& tree);

  /// The variable that a name refers to at a place, the innermost one; nullptr if there is none.
  const VisibleName* Find(std::string_view name, SourceRange use) const;

 private:
  void AddItems(const std::vector<StatementPtr>& items, bool local, uint32_t end);
  void AddStatement(const Statement& statement, bool local, uint32_t end);
  void Add(const Specifiers& specifiers, const Declarator& declarator, bool local, uint32_t end);

  std::unordered_map<std::string_view, std::vector<VisibleName>> names_;
};

}  // namespace oncard::compiler
