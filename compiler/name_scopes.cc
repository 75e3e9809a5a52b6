#include "compiler/name_scopes.h"

namespace oncard::compiler {

NameScopes::NameScopes(const Tree& tree) { AddItems(tree.items, false, 0); }

void NameScopes::Add(const Specifiers& specifiers, const Declarator& declarator, bool local,
                     uint32_t end) {
  const SourceRange& name = declarator.name_range;
  names_[declarator.name].push_back(
      {&declarator, &specifiers, local, {name.file, name.begin, end}});
}

void NameScopes::AddItems(const std::vector<StatementPtr>& items, bool local, uint32_t end) {
  for (const StatementPtr& item : items) AddStatement(*item, local, end);
}

void NameScopes::AddStatement(const Statement& statement, bool local, uint32_t end) {
  for (const Declarator& declarator : statement.declarators) {
    Add(statement.specifiers, declarator, local, end);
  }
  const uint32_t own_end = statement.range.end;
  for (const Statement* below :
       {statement.initial.get(), statement.body.get(), statement.else_body.get()}) {
    if (below != nullptr) AddStatement(*below, true, own_end);
  }
  AddItems(statement.items, true, own_end);
  if (statement.function == nullptr) return;
  const Function& function = *statement.function;
  for (const ParameterDeclaration& parameter : function.parameters) {
    Add(parameter.specifiers, parameter.declarator, true, function.close_brace.end);
  }
  AddItems(function.body, true, function.close_brace.end);
}

const VisibleName* NameScopes::Find(std::string_view name, SourceRange use) const {
  const auto found = names_.find(name);
  if (found == names_.end()) return nullptr;
  // The last one of the enclosing locals is the innermost.
  for (auto visible = found->second.rbegin(); visible != found->second.rend(); ++visible) {
    const SourceRange& scope = visible->scope;
    if (visible->local && scope.file == use.file && scope.begin <= use.begin &&
        use.begin < scope.end) {
      return &*visible;
    }
  }
  for (const VisibleName& visible : found->second) {
    if (!visible.local) return &visible;
  }
  return nullptr;
}

}  // namespace oncard::compiler
