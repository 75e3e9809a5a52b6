// The log of host calls that ONCARD_LOG asks for, one line per call (call_text.h shows them).
// docs/host-api.md describes it for users. Tested by tests/runtime/call_log_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

#include "base/message.h"
#include "runtime/sim/call_text.h"

namespace oncard::runtime {

#ifdef __wasi__
/// There is only one thread.
struct LogLock {
  void lock() {}
  void unlock() {}
};
#else
using LogLock = std::mutex;
#endif

/// The destination of the lines. Thread-safe: each line is written in one piece, by a system call
/// of its own. Shared memory, through which the record of calls is written (mapped_file.h), would
/// be faster. But this log is read while it grows: `tail -f` would see a megabyte of zero bytes
/// first, and `grep` would take the file for a binary one.
class CallLog final : public CardLog {
 public:
  /// `setting` is the value of ONCARD_LOG: empty for no log, `calls` for standard error,
  /// `calls:FILE` for a file, which is overwritten. With any other text, or a file that cannot be
  /// written, the log goes to standard error and its first line says so.
  explicit CallLog(std::string_view setting, Language language);
  CallLog(const CallLog&) = delete;
  CallLog& operator=(const CallLog&) = delete;
  ~CallLog() override;

  /// The process's log, set up at its first use.
  static CallLog& OfProcess();

  /// The process's log, or nothing when none is wanted.
  static CallLog* Wanted();

  bool enabled() const { return stream_ != nullptr; }
  /// True if a line could not be written, for example because the disk is full.
  bool lost() const { return lost_; }
  void Write(const LoggedCall& call) override;
  void Write(int64_t time_us, int card, const Message& what) override;

 private:
  void WriteLine(const std::string& line);
  /// Writes and clears line_. The caller holds the lock.
  void EndLine();

  Language language_;
  LogLock mutex_;
  std::string line_;  // the one in progress; its memory is used again for the next
  std::FILE* stream_ = nullptr;
  std::atomic<bool> lost_ = false;
};

}  // namespace oncard::runtime
