// `oncard_bench vm`: measures how fast motion programs run, compared with Lua 5.4 and gcc -O2 on
// the same kernels in the same run. CPU time, the median of several repetitions. The results of all
// are compared, so that none is faster because it computes something else.
#include <sys/wait.h>
#include <unistd.h>
#include <lua.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "base/files.h"
#include "bench/measure.h"
#include "bench/native_kernels.h"
#include "compiler/compiler.h"
#include "compiler/lowering/lowering.h"
#include "runtime/sim/controller.h"
#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::bench {
namespace {

double GeometricMean(const std::vector<double>& values) {
  double logarithms = 0;
  for (const double value : values) logarithms += std::log(value);
  return std::exp(logarithms / static_cast<double>(values.size()));
}

struct Kernel {
  const char* name;
  const char* parameter;  // the local variable with the size
  int32_t size;           // for the comparison
  int32_t endless;        // so large that a thread does not end during the measurement
  std::function<double()> native;
};

const std::vector<Kernel>& Kernels() {
  static const std::vector<Kernel> kernels = {
      {"sum", "end", 20'000'000, 2'000'000'000,
       [] { return static_cast<double>(NativeSum(20'000'000)); }},
      {"multiply_accumulate", "n", 20'000'000, 2'000'000'000,
       [] { return static_cast<double>(NativeMultiplyAccumulate(20'000'000)) / 65536; }},
      {"prefix_sum", "n", 20'000, 2'000'000'000,
       [] { return static_cast<double>(NativePrefixSum(20'000)); }},
      {"collatz", "n", 100'000, 2'000'000'000,
       [] { return static_cast<double>(NativeCollatz(100'000)); }},
  };
  return kernels;
}

std::shared_ptr<const vm::Image> LoadKernel(const Kernel& kernel,
                                            const vm::CommandTable& commands) {
  const auto compilation =
      compiler::Compile(std::string(ONCARD_KERNELS) + "/" + kernel.name + ".c");
  if (!compilation.ok()) Fail(std::string("cannot compile the kernel ") + kernel.name);
  auto image = vm::LinkObject(*compilation.object, commands);
  if (!image.ok()) Fail(image.error().message.en);
  return std::move(image).value();
}

// Binds the only function of `image` to a thread on the page of the same number and starts it.
void StartKernel(vm::Machine& machine, const vm::Image& image, const Kernel& kernel, int thread,
                 int function, int32_t size) {
  machine.Bind(thread, function + 1, thread);
  const vm::Symbol* parameter = vm::FindLocal(image, function, kernel.parameter);
  machine.WriteRaw({false, static_cast<uint8_t>(thread), parameter->id, vm::DataType::kInt}, size);
  if (const vm::Symbol* begin = vm::FindLocal(image, function, "begin")) {
    machine.WriteRaw({false, static_cast<uint8_t>(thread), begin->id, vm::DataType::kInt}, 1);
  }
  machine.Run(thread);
}

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
  Lua() : state_(luaL_newstate()) {
    luaL_openlibs(state_);
    if (luaL_dofile(state_, ONCARD_KERNELS "/kernels.lua") != LUA_OK) {
      Fail(lua_tostring(state_, -1));
    }
  }
  Lua(const Lua&) = delete;
  Lua& operator=(const Lua&) = delete;
  ~Lua() { lua_close(state_); }

  double Call(const char* function, int32_t size) {
    lua_getfield(state_, -1, function);
    lua_pushinteger(state_, size);
    if (lua_pcall(state_, 1, 1, 0) != LUA_OK) Fail(lua_tostring(state_, -1));
    const double result = lua_tonumber(state_, -1);
    lua_pop(state_, 1);
    return result;
  }

 private:
  lua_State* state_;
};

void CompareKernels(vm::CommandTable& commands) {
  Lua lua;
  std::vector<double> to_lua;
  std::vector<double> to_native;
  std::printf("%-20s %12s %10s %10s %10s %8s %8s\n", "kernel", "statements", "ns/stmt", "oncard s",
              "lua s", "vs lua", "vs gcc");
  for (const Kernel& kernel : Kernels()) {
    const auto image = LoadKernel(kernel, commands);
    Run run;
    double lua_result = 0;
    double native_result = 0;
    const double vm_seconds = MeasureCpu([&] { run = RunKernel(image, kernel, commands); });
    const double lua_seconds = MeasureCpu([&] { lua_result = lua.Call(kernel.name, kernel.size); });
    const double native_seconds = MeasureCpu([&] { native_result = kernel.native(); });
    const double scaled_lua = image->object.functions[0].return_type == vm::DataType::kDouble
                                  ? lua_result / vm::kFractionScale
                                  : lua_result;
    if (run.result != scaled_lua || run.result != native_result) {
      Fail(std::string(kernel.name) + ": the results differ");
    }
    to_lua.push_back(vm_seconds / lua_seconds);
    to_native.push_back(vm_seconds / native_seconds);
    std::printf("%-20s %12lld %10.3f %10.3f %10.3f %8.3f %8.1f\n", kernel.name,
                static_cast<long long>(run.statements),
                vm_seconds * 1e9 / static_cast<double>(run.statements), vm_seconds, lua_seconds,
                to_lua.back(), to_native.back());
  }
  std::printf("\n");
  std::fflush(stdout);
  std::printf("geomean vs lua: %.3f\n", GeometricMean(to_lua));
  std::printf("geomean vs gcc -O2: %.1f\n", GeometricMean(to_native));
}

// All four kernels in one program: 32 threads, each with its own page, quantum 1.
void MeasureQuantumOne(vm::CommandTable& commands) {
  vm::Object object;
  for (const Kernel& kernel : Kernels()) {
    const auto image = LoadKernel(kernel, commands);
    object.functions.push_back(image->object.functions[0]);
    if (!image->object.globals.empty()) object.globals = image->object.globals;
  }
  auto image = vm::LinkObject(std::move(object), commands);
  if (!image.ok()) Fail(image.error().message.en);
  constexpr int64_t kStatements = 500'000'000;
  vm::Machine machine(&commands);
  const double seconds = MeasureCpu([&] {
    machine.Load(image.value());
    for (int thread = 0; thread < vm::kThreadCount; ++thread) {
      const int function = thread % static_cast<int>(Kernels().size());
      const Kernel& kernel = Kernels()[static_cast<size_t>(function)];
      StartKernel(machine, *image.value(), kernel, thread, function, kernel.endless);
    }
    if (machine.Execute(kStatements) != kStatements) Fail("a thread ended early");
  });
  std::printf("32 threads at quantum 1: %.0f M statements/s\n", kStatements / seconds / 1e6);

  const double snapshot = MeasureCpu([&] {
    for (int i = 0; i < 1000; ++i) {
      const vm::MachineState state = machine.state();
      if (state.executed != kStatements) Fail("a snapshot differs");
    }
  });
  std::printf("snapshot with all 32 pages in use: %.1f us\n", snapshot * 1e6 / 1000);
}

void MeasureCompiler() {
  constexpr int kStatements = 10'000;
  std::string text = "int a[100];\nint f(int n)\n{\n    int i, x, cc;\n    i = 0;\n";
  for (int i = 0; i < kStatements / 5; ++i) {
    text += fmt::format(
        "l{0}:\n    x = i * {1};\n    cc = x > n;\n    if (cc) goto l{0};\n    a[{2}] = x;\n"
        "    i = i + 1;\n",
        i % 1000, i, i % 100);
    if (i % 1000 == 999)
      text += "    return i;\n}\nint f" + std::to_string(i) +
              "(int n)\n{\n    int i, x, cc;\n    i = 0;\n";
  }
  text += "    return i;\n}\n";
  const double seconds = MeasureCpu([&] {
    const auto compilation = compiler::CompileText("big.c", text, {}, compiler::ReadSource);
    if (!compilation.ok()) Fail("the generated program does not compile");
  });
  std::printf("compile %d statements: %.1f ms\n", kStatements, seconds * 1e3);
}

// A program of structured C with 10 000 lines, in ten thread functions.
void MeasureLowering() {
  constexpr int kFunctions = 10;
  constexpr int kParts = 100;
  std::string text = "int a[100], m[8][8], limit;\ndouble gain;\n\n";
  for (int f = 0; f < kFunctions; ++f) {
    text += fmt::format("int f{}(int n) {{\n  int i, x = 0;\n  double y = 0.5;\n", f);
    for (int part = 0; part < kParts; ++part) {
      text += fmt::format(
          "  for (i = 0; i < n; i++) {{\n    if (a[i] > limit && x != {0}) {{\n"
          "      x += a[i] * {0} - (i & 3);\n    }} else {{\n      m[i & 7][x & 7] = -x;\n    }}\n"
          "    y = y * gain + i;\n  }}\n  a[{0}] = x > {0} ? x : (int)y;\n\n",
          part);
    }
    text += "  return x;\n}\n\n";
  }
  const double seconds = MeasureCpu([&] {
    const auto lowering =
        compiler::LowerText("big.c", text, {}, compiler::LoweringOptions(), compiler::ReadSource);
    if (!lowering.text) Fail("the generated program cannot be lowered");
  });
  std::printf("lower and check %ld lines of structured C: %.1f ms\n",
              static_cast<long>(std::count(text.begin(), text.end(), '\n')), seconds * 1e3);
}

void MeasureTool() {
  std::fflush(stdout);  // the child must not print it again
  const double seconds = MeasureWall([] {
    const pid_t child = ::fork();
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(127);
      ::execl(ONCARD_TOOL, "oncard", "run", ONCARD_SUM_SAMPLE, static_cast<char*>(nullptr));
      ::_exit(127);
    }
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child || status != 0) {
      Fail("oncard run failed");
    }
  });
  std::printf("oncard run of the sum sample: %.1f ms wall\n", seconds * 1e3);
}

int Main(int argc, char** argv) {
  const std::string what = argc == 2 ? argv[1] : "";
  if (what == "editor") {
    BenchEditor();
    return 0;
  }
  if (what == "session") {
    BenchSession();
    return 0;
  }
  if (what == "motion") {
    BenchMotion();
    return 0;
  }
  if (what == "explore") {
    BenchExplore();
    return 0;
  }
  if (what != "vm") {
    std::fprintf(stderr, "usage: oncard_bench vm|motion|explore|session|editor\n");
    return 2;
  }
  runtime::Controller controller;
  gtcalls::CardCommands commands(&controller.card());
  MeasureQuantumOne(commands);
  MeasureCompiler();
  MeasureLowering();
  MeasureTool();
  CompareKernels(commands);
  return 0;
}

}  // namespace
}  // namespace oncard::bench

int main(int argc, char** argv) { return oncard::bench::Main(argc, argv); }
