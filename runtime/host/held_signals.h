// Signals that wait for the end of a call (call_scope.h). Linux only.
// Tested by tests/tools/exec_signals_test.cc.
#pragma once

#include <csignal>

namespace oncard::runtime {

/// To be called by the handler of a signal, with its arguments. If the thread is in a call, keeps
/// the signal for the end of the call, wakes the thread if it sleeps, and returns true.
bool HoldSignal(int number, siginfo_t* info, void* context);

/// The C library's sigaction(), which the one of the host library covers.
int SystemSigaction(int number, const struct sigaction* wanted, struct sigaction* before);

}  // namespace oncard::runtime
