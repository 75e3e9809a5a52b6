// `oncard_bench run`: measures whole runs: a controller whose threads move axes, the scenarios of
// all samples, and the command `oncard run` with and without a recording. Hosts are in
// host_bench.cc.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bench/kernels.h"
#include "bench/measure.h"
#include "bench/tool.h"
#include "compiler/compiler.h"
#include "runtime/scenario/run/scenario_run.h"
#include "runtime/sim/controller.h"

namespace oncard::bench {
namespace {

// --- In this process -----------------------------------------------------------------------------

// Eight threads, each with an axis that they move back and forth.
void MeasureAxes() {
  constexpr int64_t kCycles = 200'000;
  constexpr int kAxes = 8;
  int64_t statements = 0;
  const double seconds = MeasureCpu([&] {
    runtime::Controller controller;
    const gtcalls::CardCommands commands(&controller.card());
    const auto image = LoadProgram(ONCARD_KERNELS "/axes.c", commands);
    if (!controller.Load(image->object).ok()) Fail("cannot load the program of axes");
    const Kernel drive = {"axes", "axis", 0, nullptr};
    for (int axis = 1; axis <= kAxes; ++axis) {
      StartKernel(controller.machine(), *image, drive, axis - 1, 0, axis);
    }
    for (int64_t cycle = 0; cycle < kCycles; ++cycle) controller.RunCycle();
    statements = controller.machine().state().executed;
    const vm::Symbol* moves = vm::FindLocal(*image, 0, "moves");
    const vm::SlotAddress last = {false, kAxes - 1, moves->id, vm::DataType::kInt};
    if (controller.machine().ReadRaw(last) < 10) Fail("the axes did not move");
  });
  const double simulated = static_cast<double>(kCycles) * 250e-6;
  std::printf("8 threads, 8 axes: %.2f M statements/s, %.0f ns/cycle, %.0f x real time\n",
              static_cast<double>(statements) / seconds / 1e6,
              seconds * 1e9 / static_cast<double>(kCycles), simulated / seconds);
}

/// The scenario files of the samples, in order.
std::vector<std::string> SampleScenarios() {
  std::vector<std::string> paths;
  for (const auto& file : std::filesystem::recursive_directory_iterator(ONCARD_SAMPLES)) {
    if (file.path().extension() == ".toml") paths.push_back(file.path().string());
  }
  std::ranges::sort(paths);
  return paths;
}

// From the object to the result, as `oncard run` without its start.
void MeasureSamples() {
  std::printf("%-34s %10s %10s %10s %8s\n", "scenarios of samples", "statements", "ms of run", "us",
              "x time");
  for (const std::string& path : SampleScenarios()) {
    // Those of hosts have no program.
    const auto scenario = runtime::LoadScenario(path, runtime::ScenarioUse::kRun);
    if (!scenario.ok() || scenario.value().program.empty()) continue;
    const auto compilation = compiler::Compile(runtime::ProgramPath(scenario.value()),
                                               runtime::CompileOptions(scenario.value()));
    if (!compilation.ok()) Fail("cannot compile the program of " + path);
    runtime::ScenarioResult result;
    const double seconds = MeasureCpu([&] {
      auto run = runtime::RunScenario(scenario.value(), *compilation.object);
      if (!run.ok()) Fail(run.error().message.en);
      result = std::move(run).value();
    });
    const auto name = std::filesystem::relative(path, ONCARD_SAMPLES).string();
    std::printf("%-34s %10jd %10.2f %10.1f %8.0f\n", name.c_str(),
                static_cast<intmax_t>(result.statements), result.end_ms, seconds * 1e6,
                result.end_ms * 1e-3 / seconds);
  }
  std::fflush(stdout);
}

// --- The command ---------------------------------------------------------------------------------

/// The same run without and with a recording, processor time.
void MeasureRecording(const char* what, const std::vector<std::string>& arguments,
                      const std::string& file) {
  std::vector<std::string> recording = arguments;
  recording.insert(recording.end(), {"--record", file});
  const auto samples = MeasureInTurns(Clock::kChildren, {
                                                            [&] { RunTool(arguments); },
                                                            [&] { RunTool(recording); },
                                                        });
  const Ratio ratio = RatioOf(samples[1], samples[0]);
  std::printf("%s: %.3f s, with --record %.3f s: %.2f times as long (%.2f..%.2f), %ju KB\n", what,
              Shortest(samples[0]), Shortest(samples[1]), ratio.shortest, ratio.low, ratio.high,
              std::filesystem::file_size(file) / 1024);
  std::fflush(stdout);
}

}  // namespace

void BenchRun() {
  MeasureAxes();
  MeasureSamples();
  const double start = MeasureWall([] {
    RunTool({"run", ONCARD_SAMPLES "/01_sum/one_thread.toml"});
  });
  std::printf("oncard run of the sum sample: %.1f ms wall\n", start * 1e3);
  const std::string folder = NewFolder();
  const std::string file = folder + "/recording.sched";
  MeasureRecording("oncard run, 8 threads, 8 axes, 100 s", {"run", ONCARD_KERNELS "/axes.toml"},
                   file);
  const std::vector<std::string> one = {
      "run", ONCARD_KERNELS "/collatz.c", "--thread", "0=collatz:n=100000", "--rate", "1000000"};
  MeasureRecording("oncard run, 1 thread computes", one, file);
  for (const char* rate : {"1000", "1000000"}) {
    std::vector<std::string> eight = {"run", ONCARD_KERNELS "/collatz.c", "--rate", rate};
    for (int thread = 0; thread < 8; ++thread) {
      const std::string number = std::to_string(thread);
      eight.insert(eight.end(), {"--thread", number + "=collatz@" + number + ":n=5000"});
    }
    const std::string what = std::string("oncard run, 8 threads compute, rate ") + rate;
    MeasureRecording(what.c_str(), eight, file);
  }
  BenchHosts(folder);
  std::filesystem::remove_all(folder);
}

}  // namespace oncard::bench
