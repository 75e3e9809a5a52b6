// Whole-file access. Writing is atomic: a reader sees the old content or the new one, never a
// part, and a failed write leaves the old file as it was.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace oncard {

/// The bytes of a regular file. Fails when it is missing, a folder, or unreadable.
Result<std::string> ReadFile(const std::string& path);

/// Writes a temporary file beside `path`, flushes it and renames it over `path`. On failure the
/// temporary file is gone.
Result<void> WriteFileAtomically(const std::string& path, std::string_view content);

/// Writes two files that belong together: both are complete on disk before either is renamed, so
/// that a failure leaves the old pair.
Result<void> WritePairAtomically(const std::string& first_path, std::string_view first,
                                 const std::string& second_path, std::string_view second);

}  // namespace oncard
