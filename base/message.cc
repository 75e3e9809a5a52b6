#include "base/message.h"

#include <cstdlib>

namespace oncard {

Language LanguageFromEnvironment() {
  for (const char* name : {"ONCARD_LANG", "LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') {
      return std::string_view(value).substr(0, 2) == "zh" ? Language::kChinese : Language::kEnglish;
    }
  }
  return Language::kEnglish;
}

}  // namespace oncard
