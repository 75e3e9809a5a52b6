#include "explore/reports/starvation.h"

#include <algorithm>
#include <map>
#include <optional>
#include <variant>

#include "runtime/observe/step_log.h"

namespace oncard::explore {
namespace {

/// What a thread does in the cycle.
struct Looks {
  const runtime::LoggedStep* step = nullptr;  ///< one that reads the global
  runtime::SlotValue found;
  bool only = true;  ///< it writes no global, and reads no other one and no other value
};

/// A lock is what a thread sets itself once it has found it free.
bool Sets(const vm::Function& function, uint16_t global) {
  return std::ranges::any_of(function.instructions, [&](const vm::Instruction& instruction) {
    const bool computes =
        instruction.opcode == vm::Opcode::kUnary || instruction.opcode == vm::Opcode::kBinary;
    if (!computes) return false;
    const auto* written = std::get_if<vm::Variable>(&instruction.operands.back());
    return written != nullptr && written->storage == vm::Storage::kGlobal && written->id == global;
  });
}

void Look(const runtime::LoggedStep& step, Looks* looks) {
  for (const runtime::SlotChange& write : step.writes) {
    looks->only = looks->only && !write.slot.global;
  }
  for (const runtime::SlotValue& read : step.reads) {
    if (!read.slot.global) continue;
    if (looks->step == nullptr) {
      looks->step = &step;
      looks->found = read;
    }
    looks->only = looks->only && runtime::SameSlot(read.slot, looks->found.slot) &&
                  read.raw == looks->found.raw;
  }
}

}  // namespace

Message DescribeStarvation(const std::vector<TrailStep>& cycle, const vm::Object& object) {
  std::map<int, Looks> threads;  // by their numbers on the card
  for (const TrailStep& step : cycle) Look(step.log, &threads[step.log.thread]);
  Message all;
  for (const auto& [thread, looks] : threads) {
    if (looks.step == nullptr || !looks.only) continue;
    const vm::SlotAddress& slot = looks.found.slot;
    const bool taken = looks.found.raw != 0 &&
                       Sets(object.functions[static_cast<size_t>(looks.step->function)], slot.id);
    const std::string name = runtime::NameOf(*looks.step, slot, object);
    const Message one =
        taken ? MakeMessage("thread {0} finds {1} taken each time it looks",
                            "线程 {0} 每次查看时 {1} 都被占用", thread, name)
              : MakeMessage("thread {0} finds {1} = {2} each time it looks",
                            "线程 {0} 每次查看时 {1} 都是 {2}", thread, name,
                            runtime::ValueText(*looks.step, slot, looks.found.raw, object));
    all.en += (all.en.empty() ? "starvation: " : ", ") + one.en;
    all.zh += (all.zh.empty() ? "饥饿：" : "，") + one.zh;
  }
  return all;
}

}  // namespace oncard::explore
