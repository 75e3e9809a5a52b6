// A part of the state that few cards use: nothing but a null pointer until it is begun, and then a
// value like any other, copied with the state that contains it. It joins hashes while it is in use
// (state_hash.h). Tested by tests/motion/path_planner_test.cc.
#pragma once

#include <memory>
#include <tuple>
#include <utility>

namespace oncard::motion {

template <typename T>
class Held {
 public:
  Held() = default;
  Held(const Held& other) : part_(other.part_ ? std::make_unique<T>(*other.part_) : nullptr) {}
  Held(Held&&) noexcept = default;
  Held& operator=(const Held& other) {
    if (this != &other) part_ = other.part_ ? std::make_unique<T>(*other.part_) : nullptr;
    return *this;
  }
  Held& operator=(Held&&) noexcept = default;
  ~Held() = default;

  bool in_use() const { return part_ != nullptr; }
  void Begin(T value) { part_ = std::make_unique<T>(std::move(value)); }
  void End() { part_.reset(); }
  /// Only while it is in use.
  T& operator*() { return *part_; }
  const T& operator*() const { return *part_; }
  T* operator->() { return part_.get(); }
  const T* operator->() const { return part_.get(); }

  auto Fields() const { return std::tie(*part_); }

 private:
  std::unique_ptr<T> part_;
};

}  // namespace oncard::motion
