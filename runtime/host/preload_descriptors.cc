// Part of liboncard_host.so (preload.cc): makes waits for descriptors with a time-out use virtual
// time.
//
//   select pselect poll ppoll   without descriptors they are sleeps
//   epoll_wait epoll_pwait epoll_pwait2
//
// Waits without a time-out and time-outs of sockets (SO_RCVTIMEO) are not changed.
// Tested by tests/tools/exec_command_test.cc.
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/select.h>

#include "runtime/host/preload.h"

using namespace oncard::preload;

namespace {

/// Executes a wait for descriptors in slices of virtual time. `wait_for(timeout)` is the real wait
/// and returns the number of ready descriptors, 0 after the time-out, or -1 with errno. Returns the
/// same.
template <typename WaitFor>
int WaitForDescriptors(const Hooks& hooks, long long deadline_ns, const WaitFor& wait_for) {
  pthread_testcancel();
  int ready = 0;
  WaitUntil(hooks, deadline_ns, [&](long long slice_ns) {
    const timespec slice = ToTimespec(slice_ns);
    ready = wait_for(&slice);
    return ready != 0;
  });
  return ready;
}

/// The virtual time at which a time-out that begins now ends.
long long DeadlineAfter(const Hooks& hooks, long long timeout_ns) {
  const long long now_ns = hooks.time_ns();
  return timeout_ns > kForeverNs - now_ns ? kForeverNs : now_ns + timeout_ns;
}

// --- poll ----------------------------------------------------------------------------------------

int Poll(const Hooks& hooks, pollfd* descriptors, nfds_t count, long long timeout_ns,
         const sigset_t* mask) {
  if (count == 0 && mask == nullptr) {
    return Sleep(hooks, timeout_ns) > 0 ? Fail(EINTR) : 0;
  }
  return WaitForDescriptors(hooks, DeadlineAfter(hooks, timeout_ns), [&](const timespec* slice) {
    return ORIGINAL(ppoll)(descriptors, count, slice, mask);
  });
}

// --- select --------------------------------------------------------------------------------------

bool IsEmpty(int count, const fd_set* set) {
  if (set == nullptr) return true;
  for (int descriptor = 0; descriptor < count; ++descriptor) {
    if (FD_ISSET(descriptor, set)) return false;
  }
  return true;
}

/// The three sets of a select(), which overwrites them in every slice.
struct Sets {
  fd_set* of_host[3];
  fd_set asked[3];

  Sets(fd_set* read, fd_set* write, fd_set* except) : of_host{read, write, except} {
    for (int i = 0; i < 3; ++i) {
      if (of_host[i] != nullptr) asked[i] = *of_host[i];
    }
  }
  /// False if there is a pointer to no set.
  static bool AreSets(const fd_set* read, const fd_set* write, const fd_set* except) {
    const auto is_set = [](const fd_set* set) { return set == nullptr || IsAddress(set); };
    return is_set(read) && is_set(write) && is_set(except);
  }
  bool AreEmpty(int count) const {
    return IsEmpty(count, of_host[0]) && IsEmpty(count, of_host[1]) && IsEmpty(count, of_host[2]);
  }
  void Ask() {
    for (int i = 0; i < 3; ++i) {
      if (of_host[i] != nullptr) *of_host[i] = asked[i];
    }
  }
};

int Select(const Hooks& hooks, int count, Sets* sets, long long deadline_ns, const sigset_t* mask) {
  return WaitForDescriptors(hooks, deadline_ns, [&](const timespec* slice) {
    sets->Ask();
    return ORIGINAL(pselect)(count, sets->of_host[0], sets->of_host[1], sets->of_host[2], slice,
                             mask);
  });
}

// --- epoll ---------------------------------------------------------------------------------------

/// An epoll descriptor can itself be polled, with a resolution of 1 ns, which epoll_wait() does not
/// have.
int Epoll(const Hooks& hooks, int epoll, epoll_event* events, int count, long long timeout_ns,
          const sigset_t* mask) {
  return WaitForDescriptors(hooks, DeadlineAfter(hooks, timeout_ns), [&](const timespec* slice) {
    pollfd descriptor = {epoll, POLLIN, 0};
    const int ready = ORIGINAL(ppoll)(&descriptor, 1, slice, mask);
    return ready < 0 ? ready : ORIGINAL(epoll_wait)(epoll, events, count, 0);
  });
}

}  // namespace

