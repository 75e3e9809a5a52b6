// The keys that a scenario or `oncard exec --keys` presses while a host program runs. The text of
// ONCARD_KEYS is a list of moments and characters:
//
//   500:a,1000:q      a at 500 ms, q at 1000 ms after the start
//   2000:\r           escapes: \r \n \t \e (escape) \\ \, and \xNN
//
// Tested by tests/runtime/key_script_test.cc.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace oncard::runtime {

/// One or several keys pressed at an instant.
struct KeyPress {
  int64_t at_us = 0;  ///< since the start of the host
  std::string text;
  bool operator==(const KeyPress&) const = default;
};

/// Reads the form of ONCARD_KEYS; an empty text has no keys. The result is in order of time.
Result<std::vector<KeyPress>> ParseKeyScript(std::string_view text);

}  // namespace oncard::runtime
