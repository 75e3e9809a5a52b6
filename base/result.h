// Errors are values: a function that can fail returns Result<T>, which holds either the value or
// an Error that says in both languages what was found, what was expected and how to go on.
#pragma once

#include <optional>
#include <utility>
#include <variant>

#include "base/message.h"

namespace oncard {

/// Why an operation failed. `code` is the card's own return code where there is one
/// (GTS manual table 3-1, and 2007/2008 for program files), 1 otherwise.
struct Error {
  int code = 1;
  Message message;
};

/// Builds an Error from a code and its text in both languages.
template <typename... Args>
Error MakeError(int code, std::string_view en, std::string_view zh, const Args&... args) {
  return {code, MakeMessage(en, zh, args...)};
}

/// A value, or the reason why there is none. Accessing the one that is absent is a bug in the
/// caller.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}      // NOLINT: implicit by design
  Result(Error error) : content_(std::move(error)) {}  // NOLINT: implicit by design

  bool ok() const { return std::holds_alternative<T>(content_); }
  T& value() & { return *std::get_if<T>(&content_); }
  const T& value() const& { return *std::get_if<T>(&content_); }
  T&& value() && { return std::move(*std::get_if<T>(&content_)); }
  const Error& error() const { return *std::get_if<Error>(&content_); }

 private:
  std::variant<T, Error> content_;
};

/// Success, or the reason of failure.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit by design

  bool ok() const { return !error_.has_value(); }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace oncard
