#include "runtime/sim/command_place.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/milliseconds.h"
#include "base/path_bytes.h"
#include "runtime/sim/call_text.h"

namespace oncard::runtime {

CommandPlace PlaceOfInstruction(const vm::Machine& machine, int thread, int function,
                                int instruction) {
  const vm::Function& called = machine.image()->object.functions[static_cast<size_t>(function)];
  const auto line = static_cast<size_t>(instruction);
  return {.thread = thread,
          .function = called.name,
          .file = called.file,
          .line = line < called.lines.size() ? called.lines[line] : 0,
          .call = {}};
}

CommandPlace PlaceOf(const gtcalls::Call& call) {
  if (call.caller == vm::kHostCaller) {
    CommandPlace place;
    place.call = FormatInputs(call.command, call.arguments);
    return place;
  }
  const vm::ThreadState& thread = call.card.machine.thread(call.caller);
  return PlaceOfInstruction(call.card.machine, call.caller, thread.function, thread.pc);
}

Message DescribePlace(const CommandPlace& place, const std::string& program_path) {
  // Nobody has called anything, or it is no longer known.
  if (place.thread == vm::kHostCaller && place.call.empty()) return {};
  if (place.thread == vm::kHostCaller) return {place.call + ": ", place.call + "："};
  const std::filesystem::path folder = PathOf(program_path).parent_path();
  const std::string line =
      fmt::format("{}:{}", FileNameOf(folder / PathOf(place.file)), place.line);
  return MakeMessage("{0}: thread {1} {2}: ", "{0}：线程 {1} {2}：", line, place.thread,
                     place.function);
}

Message DescribeOccurrences(int64_t first_us, int64_t count) {
  if (count == 0) return {};
  const double at_ms = ToMs(first_us);
  if (count == 1) return MakeMessage(" (at {0} ms)", "（{0} ms 时）", at_ms);
  return MakeMessage(" (first at {0} ms, {1} times)", "（首次在 {0} ms，共 {1} 次）", at_ms, count);
}

}  // namespace oncard::runtime
