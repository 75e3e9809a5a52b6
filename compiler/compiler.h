// Compiles one motion program: source text in, vm::Object and diagnostics out. No output, no
// exceptions, no global state: usable from any thread.
// The language is described in docs/language.md, structured C in docs/structured.md.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"
#include "base/result.h"
#include "compiler/diagnostic.h"
#include "gtcalls/gts/catalogue.h"
#include "vm/fixed_point.h"
#include "vm/object.h"

namespace oncard::compiler {

struct Options {
  vm::DoubleFormat double_format = vm::DoubleFormat::k32_16;
  /// Folders searched for `#include "file"` after the folder of the including file.
  std::vector<std::string> include_folders;
  /// After this number of errors the rest is not reported (a note says so). 0: no limit.
  int max_errors = 50;
  /// Warnings are errors: a program with warnings gives no object.
  bool warnings_are_errors = false;
  /// Codes of warnings that are not reported.
  std::vector<int> silent_warnings = {};
  /// The commands that programs may call. There are motion programs on GTS controllers only.
  const gtcalls::Catalogue* catalogue = &gtcalls::GtsCatalogue();
  /// The program is structured C (docs/structured.md) even if its first line does not say so.
  bool structured = false;
  /// Structured C that does not say so gets one error, and not one for each of its constructs.
  bool recognize_structured = true;
};

/// Reads `error`, or `no-` with the slug of a warning, into the options unless they are nullptr.
/// False for anything else.
bool ReadWarningOption(std::string_view text, Options* options);

/// Returns the bytes of a file, or an Error, kNoSuchFile if there is none; tests replace the file
/// system with it.
using FileReader = std::function<Result<std::string>(const std::string& path)>;

/// The reader of the file system: regular files up to the bound of kSourceKind.
Result<std::string> ReadSource(const std::string& path);

struct Compilation {
  /// Every file that was read, in order; Diagnostic locations index it. [0] is the program.
  std::vector<SourceFile> files;
  /// In source order: by file of the program's inclusion point, line, column.
  std::vector<Diagnostic> diagnostics;
  /// Present when there is no error.
  std::optional<vm::Object> object;
  /// For each function of the object, what each of its instructions comes from: a statement, or in
  /// structured C a part of one. File -1: nothing.
  std::vector<std::vector<SourceRange>> places;

  bool ok() const { return object.has_value(); }
};

/// Compiles the program at `path`. An unreadable file is a diagnostic (MP022), not a failure.
Compilation Compile(const std::string& path, const Options& options, const FileReader& reader);

/// The same, reading from the file system.
Compilation Compile(const std::string& path, const Options& options = {});

/// True for structured C: the options say so, or the first line of the program.
bool IsStructured(const Options& options, std::string_view text);

/// Compiles text that is in memory under the name `path`; includes go through `reader`. A program
/// of structured C is lowered first; diagnostics and lines of the object are those of its source.
Compilation CompileText(const std::string& path, std::string text, const Options& options,
                        const FileReader& reader);

/// How much a program and all it includes may have.
struct TextLimits {
  size_t bytes = kSourceKind.bytes_max;
  size_t tokens = kTokenMax;
};

/// The same for a program of the card's language, whatever Options::structured and its first line
/// say.
Compilation CompileCardText(const std::string& path, std::string text, const Options& options,
                            const FileReader& reader, const TextLimits& limits = {});

/// Paths of the pair that belongs to a source: `dir/sum.c` -> `dir/sum.bin`, `dir/sum.ini`, or in
/// `folder` when it is not empty.
struct OutputPaths {
  std::string bin;
  std::string ini;
};
OutputPaths OutputPathsFor(const std::string& source_path, const std::string& folder = {});

}  // namespace oncard::compiler
