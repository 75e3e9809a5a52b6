#include "tools/stop_signals.h"

#include <csignal>

#include "tools/stop_signal_numbers.h"

namespace oncard::tools {
namespace {

std::atomic<std::atomic<bool>*> current{nullptr};

// A signal that is ignored, for example by nohup, remains ignored.
void Handle(void (*handler)(int)) {
  for (const int signal : kStopSignals.all()) {
    if (std::signal(signal, handler) == SIG_IGN) static_cast<void>(std::signal(signal, SIG_IGN));
  }
}

extern "C" void SetStop(int /*signal*/) {
  if (std::atomic<bool>* stop = current.load(); stop != nullptr) stop->store(true);
  Handle(SIG_DFL);
}

}  // namespace

StopSignals::StopSignals() {
  current = &stop_;
  Handle(SetStop);
}

StopSignals::~StopSignals() {
  Handle(SIG_DFL);
  current = nullptr;
}

}  // namespace oncard::tools
