#include "compiler/compiler.h"

#include <algorithm>

#include "base/files.h"
#include "compiler/asserts.h"
#include "compiler/checker.h"
#include "compiler/depth_comments.h"
#include "compiler/dialect.h"
#include "compiler/directives.h"
#include "compiler/flow_warnings.h"
#include "compiler/lowering/lowering.h"
#include "compiler/parser_driver.h"

namespace oncard::compiler {
namespace {

void ApplyWarningOptions(const Options& options, Reporter& reporter) {
  for (const int code : options.silent_warnings) reporter.Drop(static_cast<Code>(code));
  if (!options.warnings_are_errors) return;
  for (Diagnostic& diagnostic : reporter.diagnostics()) diagnostic.severity = Severity::kError;
}

// So many errors of the card's language make it worth a look whether a program is structured C.
constexpr std::ptrdiff_t kErrorsOfStructured = 6;

// A warning stays one if warnings are errors.
bool IsError(const Diagnostic& diagnostic) { return diagnostic.info->severity == Severity::kError; }

// Replaces the errors of a program that has none as structured C by one that says so.
void RecognizeStructured(const std::string& text, const Options& options, const FileReader& reader,
                         Compilation* compilation) {
  std::vector<Diagnostic>& found = compilation->diagnostics;
  if (std::count_if(found.begin(), found.end(), IsError) < kErrorsOfStructured) return;
  const std::string& path = compilation->files[0].path();
  Options lenient = options;
  lenient.warnings_are_errors = false;
  const Lowering lowering = LowerText(path, text, lenient, {.comments = false}, reader);
  if (std::any_of(lowering.diagnostics.begin(), lowering.diagnostics.end(), IsError)) return;
  Reporter reporter;
  const SourceRange place = std::find_if(found.begin(), found.end(), IsError)->range;
  Diagnostic& diagnostic = reporter.Report(Code::kUnmarkedStructured, place);
  InsertBefore(diagnostic, SourceRange{}, std::string(kStructuredLine) + '\n');
  found.clear();
  found.push_back(std::move(diagnostic));
}

}  // namespace

bool ReadWarningOption(std::string_view text, Options* options) {
  constexpr std::string_view kNo = "no-";
  if (text == "error") {
    if (options != nullptr) options->warnings_are_errors = true;
    return true;
  }
  if (!text.starts_with(kNo)) return false;
  text.remove_prefix(kNo.size());
  for (const DiagnosticInfo& info : DiagnosticTable()) {
    if (info.slug != text || info.severity != Severity::kWarning) continue;
    if (options != nullptr) options->silent_warnings.push_back(info.code);
    return true;
  }
  return false;
}

bool IsStructured(const Options& options, std::string_view text) {
  return options.structured || WantsStructured(text);
}

Compilation CompileText(const std::string& path, std::string text, const Options& options,
                        const FileReader& reader) {
  if (!IsStructured(options, text)) {
    if (!options.recognize_structured) {
      return CompileCardText(path, std::move(text), options, reader);
    }
    // Errors that are not shown count as well.
    Options all = options;
    all.max_errors = 0;
    Compilation compilation = CompileCardText(path, text, all, reader);
    RecognizeStructured(text, options, reader, &compilation);
    LimitErrors(compilation.diagnostics, options.max_errors);
    return compilation;
  }
  // Nobody reads the text.
  Lowering lowering = LowerText(path, std::move(text), options, {.comments = false}, reader);
  return TakeCompilation(lowering);
}

/// True if a comment for the explorer says that the program is meant to run for ever.
bool SaysEndless(std::string_view source) {
  bool endless = false;
  ForEachToolComment(source, [&endless](int /*number*/, std::string_view line) {
    endless = endless || Trim(Trim(line).substr(kToolComment.size())) == "endless";
  });
  return endless;
}

Compilation CompileCardText(const std::string& path, std::string text, const Options& options,
                            const FileReader& reader, const TextLimits& limits) {
  Reporter reporter;
  Directives directives(options, reader, limits, reporter);
  directives.Run(SourceFile(path, std::move(text)));
  ParserDriver driver(directives.tokens(), reporter);
  driver.tree.macros = std::move(directives.macros());
  Parser parser(driver);
  parser.parse();

  Checker checker(options, directives.files(), reporter, directives.tokens());
  checker.AddSkippedNames(directives.skipped_names());
  checker.AddSkippedNames(driver.skipped_names());
  vm::Object object = checker.Check(driver.tree);
  // If a function begins inside another one, usually a '}' is missing; the error at the end of the
  // file would report the same again.
  if (reporter.Has(Code::kNestedFunction)) reporter.Drop(Code::kUnexpectedEnd);

  for (const DepthComment& comment : FindDepths(directives.files())) {
    reporter.Report(
        Code::kDepth, comment.range,
        MakeMessage("only structured C has functions that are called; remove the comment",
                    "只有结构化 C 才有被调用的函数；请删除此注释"));
  }
  if (!reporter.HasErrors()) {
    PlaceAsserts(directives.files(), checker.places(), &object, reporter);
  }
  if (!reporter.HasErrors()) WarnAboutFlow(object, checker.places(), *options.catalogue, reporter);
  if (SaysEndless(directives.files()[0].text())) reporter.Drop(Code::kEndlessLoop);
  ApplyWarningOptions(options, reporter);

  Compilation compilation;
  if (!reporter.HasErrors()) {
    compilation.object = std::move(object);
    for (const FunctionPlaces& places : checker.places()) {
      compilation.places.push_back(places.statements);
    }
  }
  compilation.diagnostics.assign(std::make_move_iterator(reporter.diagnostics().begin()),
                                 std::make_move_iterator(reporter.diagnostics().end()));
  SortAndLimit(compilation.diagnostics, directives.inclusion_points(), options.max_errors);
  for (SourceFile& file : directives.files()) compilation.files.push_back(std::move(file));
  return compilation;
}

Compilation Compile(const std::string& path, const Options& options, const FileReader& reader) {
  Result<std::string> text = reader(path);
  if (text.ok()) return CompileText(path, std::move(text).value(), options, reader);
  Reporter reporter;
  reporter.Report(Code::kCannotOpen, SourceRange{}, path, text.error().message);
  Compilation compilation;
  compilation.files.emplace_back(path, std::string());
  compilation.diagnostics.push_back(std::move(reporter.diagnostics().front()));
  return compilation;
}

Result<std::string> ReadSource(const std::string& path) { return ReadFile(path, kSourceKind); }

Compilation Compile(const std::string& path, const Options& options) {
  return Compile(path, options, ReadSource);
}

OutputPaths OutputPathsFor(const std::string& source_path, const std::string& folder) {
  const size_t slash = source_path.find_last_of("/\\");
  const size_t name_begin = slash == std::string::npos ? 0 : slash + 1;
  std::string name = source_path.substr(name_begin);
  const size_t dot = name.find_last_of('.');
  if (dot != std::string::npos && dot > 0) name.erase(dot);
  std::string stem = source_path.substr(0, name_begin) + name;
  if (!folder.empty()) {
    stem = folder;
    if (stem.back() != '/' && stem.back() != '\\') stem += '/';
    stem += name;
  }
  return {stem + ".bin", stem + ".ini"};
}

}  // namespace oncard::compiler