ONCARD_EXPORT int poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || timeout_ms < 0) return ORIGINAL(poll)(descriptors, count, timeout_ms);
  return Poll(*hooks, descriptors, count, timeout_ms * 1'000'000LL, nullptr);
}

ONCARD_EXPORT int ppoll(pollfd* descriptors, nfds_t count, const timespec* timeout,
                        const sigset_t* mask) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsAddress(timeout) || !IsValid(*timeout)) {
    return ORIGINAL(ppoll)(descriptors, count, timeout, mask);
  }
  return Poll(*hooks, descriptors, count, ToNs(*timeout), mask);
}

ONCARD_EXPORT int select(int count, fd_set* read, fd_set* write, fd_set* except, timeval* timeout) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsAddress(timeout) || count > FD_SETSIZE || timeout->tv_sec < 0 ||
      timeout->tv_usec < 0 || !Sets::AreSets(read, write, except)) {
    return ORIGINAL(select)(count, read, write, except, timeout);
  }
  const long long timeout_ns = ToNs(*timeout);
  Sets sets(read, write, except);
  if (sets.AreEmpty(count)) {
    const timespec left = ToTimespec(Sleep(*hooks, timeout_ns));
    *timeout = {left.tv_sec, static_cast<suseconds_t>(left.tv_nsec / 1000)};
    return left.tv_sec != 0 || left.tv_nsec != 0 ? Fail(EINTR) : 0;
  }
  const long long deadline_ns = DeadlineAfter(*hooks, timeout_ns);
  const int ready = Select(*hooks, count, &sets, deadline_ns, nullptr);
  // Returns the remaining time, as Linux does.
  const long long left_ns = ready == 0 ? 0 : deadline_ns - hooks->time_ns();
  const timespec left = ToTimespec(left_ns > 0 ? left_ns : 0);
  *timeout = {left.tv_sec, static_cast<suseconds_t>(left.tv_nsec / 1000)};
  return ready;
}

ONCARD_EXPORT int pselect(int count, fd_set* read, fd_set* write, fd_set* except,
                          const timespec* timeout, const sigset_t* mask) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsAddress(timeout) || count > FD_SETSIZE || !IsValid(*timeout) ||
      !Sets::AreSets(read, write, except)) {
    return ORIGINAL(pselect)(count, read, write, except, timeout, mask);
  }
  Sets sets(read, write, except);
  if (sets.AreEmpty(count) && mask == nullptr) {
    return Sleep(*hooks, ToNs(*timeout)) > 0 ? Fail(EINTR) : 0;
  }
  return Select(*hooks, count, &sets, DeadlineAfter(*hooks, ToNs(*timeout)), mask);
}

ONCARD_EXPORT int epoll_wait(int epoll, epoll_event* events, int count, int timeout_ms) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || timeout_ms < 0) {
    return ORIGINAL(epoll_wait)(epoll, events, count, timeout_ms);
  }
  return Epoll(*hooks, epoll, events, count, timeout_ms * 1'000'000LL, nullptr);
}

ONCARD_EXPORT int epoll_pwait(int epoll, epoll_event* events, int count, int timeout_ms,
                              const sigset_t* mask) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || timeout_ms < 0) {
    return ORIGINAL(epoll_pwait)(epoll, events, count, timeout_ms, mask);
  }
  return Epoll(*hooks, epoll, events, count, timeout_ms * 1'000'000LL, mask);
}

ONCARD_EXPORT int epoll_pwait2(int epoll, epoll_event* events, int count, const timespec* timeout,
                               const sigset_t* mask) {
  const Hooks* hooks = VirtualHooks();
  if (hooks == nullptr || !IsAddress(timeout) || !IsValid(*timeout)) {
    return ORIGINAL(epoll_pwait2)(epoll, events, count, timeout, mask);
  }
  return Epoll(*hooks, epoll, events, count, ToNs(*timeout), mask);
}
