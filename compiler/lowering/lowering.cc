#include "compiler/lowering/lowering.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "compiler/asserts.h"
#include "compiler/lowering/costs.h"
#include "compiler/lowering/lowerer.h"
#include "compiler/lowering/passes/passes.h"
#include "compiler/lowering/printer.h"
#include "compiler/lowering/speller.h"
#include "compiler/lowering/written_names.h"
#include "compiler/structured_source.h"

namespace oncard::compiler {
namespace {

// The place in C of a place in the lowered text; file -1: none.
SourceRange OriginOf(const SourceRange& range, const SourceFile& text,
                     const std::vector<SourceRange>& origins) {
  const size_t line = static_cast<size_t>(text.LineOf(range.begin)) - 1;
  SourceRange nowhere;
  nowhere.file = -1;
  return line < origins.size() ? origins[line] : nowhere;
}

// The compiler's diagnostics of the lowered text, at the places of C. The same statement may stand
// in the text several times.
void Translate(const Compilation& compilation, const std::vector<SourceRange>& origins,
               bool has_asserts, Reporter& reporter) {
  const SourceFile& text = compilation.files[0];
  const auto origin = [&](const SourceRange& range) { return OriginOf(range, text, origins); };
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    // It includes nothing that could not be read: the text is too long itself.
    if (diagnostic.info->code == static_cast<int>(Code::kCannotOpen)) {
      reporter.Report(Code::kLoweredTooLong, SourceRange(), text.path());
      continue;
    }
    // An assert keeps values that nothing else reads; without them the passes remove such values.
    if (has_asserts && diagnostic.info->code == static_cast<int>(Code::kUnusedResult)) continue;
    const SourceRange place = origin(diagnostic.range);
    const bool known = std::any_of(reporter.diagnostics().begin(), reporter.diagnostics().end(),
                                   [&](const Diagnostic& other) {
                                     return other.info == diagnostic.info && other.range == place;
                                   });
    if (known) continue;
    Diagnostic translated;
    translated.info = diagnostic.info;
    translated.severity = diagnostic.severity;
    translated.range = place.file < 0 ? SourceRange() : place;
    translated.message = diagnostic.message;
    for (const Note& note : diagnostic.notes) {
      Note moved = note;
      moved.range = note.has_place ? origin(note.range) : note.range;
      moved.has_place = note.has_place && moved.range.file >= 0;
      translated.notes.push_back(std::move(moved));
    }
    std::string_view line = text.Line(text.LineOf(diagnostic.range.begin));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    AddNote(translated,
            MakeMessage("the lowered statement is '{0}'", "转换后的语句是 '{0}'", line));
    reporter.diagnostics().push_back(std::move(translated));
  }
}

/// Gives the instructions of a function the lines of C, in the file where the function begins. What
/// comes from another file, such as a function that it calls, has the line of the statement before.
void MoveLines(SourceRange header, const std::deque<SourceFile>& files,
               const std::vector<SourceRange>& origins, vm::Function* function) {
  const SourceFile& file = files[static_cast<size_t>(header.file)];
  function->file = file.IniName();
  int line = file.LineOf(header.begin);
  for (uint16_t& number : function->lines) {
    if (number == 0) continue;  // beyond the last line that an object can name
    const SourceRange& origin = origins[number - 1u];
    if (origin.file == header.file) line = file.LineOf(origin.begin);
    number = line <= UINT16_MAX ? static_cast<uint16_t>(line) : uint16_t{0};
  }
}

// Reports the asserts that no function of the card has, which could never fail.
void CheckAsserts(const lowering::Program& program, const std::vector<AssertComment>& asserts,
                  Reporter& reporter) {
  std::set<std::pair<int, uint32_t>> kept;
  for (const lowering::LoweredFunction& function : program.functions) {
    for (const lowering::Instruction& instruction : function.code) {
      if (instruction.kind != lowering::Instruction::Kind::kAssert) continue;
      const SourceRange& comment =
          program.assertions[static_cast<size_t>(instruction.assertion)].comment;
      kept.emplace(comment.file, comment.begin);
    }
  }
  for (const AssertComment& comment : asserts) {
    if (kept.contains({comment.range.file, comment.range.begin})) continue;
    reporter.Report(Code::kMisplacedAssert, comment.range,
                    MakeMessage("stands before a statement that no thread can reach",
                                "其后的语句没有线程能够到达"));
  }
}

/// Gives the asserts of a function the words of C.
void NameAsserts(const lowering::Program& program, const lowering::LoweredFunction& lowered,
                 vm::Function* function) {
  const lowering::Speller speller(program);
  auto assert = function->asserts.begin();
  for (const lowering::Instruction& instruction : lowered.code) {
    if (instruction.kind != lowering::Instruction::Kind::kAssert) continue;
    const lowering::Assertion& assertion =
        program.assertions[static_cast<size_t>(instruction.assertion)];
    assert->written = assertion.written;
    for (size_t i = 0; i < assertion.names.size(); ++i) {
      assert->names.emplace_back(speller.SpellName(instruction, i), assertion.names[i]);
    }
    ++assert;
  }
}

/// Tells a function where its recursive functions keep what they need.
void WriteFrames(const lowering::Program& program, const lowering::LoweredFunction& lowered,
                 vm::Function* function) {
  for (const lowering::KeptFrames& frames : lowered.frames) {
    const std::string& array = program.variables[static_cast<size_t>(frames.array)].name;
    const auto symbol = std::ranges::find(function->variables, array, &vm::Symbol::name);
    if (symbol == function->variables.end()) continue;  // no statement uses them
    function->frames.push_back({frames.name, frames.depth, symbol->id});
  }
}

// The variables that the statements of a function name.
std::vector<int> VariablesOf(const lowering::LoweredFunction& function) {
  std::vector<int> variables;
  for (const lowering::Instruction& instruction : function.code) {
    lowering::ForEachOperand(instruction, [&](const lowering::Operand& operand, bool /*written*/) {
      if (operand.variable >= 0) variables.push_back(operand.variable);
    });
  }
  return variables;
}

}  // namespace

