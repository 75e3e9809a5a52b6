#include "base/path_bytes.h"

#include <windows.h>

#include <climits>

namespace oncard {
namespace {

/// Longer names are cut: no file has one.
int LengthOf(size_t size) { return static_cast<int>(size < INT_MAX ? size : INT_MAX); }

}  // namespace

std::filesystem::path PathOf(const std::string& name) {
  const int length = LengthOf(name.size());
  std::wstring wide(name.size(), L'\0');  // no character is longer in UTF-16
  const int written = ::MultiByteToWideChar(CP_ACP, 0, name.data(), length, wide.data(), length);
  wide.resize(static_cast<size_t>(written));
  return wide;
}

std::string FileNameOf(const std::filesystem::path& path) {
  const std::wstring wide = path.generic_wstring();
  constexpr size_t kBytesMax = 4;  // of a character
  std::string name(kBytesMax * wide.size(), '\0');
  const int written = ::WideCharToMultiByte(CP_ACP, 0, wide.data(), LengthOf(wide.size()),
                                            name.data(), LengthOf(name.size()), nullptr, nullptr);
  name.resize(static_cast<size_t>(written));
  return name;
}

}  // namespace oncard
