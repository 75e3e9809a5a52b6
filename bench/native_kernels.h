// The kernels in plain C++, compiled with -O2: their speed as machine code.
#pragma once

#include <cstdint>

namespace oncard::bench {

int32_t NativeSum(int32_t n);
int64_t NativeMultiplyAccumulate(int32_t n);  ///< raw 32.16
int32_t NativePrefixSum(int32_t n);
int32_t NativeCollatz(int32_t n);

int32_t NativeGcd(int32_t n);
int32_t NativeSieve(int32_t n);
int32_t NativeHashMix(int32_t n);
int64_t NativeBiquad(int32_t n);  ///< raw 32.16
int32_t NativeBubbleSort(int32_t n);
int32_t NativePlc(int32_t n);

}  // namespace oncard::bench
