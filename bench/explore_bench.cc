// `oncard_bench explore`: measures how fast interleavings are explored, compared with SPIN on the
// same programs in the same run. The programs are translated to Promela statement by statement:
// every statement of a motion program is one step of a process. Wall-clock time.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/files.h"
#include "bench/measure.h"
#include "bench/tool.h"
#include "compiler/compiler.h"
#include "explore/engines/shrink.h"
#include "explore/engines/trace_count.h"
#include "explore/scenario_exploration.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "tests/explore/explore_programs.h"
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

/// A lock that tests and sets in two statements.
constexpr const char* kNaiveLock =
    "int lock, c;\n//@ final: c == 2\n"
    "int t0() {\n  int a;\nW:\n  a = lock;\n  if (a) goto W;\n  lock = 1;\n  a = c;\n  a = a + 1;\n"
    "  c = a;\n  lock = 0;\n  return 0;\n}\n"
    "int t1() {\n  int a;\nW:\n  a = lock;\n  if (a) goto W;\n  lock = 1;\n  a = c;\n  a = a + 1;\n"
    "  c = a;\n  lock = 0;\n  return 0;\n}\n";

/// Threads that each write `x` once.
std::string Writers(int threads) {
  std::string source = "int x;\n";
  for (int i = 0; i < threads; ++i) {
    source += fmt::format("int t{}() {{\n  x = {};\n  return 0;\n}}\n", i, i + 1);
  }
  return source;
}

/// A thread that writes `x` and others that read it.
std::string Readers(int readers) {
  std::string source = "int x;\nint t0() {\n  x = 42;\n  return 0;\n}\n";
  for (int i = 1; i <= readers; ++i) {
    source += fmt::format("int t{}() {{\n  int r;\n  r = x;\n  return r;\n}}\n", i);
  }
  return source;
}

/// A thread that searches for the last zero, starting at the end, while each of the others sets an
/// element to one more than the element before it.
std::string LastZero(int writers) {
  std::string source = "int a[32];\nint t0() {\n  int c, r;\n";
  std::string ends;
  for (int i = writers; i >= 1; --i) {
    source += fmt::format("  r = a[{0}];\n  c = r == 0;\n  if (c) goto E{0};\n", i);
    ends += fmt::format("E{0}:\n  return {0};\n", i);
  }
  source += "  r = a[0];\n  return 0;\n" + ends + "}\n";
  for (int i = 1; i <= writers; ++i) {
    source += fmt::format(
        "int t{0}() {{\n  int r;\n  r = a[{1}];\n  r = r + 1;\n  a[{0}] = r;\n  return 0;\n}}\n", i,
        i - 1);
  }
  return source;
}

/// A thread that counts forever.
constexpr const char* kCounter =
    "int n;\nint t0() {\nL:\n  n = n + 1;\n  goto L;\n  return 0;\n}\n";

/// A thread that repeatedly reads the status of a moving axis, and one that counts.
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
  // SPIN counts the states between single statements.
  if (engine == explore::EngineKind::kStateful) options.merge_private = false;
  auto findings =
      explore::ExploreScenario(program.scenario, program.requirements, program.object, options);
  if (!findings.ok()) Fail(findings.error().message.en);
  return std::move(findings.value().exploration);
}

// --- SPIN ----------------------------------------------------------------------------------------

/// How SPIN searches.
enum class SpinSearch {
  kEveryState,  ///< without its partial-order reduction
  kReduced,     ///< with it
};

/// The translation of an object. For the reduction, the variables of threads are local to their
/// processes, because SPIN takes statements as independent if they access nothing global. Without
/// it they are global, so that they remain part of the state when a process has ended.
class PromelaModel {
 public:
  PromelaModel(const vm::Object& object, SpinSearch search) : object_(object), search_(search) {}

  std::string Text() const {
    std::string text = "int g[16];\n";
    for (size_t thread = 0; thread < object_.functions.size(); ++thread) {
      if (search_ == SpinSearch::kEveryState) text += fmt::format("int l{}[16];\n", thread);
    }
    for (size_t thread = 0; thread < object_.functions.size(); ++thread) {
      text += fmt::format("active proctype t{}() {{\n", thread);
      if (search_ == SpinSearch::kReduced) text += fmt::format("int l{}[16];\n", thread);
      const auto& instructions = object_.functions[thread].instructions;
      for (size_t i = 0; i < instructions.size(); ++i) {
        text += fmt::format("L{}: {};\n", i, Statement(instructions[i], thread, i));
      }
      text += "LE: skip\n}\n";
    }
    return text;
  }

