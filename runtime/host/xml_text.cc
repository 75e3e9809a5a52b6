#include "runtime/host/xml_text.h"

#include <cstdint>

#include "base/limits.h"
#include "base/utf8.h"

namespace oncard::runtime {
namespace {

constexpr std::string_view kLittleEndianMark = "\xFF\xFE";
constexpr std::string_view kBigEndianMark = "\xFE\xFF";

constexpr std::string_view kComment = "<!--";
constexpr std::string_view kCharacters = "<![CDATA[";
constexpr std::string_view kInstruction = "<?";
constexpr std::string_view kDocumentType = "<!DOCTYPE";
constexpr std::string_view kBlanks = " \t\r\n";
/// What ends the name of an element for the library: it takes < and quotes for letters.
constexpr std::string_view kNameEnds = " \t\r\n/>?";

/// Follows the library through markup, from one < to the next. What the library refuses ends it, so
/// that it does not matter how this goes on.
class XmlScanner {
 public:
  explicit XmlScanner(std::string_view text) : text_(text) {}

  std::optional<XmlRefusal> Run() {
    if (const size_t nul = text_.find('\0'); nul != std::string_view::npos) {
      return XmlRefusal{nul, {"not XML: it contains a NUL", "不符合 XML 语法：含有 NUL"}};
    }
    for (at_ = text_.find('<'); at_ < text_.size(); at_ = text_.find('<', at_)) {
      const size_t begin = at_;
      Skip();
      if (depth_ > kXmlDepthMax) {
        return XmlRefusal{begin, MakeMessage("elements are nested at most {0} deep",
                                             "元素嵌套最多 {0} 层", kXmlDepthMax)};
      }
    }
    return std::nullopt;
  }

 private:
  /// Skips a comment, a tag or other markup.
  void Skip() {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with(kComment)) {
      SkipBehind(at_ + kComment.size(), "-->");
    } else if (rest.starts_with(kCharacters)) {
      SkipBehind(at_ + kCharacters.size(), "]]>");
    } else if (rest.starts_with(kInstruction)) {
      SkipBehind(at_ + kInstruction.size(), "?>");
    } else if (IsDocumentType(rest)) {
      SkipDocumentType();
    } else if (rest.starts_with("<!")) {
      SkipBehind(at_, ">");
    } else if (rest.starts_with("</")) {
      if (depth_ > 0) --depth_;
      SkipBehind(at_, ">");
    } else {
      SkipStartTag();
    }
  }

  /// To behind the next `end` at or behind `begin`.
  void SkipBehind(size_t begin, std::string_view end) {
    const size_t found = text_.find(end, begin);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }

  /// Only a blank makes it one: <!DOCTYPE[> is other markup, and its bracket means nothing.
  static bool IsDocumentType(std::string_view markup) {
    return markup.starts_with(kDocumentType) && markup.size() > kDocumentType.size() &&
           kBlanks.find(markup[kDocumentType.size()]) != std::string_view::npos;
  }

  /// It has declarations of its own in brackets.
  void SkipDocumentType() {
    int brackets = 0;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '[') ++brackets;
      if (c == ']' && brackets > 0) --brackets;
      if (c == '>' && brackets == 0) return;
    }
  }

  /// The value of an attribute, between quotes behind a =, may contain what ends a tag.
  void SkipStartTag() {
    ++depth_;
    at_ = text_.find_first_of(kNameEnds, at_ + 1);
    while (at_ < text_.size()) {
      at_ = text_.find_first_of("=>", at_);
      if (at_ >= text_.size()) return;
      if (text_[at_] == '>') {
        if (text_[at_ - 1] == '/') --depth_;
        return;
      }
      at_ = text_.find_first_not_of(kBlanks, at_ + 1);
      if (at_ < text_.size()) SkipBehind(at_ + 1, text_.substr(at_, 1));
    }
  }

  const std::string_view text_;
  size_t at_ = 0;
  size_t depth_ = 0;
};

}  // namespace

bool IsUtf16(std::string_view text) {
  return text.starts_with(kLittleEndianMark) || text.starts_with(kBigEndianMark);
}

std::string Utf8Of(std::string_view utf16) {
  const bool big = utf16.starts_with(kBigEndianMark);
  std::string text;
  for (size_t i = kBigEndianMark.size(); i + 1 < utf16.size(); i += 2) {
    const char32_t first = static_cast<uint8_t>(utf16[i]);
    const char32_t second = static_cast<uint8_t>(utf16[i + 1]);
    const char32_t code = big ? first << 8 | second : second << 8 | first;
    const bool is_half = code >= 0xD800 && code <= 0xDFFF;
    AppendUtf8(text, is_half ? U'\uFFFD' : code);
  }
  return text;
}

std::optional<XmlRefusal> CheckXml(std::string_view text) { return XmlScanner(text).Run(); }

}  // namespace oncard::runtime
