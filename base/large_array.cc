#include "base/large_array.h"

#include <cstdint>
#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace oncard {
namespace {

constexpr std::align_val_t kLine{64};

#ifdef __linux__

constexpr size_t kPage = size_t{2} << 20;

/// In whole large pages.
size_t Pages(size_t size) { return (size + kPage - 1) / kPage * kPage; }

/// Addresses for `size` bytes of whole large pages; nullptr if there are none.
std::byte* Reserve(size_t size) {
  const size_t more = size + kPage;
  void* const region =
      mmap(nullptr, more, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (region == MAP_FAILED) return nullptr;
  auto* const first = static_cast<std::byte*>(region);
  const size_t before = (kPage - reinterpret_cast<uintptr_t>(first) % kPage) % kPage;
  if (before > 0) munmap(first, before);
  munmap(first + before + size, kPage - before);
  return first + before;
}

/// Pages of zeros at these addresses.
bool Map(std::byte* at, size_t size) {
  constexpr int kFlags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED;
  if (mmap(at, size, PROT_READ | PROT_WRITE, kFlags, -1, 0) == MAP_FAILED) return false;
  static_cast<void>(madvise(at, size, MADV_HUGEPAGE));  // a wish; without it, only slower
  return true;
}

#endif

}  // namespace

void LargeBlock::Grow(size_t size) {
#ifdef __linux__
  if (size >= kPage && (!mapped_ || Pages(size) > Pages(size_))) {
    std::byte* const larger = Reserve(Pages(size));
    if (larger == nullptr) return GrowByCopy(size);
    if (mapped_) {
      constexpr int kFlags = MREMAP_MAYMOVE | MREMAP_FIXED;
      if (mremap(data_, Pages(size_), Pages(size), kFlags, larger) == MAP_FAILED) {
        munmap(larger, Pages(size));
        return GrowByCopy(size);
      }
    } else {
      if (!Map(larger, Pages(size))) {
        munmap(larger, Pages(size));
        return GrowByCopy(size);
      }
      if (size_ > 0) std::memcpy(larger, data_, size_);
      Free();
    }
    data_ = larger;
    size_ = size;
    mapped_ = true;
    return;
  }
  if (mapped_) {
    size_ = size;
    return;
  }
#endif
  GrowByCopy(size);
}

void LargeBlock::GrowByCopy(size_t size) {
  auto* const larger = static_cast<std::byte*>(::operator new(size, kLine));
  if (size_ > 0) std::memcpy(larger, data_, size_);
  std::memset(larger + size_, 0, size - size_);
  Free();
  data_ = larger;
  size_ = size;
}

void LargeBlock::Free() {
  if (!mapped_) return ::operator delete(data_, kLine);
#ifdef __linux__
  munmap(data_, Pages(size_));
#endif
  mapped_ = false;
}

}  // namespace oncard
