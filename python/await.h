// Work that Python waits for. It is done in a thread of its own and without Python's lock: other
// threads of Python go on, and Ctrl-C is heard. To be called with the lock.
// Tested by tests/python/test_explore.py.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <utility>

namespace oncard::python {

/// How often signals and limits are looked at while work is going on.
inline constexpr std::chrono::milliseconds kLook{50};

/// What `work` returns. `look` is called from time to time while it goes on; it may be empty. A
/// signal whose handler raises an exception, as Ctrl-C does, calls `stop`, which must let the work
/// end soon; its result is then lost, and the exception is thrown.
template <typename Work>
auto Await(Work work, const std::function<void()>& stop, const std::function<void()>& look = {})
    -> decltype(work()) {
  auto result = std::async(std::launch::async, std::move(work));
  std::optional<pybind11::error_already_set> signalled;
  {
    const pybind11::gil_scoped_release unlocked;
    while (result.wait_for(kLook) != std::future_status::ready) {
      if (look) look();
      const pybind11::gil_scoped_acquire locked;
      if (signalled || PyErr_CheckSignals() == 0) continue;
      signalled.emplace();
      stop();
    }
  }
  if (signalled) throw pybind11::error_already_set(*signalled);
  return result.get();
}

}  // namespace oncard::python
