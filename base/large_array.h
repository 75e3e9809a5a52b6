// Arrays for tables that are much larger than the processor's caches: in large pages, where the
// system has them, so that few lookups wait for an address translation. They grow without copies,
// where the system can give memory another address.
// Tested by tests/base/large_array_test.cc.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace oncard {

/// Memory for a LargeArray.
class LargeBlock {
 public:
  LargeBlock() = default;
  LargeBlock(LargeBlock&& other) noexcept { *this = std::move(other); }
  LargeBlock& operator=(LargeBlock&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(mapped_, other.mapped_);
    return *this;
  }
  ~LargeBlock() { Free(); }

  std::byte* data() const { return data_; }
  size_t size() const { return size_; }
  /// To `size` bytes, more than there are now; those keep their values, and the new ones are 0. A
  /// lack of memory is that of operator new.
  void Grow(size_t size);

 private:
  void Free();
  /// Where the system cannot help.
  void GrowByCopy(size_t size);

  std::byte* data_ = nullptr;
  size_t size_ = 0;
  bool mapped_ = false;  ///< pages of the system, which are not part of the heap
};

/// A vector of values that are plain bytes. New elements are zero bytes if nothing else is said.
template <typename T>
class LargeArray {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);

 public:
  using value_type = T;
  using const_iterator = const T*;

  LargeArray() = default;
  explicit LargeArray(size_t size) { Grow(size); }
  LargeArray(LargeArray&& other) noexcept { *this = std::move(other); }
  LargeArray& operator=(LargeArray&& other) noexcept {
    std::swap(block_, other.block_);
    std::swap(size_, other.size_);
    return *this;
  }

  size_t size() const { return size_; }
  T& operator[](size_t index) { return begin()[index]; }
  const T& operator[](size_t index) const { return begin()[index]; }
  T* begin() { return reinterpret_cast<T*>(block_.data()); }
  T* end() { return begin() + size_; }
  const T* begin() const { return reinterpret_cast<const T*>(block_.data()); }
  const T* end() const { return begin() + size_; }

  bool operator==(const LargeArray& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }

  /// To `size` elements, at least those that there are; the new ones are zero bytes.
  void Grow(size_t size) {
    if (size * sizeof(T) > block_.size()) block_.Grow(size * sizeof(T));
    size_ = size;
  }
  /// Appends a value `count` times.
  void Append(size_t count, const T& value) {
    const size_t size = size_ + count;
    if (size * sizeof(T) > block_.size()) block_.Grow(std::max(size, 2 * size_) * sizeof(T));
    std::fill(end(), begin() + size, value);
    size_ = size;
  }

 private:
  LargeBlock block_;
  size_t size_ = 0;
};

}  // namespace oncard
