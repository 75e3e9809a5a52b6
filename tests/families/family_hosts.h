// The hosts that the test of a family has, run as by their authors: under `oncard exec`, with
// records that are replayed. CMake says where they are, and which command knows the family.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {

inline const std::string kHostFolder = ONCARD_HOST_FOLDER;

/// Runs `oncard arguments...`.
inline ProcessResult RunFamilyOncard(std::vector<std::string> arguments,
                                     const ScratchFolder& folder,
                                     const std::vector<std::string>& environment = {}) {
  arguments.insert(arguments.begin(), ONCARD_COMMAND);
  return RunProgram(arguments, folder.path(), environment);
}

/// Runs a host under `oncard exec` with some options.
inline ProcessResult Exec(const std::string& host, std::vector<std::string> options = {},
                          const std::vector<std::string>& environment = {},
                          const ScratchFolder& folder = ScratchFolder()) {
  options.insert(options.begin(), "exec");
  options.insert(options.end(), {"--", kHostFolder + "/" + host});
  return RunFamilyOncard(options, folder, environment);
}

/// The cards answer the calls of host.calls as they did when it was recorded.
inline void ExpectReplay(const ScratchFolder& folder) {
  const ProcessResult replay = RunFamilyOncard({"replay", "host.calls"}, folder);
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
}

}  // namespace oncard::tools
