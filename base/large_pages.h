// Memory for tables that are much larger than the processor's caches and looked up at random: in
// large pages, where the system has them, so that few lookups wait for an address translation.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace oncard {

/// An allocator for containers; small blocks come from where all others do.
template <typename T>
class LargePageAllocator {
 public:
  using value_type = T;

  LargePageAllocator() = default;
  template <typename U>
  explicit LargePageAllocator(const LargePageAllocator<U>&) {}

  T* allocate(size_t count) {
    const size_t bytes = (count * sizeof(T) + kPage - 1) / kPage * kPage;
    if (count * sizeof(T) < kLeast) {
      return static_cast<T*>(::operator new(count * sizeof(T), kSmallAlignment));
    }
    void* block = ::operator new (bytes, std::align_val_t{kPage});
#ifdef __linux__
    static_cast<void>(madvise(block, bytes, MADV_HUGEPAGE));  // a wish; without it, only slower
#endif
    return static_cast<T*>(block);
  }
  void deallocate(T* block, size_t count) {
    if (count * sizeof(T) < kLeast) {
      ::operator delete(block, kSmallAlignment);
    } else {
      ::operator delete (block, std::align_val_t{kPage});
    }
  }
  bool operator==(const LargePageAllocator&) const { return true; }

 private:
  static constexpr size_t kPage = size_t{2} << 20;
  static constexpr size_t kLeast = kPage;
  static constexpr std::align_val_t kSmallAlignment{alignof(T)};
};

template <typename T>
using LargeVector = std::vector<T, LargePageAllocator<T>>;

}  // namespace oncard
