// Ctrl-C (SIGINT), SIGTERM and SIGHUP as a wish to end early with what there is.
// Tested by tests/tools/signals_test.cc.
#pragma once

#include <atomic>

namespace oncard::tools {

/// As long as it lives, the first of these signals sets a flag that whatever works looks at now and
/// then; a second one ends the program as usual. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  const std::atomic<bool>* stop() const { return &stop_; }
  bool stopped() const { return stop_; }

 private:
  std::atomic<bool> stop_ = false;
};

}  // namespace oncard::tools
