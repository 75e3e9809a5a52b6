#include "runtime/observe/thread_status.h"

#include "runtime/observe/quantity.h"
#include "vm/fixed_point.h"

namespace oncard::runtime {

std::string_view ThreadStateName(vm::ThreadRun run) {
  switch (run) {
    case vm::ThreadRun::kUnbound:
      return "unbound";
    case vm::ThreadRun::kStopped:
      return "finished";
    case vm::ThreadRun::kRunning:
      return "running";
    case vm::ThreadRun::kPaused:
      return "paused";
    case vm::ThreadRun::kFaulted:
      return "faulted";
  }
  return "unbound";
}

std::optional<Message> DescribeDepth(const vm::ThreadState& thread, const vm::Image& program) {
  if (thread.error != static_cast<int>(vm::Fault::kIndexOutOfBounds)) return std::nullopt;
  const vm::Function& function = program.object.functions[thread.function];
  if (thread.pc >= function.instructions.size()) return std::nullopt;
  for (const vm::Operand& operand : function.instructions[thread.pc].operands) {
    const auto* element = std::get_if<vm::Element>(&operand);
    if (element == nullptr || element->storage != vm::Storage::kLocal) continue;
    for (const vm::RecursionFrames& frames : function.frames) {
      if (frames.array != element->base) continue;
      return MakeMessage(
          "calls of '{0}' are nested more than {1} deep: write a larger number after '//@ depth:'",
          "'{0}' 的嵌套调用超过 {1} 层：请在 '//@ depth:' 后写更大的数", frames.function,
          frames.depth);
    }
  }
  return std::nullopt;
}

Message DescribeFault(const vm::ThreadState& thread, const vm::Image& program) {
  if (const auto depth = DescribeDepth(thread, program)) return *depth;
  switch (static_cast<vm::Fault>(thread.error)) {
    case vm::Fault::kDivisionByZero:
      return {"division by zero", "除数为零"};
    case vm::Fault::kIndexOutOfBounds:
      return MakeMessage("index {0} is out of bounds: the array has elements 0 to {1}",
                         "下标 {0} 越界：数组下标为 0 至 {1}", thread.fault_value,
                         thread.fault_limit - 1);
    case vm::Fault::kOutputBeyondStorage:
      return MakeMessage("the command covers {0} variables, but only {1} are there",
                         "指令涉及 {0} 个变量，而此处只有 {1} 个", thread.fault_value,
                         thread.fault_limit);
    case vm::Fault::kNone:
      break;
  }
  return MakeMessage("fault {0}", "故障 {0}", thread.error);
}

std::string ResultText(const vm::ThreadState& thread) {
  const double result = thread.result_type == vm::DataType::kDouble
                            ? vm::DoubleFromFixed(thread.result)
                            : static_cast<double>(thread.result);
  return FormatNumber(result, FormOf(thread.result_type));
}

Message DescribeStatus(const vm::ThreadState& thread, const vm::Image& program,
                       const std::string& place) {
  switch (thread.run) {
    case vm::ThreadRun::kFaulted: {
      const Message fault = DescribeFault(thread, program);
      return {fmt::format("fault at {}: {}", place, fault.en),
              fmt::format("在 {} 发生故障：{}", place, fault.zh)};
    }
    case vm::ThreadRun::kRunning:
      if (thread.waiting) return MakeMessage("waiting at {0}", "在 {0} 等待", place);
      return MakeMessage("running at {0}", "在 {0} 运行", place);
    case vm::ThreadRun::kPaused:
      return MakeMessage("paused at {0}", "在 {0} 暂停", place);
    case vm::ThreadRun::kStopped:
    case vm::ThreadRun::kUnbound:
      break;
  }
  if (thread.result_type == vm::DataType::kVoid) return {"finished", "已结束"};
  return MakeMessage("finished, result {0}", "已结束，返回值 {0}", ResultText(thread));
}

}  // namespace oncard::runtime
