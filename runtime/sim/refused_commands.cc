#include "runtime/sim/refused_commands.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/milliseconds.h"
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
  const vm::Function& function = machine.image()->object.functions[static_cast<size_t>(index)];
  const auto line = static_cast<size_t>(instruction);
  const auto text = [&](Language language) {
    return FormatCallAndCode(call.command, call.arguments, code, call.reason, language);
  };
  list_.push_back({.thread = call.caller,
                   .function = function.name,
                   .file = function.file,
                   .line = line < function.lines.size() ? function.lines[line] : 0,
                   .call = {text(Language::kEnglish), text(Language::kChinese)},
                   .code = code,
                   .first_us = now_us,
                   .count = 1});
}

Message DescribeRefusedPlace(const RefusedCommand& refused, const std::string& program_path) {
  const std::filesystem::path folder = std::filesystem::path(program_path).parent_path();
  const std::string place = fmt::format("{}:{}", (folder / refused.file).string(), refused.line);
  Message text = MakeMessage("{0}: thread {1} {2}: ", "{0}：线程 {1} {2}：", place, refused.thread,
                             refused.function);
  text.en += refused.call.en;
  text.zh += refused.call.zh;
  return text;
}

Message DescribeRefusedCommand(const RefusedCommand& refused, const std::string& program_path) {
  const double at_ms = ToMs(refused.first_us);
  const Message text = DescribeRefusedPlace(refused, program_path);
  const Message when = refused.count == 1
                           ? MakeMessage(" (at {0} ms)", "（{0} ms 时）", at_ms)
                           : MakeMessage(" (first at {0} ms, {1} times)",
                                         "（首次在 {0} ms，共 {1} 次）", at_ms, refused.count);
  return {text.en + when.en, text.zh + when.zh};
}

}  // namespace oncard::runtime
