#include "tools/gbk_output.h"

#include <iconv.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace oncard::tools {
namespace {

constexpr std::string_view kReplacement = "\uFFFD";

bool IsAscii(char byte) { return static_cast<uint8_t>(byte) < 0x80; }

void AppendCharacter(iconv_t converter, char lead, char trail, std::string* out) {
  std::array<char, 2> in = {lead, trail};
  std::array<char, 8> buffer;
  char* from = in.data();
  char* to = buffer.data();
  size_t in_left = in.size();
  size_t out_left = buffer.size();
  if (::iconv(converter, &from, &in_left, &to, &out_left) == static_cast<size_t>(-1)) {
    ::iconv(converter, nullptr, nullptr, nullptr, nullptr);
    *out += kReplacement;
    if (IsAscii(trail)) *out += trail;  // the text continues after an invalid character
    return;
  }
  out->append(buffer.data(), buffer.size() - out_left);
}

}  // namespace

GbkText::GbkText() : converter_(::iconv_open("UTF-8", "GBK")) {}

GbkText::~GbkText() {
  if (reinterpret_cast<intptr_t>(converter_) != -1) ::iconv_close(converter_);  // -1: none
}

std::string GbkText::Convert(std::string_view piece) {
  std::string text;
  for (const char byte : piece) {
    if (lead_ != 0) {
      AppendCharacter(converter_, lead_, byte, &text);
      lead_ = 0;
    } else if (IsAscii(byte)) {
      text += byte;
    } else {
      lead_ = byte;
    }
  }
  return text;
}

Result<void> RelayGbk(int from, int to) {
  GbkText converter;
  std::array<char, 4096> buffer;
  while (true) {
    const ssize_t size = ::read(from, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return {};
    const std::string text = converter.Convert({buffer.data(), static_cast<size_t>(size)});
    for (size_t written = 0; written < text.size();) {
      const ssize_t count = ::write(to, text.data() + written, text.size() - written);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) {
        return MakeError(1, "cannot write the output of the host: {}", "无法写出主机程序的输出：{}",
                         std::strerror(errno));
      }
      written += static_cast<size_t>(count);
    }
  }
}

}  // namespace oncard::tools
