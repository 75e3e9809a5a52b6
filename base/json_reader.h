// Reads JSON that others have written. Thread-safe. Tested by tests/base/json_reader_test.cc.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace oncard {

/// Maximum number of keys of one object. An ordered document looks at all keys of an object for
/// each that is added, so that the time for a larger one would grow with the square of its size.
inline constexpr size_t kJsonKeysMax = 1000;

/// The document; discarded (`is_discarded()`) if the text is not JSON, or if an object in it has
/// more keys than kJsonKeysMax.
nlohmann::ordered_json ReadJson(std::string_view text);

}  // namespace oncard
