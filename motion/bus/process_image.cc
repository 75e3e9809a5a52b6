#include "motion/bus/process_image.h"

#include <algorithm>

namespace oncard::motion::bus {

// Both take as many bits of a byte at once as belong to the number.

int64_t ProcessImage::Get(size_t bit, uint8_t bits, bool is_signed) const {
  uint64_t value = 0;
  for (unsigned done = 0; done < bits;) {
    const size_t at = bit + done;
    const auto shift = static_cast<unsigned>(at % 8);
    const unsigned count = std::min(8 - shift, bits - done);
    const unsigned mask = (1u << count) - 1;
    value |= uint64_t{bytes_[at / 8] >> shift & mask} << done;
    done += count;
  }
  if (!is_signed) return static_cast<int64_t>(value);
  const unsigned unused = 64u - bits;
  return static_cast<int64_t>(value << unused) >> unused;
}

void ProcessImage::Put(size_t bit, uint8_t bits, int64_t value) {
  for (unsigned done = 0; done < bits;) {
    const size_t at = bit + done;
    const auto shift = static_cast<unsigned>(at % 8);
    const unsigned count = std::min(8 - shift, bits - done);
    const unsigned mask = ((1u << count) - 1) << shift;
    const unsigned put = static_cast<unsigned>(value >> done & 0xFF) << shift & mask;
    bytes_[at / 8] = static_cast<uint8_t>((bytes_[at / 8] & ~mask) | put);
    done += count;
  }
}

void ProcessImage::PutUnlessHeld(size_t bit, uint8_t bits, int64_t value) {
  const size_t last = (bit + bits - 1) / 8;
  for (size_t byte = bit / 8; any_held_ && byte <= last; ++byte) {
    if (held_[byte] != 0) return;
  }
  Put(bit, bits, value);
}

void ProcessImage::WriteByHost(size_t offset, std::span<const uint8_t> data) {
  std::ranges::copy(data, bytes_.begin() + static_cast<std::ptrdiff_t>(offset));
  std::fill_n(held_.begin() + static_cast<std::ptrdiff_t>(offset), data.size(), uint8_t{1});
  any_held_ = true;
}

void ProcessImage::EndExchange() {
  if (!any_held_) return;
  std::ranges::fill(held_, uint8_t{0});
  any_held_ = false;
}

void ProcessImage::Clear() {
  std::ranges::fill(bytes_, uint8_t{0});
  EndExchange();
}

}  // namespace oncard::motion::bus
