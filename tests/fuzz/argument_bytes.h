// The bytes of an input as the arguments of commands.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "gtcalls/catalogue.h"

namespace oncard::fuzz {

/// The bytes of an input, one after another; zeros after the end.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  uint8_t Byte() {
    uint8_t byte = 0;
    Copy(&byte, 1);
    return byte;
  }
  template <typename T>
  T Value() {
    T value{};
    Copy(&value, sizeof value);
    return value;
  }
  void Copy(void* to, size_t size) {
    const size_t count = std::min(size, bytes_.size());
    std::memcpy(to, bytes_.data(), count);
    bytes_.remove_prefix(count);
  }

  double Real() {
    constexpr std::array kValues = {0.0, 1.0, -1.0, 0.5, 5e-324, 1e-9, 1e9, 2147483648.0, 1e308};
    const uint8_t kind = Byte();
    return kind < 2 * kValues.size() ? kValues[kind % kValues.size()] : Value<double>();
  }

  /// A value with the width of its type, as a C caller passes it.
  int64_t Integer(gtcalls::Scalar type) {
    const uint8_t kind = Byte();
    if (kind < 200) return kind % 20;
    switch (type) {
      case gtcalls::Scalar::kShort:
        return Value<int16_t>();
      case gtcalls::Scalar::kUnsignedShort:
        return Value<uint16_t>();
      case gtcalls::Scalar::kChar:
        return Value<char>();
      case gtcalls::Scalar::kUnsignedChar:
        return Value<uint8_t>();
      default:
        return kind < 228 ? Value<int32_t>() : Value<int64_t>();
    }
  }

 private:
  std::string_view bytes_;
};

}  // namespace oncard::fuzz
