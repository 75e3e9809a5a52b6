// A part of a state that few cards have. A card without it carries one pointer and nothing in its
// hash, so that its hash is that of a card which does not know the part; with it, copies are deep
// and the part is hashed after everything else. Not thread-safe. Tested by
// tests/motion/bus/bus_axes_test.cc.
#pragma once

#include <memory>
#include <utility>

namespace oncard::motion {

template <typename T>
class Rare {
 public:
  Rare() = default;
  Rare(const Rare& other) : part_(other.part_ ? std::make_unique<T>(*other.part_) : nullptr) {}
  Rare(Rare&&) noexcept = default;
  Rare& operator=(const Rare& other) {
    if (this == &other) return *this;
    if (part_ && other.part_) {
      *part_ = *other.part_;
    } else {
      part_ = other.part_ ? std::make_unique<T>(*other.part_) : nullptr;
    }
    return *this;
  }
  Rare& operator=(Rare&&) noexcept = default;
  ~Rare() = default;

  /// Gives the card the part.
  T& Emplace(T part = {}) {
    part_ = std::make_unique<T>(std::move(part));
    return *part_;
  }

  /// Takes it away.
  void Reset() { part_.reset(); }

  explicit operator bool() const { return part_ != nullptr; }
  /// nullptr: the card does not have it.
  const T* get() const { return part_.get(); }
  T* operator->() { return part_.get(); }
  const T* operator->() const { return part_.get(); }
  T& operator*() { return *part_; }
  const T& operator*() const { return *part_; }

 private:
  std::unique_ptr<T> part_;
};

}  // namespace oncard::motion
