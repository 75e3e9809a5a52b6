// Runs the oncard command and others, like a user but without a shell.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace oncard::tools {

/// All commands of oncard.
inline constexpr const char* kCommands[] = {
    "build", "check",   "lower",  "explain", "run", "test",  "replay", "dump", "verify",
    "exec",  "explore", "doctor", "schema",  "eni", "debug", "serve",  "new"};

inline const std::string kSamples = ONCARD_SOURCE_DIR "/samples";
/// The first sample, which adds numbers.
inline const std::string kSum = kSamples + "/01_sum/sum.c";

struct ProcessResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `oncard arguments...` in `folder` (empty: the current one) with LANG=C, without colour, and
/// with `environment` ("NAME=value") added.
ProcessResult RunOncard(const std::vector<std::string>& arguments, const std::string& folder = {},
                        const std::vector<std::string>& environment = {});

/// The same for any program, which is searched for like in a shell.
ProcessResult RunProgram(const std::vector<std::string>& command, const std::string& folder = {},
                         const std::vector<std::string>& environment = {});

/// Runs `oncard arguments...` and sends it the signal as soon as it has a handler for it.
ProcessResult InterruptOncard(const std::vector<std::string>& arguments, int signal,
                              const std::string& folder);

/// A separate folder for a test, removed with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  std::string path() const { return path_.string(); }
  /// Writes a file and returns its path.
  std::string Write(const std::string& name, const std::string& content) const;
  /// The bytes of a file; empty if it does not exist.
  std::string Read(const std::string& name) const;
  bool Has(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

/// `oncard arguments...`, or a copy of oncard, with LANG=C while a test does something else; killed
/// with the object.
class RunningOncard {
 public:
  explicit RunningOncard(const std::vector<std::string>& arguments, const std::string& copy = {});
  RunningOncard(const RunningOncard&) = delete;
  RunningOncard& operator=(const RunningOncard&) = delete;
  ~RunningOncard();

  /// Waits for the first line on standard output, without its end; or for the end of the process.
  std::string FirstLine() const;
  pid_t process() const { return process_; }
  /// Sends the signal; the exit code, or 128 plus the number of the signal that ended the process.
  int Stop(int signal);

 private:
  const ScratchFolder scratch_;
  pid_t process_ = 0;
};

/// Compares with tests/tools/golden/`name`. If ONCARD_REBASE is set in the environment, the file is
/// written instead; review the difference before committing it.
void ExpectGolden(const std::string& name, const std::string& actual);

}  // namespace oncard::tools
