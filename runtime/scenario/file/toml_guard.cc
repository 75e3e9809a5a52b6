// Tested by tests/runtime/toml_guard_test.cc.
#include "runtime/scenario/file/toml_guard.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/files.h"
#include "base/limits.h"

namespace oncard::runtime {
namespace {

constexpr char kArray = '[';
constexpr char kTable = '{';

class TomlScanner {
 public:
  explicit TomlScanner(std::string_view text) : text_(text) {}

  std::optional<TomlRefusal> Run() {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
    while (at_ < text_.size()) {
      if (auto message = Step()) return Refusal(std::move(*message));
    }
    return std::nullopt;
  }

 private:
  /// Skips one character, string or comment.
  std::optional<Message> Step() {
    const char c = text_[at_];
    switch (c) {
      case '#':
        at_ = std::min(text_.find('\n', at_), text_.size());
        return std::nullopt;
      case '"':
      case '\'':
        SkipString(c);
        value_begins_ = false;
        return std::nullopt;
      case ' ':
      case '\t':
      case '\r':
        break;
      case '.':
        if (++parts_ > kTomlKeyPartMax) {
          return MakeMessage("a key has at most {0} parts between dots",
                             "键中以点分隔的部分最多 {0} 个", kTomlKeyPartMax);
        }
        break;
      case '[':
      case '{':
        parts_ = 1;
        if (brackets_.empty() && AddKey()) return TooManyKeys();
        // Values are only in the brackets of an array, not in those of a table or its header.
        value_begins_ = value_begins_ && c == '[';
        brackets_ += value_begins_ ? kArray : kTable;
        if (brackets_.size() > kTomlDepthMax) {
          return MakeMessage("brackets are nested at most {0} deep", "括号嵌套最多 {0} 层",
                             kTomlDepthMax);
        }
        break;
      case ']':
      case '}':
        parts_ = 1;
        value_begins_ = false;
        if (!brackets_.empty()) brackets_.pop_back();
        break;
      case '=':
        parts_ = 1;
        if (AddKey()) return TooManyKeys();
        if (value_begins_ && FindNotAscii()) return NotAscii();
        value_begins_ = true;
        break;
      case ',':
      case '\n':
        parts_ = 1;
        value_begins_ = brackets_.ends_with(kArray);
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x80) return NotAscii();
        if (value_begins_ && FindNotAscii()) return NotAscii();
        value_begins_ = false;
    }
    ++at_;
    return std::nullopt;
  }

  /// Moves to the first non-ASCII byte of the bare value that begins here; false if there is none.
  /// The parser reads a value up to here as one word, even with quotes: `0"x"`.
  bool FindNotAscii() {
    const size_t end = std::min(text_.find_first_of(" \t\r\n,]}#", at_), text_.size());
    for (size_t i = at_; i < end; ++i) {
      if (static_cast<unsigned char>(text_[i]) < 0x80) continue;
      at_ = i;
      return true;
    }
    return false;
  }

  void SkipString(char quote) {
    const std::string_view three = quote == '"' ? R"(""")" : "'''";
    const bool multi_line = text_.substr(at_).starts_with(three);
    at_ += multi_line ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\\' && quote == '"') {
        at_ = std::min(at_ + 2, text_.size());
      } else if (multi_line && text_.substr(at_).starts_with(three)) {
        at_ += 3;
        // Up to two quotes before the closing ones belong to the string.
        for (int i = 0; i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
        return;
      } else if (!multi_line && (c == quote || c == '\n')) {
        // The parser reports a string that is not closed.
        if (c == quote) ++at_;
        return;
      } else {
        ++at_;
      }
    }
  }

  bool AddKey() { return ++keys_ > kTomlKeyMax; }

  static Message NotAscii() {
    return {"non-ASCII characters are allowed only in strings and comments; put the key in quotes",
            "ASCII 以外的字符只能出现在字符串和注释中；请给键加上引号"};
  }
  static Message TooManyKeys() {
    return MakeMessage("a file has at most {0} keys and tables", "一个文件最多 {0} 个键和表",
                       kTomlKeyMax);
  }

  TomlRefusal Refusal(Message message) const {
    const std::string_view before = text_.substr(0, at_);
    const size_t line_start =
        before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return {static_cast<uint32_t>(1 + std::count(before.begin(), before.end(), '\n')),
            static_cast<uint32_t>(1 + at_ - line_start), std::move(message)};
  }

  std::string_view text_;
  size_t at_ = 0;
  std::string brackets_;       ///< the open ones: kArray or kTable
  bool value_begins_ = false;  ///< the next token begins a value
  size_t parts_ = 1;
  size_t keys_ = 0;
};

}  // namespace

std::optional<TomlRefusal> CheckToml(std::string_view text) { return TomlScanner(text).Run(); }

}  // namespace oncard::runtime
