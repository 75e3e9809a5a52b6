// Random programs of csmith, a generator of C that finds errors of compilers. It need not be on a
// machine; the tests say what they leave out then.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace oncard::differential {

/// Where the programs find csmith.h, their arithmetic and their checksum.
inline constexpr const char* kCsmithHeader =
    ONCARD_SOURCE_DIR "/tests/differential/csmith/csmith.h";

/// The variable with the result of a program.
inline constexpr std::string_view kCsmithResult = "checksum";

bool HasCsmith();

/// The program of a seed: what a motion program can be, with a thread function `main`.
Result<std::string> MakeCsmithProgram(uint64_t seed, const std::string& folder);

/// One C file with the text of csmith.h and all programs, each of which prints its result.
std::string CsmithOracleText(const std::string& header, const std::vector<std::string>& programs);

}  // namespace oncard::differential
