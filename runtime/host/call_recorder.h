// Writes the record of host calls that ONCARD_RECORD asks for (call_record.h).
// Tested by tests/tools/record_calls_test.cc.
#pragma once

#include <mutex>
#include <string>

#include "base/result.h"
#include "runtime/host/mapped_file.h"
#include "runtime/scenario/record/call_record.h"

namespace oncard::runtime {

/// The file of this process. Thread-safe: each line is written in one piece.
class CallRecorder {
 public:
  CallRecorder() = default;
  CallRecorder(const CallRecorder&) = delete;
  CallRecorder& operator=(const CallRecorder&) = delete;

  /// The process's own; nullptr when none is wanted.
  static CallRecorder* Wanted();

  /// A card is opened; the first time the file is made, or overwritten. Fails if that is
  /// impossible.
  Result<void> Open(int card, const Scenario& scenario, bool bare);
  void Write(int card, const RecordedCall& call);
  void Close(int card, const CallRecord::End& end);
  /// To be called when the host ends: the file gets its true size.
  void Finish();
  /// In a child of fork(): its calls are not recorded if those of its parent are.
  void LeaveToParent();
  /// True if a line could not be written, for example because the disk is full. Nothing is written
  /// after it, so that the record has no gap.
  bool lost() const { return lost_; }

 private:
  void WriteLine(const std::string& line);

  std::string path_;
  std::mutex mutex_;
  std::string line_;  // the one in progress; its memory is used again for the next
  MappedFile file_;   // a host that is killed leaves all of its calls
  bool lost_ = false;
  bool in_child_ = false;
};

}  // namespace oncard::runtime
