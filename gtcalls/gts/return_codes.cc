#include "gtcalls/gts/return_codes.h"

#include <fmt/core.h>

#include <string_view>

namespace oncard::gtcalls::gts {
namespace {

struct ReturnCodeRow {
  int code;
  std::string_view from_en, from_zh;
  std::string_view meaning_en, meaning_zh;
  std::string_view advice_en, advice_zh;
};

constexpr ReturnCodeRow kReturnCodes[] = {
#define RETURN_CODE(code, from, from_zh, meaning, meaning_zh, advice, advice_zh) \
  {code, from, from_zh, meaning, meaning_zh, advice, advice_zh},
#include "gtcalls/gts/return_codes.def"
};

std::string Paragraph(std::string_view from, std::string_view meaning, std::string_view advice) {
  std::string text = fmt::format("\n{}\n    {}\n", from, meaning);
  if (!advice.empty()) text += fmt::format("    {}\n", advice);
  return text;
}

}  // namespace

std::optional<Message> ReturnCodePage(int code) {
  Message page;
  for (const ReturnCodeRow& row : kReturnCodes) {
    if (row.code != code) continue;
    page.en += Paragraph(row.from_en, row.meaning_en, row.advice_en);
    page.zh += Paragraph(row.from_zh, row.meaning_zh, row.advice_zh);
  }
  if (page.en.empty()) return std::nullopt;
  page.en.insert(0, fmt::format("return code {}\n", code));
  page.zh.insert(0, fmt::format("返回值 {}\n", code));
  return page;
}

}  // namespace oncard::gtcalls::gts
