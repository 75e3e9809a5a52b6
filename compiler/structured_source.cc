#include "compiler/structured_source.h"

#include "compiler/parser_driver.h"
#include "compiler/preprocessor.h"
#include "compiler/structured_refusals.h"
#include "compiler/type_names.h"

namespace oncard::compiler {

StructuredSource::StructuredSource(const std::string& path, std::string text,
                                   const Options& options, const FileReader& reader,
                                   Reporter& reporter) {
  Preprocessor preprocessor(options, reader, reporter);
  preprocessor.Run(SourceFile(path, std::move(text)));
  files_ = std::move(preprocessor.files());
  made_ = std::move(preprocessor.made());
  inclusion_points_ = std::move(preprocessor.inclusion_points());
  macro_uses_ = std::move(preprocessor.macros().uses());
  asserts_ = FindAsserts(files_);
  depths_ = FindDepths(files_);
  comments_ = std::move(preprocessor.comments());
  const auto is_skipped = [&preprocessor](const auto& comment) {
    return preprocessor.IsSkipped(comment.range);
  };
  std::erase_if(asserts_, is_skipped);
  std::erase_if(depths_, is_skipped);
  std::erase_if(comments_, is_skipped);
  tokens_ = std::move(preprocessor.tokens());
  const std::unordered_set<std::string_view> type_names = MarkTypeNames(tokens_);
  ParserDriver driver(tokens_, reporter, Dialect::kStructured);
  Parser parser(driver);
  parser.parse();
  tree_ = std::move(driver.tree);
  skipped_names_ = driver.skipped_names();
  RefuseUntranslatable(tree_, type_names, skipped_names_, options, reporter);
}

StructuredSource::StructuredSource(StructuredSource&&) noexcept = default;
StructuredSource& StructuredSource::operator=(StructuredSource&&) noexcept = default;
StructuredSource::~StructuredSource() = default;

void StructuredSource::AddMacroNotes(Reporter& reporter) const {
  for (Diagnostic& diagnostic : reporter.diagnostics()) {
    const MacroUses::Macro* const macro = macro_uses_.Find(diagnostic.range);
    if (macro == nullptr) continue;
    AddNote(diagnostic, macro->name_range,
            MakeMessage("this comes from the macro '{0}', defined here",
                        "这来自宏 '{0}'，它在此处定义", macro->name));
  }
}

}  // namespace oncard::compiler