 private:
  std::string Operand(const vm::Operand& operand, size_t thread) const {
    if (const auto* immediate = std::get_if<vm::Immediate>(&operand)) {
      return fmt::format("({})", vm::IntFromFixed(immediate->raw));
    }
    if (const auto* variable = std::get_if<vm::Variable>(&operand)) {
      return variable->storage == vm::Storage::kGlobal
                 ? fmt::format("g[{}]", variable->id)
                 : fmt::format("l{}[{}]", thread, variable->id);
    }
    Fail("the translation knows no arrays");
  }

  std::string Statement(const vm::Instruction& instruction, size_t thread, size_t index) const {
    const auto operand = [&](size_t i) { return Operand(instruction.operands[i], thread); };
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

  const vm::Object& object_;
  SpinSearch search_;
};

/// SPIN's search program for an object, in a folder of its own.
class SpinProgram {
 public:
  SpinProgram(const vm::Object& object, SpinSearch search) : folder_(NewFolder()) {
    if (!WriteFileAtomically(folder_ + "/model.pml", PromelaModel(object, search).Text()).ok()) {
      Fail("cannot write a model");
    }
    const std::string command =
        fmt::format("cd {} && spin -a model.pml >/dev/null && gcc -O2 -DSAFETY {} -o pan pan.c",
                    folder_, search == SpinSearch::kEveryState ? "-DNOREDUCE" : "");
    if (std::system(command.c_str()) != 0) Fail("SPIN cannot translate a program");
  }
  SpinProgram(const SpinProgram&) = delete;
  SpinProgram& operator=(const SpinProgram&) = delete;
  ~SpinProgram() { std::filesystem::remove_all(folder_); }

  void Search() const {
    const std::string command = fmt::format("cd {} && ./pan -m1000000 -w24 -E >out", folder_);
    if (std::system(command.c_str()) != 0) Fail("SPIN's search failed");
  }

  /// The number of states that the last search has stored.
  double States() const {
    const auto report = ReadFile(folder_ + "/out");
    if (!report.ok()) Fail("SPIN gave no report");
    const size_t end = report.value().find(" states, stored");
    if (end == std::string::npos) Fail("SPIN's report names no states");
    return std::strtod(report.value().substr(report.value().rfind('\n', end)).c_str(), nullptr);
  }

