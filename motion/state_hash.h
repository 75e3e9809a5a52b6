// XXH64 over state values one by one, in the order they are added: no padding, no addresses, the
// same number on every machine.
#pragma once

// The state's layout, so that it can be a member.
#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

#include <bit>
#include <cstdint>
#include <type_traits>

namespace oncard::motion {

class StateHash {
 public:
  StateHash() { XXH64_reset(&state_, 0); }

  /// Adds an integer, bool or enumerator as 64 bits, least significant byte first.
  template <typename T>
  requires std::is_integral_v<T> || std::is_enum_v<T> StateHash& Add(T value) {
    const auto bits = static_cast<uint64_t>(value);
    unsigned char bytes[8];
    for (unsigned i = 0; i < 8; ++i) bytes[i] = static_cast<unsigned char>(bits >> (8 * i));
    XXH64_update(&state_, bytes, sizeof bytes);
    return *this;
  }
  /// Adds the bits of a double.
  StateHash& Add(double value) { return Add(std::bit_cast<uint64_t>(value)); }

  uint64_t value() const { return XXH64_digest(&state_); }

 private:
  XXH64_state_t state_;
};

}  // namespace oncard::motion
