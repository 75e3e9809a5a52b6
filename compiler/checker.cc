#include "compiler/checker.h"

namespace oncard::compiler {

void Checker::AddSkippedNames(const std::unordered_set<std::string_view>& names) {
  context_.skipped_names.insert(names.begin(), names.end());
}

vm::Object Checker::Check(const Tree& tree) {
  context_.tree = &tree;
  for (const StatementPtr& item : tree.items) {
    if (item->kind == Statement::Kind::kFunction) {
      context_.function_names.emplace(item->function->name, item->function->name_range);
    }
  }
  for (const StatementPtr& item : tree.items) CheckItem(*item);
  return std::move(context_.object);
}

}  // namespace oncard::compiler
