// `oncard_bench explore`: how fast interleavings are searched, beside SPIN on the same programs in
// the same run. The programs are translated to Promela statement by statement: every statement of a
// motion program is one step of a process. Wall-clock time.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <variant>

#include "base/files.h"
#include "bench/measure.h"
#include "compiler/compiler.h"
#include "explore/scenario_exploration.h"
#include "vm/fixed_point.h"

namespace oncard::bench {
namespace {

/// Threads that each increment `x` in three statements.
std::string Increments(int threads, int times) {
  std::string source = "int x;\n";
  for (int thread = 0; thread < threads; ++thread) {
    source += fmt::format("int t{}() {{\n  int t;\n", thread);
    for (int i = 0; i < times; ++i) source += "  t = x;\n  t = t + 1;\n  x = t;\n";
    source += "  return 0;\n}\n";
  }
  return source;
}

/// Peterson's lock, which waits in a loop.
constexpr const char* kLock =
    "int f0, f1, turn, c;\n//@ final: c == 2\n"
    "int t0() {\n  int a, cc;\n  f0 = 1;\n  turn = 1;\nW:\n  a = f1;\n  cc = a == 0;\n"
    "  if (cc) goto C;\n  a = turn;\n  cc = a == 1;\n  if (cc) goto W;\nC:\n  a = c;\n  a = a + "
    "1;\n"
    "  c = a;\n  f0 = 0;\n  return 0;\n}\n"
    "int t1() {\n  int a, cc;\n  f1 = 1;\n  turn = 0;\nW:\n  a = f0;\n  cc = a == 0;\n"
    "  if (cc) goto C;\n  a = turn;\n  cc = a == 0;\n  if (cc) goto W;\nC:\n  a = c;\n  a = a + "
    "1;\n"
    "  c = a;\n  f1 = 0;\n  return 0;\n}\n";

/// A thread that asks for the status of a moving axis again and again, and one that counts.
constexpr const char* kMove =
    "int moving, ticks;\n"
    "int t0() {\n  int sts;\n  int clock;\n  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  GT_SetPos(1, "
    "500);\n"
    "  GT_SetVel(1, 10);\n  GT_Update(1);\nL:\n  GT_GetSts(1, &sts, 1, &clock);\n"
    "  moving = sts & 1024;\n  if (moving) goto L;\n  return 0;\n}\n"
    "int t1() {\nL:\n  ticks = ticks + 1;\n  GT_Delay(5);\n  if (moving) goto L;\n  return 0;\n}\n";

struct Program {
  runtime::Scenario scenario;
  std::vector<explore::Requirement> requirements;
  vm::Object object;
};

Program ProgramOf(const std::string& source) {
  auto compilation = compiler::CompileText("bench.c", source, {}, [](const std::string&) {
    return Result<std::string>(MakeError(1, "no files", "无文件"));
  });
  if (!compilation.ok()) Fail("cannot compile a program of threads");
  auto read = explore::ReadComments("bench.c", source, *compilation.object);
  if (!read.ok()) Fail(read.error().message.en);
  return {std::move(read.value().scenario), std::move(read.value().requirements),
          std::move(*compilation.object)};
}

explore::Exploration Search(const Program& program, explore::EngineKind engine) {
  explore::ExploreOptions options;
  options.engine = engine;
  auto findings =
      explore::ExploreScenario(program.scenario, program.requirements, program.object, options);
  if (!findings.ok()) Fail(findings.error().message.en);
  return std::move(findings.value().exploration);
}

// --- SPIN ----------------------------------------------------------------------------------------

/// Threads' variables are global in the model, so that all of a state is seen.
std::string PromelaOperand(const vm::Operand& operand, size_t thread) {
  const auto name = [&](vm::Storage storage, int id) {
    return storage == vm::Storage::kGlobal ? fmt::format("g[{}]", id)
                                           : fmt::format("l{}[{}]", thread, id);
  };
  if (const auto* immediate = std::get_if<vm::Immediate>(&operand)) {
    return fmt::format("({})", vm::IntFromFixed(immediate->raw));
  }
  if (const auto* variable = std::get_if<vm::Variable>(&operand)) {
    return name(variable->storage, variable->id);
  }
  Fail("the translation knows no arrays");
}

std::string PromelaStatement(const vm::Instruction& instruction, size_t thread, size_t index) {
  const auto operand = [&](size_t i) { return PromelaOperand(instruction.operands[i], thread); };
  switch (instruction.opcode) {
    case vm::Opcode::kUnary:
      return fmt::format("{} = {}", operand(1), operand(0));
    case vm::Opcode::kBinary:
      return fmt::format("{} = {} {} {}", operand(2), operand(0),
                         vm::FindBinaryOperator(instruction.op)->spelling, operand(1));
    case vm::Opcode::kJump:
      return fmt::format("if :: ({} != 0) -> goto L{} :: else fi", operand(0),
                         static_cast<int64_t>(index) + instruction.displacement);
    case vm::Opcode::kReturn:
      return "goto LE";
    case vm::Opcode::kCommand:
      break;
  }
  Fail("the translation knows no GT commands");
}

std::string Promela(const vm::Object& object) {
  std::string text = "int g[16];\n";
  for (size_t thread = 0; thread < object.functions.size(); ++thread) {
    text += fmt::format("int l{}[16];\n", thread);
  }
  for (size_t thread = 0; thread < object.functions.size(); ++thread) {
    text += fmt::format("active proctype t{}() {{\n", thread);
    const auto& instructions = object.functions[thread].instructions;
    for (size_t i = 0; i < instructions.size(); ++i) {
      text += fmt::format("L{}: {};\n", i, PromelaStatement(instructions[i], thread, i));
    }
    text += "LE: skip\n}\n";
  }
  return text;
}

/// States that SPIN stores without partial-order reduction, and the seconds that it takes.
struct SpinRun {
  double states = 0;
  double seconds = 0;
};

SpinRun RunSpin(const vm::Object& object) {
  char folder[] = "/tmp/oncard-bench-XXXXXX";
  if (mkdtemp(folder) == nullptr) Fail("cannot make a folder");
  const std::string path = folder;
  if (!WriteFileAtomically(path + "/model.pml", Promela(object)).ok()) Fail("cannot write a model");
  const std::string prepare = fmt::format(
      "cd {} && spin -a model.pml >/dev/null && gcc -O2 -DSAFETY -DNOREDUCE -o pan pan.c", path);
  if (std::system(prepare.c_str()) != 0) Fail("SPIN cannot translate a program");
  SpinRun run;
  run.seconds = MeasureWall([&] {
    const std::string command = fmt::format("cd {} && ./pan -m1000000 -w24 -E >out", path);
    if (std::system(command.c_str()) != 0) Fail("SPIN's search failed");
  });
  const auto report = ReadFile(path + "/out");
  if (!report.ok()) Fail("SPIN gave no report");
  const size_t end = report.value().find(" states, stored");
  if (end == std::string::npos) Fail("SPIN's report names no states");
  run.states = std::strtod(report.value().substr(report.value().rfind('\n', end)).c_str(), nullptr);
  std::filesystem::remove_all(path);
  return run;
}

// --- What is measured ----------------------------------------------------------------------------

void MeasureTraces(const char* name, const std::string& source) {
  const Program program = ProgramOf(source);
  double traces = 0;
  const double seconds = MeasureWall([&] {
    const auto found = Search(program, explore::EngineKind::kDpor);
    if (found.traces->blocked != 0 || found.traces->redundant != 0) Fail("redundant executions");
    traces = static_cast<double>(found.traces->executions);
  });
  std::printf("%-28s %12.0f traces  %10.3f s %8.2f M/s\n", name, traces, seconds,
              traces / seconds * 1e-6);
}

void MeasureStates(const char* name, const std::string& source) {
  const Program program = ProgramOf(source);
  double states = 0;
  const double seconds = MeasureWall([&] {
    states = static_cast<double>(Search(program, explore::EngineKind::kStateful).states->states);
  });
  std::printf("%-28s %12.0f states  %10.3f s %8.2f M/s\n", name, states, seconds,
              states / seconds * 1e-6);
  const SpinRun spin = RunSpin(program.object);
  std::printf("%-28s %12.0f states  %10.3f s %8.2f M/s\n", "  SPIN, no reduction", spin.states,
              spin.seconds, spin.states / spin.seconds * 1e-6);
}

void MeasureCard(const char* name, const std::string& source) {
  Program program = ProgramOf(source);
  program.scenario.cycle_us = 1000;
  program.scenario.rate = 10;
  double states = 0;
  const double seconds = MeasureWall([&] {
    states = static_cast<double>(Search(program, explore::EngineKind::kStateful).states->states);
  });
  std::printf("%-28s %12.0f states  %10.3f s %8.3f M/s\n", name, states, seconds,
              states / seconds * 1e-6);
}

}  // namespace

void BenchExplore() {
  MeasureTraces("3 threads x 3 increments", Increments(3, 3));
  MeasureStates("3 threads x 3 increments", Increments(3, 3));
  MeasureStates("Peterson's lock", kLock);
  MeasureCard("a moving axis, two threads", kMove);
}

}  // namespace oncard::bench