Lowering LowerText(const std::string& path, std::string text, const Options& options,
                   const LoweringOptions& lowering_options, const FileReader& reader) {
  Reporter reporter;
  StructuredSource source(path, std::move(text), options, reader, reporter);
  Lowering result;
  if (!reporter.HasErrors()) {
    lowering::Program program =
        lowering::Lowerer(options, source.files(), source.macro_uses(), reporter, lowering_options)
            .Lower(source.tree(), source.asserts(), source.depths());
    result.tried_statements = program.tried_statements;
    if (!reporter.HasErrors()) {
      const auto taken = lowering::SharedNames(program);
      for (lowering::LoweredFunction& function : program.functions) {
        lowering::RemoveUnusedLabels(function);
        if (lowering_options.optimize) {
          lowering::Optimize(program, function, options.double_format);
        }
        lowering::GiveStatementsToAsserts(function);
        lowering::ShareTemporaries(taken, program, function);
        FunctionCost cost = lowering::CostOf(program, function);
        if (lowering_options.optimize && cost.page_slots > lowering_options.slots) {
          lowering::ShareSlots(cost.page_slots - lowering_options.slots, program, function);
          cost = lowering::CostOf(program, function);
        }
        result.costs.push_back(std::move(cost));
      }
      result.global_slots = lowering::GlobalSlots(program);
      lowering::CheckLimits(program, result.costs, reporter);
      CheckAsserts(program, source.asserts(), reporter);
    }
    if (!reporter.HasErrors()) {
      lowering::PrintedProgram printed = lowering::Print(program, source, lowering_options);
      Compilation compilation = CompileCardText(path, printed.text, options, reader,
                                                {kLoweredBytesMax, kLoweredBytesMax});
      Translate(compilation, printed.origins, !program.assertions.empty(), reporter);
      if (!reporter.HasErrors()) {
        for (size_t i = 0; i < program.functions.size(); ++i) {
          MoveLines(program.functions[i].header, source.files(), printed.origins,
                    &compilation.object->functions[i]);
          WriteFrames(program, program.functions[i], &compilation.object->functions[i]);
          NameAsserts(program, program.functions[i], &compilation.object->functions[i]);
          lowering::WriteNames(program, VariablesOf(program.functions[i]),
                               &compilation.object->functions[i].variables);
        }
        lowering::WriteNames(program, program.globals, &compilation.object->globals);
        for (std::vector<SourceRange>& places : compilation.places) {
          for (SourceRange& place : places) {
            place = OriginOf(place, compilation.files[0], printed.origins);
          }
        }
        result.places = std::move(compilation.places);
        result.object = std::move(compilation.object);
        result.text = std::move(printed.text);
      }
      result.origins = std::move(printed.origins);
      result.statements = std::move(printed.statements);
    }
  }
  source.AddMacroNotes(reporter);
  result.diagnostics.assign(std::make_move_iterator(reporter.diagnostics().begin()),
                            std::make_move_iterator(reporter.diagnostics().end()));
  SortAndLimit(result.diagnostics, source.inclusion_points(), options.max_errors);
  result.files.assign(source.files().begin(), source.files().end());
  return result;
}

Compilation TakeCompilation(Lowering& lowering) {
  return {std::move(lowering.files), std::move(lowering.diagnostics), std::move(lowering.object),
          std::move(lowering.places)};
}

}  // namespace oncard::compiler
