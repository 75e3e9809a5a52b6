#include "tests/vm/program_builder.h"

#include <utility>

namespace oncard::vm {

const CommandShape* ThreadCommands::Find(uint16_t number) const {
  static constexpr DataType kIntSlot[] = {DataType::kInt};
  static constexpr DataType kDoubleSlot[] = {DataType::kDouble};
  static constexpr ParameterShape kValue[] = {{"value", false, kIntSlot, -1}};
  static constexpr ParameterShape kWaitForParameters[] = {{"variable", true, kIntSlot, -1},
                                                          {"value", false, kIntSlot, -1}};
  static constexpr ParameterShape kAddToEachParameters[] = {{"values", true, kIntSlot, 1},
                                                            {"count", false, kIntSlot, -1},
                                                            {"amount", false, kIntSlot, -1}};
  static constexpr ParameterShape kHalveParameters[] = {{"value", true, kDoubleSlot, -1}};
  static constexpr ParameterShape kRefuseParameters[] = {{"value", true, kIntSlot, -1}};
  static constexpr CommandShape kCommands[] = {
      {kDelay, "GT_Delay", kValue, true},
      {kWaitFor, "GT_WaitFor", kWaitForParameters, true},
      {kUsePage, "GT_UsePage", kValue, true},
      {kAddToEach, "GT_AddToEach", kAddToEachParameters, true},
      {kHalve, "GT_Halve", kHalveParameters, true},
      {kRefuse, "GT_Refuse", kRefuseParameters, true},
  };
  for (const CommandShape& command : kCommands) {
    if (command.number == number) return &command;
  }
  return nullptr;
}

int16_t ThreadCommands::Execute(uint16_t number, Machine& machine, int thread,
                                std::span<CommandArgument> arguments) {
  switch (number) {
    case kDelay:
      machine.Delay(thread, static_cast<int64_t>(arguments[0].value));
      return kOk;
    case kWaitFor:
      machine.WaitForValue(thread, arguments[0].slot, static_cast<int64_t>(arguments[1].value));
      return kOk;
    case kUsePage:
      return machine.SwitchPage(thread, static_cast<int>(arguments[0].value));
    case kAddToEach:
      if (arguments[1].value < 0) return kBadParameter;
      for (double& cell : arguments[0].cells) cell += arguments[2].value;
      return kOk;
    case kHalve:
      arguments[0].cells[0] /= 2;
      return kOk;
    case kRefuse:
      arguments[0].cells[0] = 12345;
      return kRefuseCode;
    default:
      return kBadParameter;
  }
}

Instruction Goto(int16_t displacement) { return Jump(kAlways, displacement); }

Instruction Set(const Operand& dst, const Operand& src) {
  return Unary(UnaryOperator::kCopy, DataType::kInt, src, dst);
}

Instruction Add(const Operand& dst, const Operand& a, const Operand& b) {
  return Binary(BinaryOperator::kAdd, DataType::kInt, a, b, dst);
}

Function MakeFunction(std::vector<Instruction> instructions, DataType return_type) {
  Function function;
  function.return_type = return_type;
  for (size_t i = 0; i < instructions.size(); ++i) {
    function.lines.push_back(static_cast<uint16_t>(10 * (i + 1)));
  }
  function.instructions = std::move(instructions);
  return function;
}

Object MakeObject(std::vector<Function> functions) {
  Object object;
  object.functions = std::move(functions);
  return object;
}

std::shared_ptr<const Image> LinkRecords(const Object& object, const CommandTable& commands) {
  auto image = LinkObject(object, commands, Symbols::kAbsent);
  if (!image.ok()) {
    ADD_FAILURE() << image.error().message.en;
    return nullptr;
  }
  return image.value();
}

void MachineTest::Load(std::vector<Function> functions) {
  machine_.Load(LinkRecords(MakeObject(std::move(functions)), commands_));
}

void MachineTest::Start(int thread, int id) {
  ASSERT_EQ(machine_.Bind(thread, id, thread), kOk);
  ASSERT_EQ(machine_.Run(thread), kOk);
}

void MachineTest::LoadAndStart(std::vector<Instruction> instructions) {
  Load({MakeFunction(std::move(instructions))});
  Start(0);
}

int32_t MachineTest::LocalInt(int page, uint16_t id) const {
  return static_cast<int32_t>(machine_.ReadRaw({false, static_cast<uint8_t>(page), id}));
}

int32_t MachineTest::GlobalInt(uint16_t id) const {
  return static_cast<int32_t>(machine_.ReadRaw({true, 0, id}));
}

void MachineTest::SetLocalInt(int page, uint16_t id, int32_t value) {
  machine_.WriteRaw({false, static_cast<uint8_t>(page), id}, value);
}

void MachineTest::SetGlobalInt(uint16_t id, int32_t value) {
  machine_.WriteRaw({true, 0, id}, value);
}

}  // namespace oncard::vm
