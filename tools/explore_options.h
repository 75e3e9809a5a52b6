// The options of `oncard explore`.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/invocation.h"

namespace oncard::tools {

struct ExploreArguments {
  std::vector<std::string> paths;
  std::string engine;  ///< empty: as in the scenario
  std::string format = "text";
  std::string save;
  std::string regression;
  std::string report;
  int64_t execution_limit = 0;  ///< 0: as in the scenario
  uint32_t state_limit = 0;
  int64_t runs = 0;
  std::optional<uint64_t> seed;
  std::optional<int> depth;
  std::optional<int> preemptions;
  bool structured = false;
  bool merge_private = false;
  bool no_merge_private = false;
  bool no_dead_locals = false;
  bool no_symmetry = false;
  bool no_islands = false;
  bool no_reductions = false;
  bool races = false;
  bool benign = false;
  std::string search;  ///< the file in which the search is kept
  std::string shard;   ///< `I/N`
  bool merge = false;
  bool full = false;
  bool progress = false;
  double seconds = 0;      ///< 0: no limit
  int64_t memory_mib = 0;  ///< 0: half of what is there
  bool all = false;
  bool strict_commands = false;
  std::vector<std::string> silent;
};

/// Declares them; parsing the command line fills in `arguments`, which must outlive the command.
void AddExploreOptions(CLI::App& command, const Invocation& invocation,
                       ExploreArguments& arguments);

/// The command line that makes the same search again in the folder of its files: with the options
/// that decide what is found, without those of what is written.
std::string SameSearch(const ExploreArguments& arguments);

}  // namespace oncard::tools
