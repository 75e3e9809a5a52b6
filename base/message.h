// User-facing text in English and Chinese. Libraries never choose a language: they build a
// Message that holds both, and the program that prints picks one.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace oncard {

enum class Language { kEnglish, kChinese };

/// A text in both languages, lower case, without a full stop.
struct Message {
  std::string en;
  std::string zh;

  const std::string& In(Language language) const {
    return language == Language::kChinese ? zh : en;
  }
};

/// Formats both languages with the same arguments (fmt syntax; number the arguments when the
/// word order differs).
template <typename... Args>
Message MakeMessage(std::string_view en, std::string_view zh, const Args&... args) {
  return {fmt::format(fmt::runtime(en), args...), fmt::format(fmt::runtime(zh), args...)};
}

/// The language selected by ONCARD_LANG, LC_ALL, LC_MESSAGES and LANG (in this order): Chinese when
/// the first one that is set and not empty starts with "zh", English otherwise.
Language LanguageFromEnvironment();

}  // namespace oncard
