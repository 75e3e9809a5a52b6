// The upper half of a product of 128 bits, with the compiler's own type of 128 bits or without.
// Tested by tests/base/wide_product_test.cc.
#pragma once

#include <cstdint>

namespace oncard {

/// The upper 64 bits of a product, from the products of the factors' halves.
constexpr uint64_t UpperProductByHalves(uint64_t a, uint64_t b) {
  const uint64_t a_high = a >> 32;
  const uint64_t b_high = b >> 32;
  const uint64_t a_low = a & UINT32_MAX;
  const uint64_t b_low = b & UINT32_MAX;
  // Neither sum overflows: (2^32-1)^2 + 2*(2^32-1) = 2^64 - 1.
  const uint64_t middle = a_high * b_low + (a_low * b_low >> 32);
  const uint64_t carry = a_low * b_high + (middle & UINT32_MAX);
  return a_high * b_high + (middle >> 32) + (carry >> 32);
}

/// The upper 64 bits of a product.
constexpr uint64_t UpperProduct(uint64_t a, uint64_t b) {
#ifdef __SIZEOF_INT128__
  __extension__ using Wide = unsigned __int128;
  return static_cast<uint64_t>((static_cast<Wide>(a) * b) >> 64);
#else
  return UpperProductByHalves(a, b);
#endif
}

}  // namespace oncard
