// Programs: from source to a run, and from object files to a listing and a run.
#include <string>

#include "base/files.h"
#include "compiler/compiler.h"
#include "compiler/diagnostic_printer.h"
#include "compiler/structured_source.h"
#include "compiler/tree_walk.h"
#include "gtcalls/gts/catalogue.h"
#include "runtime/scenario/run/scenario_run.h"
#include "tests/fuzz/fuzz.h"
#include "vm/disassembler.h"
#include "vm/object_reader.h"
#include "vm/object_writer.h"
#include "vm/verifier.h"

namespace oncard::fuzz {
namespace {

class CatalogueShapes final : public vm::CommandTable {
 public:
  const vm::CommandShape* Find(uint16_t number) const override {
    const gtcalls::Command* command = gtcalls::GtsCatalogue().Find(number);
    return command == nullptr ? nullptr : &gtcalls::GtsCatalogue().ShapeOf(*command);
  }
  int16_t Execute(uint16_t /*number*/, vm::Machine& /*machine*/, int /*thread*/,
                  std::span<vm::CommandArgument> /*arguments*/) override {
    return 0;
  }
};

/// The include file to which the texts may refer.
Result<std::string> ReadIncluded(const std::string& path) {
  if (path == "a.h") return std::string("#define A 1\nint shared;\n");
  return MakeError(kNoSuchFile, "no such file", "没有该文件");
}

void CheckPlaces(const compiler::Compilation& compilation) {
  for (const compiler::Diagnostic& diagnostic : compilation.diagnostics) {
    const compiler::SourceRange& range = diagnostic.range;
    FUZZ_CHECK(static_cast<size_t>(range.file) < compilation.files.size());
    FUZZ_CHECK(range.begin <= range.end);
    FUZZ_CHECK(range.end <= compilation.files[static_cast<size_t>(range.file)].text().size());
  }
}

/// The two parts of an input: the .bin up to the first line of an .ini, and that .ini. The checksum
/// is corrected, because a fuzzer cannot guess it.
vm::ObjectFiles FilesOf(std::string_view bytes) {
  constexpr std::string_view kChecksum = "bin_crc32=";
  const size_t split = std::min(bytes.find("[function]"), bytes.size());
  vm::ObjectFiles files{std::string(bytes.substr(0, split)), std::string(bytes.substr(split))};
  const size_t at = files.ini.find(kChecksum);
  if (at != std::string::npos && at + kChecksum.size() + 8 <= files.ini.size()) {
    files.ini.replace(at + kChecksum.size(), 8, fmt::format("{:08x}", vm::BinChecksum(files.bin)));
  }
  return files;
}

}  // namespace

const vm::CommandTable& Shapes() {
  static const CatalogueShapes shapes;
  return shapes;
}

const vm::Object& SeedProgram() {
  static const vm::Object program =
      *compiler::Compile(ONCARD_SOURCE_DIR "/tests/fuzz/seeds/race.c").object;
  return program;
}

void RunBriefly(const vm::Object& object) {
  runtime::Scenario scenario;
  scenario.limit_ms = 5;
  for (const vm::Function& function : object.functions) {
    if (scenario.threads.size() == vm::kThreadCount) break;
    runtime::ThreadStart start;
    start.thread = start.page = static_cast<int>(scenario.threads.size());
    start.function = function.name;
    scenario.threads.push_back(start);
  }
  runtime::RunOptions options;
  options.trace = true;
  static_cast<void>(runtime::RunScenario(scenario, object, options));
}

/// Compiles a text, prints what the compiler says, and runs the program if there is one.
static void CompileAndRun(std::string_view text, bool structured) {
  compiler::Options options;
  options.max_errors = 0;
  options.structured = structured;
  const auto compilation = compiler::CompileText("p.c", std::string(text), options, ReadIncluded);
  CheckPlaces(compilation);
  static_cast<void>(compiler::PrintText(compilation, {}));
  static_cast<void>(compiler::PrintJson(compilation, {}));
  if (!compilation.ok()) return;
  const vm::Object& object = *compilation.object;
  const auto verified = vm::Verify(object, Shapes());
  FUZZ_CHECK(verified.ok());
  const auto read = vm::ReadObject(vm::WriteObject(object, false));
  FUZZ_CHECK(read.ok());
  RunBriefly(object);
}

void FuzzSource(std::string_view bytes) { CompileAndRun(bytes, false); }

void FuzzStructured(std::string_view bytes) {
  const compiler::Options options;
  compiler::Reporter reporter;
  const compiler::StructuredSource source("p.c", std::string(bytes), options, ReadIncluded,
                                          reporter);
  source.AddMacroNotes(reporter);
  const auto check = [&source](const compiler::SourceRange& range) {
    FUZZ_CHECK(static_cast<size_t>(range.file) < source.files().size());
    FUZZ_CHECK(range.begin <= range.end);
    FUZZ_CHECK(range.end <= source.files()[static_cast<size_t>(range.file)].text().size());
  };
  for (const compiler::Diagnostic& diagnostic : reporter.diagnostics()) {
    check(diagnostic.range);
    for (const compiler::Note& note : diagnostic.notes) {
      if (note.has_place) check(note.range);
    }
    for (const compiler::FixIt& edit : diagnostic.fixits) check(edit.range);
  }
  const auto check_expression = [&check](const compiler::Expression& expression) {
    check(expression.range);
  };
  for (const compiler::StatementPtr& item : source.tree().items) {
    compiler::ForEachStatement(*item, [&](const compiler::Statement& statement) {
      check(statement.range);
      compiler::ForEachWholeExpression(statement, [&](const compiler::Expression& whole) {
        compiler::ForEachExpression(whole, check_expression);
      });
    });
  }
  CompileAndRun(bytes, true);
}

void FuzzObject(std::string_view bytes) {
  const auto object = vm::ReadObject(FilesOf(bytes));
  if (!object.ok()) return;
  // The reader accepts exactly what the writer writes.
  const auto again = vm::ReadObject(vm::WriteObject(object.value(), false));
  FUZZ_CHECK(again.ok());
  if (vm::Verify(object.value(), Shapes()).ok()) RunBriefly(object.value());
}

void FuzzDisassembler(std::string_view bytes) {
  const auto object = vm::ReadObject(FilesOf(bytes));
  if (!object.ok()) return;
  static_cast<void>(vm::Disassemble(object.value(), Shapes()));
  static_cast<void>(vm::DisassembleJson(object.value(), Shapes()));
}

}  // namespace oncard::fuzz
