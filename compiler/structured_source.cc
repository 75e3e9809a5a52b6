#include "compiler/structured_source.h"

#include "compiler/directives.h"
#include "compiler/parser_driver.h"
#include "compiler/structured_refusals.h"

namespace oncard::compiler {

StructuredSource::StructuredSource(const std::string& path, std::string text,
                                   const Options& options, const FileReader& reader,
                                   Reporter& reporter) {
  Directives directives(options, reader, reporter, Dialect::kStructured);
  directives.Run(SourceFile(path, std::move(text)));
  files_ = std::move(directives.files());
  inclusion_points_ = directives.inclusion_points();
  skipped_names_ = directives.skipped_names();
  tokens_ = std::move(directives.tokens());
  ParserDriver driver(tokens_, reporter, Dialect::kStructured);
  driver.tree.macros = std::move(directives.macros());
  Parser parser(driver);
  parser.parse();
  tree_ = std::move(driver.tree);
  RefuseUntranslatable(tree_, options, reporter);
  skipped_names_.insert(driver.skipped_names().begin(), driver.skipped_names().end());
}

StructuredSource::StructuredSource(StructuredSource&&) noexcept = default;
StructuredSource& StructuredSource::operator=(StructuredSource&&) noexcept = default;
StructuredSource::~StructuredSource() = default;

}  // namespace oncard::compiler
