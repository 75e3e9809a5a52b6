#include "gtcalls/gts/mram_text.h"

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <vector>

#include "base/number.h"
#include "base/trim.h"

namespace oncard::gtcalls::gts {
namespace {

constexpr std::string_view kHead = "oncard-mram 1";

struct MramWord {
  int address = 0;
  int16_t value = 0;
};

/// Reads `address value`.
std::optional<MramWord> ReadMramWord(std::string_view line) {
  const size_t blank = line.find_first_of(" \t");
  if (blank == std::string_view::npos) return std::nullopt;
  const auto address = ReadWhole<int>(line.substr(0, blank));
  const auto value = ReadWhole<int16_t>(Trim(line.substr(blank)));
  if (!address || *address < 0 || *address >= kMramWords || !value) return std::nullopt;
  return MramWord{*address, *value};
}

}  // namespace

std::string FormatMram(const Mram& mram) {
  std::string text(kHead);
  text += '\n';
  for (int address = 0; address < kMramWords; ++address) {
    const int16_t value = mram.Kept(address);
    if (value != 0) fmt::format_to(std::back_inserter(text), "{} {}\n", address, value);
  }
  return text;
}

Result<Mram> ParseMram(std::string_view text, std::string_view path) {
  Mram mram;
  std::vector<bool> given(kMramWords);
  for (int number = 1; number == 1 || !text.empty(); ++number) {
    const size_t end = text.find('\n');
    const std::string_view line = Trim(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (number == 1) {
      if (line == kHead) continue;
      return MakeError(1, "{0}: this is no memory of a card: the first line must be '{1}'",
                       "{0}：这不是控制卡存储器的文件：首行应为“{1}”", path, kHead);
    }
    if (line.empty()) continue;
    const auto word = ReadMramWord(line);
    if (!word) {
      return MakeError(
          1, "{0}:{1}: expected an address from 0 to {2} and a value from -32768 to 32767",
          "{0}:{1}：应为地址（0 到 {2}）与值（-32768 到 32767）", path, number, kMramWords - 1);
    }
    if (given[static_cast<size_t>(word->address)]) {
      return MakeError(1, "{0}:{1}: address {2} already has a value", "{0}:{1}：地址 {2} 已有值",
                       path, number, word->address);
    }
    given[static_cast<size_t>(word->address)] = true;
    mram.Keep(word->address, word->value);
  }
  return mram;
}

}  // namespace oncard::gtcalls::gts
