// The characters of GBK, as the system converts them: gbk_decoder.cc by iconv(), which Linux and
// WebAssembly have, gbk_decoder_windows.cc on Windows.
#pragma once

#include <optional>

namespace oncard::compiler {

class GbkDecoder {
 public:
  GbkDecoder();
  GbkDecoder(const GbkDecoder&) = delete;
  GbkDecoder& operator=(const GbkDecoder&) = delete;
  ~GbkDecoder();

  /// False if the system knows no GBK; then there is no character.
  bool Available() const;
  /// The character of two bytes; empty if there is none.
  std::optional<char32_t> Decode(char lead, char trail);

 private:
  void* handle_;
};

}  // namespace oncard::compiler
