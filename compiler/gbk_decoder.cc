#include "compiler/gbk_decoder.h"

#include <iconv.h>

#include <cstddef>
#include <cstdint>

namespace oncard::compiler {

GbkDecoder::GbkDecoder() : handle_(::iconv_open("UTF-32LE", "GBK")) {}

GbkDecoder::~GbkDecoder() {
  if (Available()) ::iconv_close(handle_);
}

// iconv_open() reports an error by the pointer value -1.
bool GbkDecoder::Available() const { return reinterpret_cast<intptr_t>(handle_) != -1; }

std::optional<char32_t> GbkDecoder::Decode(char lead, char trail) {
  if (!Available()) return std::nullopt;
  char input[2] = {lead, trail};
  uint8_t output[4] = {};
  char* from = input;
  char* to = reinterpret_cast<char*>(output);
  size_t from_left = sizeof input;
  size_t to_left = sizeof output;
  ::iconv(handle_, nullptr, nullptr, nullptr, nullptr);
  if (::iconv(handle_, &from, &from_left, &to, &to_left) == static_cast<size_t>(-1) ||
      from_left != 0 || to_left != 0) {
    return std::nullopt;
  }
  char32_t code = 0;
  for (size_t i = 0; i < sizeof output; ++i) code |= static_cast<char32_t>(output[i]) << (8 * i);
  return code;
}

}  // namespace oncard::compiler
