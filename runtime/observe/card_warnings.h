// The names of the supervisor's warnings: a row for each in card_warnings.def. Tested by
// tests/runtime/supervisor_test.cc.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/message.h"

namespace oncard::runtime {

enum class CardWarning : uint8_t {
#define CARD_WARNING(id, ...) id,
#include "runtime/observe/card_warnings.def"
};

struct CardWarningInfo {
  CardWarning warning;
  std::string_view name;  ///< the word in brackets, such as `drive-off`
  // What is wrong, and what to do about it, in both languages.
  std::string_view en;
  std::string_view zh;
  std::string_view why_en;
  std::string_view why_zh;
};

/// All rows, in the order of the enumeration.
std::span<const CardWarningInfo> CardWarningTable();
const CardWarningInfo& InfoOf(CardWarning warning);
/// The row of a name, or nullptr.
const CardWarningInfo* FindCardWarning(std::string_view name);

/// A set of warnings.
class CardWarnings {
 public:
  void Add(CardWarning warning) { bits_ |= BitOf(warning); }
  bool Has(CardWarning warning) const { return (bits_ & BitOf(warning)) != 0; }

 private:
  static uint32_t BitOf(CardWarning warning) {
    return uint32_t{1} << static_cast<uint32_t>(warning);
  }

  uint32_t bits_ = 0;
};

/// Adds the warning of `no-NAME` to the set unless that is nullptr. False for anything else.
bool ReadSilentWarning(std::string_view text, CardWarnings* silent);

}  // namespace oncard::runtime
