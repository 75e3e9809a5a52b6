// `oncard_bench session`: how long a session takes to go back, in a run of a million statements
// while eight axes move, and to read values over time after the fact. Wall-clock time; the slow
// walks are shown, because a user notices those.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "base/random.h"
#include "bench/measure.h"
#include "compiler/compiler.h"
#include "session/session.h"

namespace oncard::bench {
namespace {

constexpr int64_t kStatements = 1'000'000;

/// Eight axes run for as long as a thread counts.
std::string Source() {
  std::string source =
      "int n;\nint f()\n{\n  TJogPrm jog;\n  jog.acc = 0.5;\n  jog.dec = 0.5;\n"
      "  jog.smooth = 0;\n";
  for (int axis = 1; axis <= 8; ++axis) {
    const std::string number = std::to_string(axis);
    source += "  GT_AxisOn(" + number + ");\n  GT_PrfJog(" + number + ");\n  GT_SetJogPrm(" +
              number + ", &jog);\n  GT_SetVel(" + number + ", 50);\n";
  }
  return source + "  GT_Update(255);\nloop:\n  n = n + 1;\n  goto loop;\n}\n";
}

session::Session StartSession() {
  const auto no_files = [](const std::string&) -> Result<std::string> {
    return MakeError(1, "no file", "没有文件");
  };
  const auto compilation = compiler::CompileText("p.c", Source(), {}, no_files);
  if (!compilation.ok()) Fail("cannot compile the program");
  runtime::Scenario scenario;
  scenario.program = "p.c";
  auto session = session::Session::Create(scenario, *compilation.object);
  if (!session.ok()) Fail(session.error().message.en);
  return std::move(session).value();
}

/// The milliseconds below which 99 of 100 walks stay, and the longest.
void Print(const char* what, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  std::printf("%-44s p99 %8.3f ms   longest %8.3f ms\n", what, ms[ms.size() * 99 / 100], ms.back());
}

template <typename Walk>
std::vector<double> TimesOf(int walks, Walk walk) {
  std::vector<double> ms;
  for (int i = 0; i < walks; ++i) {
    const auto before = std::chrono::steady_clock::now();
    walk();
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - before;
    ms.push_back(passed.count());
  }
  return ms;
}

}  // namespace

void BenchSession() {
  constexpr int kWalks = 1000;
  session::Session session = StartSession();
  session::RewindableRun& run = session.run();
  const double seconds = MeasureCpu([&] {
    run.GoTo(0);
    while (run.machine().state().executed < kStatements) run.Advance(INT64_MAX);
  });
  const double ms = run.controller().NowMs();
  std::printf("%-44s %8.0f ms of the card in %.0f ms, %zu states kept\n",
              "a million statements, 8 axes in Jog", ms, seconds * 1e3, run.kept_count());
  const int64_t end = run.moment();
  Print("a step back", TimesOf(kWalks, [&] { run.GoTo(run.moment() - 1); }));
  run.GoTo(end);
  session::Walk cycle;
  cycle.goal = session::Goal::kCycle;
  Print("a cycle back", TimesOf(kWalks, [&] {
          if (!session.Back(cycle).ok()) Fail("cannot go back");
        }));
  uint64_t random = 1;
  Print("to any moment of the run", TimesOf(kWalks, [&] {
          run.GoTo(static_cast<int64_t>(RandomBelow(random, static_cast<uint64_t>(end))));
        }));
  run.GoTo(end);
  Print("8 channels over the whole run, 1000 points", TimesOf(10, [&] {
          std::vector<std::string> names;
          for (int axis = 1; axis <= 8; ++axis) {
            names.push_back("axis" + std::to_string(axis) + ".prfPos");
          }
          const auto to_us = static_cast<int64_t>(ms * 1000);
          if (!session.Trace(names, 0, to_us, 1000).ok()) Fail("cannot read the values");
        }));
}

}  // namespace oncard::bench
