// A register in two steps: a command writes the waiting value, and an update makes it the working
// one, together with those of other registers. Source: GE manual 5.4. Tested by
// tests/gtcalls/ge/motion_command_test.cc.
#pragma once

namespace oncard::gtcalls {

template <typename T>
struct Refresh {
  T waiting{};  ///< as last written; what commands read
  T working{};  ///< in use

  /// True if an update would change the working value.
  bool Waits() const { return waiting != working; }
  void Update() { working = waiting; }
  /// Both steps at once.
  void Set(T value) { waiting = working = value; }

  auto Fields(auto visit) const { return visit(waiting, working); }
};

}  // namespace oncard::gtcalls
