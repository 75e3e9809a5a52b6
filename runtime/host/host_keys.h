// The keyboard of a host program, for kbhit() and getch() of compat/conio.h: keys of ONCARD_KEYS
// and of the scenario, or, without either, the terminal's. Thread-safe. Tested by
// tests/tools/exec_command_test.cc.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "runtime/scenario/file/key_script.h"

namespace oncard::runtime {

class HostKeys {
 public:
  explicit HostKeys(std::vector<KeyPress> script);

  /// The process's keyboard, set up at its first use. Keys that cannot be read are reported on
  /// standard error and left out.
  static HostKeys& OfProcess();

  /// True if a key has been pressed and not yet read. The query takes virtual time (host_time.h).
  bool Hit();
  /// Waits for a key; returns -1 if there are no more. A host that keeps asking after that is in an
  /// endless loop: this is reported, and the host is ended with kExitNoMoreKeys.
  int Read();

 private:
  struct Key {
    int64_t at_ns = 0;
    unsigned char character = 0;
  };
  int ReadNext();
  int ReadScripted();

  std::mutex mutex_;
  const bool scripted_;
  std::vector<Key> keys_;
  size_t next_ = 0;
  int reads_after_end_ = 0;
};

}  // namespace oncard::runtime
