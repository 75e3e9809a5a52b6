#include "runtime/host/host_refusals.h"

#include <cstdlib>
#include <string_view>
#include <utility>

#include "base/split.h"
#include "runtime/host/host_scenario.h"

namespace oncard::runtime {
namespace {

CardWarnings SilentWarningsOfProcess() {
  const char* setting = std::getenv("ONCARD_SILENT");
  CardWarnings silent;
  for (const std::string_view name : Split(setting == nullptr ? "" : setting, ',')) {
    ReadSilentWarning(name, &silent);
  }
  return silent;
}

}  // namespace

RefusalReport RefusalReportOfProcess() {
  const char* setting = std::getenv("ONCARD_REFUSALS");
  const std::string_view wanted = setting == nullptr ? "" : setting;
  if (wanted == "strict") return RefusalReport::kStrict;
  return wanted == "warn" ? RefusalReport::kWarn : RefusalReport::kNothing;
}

HostRefusals& HostRefusals::OfProcess() {
  // Never destroyed: other threads of the host may still make calls while the process exits.
  static HostRefusals& refusals = *new HostRefusals;
  return refusals;
}

void HostRefusals::Add(const LoggedCall& call) {
  const std::lock_guard lock(mutex_);
  std::vector<Reason>& reasons = known_[{call.card, call.command.number, call.code}];
  if (Refusal* known = Find(call, &reasons)) {
    ++known->count;
    return;
  }
  const bool others = reasons.size() == kRefusalReasons;
  reasons.push_back({others ? std::string() : call.reason.en, list_.size()});
  const auto text = [&](Language language) {
    return FormatCallAndCode(call.command, call.arguments, call.code, call.reason, language);
  };
  Message what = others ? MakeMessage("{0} = {1} for other reasons", "{0} = {1}，其他原因",
                                      call.command.name, call.code)
                        : Message{text(Language::kEnglish), text(Language::kChinese)};
  list_.push_back({call.card, std::move(what), call.time_us, 1});
}

HostRefusals::Refusal* HostRefusals::Find(const LoggedCall& call, std::vector<Reason>* reasons) {
  for (const Reason& reason : *reasons) {
    if (reason.text == call.reason.en) return &list_[reason.position];
  }
  return reasons->size() > kRefusalReasons ? &list_[reasons->back().position] : nullptr;
}

void HostRefusals::AddProgram(int card, const std::vector<RefusedCommand>& refused) {
  const std::lock_guard lock(mutex_);
  for (const RefusedCommand& command : refused) {
    of_programs_.push_back(OfCard(card, DescribeRefusedCommand(command, {})));
  }
}

void HostRefusals::AddFindings(int card, const std::vector<CardFinding>& findings) {
  const std::lock_guard lock(mutex_);
  const CardWarnings silent = SilentWarningsOfProcess();
  for (const CardFinding& finding : findings) {
    if (silent.Has(finding.warning)) continue;
    of_programs_.push_back(OfCard(card, DescribeFinding(finding, {})));
  }
}

std::vector<Message> HostRefusals::Describe() {
  const std::lock_guard lock(mutex_);
  std::vector<Message> texts;
  for (const Refusal& refusal : list_) {
    const Message when = DescribeOccurrences(refusal.first_us, refusal.count);
    texts.push_back(OfCard(refusal.card, {refusal.call.en + when.en, refusal.call.zh + when.zh}));
  }
  texts.insert(texts.end(), of_programs_.begin(), of_programs_.end());
  return texts;
}

}  // namespace oncard::runtime
