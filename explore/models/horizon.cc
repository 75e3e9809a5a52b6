#include "explore/models/horizon.h"

#include <fmt/ranges.h>

#include <bit>

namespace oncard::explore {

std::vector<int> NumbersOf(uint32_t bits, int first) {
  std::vector<int> numbers;
  for (; bits != 0; bits &= bits - 1) numbers.push_back(std::countr_zero(bits) + first);
  return numbers;
}

Message DescribeHorizon(const Horizon& horizon) {
  Message going;
  const auto add = [&](const std::vector<int>& numbers, const Message& one, const Message& more) {
    if (numbers.empty()) return;
    const Message& which = numbers.size() == 1 ? one : more;
    const Message part = MakeMessage(which.en, which.zh, fmt::to_string(fmt::join(numbers, ", ")));
    going.en += (going.en.empty() ? "" : ", ") + part.en;
    going.zh += (going.zh.empty() ? "" : "，") + part.zh;
  };
  add(NumbersOf(horizon.axes, 1), {"axis {0} still moves", "轴 {0} 仍在运动"},
      {"axes {0} still move", "轴 {0} 仍在运动"});
  add(NumbersOf(horizon.threads, 0), {"thread {0} still runs", "线程 {0} 仍在运行"},
      {"threads {0} still run", "线程 {0} 仍在运行"});
  if (!horizon.at_ms) {
    return MakeMessage("up to the end of the threads: {0}", "到线程结束为止：{1}", going.en,
                       going.zh);
  }
  return MakeMessage("up to {0} ms: {1}", "到 {0} ms 为止：{2}", *horizon.at_ms, going.en,
                     going.zh);
}

}  // namespace oncard::explore
