#include "runtime/observe/card_warnings.h"

#include <algorithm>
#include <iterator>

namespace oncard::runtime {
namespace {

constexpr CardWarningInfo kCardWarnings[] = {
#define CARD_WARNING(id, name, en, zh, why_en, why_zh) \
  {CardWarning::id, name, en, zh, why_en, why_zh},
#include "runtime/observe/card_warnings.def"
};

}  // namespace

std::span<const CardWarningInfo> CardWarningTable() { return kCardWarnings; }

const CardWarningInfo& InfoOf(CardWarning warning) {
  return kCardWarnings[static_cast<size_t>(warning)];
}

const CardWarningInfo* FindCardWarning(std::string_view name) {
  const auto* row = std::ranges::find(kCardWarnings, name, &CardWarningInfo::name);
  return row == std::end(kCardWarnings) ? nullptr : row;
}

bool ReadSilentWarning(std::string_view text, CardWarnings* silent) {
  constexpr std::string_view kNo = "no-";
  if (!text.starts_with(kNo)) return false;
  const CardWarningInfo* info = FindCardWarning(text.substr(kNo.size()));
  if (info == nullptr) return false;
  if (silent != nullptr) silent->Add(info->warning);
  return true;
}

}  // namespace oncard::runtime
