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

int32_t NativeGcd(int32_t n) {
  int32_t total = 0;
  for (int32_t i = 1; i <= n; ++i) {
    int32_t a = n;
    for (int32_t b = i; b != 0;) {
      const int32_t rest = a % b;
      a = b;
      b = rest;
    }
    total = Add(total, a);
  }
  return total;
}

int32_t NativeSieve(int32_t n) {
  int32_t prime[1000];
  int32_t count = 0;
  for (; n != 0; --n) {
    for (int32_t i = 2; i < 1000; ++i) prime[i] = 1;
    count = 0;
    for (int32_t i = 2; i < 1000; ++i) {
      if (prime[i] == 0) continue;
      ++count;
      for (int32_t multiple = i + i; multiple < 1000; multiple += i) prime[multiple] = 0;
    }
  }
  return count;
}

int32_t NativeHashMix(int32_t n) {
  uint32_t x = 12345;
  uint32_t hash = 0;
  for (; n != 0; --n) {
    x = x * 1664525 + 1013904223;
    hash = (hash ^ (x >> 16)) * 31;
  }
  return static_cast<int32_t>(hash);
}

int64_t NativeBiquad(int32_t n) {
  int64_t x = 16384;
  int64_t x1 = 0;
  int64_t x2 = 0;
  int64_t y1 = 0;
  int64_t y2 = 0;
  int64_t total = 0;
  int32_t phase = 0;
  for (int32_t i = 0; i < n; ++i) {
    if (++phase >= 100) {
      phase = 0;
      x = 81920 - x;
    }
    int64_t y = 655 * x / 65536;
    y += 1311 * x1 / 65536;
    y += 655 * x2 / 65536;
    y += 104858 * y1 / 65536;
    y -= 41943 * y2 / 65536;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    total += y;
  }
  return total;
}

int32_t NativeBubbleSort(int32_t n) {
  int32_t a[200];
  int32_t x = 1;
  int32_t total = 0;
  for (; n != 0; --n) {
    for (int32_t& element : a) {
      x = (x * 75 + 74) % 65537;
      element = x;
    }
    for (int32_t last = 199; last != 0; --last) {
      for (int32_t i = 0; i < last; ++i) {
        if (a[i] <= a[i + 1]) continue;
        const int32_t kept = a[i];
        a[i] = a[i + 1];
        a[i + 1] = kept;
      }
    }
    total = Add(total, a[100]);
  }
  return total;
}

int32_t NativePlc(int32_t n) {
  enum class State { kWaiting, kFilling, kClosing, kMoving, kStopped };
  State state = State::kWaiting;
  int32_t timer = 0;
  int32_t bottles = 0;
  int32_t stops = 0;
  for (int32_t cycle = 0; cycle < n; ++cycle) {
    const int32_t inputs = (cycle >> 3) ^ cycle;
    const int32_t overflow = inputs & 56;
    switch (state) {
      case State::kWaiting:
        if ((inputs & 1) == 0) break;
        state = State::kFilling;
        timer = 20;
        break;
      case State::kFilling:
        --timer;
        if (overflow == 56) {
          ++stops;
          state = State::kStopped;
        } else if ((inputs & 6) == 6 || timer == 0) {
          state = State::kClosing;
          timer = 3;
        }
        break;
      case State::kClosing:
        if (--timer != 0) break;
        state = State::kMoving;
        timer = 5;
        break;
      case State::kMoving:
        if (--timer != 0) break;
        ++bottles;
        state = State::kWaiting;
        break;
      case State::kStopped:
        state = State::kWaiting;
        if (overflow != 56) break;
        ++stops;
        state = State::kStopped;
        break;
    }
  }
  return static_cast<int32_t>(static_cast<uint32_t>(bottles) +
                              static_cast<uint32_t>(stops) * 1000u);
}

}  // namespace oncard::bench
