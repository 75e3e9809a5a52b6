// `oncard_bench vm`: measures how fast motion programs run, compared with Lua 5.4 and gcc -O2 on
// the same kernels in the same run. The contenders take turns. CPU time.
#include <lua.hpp>

#include <cstdio>
#include <string>
#include <vector>

#include "bench/kernels.h"
#include "bench/measure.h"
#include "runtime/sim/controller.h"
#include "vm/fixed_point.h"
#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::bench {
namespace {

// --- Beside Lua and gcc --------------------------------------------------------------------------

struct Run {
  double result = 0;
  int64_t statements = 0;
};

Run RunKernel(const std::shared_ptr<const vm::Image>& image, const Kernel& kernel,
              vm::CommandTable& commands) {
  vm::Machine machine(&commands);
  machine.Load(image);
  StartKernel(machine, *image, kernel, 0, 0, kernel.size);
  Run run;
  run.statements = machine.Execute(INT64_MAX);
  const vm::ThreadState& thread = machine.thread(0);
  if (thread.run != vm::ThreadRun::kStopped) Fail(std::string(kernel.name) + " did not end");
  run.result = thread.result_type == vm::DataType::kDouble ? vm::DoubleFromFixed(thread.result)
                                                           : static_cast<double>(thread.result);
  return run;
}

class Lua {
 public:
  explicit Lua(const std::string& path) : state_(luaL_newstate()) {
    luaL_openlibs(state_);
    if (luaL_dofile(state_, path.c_str()) != LUA_OK) Fail(lua_tostring(state_, -1));
  }
  Lua(const Lua&) = delete;
  Lua& operator=(const Lua&) = delete;
  ~Lua() { lua_close(state_); }

  double Call(const std::string& function, int32_t size) {
    lua_getfield(state_, -1, function.c_str());
    lua_pushinteger(state_, size);
    if (lua_pcall(state_, 1, 1, 0) != LUA_OK) Fail(lua_tostring(state_, -1));
    const double result = lua_tonumber(state_, -1);
    lua_pop(state_, 1);
    return result;
  }

 private:
  lua_State* state_;
};

/// How long the virtual machine takes, relative to each of the others.
struct Comparison {
  Ratio to_lua;
  Ratio to_lua_for;
  Ratio to_native;
};

Comparison CompareKernel(const KernelSet& set, const Kernel& kernel, Lua& lua,
                         vm::CommandTable& commands) {
  const std::string name = kernel.name;
  const auto image = LoadProgram(set.folder + "/" + name + ".c", commands);
  Run run;
  double lua_result = 0;
  double lua_for_result = 0;
  double native_result = 0;
  const auto samples = MeasureInTurns(
      Clock::kCpu, {
                       [&] { run = RunKernel(image, kernel, commands); },
                       [&] { lua_result = lua.Call(name, kernel.size); },
                       [&] { lua_for_result = lua.Call(name + "_for", kernel.size); },
                       [&] { native_result = kernel.native(); },
                   });
  const bool fixed = image->object.functions[0].return_type == vm::DataType::kDouble;
  const double scale = fixed ? vm::kFractionScale : 1;
  if (run.result != lua_result / scale || run.result != lua_for_result / scale ||
      run.result != native_result) {
    Fail(name + ": the results differ");
  }
  const Comparison comparison = {RatioOf(samples[0], samples[1]), RatioOf(samples[0], samples[2]),
                                 RatioOf(samples[0], samples[3])};
  const double seconds = Shortest(samples[0]);
  std::printf("%-20s %12lld %8.3f %9.3f %7.3f (%5.3f..%5.3f) %7.3f (%5.3f..%5.3f) %7.1f\n",
              kernel.name, static_cast<long long>(run.statements),
              seconds * 1e9 / static_cast<double>(run.statements), seconds,
              comparison.to_lua.shortest, comparison.to_lua.low, comparison.to_lua.high,
              comparison.to_lua_for.shortest, comparison.to_lua_for.low, comparison.to_lua_for.high,
              comparison.to_native.shortest);
  std::fflush(stdout);
  return comparison;
}

// The ratio counts the Lua functions with the statements of the motion program (`while`); the one
// to those with Lua's own counting (`for`) is in a line of its own.
void CompareKernels(const KernelSet& set, vm::CommandTable& commands) {
  std::printf("\n%-20s %12s %8s %9s %22s %22s %7s\n", (std::string(set.prefix) + "kernel").c_str(),
              "statements", "ns/stmt", "oncard s", "vs lua, while", "vs lua, for", "vs gcc");
  Lua lua(set.lua);
  std::vector<double> to_lua;
  std::vector<double> to_lua_for;
  std::vector<double> to_native;
  for (const Kernel& kernel : set.kernels) {
    const Comparison comparison = CompareKernel(set, kernel, lua, commands);
    to_lua.push_back(comparison.to_lua.shortest);
    to_lua_for.push_back(comparison.to_lua_for.shortest);
    to_native.push_back(comparison.to_native.shortest);
  }
  std::printf("%sgeomean vs lua: %.3f\n", set.prefix, GeometricMean(to_lua));
  std::printf("%sgeomean vs lua with for: %.3f\n", set.prefix, GeometricMean(to_lua_for));
  std::printf("%sgeomean vs gcc -O2: %.1f\n", set.prefix, GeometricMean(to_native));
  std::fflush(stdout);
}

// --- 32 threads ----------------------------------------------------------------------------------

/// One program with several kernels: thread t runs the kernel t modulo their number.
class ThreadedProgram {
 public:
  ThreadedProgram(std::vector<Kernel> kernels, vm::CommandTable& commands)
      : kernels_(std::move(kernels)), machine_(&commands) {
    vm::Object object;
    for (const Kernel& kernel : kernels_) {
      const auto image =
          LoadProgram(std::string(ONCARD_KERNELS) + "/" + kernel.name + ".c", commands);
      object.functions.push_back(image->object.functions[0]);
      if (!image->object.globals.empty()) object.globals = image->object.globals;
    }
    auto image = vm::LinkObject(std::move(object), commands);
    if (!image.ok()) Fail(image.error().message.en);
    image_ = std::move(image).value();
  }

