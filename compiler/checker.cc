#include "compiler/checker.h"

#include "compiler/parser.hh"

namespace oncard::compiler {

Checker::Checker(const Options& options, const std::deque<SourceFile>& files, Reporter& reporter,
                 const std::vector<Token>& tokens)
    : options_(options), catalogue_(*options.catalogue), files_(files), reporter_(reporter) {
  object_.double_format = options.double_format;
  for (const Token& token : tokens) {
    if (token.kind == Parser::token::kName) fresh_.Reserve(token.text);
  }
  first_item_ = tokens.front().range;
  for (const Token& token : tokens) {
    if (token.range.file != 0) continue;
    first_item_ = token.range;
    break;
  }
}

void Checker::AddSkippedNames(const std::unordered_set<std::string_view>& names) {
  skipped_names_.insert(names.begin(), names.end());
}

std::string_view Checker::Source(SourceRange range) const {
  const std::string_view text = files_[static_cast<size_t>(range.file)].text();
  return text.substr(range.begin, range.end - range.begin);
}

int Checker::LineOf(SourceRange range) const {
  return files_[static_cast<size_t>(range.file)].LineOf(range.begin);
}

vm::Object Checker::Check(const Tree& tree) {
  tree_ = &tree;
  for (const StatementPtr& item : tree.items) {
    if (item->kind == Statement::Kind::kFunction) {
      function_names_.emplace(item->function->name, item->function->name_range);
    }
  }
  for (const StatementPtr& item : tree.items) CheckItem(*item);
  return std::move(object_);
}

}  // namespace oncard::compiler
