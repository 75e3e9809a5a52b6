// The life of a host on Linux beside its calls: its end, when it is judged, and its children.
#include <pthread.h>

#include <cstdio>
#include <cstdlib>

#include "runtime/host/call_scope.h"
#include "runtime/host/card_table.h"
#include "runtime/host/host_scenario.h"
#include "runtime/host/virtual_time.h"
#include "runtime/host/waiting_threads.h"

namespace oncard::runtime {
namespace {

/// Called when the host has ended, after its own destructors.
__attribute__((destructor)) void JudgeHost() {
  const CallScope scope;
  FinishHost();
}

// A host may fork while another of its threads executes a command. The locks are taken before, so
// that the child gets copies of the cards and of time in their state between two commands. Signals
// wait until they are free again.
void LockEverything() {
  CallScope::Begin();
  // A handler may fork, and a thread that has a card may wait for the wait that it has interrupted.
  if (call_state.waits != 0) VirtualTime::OfProcess().LetOthersPass();
  for (CardSlot& slot : CardTable::OfProcess().slots) slot.mutex.lock();
  VirtualTime::OfProcess().LockForFork();
  WaitingThreads::OfProcess().LockForFork();
}
void UnlockCards() {
  for (CardSlot& slot : CardTable::OfProcess().slots) slot.mutex.unlock();
}
void UnlockParent() {
  WaitingThreads::OfProcess().UnlockAfterFork();
  VirtualTime::OfProcess().UnlockAfterFork();
  UnlockCards();
  CallScope::End();
}
void UnlockChild() {
  WaitingThreads::OfProcess().UnlockAfterFork();
  VirtualTime::OfProcess().BecomeChild();
  UnlockCards();
  LeaveJudgingToParent();
  CallScope::End();
}

/// If `oncard exec` reads the host's output, it is line-buffered as on a terminal.
__attribute__((constructor)) void WriteLines() {
  if (std::getenv("ONCARD_LINES") != nullptr) std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
}

__attribute__((constructor)) void WatchForks() {
  pthread_atfork(LockEverything, UnlockParent, UnlockChild);
}

}  // namespace

}  // namespace oncard::runtime
