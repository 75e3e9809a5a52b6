// What a host writes in GBK as UTF-8, piece by piece, for terminals of today.
// Tested by tests/tools/exec_command_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace oncard::tools {

/// Converts a text that comes in pieces, which may end within a character. Bytes that are no GBK
/// show as U+FFFD.
class GbkText {
 public:
  GbkText();
  GbkText(const GbkText&) = delete;
  GbkText& operator=(const GbkText&) = delete;
  ~GbkText();

  /// The characters that are complete by now.
  std::string Convert(std::string_view piece);

 private:
  void* converter_;
  char lead_ = 0;  // the first byte of a character whose second has not come; 0 for none
};

/// Copies what comes from one descriptor to another until its end. Fails when it cannot be written.
Result<void> RelayGbk(int from, int to);

}  // namespace oncard::tools
