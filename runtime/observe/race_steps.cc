#include "runtime/observe/race_steps.h"

#include <fmt/core.h>

#include <algorithm>

#include "motion/motion_state.h"

namespace oncard::runtime {
namespace {

using gtcalls::Resource;

/// Words of outputs have numbers below, and so many bits; modules have so many outputs of both
/// kinds.
constexpr uint32_t kOutputWordMax = 32;
constexpr uint32_t kOutputWordBits = Touched::kFirstChannel;
constexpr uint32_t kModuleOutputs = 32;

// Where the cells of each kind begin.
constexpr auto kFirstAxis = uint32_t{vm::kSlotCount};
constexpr uint32_t kFirstCrd = kFirstAxis + motion::kAxisMax;
constexpr uint32_t kFirstAnalog = kFirstCrd + motion::kCrdCount;
constexpr uint32_t kFirstOutput = kFirstAnalog + motion::kAxisMax;
constexpr uint32_t kFirstModule = kFirstOutput + kOutputWordMax * kOutputWordBits;

/// Adds the cells of what a command sets.
class SetCells {
 public:
  SetCells(const Controller& controller, std::vector<uint32_t>* cells)
      : axis_count_(static_cast<uint32_t>(controller.motion().axis_count())), cells_(*cells) {}

  void Add(const Touched& touched) {
    switch (touched.resource) {
      case Resource::kAxis:
      case Resource::kEncoder:
      case Resource::kControl:
        return AddNumbered(touched.number, kFirstAxis, axis_count_);
      case Resource::kCrd:
        return AddNumbered(touched.number, kFirstCrd, motion::kCrdCount);
      case Resource::kAnalog:
        return AddNumbered(touched.number, kFirstAnalog, motion::kAxisMax);
      case Resource::kDigitalOutput:
        if (touched.number < kOutputWordMax) {
          AddBits(touched.bits, kFirstOutput, touched.number, kOutputWordBits);
        }
        return;
      case Resource::kExtension:
        if (touched.number < motion::kModuleCount) {
          AddBits(touched.bits, kFirstModule, touched.number, kModuleOutputs);
        }
        return;
      default:
        return;
    }
  }

 private:
  void AddCell(uint32_t cell) {
    if (std::ranges::find(cells_, cell) == cells_.end()) cells_.push_back(cell);
  }
  /// Numbers count from 1.
  void AddNumbered(uint32_t number, uint32_t first, size_t count) {
    for (uint32_t i = 0; i < count; ++i) {
      if (number == Touched::kAll || number == i + 1) AddCell(first + i);
    }
  }
  void AddBits(uint32_t bits, uint32_t first, uint32_t number, uint32_t width) {
    for (uint32_t bit = 0; bit < width; ++bit) {
      if ((bits >> bit & 1) != 0) AddCell(first + number * width + bit);
    }
  }

  uint32_t axis_count_;
  std::vector<uint32_t>& cells_;
};

}  // namespace

std::vector<RaceStep> NextRaceSteps(const Controller& controller, int thread,
                                    const std::vector<bool>& sync) {
  using Kind = RaceStep::Kind;
  const auto synchronises = [&](uint32_t slot) { return slot < sync.size() && sync[slot]; };
  std::vector<RaceStep> steps;
  std::vector<uint32_t> set;
  for (const Touched& touched : NextPreciseAccess(controller, thread)) {
    if (touched.resource == Resource::kVariable) {
      const bool orders = synchronises(touched.number);
      steps.push_back({touched.write ? (orders ? Kind::kRelease : Kind::kWrite)
                                     : (orders ? Kind::kAcquire : Kind::kRead),
                       touched.number});
    } else if (touched.write) {
      SetCells(controller, &set).Add(touched);
    }
  }
  for (const uint32_t cell : set) steps.push_back({Kind::kWrite, cell});
  std::ranges::stable_sort(steps, {}, &RaceStep::kind);
  return steps;
}

bool IsSetByCommands(uint32_t cell) { return cell >= kFirstAxis; }

Message NameOfCell(uint32_t cell, const vm::Object& object) {
  if (cell >= kFirstModule) {
    const uint32_t module = (cell - kFirstModule) / kModuleOutputs;
    const uint32_t output = (cell - kFirstModule) % kModuleOutputs;
    if (output < Touched::kFirstChannel) {
      return MakeMessage("output {0} of extension module {1}", "扩展模块 {1} 的输出 {0}", output,
                         module);
    }
    return MakeMessage("analogue output {0} of extension module {1}",
                       "扩展模块 {1} 的模拟量输出 {0}", output - Touched::kFirstChannel, module);
  }
  if (cell >= kFirstOutput) {
    return MakeMessage("output {0} of word {1}", "第 {1} 类输出的第 {0} 路",
                       (cell - kFirstOutput) % kOutputWordBits + 1,
                       (cell - kFirstOutput) / kOutputWordBits);
  }
  if (cell >= kFirstAnalog) {
    return MakeMessage("analogue output {0}", "模拟量输出 {0}", cell - kFirstAnalog + 1);
  }
  if (cell >= kFirstCrd) {
    return MakeMessage("coordinate system {0}", "坐标系 {0}", cell - kFirstCrd + 1);
  }
  if (cell >= kFirstAxis) return MakeMessage("axis {0}", "轴 {0}", cell - kFirstAxis + 1);
  const std::string name = NameOf({Resource::kVariable, cell}, object);
  return {name, name};
}

std::string_view CommandAt(const Controller& controller, int thread, int position) {
  const vm::Machine& machine = controller.machine();
  const vm::Function& function = machine.image()->object.functions[machine.thread(thread).function];
  const vm::Instruction& instruction = function.instructions[static_cast<size_t>(position)];
  if (instruction.opcode != vm::Opcode::kCommand) return {};
  const vm::CommandShape* shape = controller.commands().Find(instruction.op);
  return shape == nullptr ? std::string_view{} : shape->name;
}

Message DescribeTwoOwners(uint32_t cell, const vm::Object& object, const PlacedCommand& one,
                          const PlacedCommand& other) {
  const auto& [first, second] = std::minmax(
      one, other, [](const auto& left, const auto& right) { return left.thread < right.thread; });
  const Message what = NameOfCell(cell, object);
  const bool output = cell >= kFirstAnalog;
  return {fmt::format("threads {} and {} both {} {}: {} in line {}, {} in line {}; nothing orders "
                      "them",
                      first.thread, second.thread, output ? "set" : "command", what.en, first.name,
                      first.line, second.name, second.line),
          fmt::format("线程 {} 和 {} 都{}{}：第 {} 行的 {}、第 {} 行的 {}；两者之间没有顺序",
                      first.thread, second.thread, output ? "设置" : "操作", what.zh, first.line,
                      first.name, second.line, second.name)};
}

}  // namespace oncard::runtime
