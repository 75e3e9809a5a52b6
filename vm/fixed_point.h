// The motion program's `double`: a fixed-point number with 16 fractional bits (GTS manual 10.4.1).
// A raw value is the number times 2^16, held sign-extended in 64 bits. The integer part is 32 bits
// wide (32.16) or, on request, 16 bits (16.16); results wrap to that width. Everything here is
// integer arithmetic, so it is the same on every machine.
// Tested by tests/vm/fixed_point_test.cc.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace oncard::vm {

/// Width of the integer part; the numbers are stored in snapshots and compared.
enum class DoubleFormat : uint8_t { k32_16 = 0, k16_16 = 1 };

inline constexpr int kFractionBits = 16;
inline constexpr double kFractionScale = 65536.0;

/// How far a raw value is shifted left and arithmetically back to wrap it to the format's width.
constexpr int WrapShift(DoubleFormat format) { return format == DoubleFormat::k32_16 ? 16 : 32; }

/// Wraps to the width given by WrapShift().
constexpr int64_t WrapFixed(int64_t raw, int wrap_shift) {
  return static_cast<int64_t>(static_cast<uint64_t>(raw) << wrap_shift) >> wrap_shift;
}

constexpr int64_t AddFixed(int64_t a, int64_t b, int wrap_shift) {
  return WrapFixed(static_cast<int64_t>(static_cast<uint64_t>(a) + static_cast<uint64_t>(b)),
                   wrap_shift);
}

constexpr int64_t SubtractFixed(int64_t a, int64_t b, int wrap_shift) {
  return WrapFixed(static_cast<int64_t>(static_cast<uint64_t>(a) - static_cast<uint64_t>(b)),
                   wrap_shift);
}

/// (a*b)/2^16, exact before it is truncated toward zero and wrapped.
constexpr int64_t MultiplyFixed(int64_t a, int64_t b, int wrap_shift) {
  // Of the product's bits only 16 to 63 can remain: the fraction is cut off below them, the wrap
  // above. So its lower half is enough. Adding the largest fraction to a negative product makes the
  // cut one toward zero; to a product of 0 it adds nothing that remains.
  const uint64_t product = static_cast<uint64_t>(a) * static_cast<uint64_t>(b);
  const auto fraction = static_cast<uint64_t>((a ^ b) >> 63 & ((1 << kFractionBits) - 1));
  return static_cast<int64_t>((product + fraction) << (wrap_shift - kFractionBits)) >> wrap_shift;
}

/// (a*2^16)/b truncated toward zero and wrapped; b must not be 0.
constexpr int64_t DivideFixed(int64_t a, int64_t b, int wrap_shift) {
  // A raw value has at most 48 bits, so the shifted dividend fits. Dividing the most negative one
  // by -1 would not, hence the negation.
  const int64_t dividend = static_cast<int64_t>(static_cast<uint64_t>(a) << kFractionBits);
  if (b == -1) {
    return WrapFixed(static_cast<int64_t>(0 - static_cast<uint64_t>(dividend)), wrap_shift);
  }
  return WrapFixed(dividend / b, wrap_shift);
}

/// (double)i.
constexpr int64_t FixedFromInt(int32_t value, int wrap_shift) {
  return WrapFixed(static_cast<int64_t>(value) * (1 << kFractionBits), wrap_shift);
}

/// (int)d: truncated toward zero.
constexpr int32_t IntFromFixed(int64_t raw) {
  return static_cast<int32_t>((raw + ((raw >> 63) & ((1 << kFractionBits) - 1))) >> kFractionBits);
}

/// The exact value of a raw number.
constexpr double DoubleFromFixed(int64_t raw) { return static_cast<double>(raw) / kFractionScale; }

/// The smallest and largest raw values of a format.
constexpr int64_t FixedMin(DoubleFormat format) {
  return std::numeric_limits<int64_t>::min() >> WrapShift(format);
}
constexpr int64_t FixedMax(DoubleFormat format) {
  return std::numeric_limits<int64_t>::max() >> WrapShift(format);
}

/// A host's value as a raw number, truncated toward zero. Returns false and
/// leaves `raw` alone when the value is not finite or does not fit the format.
inline bool FixedFromDouble(double value, DoubleFormat format, int64_t* raw) {
  const double scaled = std::trunc(value * kFractionScale);
  if (!(scaled >= static_cast<double>(FixedMin(format)) &&
        scaled <= static_cast<double>(FixedMax(format)))) {
    return false;
  }
  *raw = static_cast<int64_t>(scaled);
  return true;
}

}  // namespace oncard::vm
