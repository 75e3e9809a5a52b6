// Additional output of a run: its statements, and its values over time as a file or a picture. For
// run and replay.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "runtime/scenario/run/scenario_run.h"
#include "tools/invocation.h"

namespace oncard::tools {

struct RunViews {
  bool steps = false;
  bool full = false;
  std::string trace;  ///< file
  std::string plot;   ///< file
};

/// Describes `--steps`, `--full`, `--trace` and `--plot`.
void AddViewOptions(CLI::App& command, const Invocation& invocation, RunViews& views);

/// The data that the run must record for them.
void ApplyViews(const RunViews& views, runtime::RunOptions* options);

/// Prints the statements if they are requested and the results are printed as text.
void PrintSteps(const runtime::ScenarioResult& result, const runtime::ProgramLoad& load,
                const RunViews& views, const std::string& format, const Invocation& invocation);

/// Writes the files. Returns the exit code.
int WriteViews(const runtime::ScenarioResult& result, const RunViews& views,
               const std::string& title, const Invocation& invocation);

}  // namespace oncard::tools
