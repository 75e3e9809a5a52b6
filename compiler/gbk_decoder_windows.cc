#include <windows.h>

#include "compiler/gbk_decoder.h"

namespace oncard::compiler {
namespace {

constexpr UINT kGbk = 936;

/// Where the code page has room for characters that users define. GBK has none there.
bool IsPrivate(wchar_t code) { return code >= 0xE000 && code <= 0xF8FF; }

}  // namespace

GbkDecoder::GbkDecoder() : handle_(nullptr) {}

GbkDecoder::~GbkDecoder() = default;

bool GbkDecoder::Available() const { return ::IsValidCodePage(kGbk) != 0; }

std::optional<char32_t> GbkDecoder::Decode(char lead, char trail) {
  const char input[2] = {lead, trail};
  wchar_t output[2];
  const int size = ::MultiByteToWideChar(kGbk, MB_ERR_INVALID_CHARS, input, 2, output, 2);
  if (size != 1 || IsPrivate(output[0])) return std::nullopt;
  return output[0];
}

}  // namespace oncard::compiler
