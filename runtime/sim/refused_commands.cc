#include "runtime/sim/refused_commands.h"

#include "runtime/sim/call_text.h"

namespace oncard::runtime {

void RefusedCommands::Add(const gtcalls::Call& call, int16_t code, int64_t now_us) {
  const vm::Machine& machine = call.card.machine;
  const int index = machine.thread(call.caller).function;
  const int instruction = machine.thread(call.caller).pc;
  const auto [entry, added] =
      known_.try_emplace({machine.image()->hash, index, instruction, code}, list_.size());
  if (!added) {
    ++list_[entry->second].count;
    return;
  }
  const auto text = [&](Language language) {
    return FormatCallAndCode(call.command, call.arguments, code, call.reason, language);
  };
  list_.push_back({.place = PlaceOf(call),
                   .call = {text(Language::kEnglish), text(Language::kChinese)},
                   .code = code,
                   .first_us = now_us,
                   .count = 1});
}

void RefusedCommands::Include(const RefusedCommands& other) {
  IncludeFound(other.known_, other.list_, &known_, &list_);
}

Message DescribeRefusedPlace(const RefusedCommand& refused, const std::string& program_path) {
  Message text = DescribePlace(refused.place, program_path);
  text.en += refused.call.en;
  text.zh += refused.call.zh;
  return text;
}

Message DescribeRefusedCommand(const RefusedCommand& refused, const std::string& program_path) {
  const Message text = DescribeRefusedPlace(refused, program_path);
  const Message when = DescribeOccurrences(refused.first_us, refused.count);
  return {text.en + when.en, text.zh + when.zh};
}

}  // namespace oncard::runtime
