// Runs the oncard command, and others, as a user does, without a shell.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace oncard::tools {

struct ProcessResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `oncard arguments...` in `folder` (empty: the current one) with LANG=C and no colour, and
/// with `environment` ("NAME=value") added.
ProcessResult RunOncard(const std::vector<std::string>& arguments, const std::string& folder = {},
                        const std::vector<std::string>& environment = {});

/// The same for any program, found as the shell would find it.
ProcessResult RunProgram(const std::vector<std::string>& command, const std::string& folder = {},
                         const std::vector<std::string>& environment = {});

/// Runs `oncard arguments...` and sends it the signal as soon as it has a handler for it.
ProcessResult InterruptOncard(const std::vector<std::string>& arguments, int signal,
                              const std::string& folder);

/// A folder of its own for a test, removed with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  std::string path() const { return path_.string(); }
  /// Writes a file and gives its path.
  std::string Write(const std::string& name, const std::string& content) const;
  /// The bytes of a file; empty when there is none.
  std::string Read(const std::string& name) const;
  bool Has(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

/// Compares with tests/tools/golden/`name`. With ONCARD_REBASE set in the environment the file is
/// written instead; review the difference before committing it.
void ExpectGolden(const std::string& name, const std::string& actual);

}  // namespace oncard::tools