 private:
  std::string folder_;
};

// --- What is measured ----------------------------------------------------------------------------

/// Prints what was found, and the rate.
double PrintRate(const char* name, double found, const char* of, double seconds) {
  const double rate = found / seconds * 1e-6;
  std::printf("%-28s %12.0f %s  %10.3f s %8.2f M/s\n", name, found, of, seconds, rate);
  std::fflush(stdout);
  return rate;
}

/// Returns the rate in millions of traces per second.
double MeasureTraces(const char* name, const std::string& source) {
  const Program program = ProgramOf(source);
  double traces = 0;
  const double seconds = MeasureWall([&] {
    const auto found = Search(program, explore::EngineKind::kDpor);
    if (found.traces->blocked != 0 || found.traces->redundant != 0) Fail("redundant executions");
    traces = static_cast<double>(found.traces->executions);
  });
  return PrintRate(name, traces, "traces", seconds);
}

/// More than the searches of states need, SPIN's with its table of 2^24 states.
constexpr size_t kSearchMemory = size_t{512} << 20;

/// Beside SPIN; returns the rate in millions of states per second.
double MeasureStates(const char* name, const std::string& source) {
  const Program program = ProgramOf(source);
  const SpinProgram every(program.object, SpinSearch::kEveryState);
  const SpinProgram reduced(program.object, SpinSearch::kReduced);
  double states = 0;
  const auto samples = MeasureInTurns(Clock::kWall,
                                      {
                                          [&] {
                                            const auto found =
                                                Search(program, explore::EngineKind::kStateful);
                                            states = static_cast<double>(found.states->states);
                                          },
                                          [&] { every.Search(); },
                                          [&] { reduced.Search(); },
                                      },
                                      kSearchMemory);
  const double rate = PrintRate(name, states, "states", Shortest(samples[0]));
  PrintRate("  SPIN, no reduction", every.States(), "states", Shortest(samples[1]));
  PrintRate("  SPIN, partial order", reduced.States(), "states", Shortest(samples[2]));
  const Ratio to_every = RatioOf(samples[0], samples[1]);
  const Ratio to_reduced = RatioOf(samples[0], samples[2]);
  std::printf("  time relative to SPIN: %.2f (%.2f..%.2f), with its reduction %.2f (%.2f..%.2f)\n",
              to_every.shortest, to_every.low, to_every.high, to_reduced.shortest, to_reduced.low,
              to_reduced.high);
  return rate;
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

/// Wall-clock seconds for work that is long enough to be measured once.
template <typename Work>
double Once(const Work& work) {
  const auto before = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  return passed.count();
}

/// A program that is decided by its graph of states, however long its loops wait.
void MeasureLoop(const char* name, const std::string& source, explore::Verdict verdict) {
  const Program program = ProgramOf(source);
  if (Search(program, explore::EngineKind::kAuto).verdict != verdict) Fail("another verdict");
  std::printf("%-28s %-12s %20.4f s\n", name, std::string(explore::VerdictName(verdict)).c_str(),
              MeasureWall([&] { Search(program, explore::EngineKind::kAuto); }));
}

/// Compares the better engine for a program alone with both running at the same time.
void MeasureAuto(const char* name, const std::string& source, explore::EngineKind better) {
  const Program program = ProgramOf(source);
  const double alone = Once([&] { Search(program, better); });
  const double both = Once([&] { Search(program, explore::EngineKind::kAuto); });
  std::printf("%-28s %-9s%8.3f s, auto %8.3f s: %4.2f times as long\n", name,
              std::string(explore::EngineName(better)).c_str(), alone, both, both / alone);
}

/// The same search as one process and as two at the same time.
void MeasureShards(const std::string& source) {
  const std::string path = NewFolder();
  if (!WriteFileAtomically(path + "/p.c", source).ok()) Fail("cannot write a program");
  const auto seconds = [&](const std::string& command) {
    return Once([&] {
      const std::string clean = "cd " + path + " && rm -f *.search && { ";
      if (std::system((clean + command + "; } >/dev/null").c_str()) != 0) Fail("a part failed");
    });
  };
  const std::string explore = ONCARD_TOOL " explore p.c --engine dpor --shard ";
  const auto part = [&](const char* which) {
    return "{ " + explore + which + " || [ $? -le 5 ]; }";
  };
  const double one = seconds(part("1/1"));
  const double two = seconds(part("1/2") + " & " + part("2/2") + "; wait");
  std::printf("%-28s one process %8.3f s, two %8.3f s: %4.2f times as fast\n", "parts of a search",
              one, two, one / two);
  std::filesystem::remove_all(path);
}

explore::Problem ProblemOf(const Program& program) {
  auto problem = explore::ProblemOfScenario(program.scenario, program.requirements, program.object);
  if (!problem.ok()) Fail(problem.error().message.en);
  return std::move(problem).value();
}

/// The traces of a search, without an execution for each.
void MeasureCount(const char* name, const std::string& source) {
  const explore::Problem problem = ProblemOf(ProgramOf(source));
  double traces = 0;
  const double seconds = MeasureWall([&] {
    const auto count =
        explore::CountTraces(problem.model, {}, [](const explore::Model&) { return true; });
    if (!count) Fail("traces cannot be counted");
    traces = static_cast<double>(count->traces);
  });
  PrintRate(name, traces, "traces", seconds);
}

/// How long it takes to simplify a random failing schedule.
void MeasureShrinking(const char* name, const std::string& source) {
  const explore::Problem problem = ProblemOf(ProgramOf(source));
  const auto samples = explore::Sample(problem, {.runs = 1000});
  if (samples.bad == 0) Fail("no random schedule fails");
  int preemptions = 0;
  const double seconds =
      Once([&] { preemptions = explore::Shrink(problem, samples.failing).preemptions; });
  std::printf("%-28s %d preemptions %21.4f s\n", name, preemptions, seconds);
}

/// Records random runs and replays them: both must end in the same state.
void MeasureReplays(int64_t pairs) {
  const Program program = ProgramOf(Increments(2, 2));
  runtime::Controller controller(runtime::CardOptions(program.scenario));
  if (!runtime::StartScenario(program.scenario, program.object, &controller).ok()) {
    Fail("cannot start a program");
  }
  vm::Machine& machine = controller.machine();
  const auto start = std::make_unique<vm::MachineState>(machine.state());
  const auto run = [&](const vm::Policy& policy) {
    machine.Restore(*start);
    machine.SetPolicy(policy);
    machine.Execute(INT64_MAX);
    return machine.Hash();
  };
  const double seconds = Once([&] {
    for (int64_t i = 0; i < pairs; ++i) {
      vm::Policy policy;
      policy.kind = vm::PolicyKind::kRandom;
      policy.seed = static_cast<uint64_t>(i);
      vm::Recording recording;
      machine.Record(&recording);
      const uint64_t recorded = run(policy);
      machine.Record(nullptr);
      policy.kind = vm::PolicyKind::kReplay;
      policy.schedule = std::make_shared<const vm::Schedule>(vm::ScheduleOf(recording));
      if (run(policy) != recorded) Fail("a replay ends in another state");
    }
  });
  std::printf("%-28s %12.0f pairs   %10.3f s\n", "recorded and replayed",
              static_cast<double>(pairs), seconds);
}

/// The longest time of a hundred steps back in a long run.
void MeasureStepsBack(int64_t steps) {
  explore::Model model = ProblemOf(ProgramOf(kCounter)).model;
  for (int64_t i = 0; i < steps; ++i) model.Step(0);
  std::vector<double> microseconds;
  for (int i = 0; i < 100'000; ++i) {
    const auto before = std::chrono::steady_clock::now();
    model.Undo();
    const std::chrono::duration<double, std::micro> passed =
        std::chrono::steady_clock::now() - before;
    microseconds.push_back(passed.count());
  }
  const auto p99 =
      microseconds.begin() + static_cast<std::ptrdiff_t>(microseconds.size() / 100 * 99);
  std::nth_element(microseconds.begin(), p99, microseconds.end());
  std::printf("%-28s %12.0f steps, p99 of a step back %8.3f us\n", "steps back",
              static_cast<double>(steps), *p99);
}

}  // namespace

void BenchExplore() {
  const double traces = MeasureTraces("3 threads x 3 increments", Increments(3, 3));
  MeasureCount("  counted", Increments(3, 3));
  MeasureCount("3 x 4 increments, counted", Increments(3, 4));
  MeasureTraces("13 readers", Readers(13));
  MeasureTraces("last zero of 13", LastZero(13));
  MeasureStates("3 threads x 3 increments", Increments(3, 3));
  const double states = MeasureStates("4 threads x 2 increments", Increments(4, 2));
  MeasureStates("Peterson's lock", explore::Peterson(false));
  std::printf("inc_3x3 dpor: %.2f M traces/s\n", traces);
  std::printf("inc_4x2 stateful: %.2f M states/s\n", states);
  MeasureCard("a moving axis, two threads", kMove);
  BenchCardSearches();
  MeasureLoop("Peterson's lock", explore::Peterson(false), explore::Verdict::kProved);
  MeasureLoop("a lock that looks, then takes", kNaiveLock, explore::Verdict::kFailed);
  MeasureAuto("4 threads x 2 increments", Increments(4, 2), explore::EngineKind::kStateful);
  MeasureAuto("9 writers", Writers(9), explore::EngineKind::kStateful);
  MeasureAuto("13 readers", Readers(13), explore::EngineKind::kDpor);
  MeasureAuto("last zero of 10", LastZero(10), explore::EngineKind::kDpor);
  MeasureShards(Increments(3, 3));
  MeasureShrinking("a lock that looks, then takes", kNaiveLock);
  MeasureReplays(1'000'000);
  MeasureStepsBack(10'000'000);
}

}  // namespace oncard::bench
