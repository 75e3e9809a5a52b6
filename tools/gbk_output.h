// Converts the GBK output of a host to UTF-8, piece by piece. Tested by
// tests/tools/exec_command_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace oncard::tools {

/// Converts a text in pieces, which may end within a character. Bytes that are not GBK become
/// U+FFFD.
class GbkText {
 public:
  GbkText();
  GbkText(const GbkText&) = delete;
  GbkText& operator=(const GbkText&) = delete;
  ~GbkText();

  /// Returns the characters that are complete.
  std::string Convert(std::string_view piece);

 private:
  void* converter_;
  char lead_ = 0;  // the first byte of a character whose second byte is missing; 0 for none
};

/// Copies the converted data from one descriptor to another until the end. Fails if it cannot be
/// written.
Result<void> RelayGbk(int from, int to);

}  // namespace oncard::tools
