// A queue whose elements lie in one piece of memory. Removing elements does not allocate, and each
// element moves rarely. Tested by tests/motion/look_ahead_test.cc.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace oncard::motion {

template <typename T>
struct ItemQueue {
  std::vector<T> slots;
  size_t head = 0;

  size_t size() const { return slots.size() - head; }
  bool empty() const { return head == slots.size(); }
  T& front() { return slots[head]; }
  const T& front() const { return slots[head]; }
  T& back() { return slots.back(); }
  const T& back() const { return slots.back(); }
  T& At(size_t index) { return slots[head + index]; }
  const T& At(size_t index) const { return slots[head + index]; }
  void Push(const T& item) {
    // Removed elements are erased once they are half of all, so that each moves rarely.
    if (head > 0 && head >= slots.size() / 2) {
      slots.erase(slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(head));
      head = 0;
    }
    slots.push_back(item);
  }
  void Pop() {
    if (++head < slots.size()) return;
    Clear();
  }
  void Clear() {
    slots.clear();
    head = 0;
  }

  /// Removed elements are not part of the value.
  auto Fields(auto visit) const { return visit(std::span(slots).subspan(head)); }
};

}  // namespace oncard::motion