  void Execute(int64_t statements) {
    machine_.Load(image_);
    for (int thread = 0; thread < vm::kThreadCount; ++thread) {
      const int function = thread % static_cast<int>(kernels_.size());
      StartKernel(machine_, *image_, kernels_[static_cast<size_t>(function)], thread, function,
                  kEndless);
    }
    if (machine_.Execute(statements) != statements) Fail("a thread ended early");
  }

  const vm::Machine& machine() const { return machine_; }

 private:
  std::vector<Kernel> kernels_;
  vm::Machine machine_;
  std::shared_ptr<const vm::Image> image_;
};

// 32 threads, each with its own page, take turns after every statement.
void MeasureQuantumOne(vm::CommandTable& commands) {
  constexpr int64_t kManyStatements = 200'000'000;
  constexpr int64_t kFewerStatements = 20'000'000;
  const std::vector<Kernel>& own = OwnKernels().kernels;
  // One kernel of the four has one shared statement among five.
  ThreadedProgram few_shared(own, commands);
  ThreadedProgram all_private({own.begin() + 1, own.end()}, commands);
  ThreadedProgram all_shared({{"all_shared", "n", 0, nullptr}}, commands);
  const auto samples =
      MeasureInTurns(Clock::kCpu, {
                                      [&] { all_private.Execute(kManyStatements); },
                                      [&] { few_shared.Execute(kManyStatements); },
                                      [&] { all_shared.Execute(kFewerStatements); },
                                  });
  const auto print = [](const char* what, int64_t statements, const Samples& seconds) {
    std::printf("%s: %.0f M statements/s\n", what,
                static_cast<double>(statements) / Shortest(seconds) / 1e6);
  };
  print("32 threads at quantum 1", kManyStatements, samples[1]);
  print("all private", kManyStatements, samples[0]);
  print("5 % shared", kManyStatements, samples[1]);
  print("all shared", kFewerStatements, samples[2]);

  const vm::Machine& machine = few_shared.machine();
  const double snapshot = MeasureCpu([&] {
    for (int i = 0; i < 1000; ++i) {
      const vm::MachineState state = machine.state();
      if (state.executed != kManyStatements) Fail("a snapshot differs");
    }
  });
  std::printf("snapshot with all 32 pages in use: %.1f us\n", snapshot * 1e6 / 1000);
}

}  // namespace

void BenchVm() {
  runtime::Controller controller;
  gtcalls::CardCommands commands(&controller.card());
  MeasureQuantumOne(commands);
  BenchCompiler();
  CompareKernels(OwnKernels(), commands);
  CompareKernels(HeldOutKernels(), commands);
}

}  // namespace oncard::bench
