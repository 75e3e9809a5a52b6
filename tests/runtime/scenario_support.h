// Programs as literal text, for tests of scenarios.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "compiler/diagnostic_printer.h"
#include "runtime/scenario/run/scenario_run.h"
#include "tests/compiler/memory_files.h"

namespace oncard::runtime {

/// Adds its argument to `n`.
inline constexpr const char* kCount = "int n;\nint f(int k)\n{\n  n = n + k;\n  return n;\n}\n";
/// Counts `n` up for ever.
inline constexpr const char* kSpin = "int n;\nint f()\n{\nlbl:\n  n = n + 1;\n  goto lbl;\n}\n";

inline vm::Object CompileForTest(const std::string& text) {
  compiler::Compilation compilation = compiler::CompileText("p.c", text, {}, compiler::NoFiles());
  EXPECT_TRUE(compilation.ok()) << compiler::PrintText(compilation, {});
  return compilation.ok() ? *compilation.object : vm::Object();
}

/// A scenario whose text contains everything except the program's name.
inline Scenario ScenarioForTest(const std::string& text) {
  auto scenario = ParseScenario("program = \"p.c\"\n" + text, "t.toml");
  EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error().message.en);
  return scenario.ok() ? scenario.value() : Scenario();
}

/// Runs it; an error makes the test fail with its English text.
inline ScenarioResult RunForTest(const std::string& program, const std::string& scenario,
                                 const RunOptions& options = {}) {
  auto result = RunScenario(ScenarioForTest(scenario), CompileForTest(program), options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message.en);
  return result.ok() ? std::move(result).value() : ScenarioResult();
}

}  // namespace oncard::runtime
