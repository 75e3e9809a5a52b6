// Sessions of programs as literal text.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "session/session.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::session {

/// The run of a program; `scenario` has everything but the program's name.
inline std::unique_ptr<RewindableRun> RunOf(const std::string& program,
                                            const std::string& scenario = "") {
  auto run =
      RewindableRun::Create(runtime::ScenarioForTest(scenario), runtime::CompileForTest(program));
  EXPECT_TRUE(run.ok()) << (run.ok() ? "" : run.error().message.en);
  return run.ok() ? std::move(run).value() : nullptr;
}

inline Session SessionOf(const std::string& program, const std::string& scenario = "") {
  auto session =
      Session::Create(runtime::ScenarioForTest(scenario), runtime::CompileForTest(program));
  EXPECT_TRUE(session.ok()) << (session.ok() ? "" : session.error().message.en);
  return std::move(session).value();
}

inline double ValueOf(const std::string& name, const RewindableRun& run) {
  const auto found = runtime::ResolveQuantity(name, run.controller());
  EXPECT_TRUE(found.ok()) << name;
  return found.ok() ? runtime::ReadQuantity(found.value().front(), run.controller()) : 0;
}

/// Two threads increment a shared variable, each in three statements.
inline constexpr const char* kRace =
    "int x;\n"
    "int f()\n"
    "{\n"
    "  int a;\n"
    "  a = x;\n"
    "  a = a + 1;\n"
    "  x = a;\n"
    "}\n";
inline constexpr const char* kTwoThreads =
    "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"f\"\n";

/// An axis moves to 5000 while a thread counts.
inline constexpr const char* kMove =
    "int n;\n"
    "int f()\n"
    "{\n"
    "  TTrapPrm trap;\n"
    "  short i;\n"
    "  GT_AxisOn(1);\n"
    "  GT_PrfTrap(1);\n"
    "  trap.acc = 0.5;\n"
    "  trap.dec = 0.5;\n"
    "  trap.velStart = 0;\n"
    "  trap.smoothTime = 0;\n"
    "  GT_SetTrapPrm(1, &trap);\n"
    "  GT_SetVel(1, 20);\n"
    "  GT_SetPos(1, 5000);\n"
    "  GT_Update(1);\n"
    "loop:\n"
    "  n = n + 1;\n"
    "  goto loop;\n"
    "}\n";

/// An axis jogs from line 6 on with its drive off, and still does when the run ends.
inline constexpr const char* kUnpowered =
    "int n;\n"
    "int f()\n"
    "{\n"
    "  GT_PrfJog(1);\n"
    "  GT_SetVel(1, 10);\n"
    "  GT_Update(1);\n"
    "  GT_Delay(5);\n"
    "  n = 1;\n"
    "}\n";

/// The names of the supervisor's findings up to the present.
inline std::vector<std::string> WarningsOf(const RewindableRun& run) {
  std::vector<std::string> names;
  for (const runtime::CardFinding& finding : run.findings()) {
    names.emplace_back(InfoOf(finding.warning).name);
  }
  return names;
}

}  // namespace oncard::session
