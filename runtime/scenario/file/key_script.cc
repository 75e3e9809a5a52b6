#include "runtime/scenario/file/key_script.h"

#include <algorithm>
#include <optional>

#include "base/milliseconds.h"
#include "base/number.h"
#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {
namespace {

/// Removes the first character or escape sequence of a text; empty for an unknown escape sequence.
std::optional<char> TakeCharacter(std::string_view* text) {
  const char first = text->front();
  text->remove_prefix(1);
  if (first != '\\') return first;
  if (text->empty()) return std::nullopt;
  const char name = text->front();
  text->remove_prefix(1);
  switch (name) {
    case 'r':
      return '\r';
    case 'n':
      return '\n';
    case 't':
      return '\t';
    case 'e':
      return '\x1b';
    case '\\':
    case ',':
      return name;
    case 'x':
      break;
    default:
      return std::nullopt;
  }
  if (text->size() < 2) return std::nullopt;
  const auto code = ReadWhole<uint8_t>(text->substr(0, 2), 16);
  if (!code) return std::nullopt;
  text->remove_prefix(2);
  return static_cast<char>(*code);
}

/// Removes `MS:TEXT` up to the comma or the end; empty if the text has another form.
std::optional<KeyPress> TakePress(std::string_view* text) {
  const size_t colon = text->find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto at_ms = ReadNumber(text->substr(0, colon));
  if (!at_ms || *at_ms < 0 || *at_ms > static_cast<double>(kTimeMsMax)) return std::nullopt;
  text->remove_prefix(colon + 1);
  KeyPress press;
  press.at_us = FromMs(*at_ms);
  while (!text->empty() && !text->starts_with(',')) {
    const auto character = TakeCharacter(text);
    if (!character) return std::nullopt;
    press.text += *character;
  }
  if (press.text.empty()) return std::nullopt;
  return press;
}

}  // namespace

Result<std::vector<KeyPress>> ParseKeyScript(std::string_view text) {
  std::vector<KeyPress> presses;
  std::string_view rest = text;
  while (!rest.empty()) {
    auto press = TakePress(&rest);
    const bool more = rest.starts_with(',');
    if (more) rest.remove_prefix(1);
    if (!press || (more && rest.empty()) || (!more && !rest.empty())) {
      return MakeError(1,
                       "the keys are '{}', expected MS:TEXT, or several of them with commas, as in "
                       "500:a,1000:q",
                       "按键为 '{}'，应为 毫秒:字符，多个之间用逗号分隔，如 500:a,1000:q", text);
    }
    presses.push_back(std::move(*press));
  }
  std::stable_sort(presses.begin(), presses.end(),
                   [](const KeyPress& a, const KeyPress& b) { return a.at_us < b.at_us; });
  return presses;
}

}  // namespace oncard::runtime
