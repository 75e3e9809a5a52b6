#include "bench/native_kernels.h"

namespace oncard::bench {
namespace {

int32_t Add(int32_t a, int32_t b) {
  return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}

}  // namespace

int32_t NativeSum(int32_t n) {
  int32_t sum = 0;
  for (int32_t i = 1; i <= n; ++i) sum = Add(sum, i);
  return sum;
}

int64_t NativeMultiplyAccumulate(int32_t n) {
  // Read once through volatile, so that the product is not computed at compile time.
  volatile int64_t x_source = 69632;
  volatile int64_t y_source = 64512;
  const int64_t x = x_source;
  const int64_t y = y_source;
  int64_t acc = 0;
  for (int32_t i = 1; i <= n; ++i) {
    const int64_t product = (x * y) / 65536;
    acc = static_cast<int64_t>(static_cast<uint64_t>(acc + product) << 16) >> 16;
  }
  return acc;
}

int32_t NativePrefixSum(int32_t n) {
  int32_t a[1000];
  for (int32_t& element : a) element = 1;
  int32_t s = 0;
  for (; n != 0; --n) {
    s = 0;
    for (int32_t& element : a) {
      s = Add(s, element);
      element = s;
    }
  }
  return s;
}

int32_t NativeCollatz(int32_t n) {
  int32_t steps = 0;
  for (int32_t i = 1; i <= n; ++i) {
    for (int32_t x = i; x != 1; ++steps) x = x % 2 != 0 ? x * 3 + 1 : x / 2;
  }
  return steps;
}

}  // namespace oncard::bench
