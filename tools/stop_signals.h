// Ctrl-C (SIGINT), SIGTERM and SIGHUP as requests to end early with the results so far. Tested by
// tests/tools/signals_test.cc.
#pragma once

#include <atomic>

namespace oncard::tools {

/// During its lifetime, the first of these signals sets a flag that running work checks from time
/// to time; a second one ends the program as usual. Only one at a time.
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
