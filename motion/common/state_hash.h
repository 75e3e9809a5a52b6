// XXH64 over state values one by one, in the order they are added: no padding, no addresses, the
// same number on every machine.
//
// A structure joins the hash by listing its members once:
//
//   auto Fields(auto visit) const { return visit(mode, position, table); }
//
// It is a template, so that only a source that needs the members compiles the list. Members that
// are not listed are not part of the hash; kFieldsComplete<T> says at compile time whether an
// aggregate's list is as long as the aggregate. A structure with a function in_use() joins the hash
// only while that is true: what a card does not use does not change its hash. StateWords has the
// same values as words, for other hashes.
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
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "motion/common/rare.h"

namespace oncard::motion {

namespace internal {

struct FieldCounter {
  template <typename... T>
  std::integral_constant<size_t, sizeof...(T)> operator()(const T&... fields) const;
};

}  // namespace internal

/// A structure that lists its members.
template <typename T>
concept ListsFields = requires(const T& value) {
  value.Fields(internal::FieldCounter());
};

/// How many members Fields() lists.
template <ListsFields T>
inline constexpr size_t kFieldCount =
    decltype(std::declval<const T&>().Fields(internal::FieldCounter()))::value;

/// What adds the values of a state as words of 64 bits, in their order, to a `Sink`, which derives
/// from it and has AddWord(uint64_t).
template <typename Sink>
class StateValues {
 public:
  /// Adds an integer, bool or enumerator as 64 bits.
  template <typename T>
  requires std::is_integral_v<T> || std::is_enum_v<T> Sink& Add(T value) {
    // NOLINTNEXTLINE(bugprone-signed-char-misuse): an int8_t is a number here
    self().AddWord(static_cast<uint64_t>(value));
    return self();
  }
  /// Adds the bits of a double.
  Sink& Add(double value) { return Add(std::bit_cast<uint64_t>(value)); }

  /// Adds the elements, preceded by their number if it can vary.
  template <typename T, size_t kSize>
  Sink& Add(const std::array<T, kSize>& values) {
    for (const T& value : values) Add(value);
    return self();
  }
  template <typename T>
  Sink& Add(const std::vector<T>& values) {
    return Add(std::span(values));
  }
  template <typename T>
  Sink& Add(std::span<const T> values) {
    Add(values.size());
    for (const T& value : values) Add(value);
    return self();
  }
  template <typename T>
  Sink& Add(const std::optional<T>& value) {
    Add(value.has_value());
    if (value.has_value()) Add(*value);
    return self();
  }
  /// Adds the alternative, preceded by its number.
  template <typename... T>
  Sink& Add(const std::variant<T...>& value) {
    Add(value.index());
    std::visit([this](const auto& alternative) { this->Add(alternative); }, value);
    return self();
  }
  /// Adds the value that the pointer points to.
  template <typename T>
  Sink& Add(const std::shared_ptr<const T>& value) {
    Add(value != nullptr);
    if (value != nullptr) Add(*value);
    return self();
  }

  /// Adds the part of a card that has it, and nothing otherwise.
  template <typename T>
  Sink& Add(const Rare<T>& part) {
    if (part) Add(*part);
    return self();
  }

  /// Adds the members that a structure lists; nothing if the structure says that it is not in use.
  template <ListsFields T>
  Sink& Add(const T& value) {
    if constexpr (requires { value.in_use(); }) {
      if (!value.in_use()) return self();
    }
    value.Fields([this](const auto&... fields) { (this->Add(fields), ...); });
    return self();
  }

 private:
  friend Sink;
  StateValues() = default;

  Sink& self() { return static_cast<Sink&>(*this); }
};

/// XXH64 of their bytes.
class StateHash : public StateValues<StateHash> {
 public:
  StateHash() { XXH64_reset(&state_, 0); }

  /// Adds its bytes, the least significant one first.
  void AddWord(uint64_t word) {
    unsigned char* bytes = waiting_.data() + count_;
    for (unsigned i = 0; i < kWordBytes; ++i)
      bytes[i] = static_cast<unsigned char>(word >> (8 * i));
    count_ += kWordBytes;
    if (count_ < waiting_.size()) return;
    XXH64_update(&state_, waiting_.data(), count_);
    count_ = 0;
  }

  uint64_t value() const {
    XXH64_state_t all = state_;
    XXH64_update(&all, waiting_.data(), count_);
    return XXH64_digest(&all);
  }

 private:
  static constexpr size_t kWordBytes = 8;

  XXH64_state_t state_;
  /// Words that are added together, which is faster.
  std::array<unsigned char, 128 * kWordBytes> waiting_{};
  size_t count_ = 0;
};

/// The words themselves.
class StateWords : public StateValues<StateWords> {
 public:
  StateWords() : words_(128) {}

  /// Inline, as it is called for every value of a state: a call takes several times as long.
  [[gnu::always_inline]] void AddWord(uint64_t word) {
    if (count_ == words_.size()) words_.resize(2 * count_);
    words_[count_++] = word;
  }
  void Clear() { count_ = 0; }
  std::span<const uint64_t> words() const { return std::span(words_).first(count_); }

 private:
  std::vector<uint64_t> words_;
  size_t count_ = 0;
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
inline constexpr bool kFieldsComplete = kFieldCount<T> == internal::CountFields<T>();

}  // namespace oncard::motion
