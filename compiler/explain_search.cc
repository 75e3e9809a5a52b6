#include "compiler/explain_search.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/nearest.h"
#include "base/number.h"
#include "compiler/diagnostic.h"
#include "compiler/explain.h"

namespace oncard::compiler {
namespace {

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c | 0x20);
  }
  return lower;
}

bool InWord(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }

std::vector<std::string_view> WordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

// True if a word of the text begins with `begin`. If `begin` does not start with a letter or digit,
// it may be anywhere in the text.
bool HasWord(std::string_view text, std::string_view begin) {
  for (size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at + 1)) {
    if (at == 0 || !InWord(begin.front()) || !InWord(text[at - 1])) return true;
  }
  return false;
}

bool HasAllWords(std::string_view text, const std::vector<std::string_view>& words) {
  return std::all_of(words.begin(), words.end(),
                     [text](std::string_view word) { return HasWord(text, word); });
}

// `MP000 to MP050, MP100 to MP137`.
Message DescribeCodes() {
  Message all;
  const auto table = DiagnosticTable();
  for (size_t first = 0; first < table.size();) {
    size_t last = first;
    while (last + 1 < table.size() && table[last + 1].code == table[last].code + 1) ++last;
    const std::string from = DiagnosticName(table[first].code);
    const std::string to = DiagnosticName(table[last].code);
    all.en += fmt::format("{}{} to {}", first > 0 ? ", " : "", from, to);
    all.zh += fmt::format("{}{} 至 {}", first > 0 ? "、" : "", from, to);
    first = last + 1;
  }
  return all;
}

}  // namespace

std::optional<int> ParseDiagnosticCode(std::string_view text) {
  if (text.size() > 2 && (text[0] | 0x20) == 'm' && (text[1] | 0x20) == 'p') text.remove_prefix(2);
  const std::optional<int> code = ReadWhole<int>(text);
  return code && *code >= 0 ? code : std::nullopt;
}

std::vector<int> SearchDiagnostics(std::string_view text) {
  if (const std::optional<int> code = ParseDiagnosticCode(text)) {
    return FindDiagnostic(*code) != nullptr ? std::vector<int>{*code} : std::vector<int>{};
  }
  const std::string lower = Lower(text);
  const std::vector<std::string_view> words = WordsOf(lower);
  if (words.empty()) return {};
  const std::string slug = fmt::format("{}", fmt::join(words, "-"));
  std::vector<int> found;
  std::vector<int> explained;
  for (const DiagnosticInfo& info : DiagnosticTable()) {
    if (info.slug == slug) return {info.code};
    const Message message = MessagePattern(info.code);
    std::string all = Lower(fmt::format("{}\n{}\n{}", info.slug, message.en, message.zh));
    if (HasAllWords(all, words)) {
      found.push_back(info.code);
      continue;
    }
    const Explanation* page = FindExplanation(info.code);
    all += Lower(fmt::format("\n{}\n{}", page->en, page->zh));
    if (HasAllWords(all, words)) explained.push_back(info.code);
  }
  found.insert(found.end(), explained.begin(), explained.end());
  return found;
}

Message AdviseSearch(std::string_view text) {
  if (ParseDiagnosticCode(text)) {
    const Message codes = DescribeCodes();
    return MakeMessage(
        "no diagnostic has the number {0}: there are {1}; 'oncard explain' lists them",
        "没有编号为 {0} 的诊断：编号为 {2}；“oncard explain”列出全部", text, codes.en, codes.zh);
  }
  const std::string lower = Lower(text);
  Nearest nearest(lower);
  for (const DiagnosticInfo& info : DiagnosticTable()) nearest.Add(info.slug);
  if (!nearest.best().empty()) {
    return MakeMessage("no diagnostic is named '{0}'; did you mean '{1}'?",
                       "没有名为“{0}”的诊断；是否为“{1}”？", text, nearest.best());
  }
  return MakeMessage(
      "no diagnostic has '{0}' in its texts: give a number, the name in the brackets of a message, "
      "or a word such as goto; 'oncard explain' lists all",
      "没有诊断的文字中含有“{0}”：请给出编号、消息方括号中的名称，或 goto 之类的词；“oncard "
      "explain”列出全部",
      text);
}

}  // namespace oncard::compiler
