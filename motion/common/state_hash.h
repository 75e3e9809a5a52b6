// XXH64 over state values one by one, in the order they are added: no padding, no addresses, the
// same number on every machine.
//
// A structure joins the hash by listing its members once:
//
//   auto Fields() const { return std::tie(mode, position, table); }
//
// Members that are not listed are not part of the hash; kFieldsComplete<T> says at compile time
// whether an aggregate's list is as long as the aggregate. A structure with a function in_use()
// joins the hash only while that is true: what a card does not use does not change its hash.
#pragma once

// The state's layout, so that it can be a member.
#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "motion/common/rare.h"

namespace oncard::motion {

class StateHash {
 public:
  StateHash() { XXH64_reset(&state_, 0); }

  /// Adds an integer, bool or enumerator as 64 bits, least significant byte first.
  template <typename T>
  requires std::is_integral_v<T> || std::is_enum_v<T> StateHash& Add(T value) {
    // NOLINTNEXTLINE(bugprone-signed-char-misuse): an int8_t is a number here
    const auto bits = static_cast<uint64_t>(value);
    unsigned char bytes[8];
    for (unsigned i = 0; i < 8; ++i) bytes[i] = static_cast<unsigned char>(bits >> (8 * i));
    XXH64_update(&state_, bytes, sizeof bytes);
    return *this;
  }
  /// Adds the bits of a double.
  StateHash& Add(double value) { return Add(std::bit_cast<uint64_t>(value)); }

  /// Adds the elements, preceded by their number if it can vary.
  template <typename T, size_t kSize>
  StateHash& Add(const std::array<T, kSize>& values) {
    for (const T& value : values) Add(value);
    return *this;
  }
  template <typename T>
  StateHash& Add(const std::vector<T>& values) {
    return Add(std::span(values));
  }
  template <typename T>
  StateHash& Add(std::span<const T> values) {
    Add(values.size());
    for (const T& value : values) Add(value);
    return *this;
  }
  template <typename T>
  StateHash& Add(const std::optional<T>& value) {
    Add(value.has_value());
    if (value.has_value()) Add(*value);
    return *this;
  }
  /// Adds the alternative, preceded by its number.
  template <typename... T>
  StateHash& Add(const std::variant<T...>& value) {
    Add(value.index());
    std::visit([this](const auto& alternative) { this->Add(alternative); }, value);
    return *this;
  }
  /// Adds the value that the pointer points to.
  template <typename T>
  StateHash& Add(const std::shared_ptr<const T>& value) {
    Add(value != nullptr);
    if (value != nullptr) Add(*value);
    return *this;
  }

  /// Adds the part of a card that has it, and nothing otherwise.
  template <typename T>
  StateHash& Add(const Rare<T>& part) {
    if (part) Add(*part);
    return *this;
  }

  /// Adds the members that a structure lists; nothing if the structure says that it is not in use.
  template <typename T>
  requires requires(const T& value) { value.Fields(); }
  StateHash& Add(const T& value) {
    if constexpr (requires { value.in_use(); }) {
      if (!value.in_use()) return *this;
    }
    std::apply([this](const auto&... fields) { (this->Add(fields), ...); }, value.Fields());
    return *this;
  }

  uint64_t value() const { return XXH64_digest(&state_); }

 private:
  XXH64_state_t state_;
};

namespace internal {

struct AnyValue {
  template <typename T>
  operator T() const;  // NOLINT(google-explicit-constructor): stands for a value of any type
};

template <typename T, typename... Values>
constexpr size_t CountFields() {
  if constexpr (requires { T{Values{}..., AnyValue{}}; }) {
    return CountFields<T, Values..., AnyValue>();
  } else {
    return sizeof...(Values);
  }
}

}  // namespace internal

/// True when an aggregate's Fields() lists as many members as it has.
template <typename T>
inline constexpr bool kFieldsComplete =
    std::tuple_size_v<decltype(std::declval<const T&>().Fields())> == internal::CountFields<T>();

}  // namespace oncard::motion
