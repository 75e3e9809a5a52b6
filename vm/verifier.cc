// One pass over the symbol tables determines the type of every slot; a second one checks the
// instructions. Both stop at the first violation.
// Tested by tests/vm/verifier_test.cc and tests/vm/corruption_test.cc.
#include "vm/verifier.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vm/limits.h"
#include "vm/object_error.h"
#include "vm/symbol_names.h"

namespace oncard::vm {
namespace {

// What is known about one declared slot.
struct Slot {
  const Symbol* symbol = nullptr;
  uint16_t extent = 0;     // slots of the same variable from this one on
  uint16_t same_type = 0;  // how many of them have the same type as this one
};

using SlotTable = std::vector<Slot>;

bool IsNameOfCard(std::string_view name) {
  return name.size() <= kNameLengthMax && IsIdentifier(name);
}

bool IsMember(const Symbol& symbol) { return symbol.name.find('.') != std::string::npos; }

// The name of the structure for a member, the whole name for any other symbol.
std::string_view BaseName(const Symbol& symbol) {
  return std::string_view(symbol.name).substr(0, symbol.name.find('.'));
}

bool SameStructure(const Symbol& a, const Symbol& b) {
  return IsMember(a) && IsMember(b) && BaseName(a) == BaseName(b);
}

// A structure's members are consecutive symbols `name.member`.
bool ContinuesStructure(const std::vector<Symbol>& symbols, size_t index) {
  return index > 0 && SameStructure(symbols[index - 1], symbols[index]);
}

bool IsVariableType(DataType type) { return type == DataType::kInt || type == DataType::kDouble; }

SlotTable BuildSlots(const std::vector<Symbol>& symbols) {
  SlotTable slots;
  for (const Symbol& symbol : symbols) slots.insert(slots.end(), symbol.slots(), Slot{&symbol});
  for (size_t i = slots.size(); i-- > 0;) {
    Slot& slot = slots[i];
    slot.extent = slot.same_type = 1;
    if (i + 1 == slots.size()) continue;
    const Slot& next = slots[i + 1];
    if (next.symbol != slot.symbol && !SameStructure(*slot.symbol, *next.symbol)) continue;
    slot.extent = static_cast<uint16_t>(next.extent + 1);
    if (next.symbol->type == slot.symbol->type) {
      slot.same_type = static_cast<uint16_t>(next.same_type + 1);
    }
  }
  return slots;
}

// Keeps the first violation; the checking functions return false when there is one.
class Verifier {
 public:
  Verifier(const Object& object, const CommandTable& commands, Symbols symbols)
      : object_(object), commands_(commands), symbols_(symbols) {}

  Result<void> Run() {
    if (object_.functions.size() > kFunctionMax) {
      return MakeError(kTooManyFunctions, "the program has {0} functions; {1} are allowed",
                       "程序有 {0} 个函数；最多允许 {1} 个", object_.functions.size(),
                       kFunctionMax);
    }
    if (symbols_ == Symbols::kRequired) {
      place_ = {"globals", "全局变量"};
      if (!CheckSymbols(object_.globals)) return *error_;
      globals_ = BuildSlots(object_.globals);
    }
    for (const Function& function : object_.functions) {
      function_ = &function;
      if (!CheckFunction()) return *error_;
    }
    return {};
  }

 private:
  // --- Symbols and functions -------------------------------------------------------------------

  bool CheckSymbols(const std::vector<Symbol>& symbols) {
    std::set<std::string_view> names;
    std::set<std::string_view> bases;
    int next_id = 0;
    for (size_t i = 0; i < symbols.size(); ++i) {
      const Symbol& symbol = symbols[i];
      const std::string name = Printable(symbol.name);
      const std::string_view base = BaseName(symbol);
      if (!IsNameOfCard(base) ||
          (IsMember(symbol) &&
           (symbol.array_size != 0 || !IsNameOfCard(symbol.name.substr(base.size() + 1))))) {
        return Fail("'{0}' is not the name of a variable or of a structure's member",
                    "“{0}”不是变量名或结构体成员名", name);
      }
      const bool new_variable = !ContinuesStructure(symbols, i);
      if (!names.insert(symbol.name).second || (new_variable && !bases.insert(base).second)) {
        return Fail("'{0}' is declared twice", "“{0}”重复声明", name);
      }
      if (!IsVariableType(symbol.type)) {
        return Fail("'{0}' has data type {1}; 1 (int) or 2 (double) is expected",
                    "“{0}”的数据类型为 {1}；应为 1（int）或 2（double）", name,
                    static_cast<int>(symbol.type));
      }
      if (symbol.id != next_id) {
        return Fail("'{0}' has id {1}; {2} is expected, ids count the slots from 0",
                    "“{0}”的标识为 {1}；应为 {2}，标识从 0 起按存储单元编号", name, symbol.id,
                    next_id);
      }
      next_id += symbol.slots();
      if (next_id > kSlotCount) {
        return Fail("'{0}' ends at slot {1}; there are {2}",
                    "“{0}”占用到第 {1} 个存储单元；共有 {2} 个", name, next_id, kSlotCount);
      }
    }
    return true;
  }

  bool CheckFunction() {
    const Function& function = *function_;
    const size_t count = function.instructions.size();
    const std::string name = Printable(function.name);
    place_ = MakeMessage("function '{0}'", "函数“{0}”", name);
    if (!IsVariableType(function.return_type) && function.return_type != DataType::kVoid) {
      return Fail("return type {0} is not known; 0 (void), 1 (int) or 2 (double) is expected",
                  "未知的返回类型 {0}；应为 0（void）、1（int）或 2（double）",
                  static_cast<int>(function.return_type));
    }
    if (count > kInstructionMax) {
      return Fail("{0} instructions; {1} are allowed", "有 {0} 条指令；最多允许 {1} 条", count,
                  kInstructionMax);
    }
    if (symbols_ == Symbols::kRequired) {
      if (!CheckNames(name) || !CheckSymbols(function.variables)) return false;
      locals_ = BuildSlots(function.variables);
    }
    for (index_ = 0; index_ < count; ++index_) {
      if (CheckInstruction(function.instructions[index_])) continue;
      error_ = At(InstructionPlace(name), *reason_);
      return false;
    }
    return true;
  }

  Message InstructionPlace(const std::string& printable_name) const {
    const std::vector<uint16_t>& lines = function_->lines;
    if (index_ >= lines.size() || lines[index_] == 0) {
      return MakeMessage("function '{0}', instruction {1}", "函数“{0}”，指令 {1}", printable_name,
                         index_);
    }
    return MakeMessage("function '{0}', instruction {1} (source line {2})",
                       "函数“{0}”，指令 {1}（源程序第 {2} 行）", printable_name, index_,
                       lines[index_]);
  }

  bool CheckNames(const std::string& printable_name) {
    const Function& function = *function_;
    if (!IsNameOfCard(function.name)) {
      return Fail("'{0}' is not the name of a function", "“{0}”不是函数名", printable_name);
    }
    if (!function_names_.insert(function.name).second) {
      return Fail("'{0}' is defined twice", "“{0}”重复定义", printable_name);
    }
    if (std::any_of(function.file.begin(), function.file.end(),
                    [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; })) {
      return Fail("the source file's name '{0}' has control characters",
                  "源文件名“{0}”含有控制字符", Printable(function.file));
    }
    if (function.lines.size() != function.instructions.size()) {
      return Fail("{0} source lines for {1} instructions", "{1} 条指令却有 {0} 个源程序行号",
                  function.lines.size(), function.instructions.size());
    }
    return true;
  }

  // --- Instructions ----------------------------------------------------------------------------

  bool CheckInstruction(const Instruction& instruction) {
    switch (instruction.opcode) {
      case Opcode::kUnary:
        return CheckOperator(instruction, FindUnaryOperator(instruction.op), 1);
      case Opcode::kBinary:
        return CheckOperator(instruction, FindBinaryOperator(instruction.op), 2);
      case Opcode::kJump:
        return CheckOperandCount(instruction, 1) && CheckCondition(instruction.operands[0]) &&
               CheckTarget(instruction.displacement);
      case Opcode::kReturn:
        return CheckOperandCount(instruction, 2) && CheckCondition(instruction.operands[0]) &&
               CheckReturnValue(instruction.operands[1]);
      case Opcode::kCommand:
        return CheckCommand(instruction);
    }
    return Reject("opcode 0x{0:04x} is not known", "未知的操作码 0x{0:04x}",
                  static_cast<uint16_t>(instruction.opcode));
  }

  bool CheckOperandCount(const Instruction& instruction, size_t expected) {
    return instruction.operands.size() == expected ||
           Reject("{0} operands; {1} are expected", "有 {0} 个操作数；应为 {1} 个",
                  instruction.operands.size(), expected);
  }

  // `sources` operands of the instruction's type, followed by the target.
  bool CheckOperator(const Instruction& instruction, const OperatorInfo* info, size_t sources) {
    if (info == nullptr) {
      return Reject("no operator has number {0}", "没有编号为 {0} 的运算符", instruction.op);
    }
    const DataType type = instruction.type;
    if (!IsVariableType(type) || !Accepts(*info, type)) {
      return Reject("operator '{0}' (number {1}) does not take operands of type {2}",
                    "运算符“{0}”（编号 {1}）不接受 {2} 类型的操作数", info->spelling, info->number,
                    TypeName(type));
    }
    if (!CheckOperandCount(instruction, sources + 1)) return false;
    for (size_t i = 0; i < sources; ++i) {
      if (!CheckValue(instruction.operands[i], type)) return false;
    }
    const Operand& target = instruction.operands[sources];
    if (std::holds_alternative<Immediate>(target)) {
      return Reject("the target is a literal; it must be a variable", "赋值目标是常数；应为变量");
    }
    return CheckValue(target, ResultOf(*info, type));
  }

  bool CheckCondition(const Operand& condition) {
    if (const auto* variable = std::get_if<Variable>(&condition)) {
      return CheckVariable(*variable, DataType::kInt);
    }
    const auto* literal = std::get_if<Immediate>(&condition);
    return (literal != nullptr && *literal == ImmediateInt(1)) ||
           Reject("the condition is neither an int variable nor the constant 1",
                  "条件既不是 int 变量，也不是常数 1");
  }

  bool CheckTarget(int displacement) {
    const int64_t target = static_cast<int64_t>(index_) + displacement;
    const auto count = static_cast<int64_t>(function_->instructions.size());
    return (target >= 0 && target < count) ||
           Reject("the jump goes to instruction {0}; the function has 0 to {1}",
                  "跳转到指令 {0}；函数只有指令 0 到 {1}", target, count - 1);
  }

  bool CheckReturnValue(const Operand& value) {
    if (function_->return_type != DataType::kVoid) {
      return CheckValue(value, function_->return_type);
    }
    const auto* literal = std::get_if<Immediate>(&value);
    return (literal != nullptr && literal->raw == 0) ||
           Reject("a void function returns a value", "void 函数返回了值");
  }

  // --- Operands --------------------------------------------------------------------------------

  bool CheckValue(const Operand& operand, DataType type) {
    if (const auto* variable = std::get_if<Variable>(&operand)) {
      return CheckVariable(*variable, type);
    }
    if (const auto* element = std::get_if<Element>(&operand)) return CheckElement(*element, type);
    return CheckLiteral(std::get<Immediate>(operand).raw, type);
  }

  bool CheckLiteral(int64_t raw, DataType type) {
    // An int literal has 32 bits before the point under both formats of double.
    const DoubleFormat format =
        type == DataType::kInt ? DoubleFormat::k32_16 : object_.double_format;
    if (raw < FixedMin(format) || raw > FixedMax(format)) {
      return Reject("literal {0} does not fit the type {1}", "常数 {0} 超出类型 {1} 的范围",
                    DoubleFromFixed(raw), TypeName(type));
    }
    if (type == DataType::kInt && raw % (1 << kFractionBits) != 0) {
      return Reject("literal {0} is not an int", "常数 {0} 不是整数", DoubleFromFixed(raw));
    }
    return true;
  }

  // The slot's description, nullptr when it is not declared.
  const Slot* FindSlot(Storage storage, size_t id) const {
    const SlotTable& slots = storage == Storage::kLocal ? locals_ : globals_;
    return id < slots.size() ? &slots[id] : nullptr;
  }

  bool CheckVariable(const Variable& variable, DataType type) {
    if (symbols_ == Symbols::kAbsent) return CheckRange(variable.id, 1);
    const Slot* slot = FindSlot(variable.storage, variable.id);
    if (slot == nullptr) {
      return variable.storage == Storage::kLocal
                 ? Reject("local variable {0} is not declared", "局部变量 {0} 未声明", variable.id)
                 : Reject("global variable {0} is not declared", "全局变量 {0} 未声明",
                          variable.id);
    }
    return CheckType(*slot->symbol, type);
  }

  bool CheckElement(const Element& element, DataType type) {
    if (symbols_ == Symbols::kAbsent) {
      if (element.size == 0) return Reject("an array has no elements", "数组没有元素");
      if (!CheckRange(element.base, element.size)) return false;
    } else {
      const Slot* slot = FindSlot(element.storage, element.base);
      if (slot == nullptr || slot->symbol->array_size == 0 || slot->symbol->id != element.base ||
          slot->symbol->array_size != element.size) {
        return element.storage == Storage::kLocal
                   ? Reject("no array of {1} elements begins at local variable {0}",
                            "局部变量 {0} 处没有 {1} 个元素的数组", element.base, element.size)
                   : Reject("no array of {1} elements begins at global variable {0}",
                            "全局变量 {0} 处没有 {1} 个元素的数组", element.base, element.size);
      }
      if (!CheckType(*slot->symbol, type)) return false;
    }
    return CheckVariable(element.index, DataType::kInt);
  }

  bool CheckRange(int first, int count) {
    return first + count <= kSlotCount ||
           Reject("slot {0} does not exist; there are {1}", "存储单元 {0} 不存在；共有 {1} 个",
                  first + count - 1, kSlotCount);
  }

  bool CheckType(const Symbol& symbol, DataType expected) {
    return symbol.type == expected ||
           Reject("'{0}' is of type {1}; {2} is expected", "“{0}”的类型是 {1}；应为 {2}",
                  Printable(symbol.name), TypeName(symbol.type), TypeName(expected));
  }

  // --- Commands --------------------------------------------------------------------------------

  bool CheckCommand(const Instruction& instruction) {
    const CommandShape* command = commands_.Find(instruction.op);
    if (command == nullptr) {
      return Reject("no command has number {0}", "没有编号为 {0} 的指令", instruction.op);
    }
    if (!command->in_motion_program) {
      return Reject("{0} cannot be called in a motion program", "{0} 不能在运动程序中调用",
                    command->name);
    }
    const auto& arguments = instruction.operands;
    if (arguments.size() > kCommandArgumentMax) {
      return Reject("{0} arguments; a record holds {1}", "有 {0} 个参数；一条记录最多 {1} 个",
                    arguments.size(), kCommandArgumentMax);
    }
    if (arguments.size() != command->parameters.size()) {
      return Reject("{0} takes {1} arguments, not {2}", "{0} 需要 {1} 个参数，而不是 {2} 个",
                    command->name, command->parameters.size(), arguments.size());
    }
    for (size_t i = 0; i < arguments.size(); ++i) {
      const ParameterShape& parameter = command->parameters[i];
      const bool accepted = parameter.address ? CheckAddress(arguments[i], parameter, arguments)
                                              : CheckValue(arguments[i], parameter.slots.front());
      if (!accepted) {
        reason_ = At(
            MakeMessage("argument '{0}' of {1}", "{1} 的参数“{0}”", parameter.name, command->name),
            *reason_);
        return false;
      }
    }
    return true;
  }

  bool CheckAddress(const Operand& operand, const ParameterShape& parameter,
                    const std::vector<Operand>& arguments) {
    if (parameter.slots.empty()) {
      return Reject("a motion program has no variables of its type", "运动程序没有该类型的变量");
    }
    if (const auto* variable = std::get_if<Variable>(&operand)) {
      if (!CheckVariable(*variable, parameter.slots.front())) return false;
      if (symbols_ == Symbols::kAbsent) {
        return CheckStorage(parameter, arguments, size_t{kSlotCount} - variable->id);
      }
      const Slot& slot = *FindSlot(variable->storage, variable->id);
      return CheckStorage(parameter, arguments, slot.extent) &&
             CheckSlotTypes(*variable, parameter, arguments);
    }
    if (const auto* element = std::get_if<Element>(&operand)) {
      for (const DataType type : parameter.slots) {
        if (!CheckElement(*element, type)) return false;
      }
      return CheckStorage(parameter, arguments, element->size);
    }
    return Reject("a literal has no address; a variable is expected", "常数没有地址；应为变量");
  }

  // Checks that the elements which the call certainly accesses are in the storage: as many as a
  // literal count says, and in any case the one whose address is passed.
  bool CheckStorage(const ParameterShape& parameter, const std::vector<Operand>& arguments,
                    size_t available) {
    const size_t needed = parameter.slots.size() * LiteralCount(parameter, arguments).value_or(1);
    return needed <= available ||
           Reject("{0} slots are needed, the variable has {1} from there on",
                  "需要 {0} 个存储单元，该变量从此处起只有 {1} 个", needed, available);
  }

  // Checks that the variable's slots have the parameter's types, as far as the call can reach.
  bool CheckSlotTypes(const Variable& variable, const ParameterShape& parameter,
                      const std::vector<Operand>& arguments) {
    for (size_t i = 1; i < parameter.slots.size(); ++i) {
      const Slot* next = FindSlot(variable.storage, variable.id + i);
      if (!CheckType(*next->symbol, parameter.slots[i])) return false;
    }
    // A count that is only known at run time may reach the end of the variable.
    const Slot& slot = *FindSlot(variable.storage, variable.id);
    const std::optional<size_t> count = LiteralCount(parameter, arguments);
    const size_t reach = count ? *count * parameter.slots.size() : slot.extent;
    if (reach <= parameter.slots.size() || reach <= slot.same_type) return true;
    const Slot* other = FindSlot(variable.storage, variable.id + size_t{slot.same_type});
    return Reject("the command may reach '{0}', which is of another type",
                  "该指令可能访问到类型不同的“{0}”", Printable(other->symbol->name));
  }

  // The number of elements that the call covers, at least 1; empty if it is only known at run time.
  static std::optional<size_t> LiteralCount(const ParameterShape& parameter,
                                            const std::vector<Operand>& arguments) {
    if (parameter.count_parameter < 0) return 1;
    const Operand& operand = arguments[static_cast<size_t>(parameter.count_parameter)];
    const auto* literal = std::get_if<Immediate>(&operand);
    if (literal == nullptr) return std::nullopt;
    return static_cast<size_t>(std::max<int64_t>(1, literal->raw >> kFractionBits));
  }

  // --- Errors ----------------------------------------------------------------------------------

  template <typename... Args>
  bool Fail(std::string_view en, std::string_view zh, const Args&... args) {
    error_ = At(place_, DamagedObject(en, zh, args...));
    return false;
  }

  // For instructions: CheckFunction() adds the place in front.
  template <typename... Args>
  bool Reject(std::string_view en, std::string_view zh, const Args&... args) {
    reason_ = DamagedObject(en, zh, args...);
    return false;
  }

  const Object& object_;
  const CommandTable& commands_;
  const Symbols symbols_;
  SlotTable globals_;
  SlotTable locals_;
  std::set<std::string_view> function_names_;
  const Function* function_ = nullptr;
  size_t index_ = 0;
  Message place_;
  std::optional<Error> reason_;
  std::optional<Error> error_;
};

}  // namespace

Result<void> Verify(const Object& object, const CommandTable& commands, Symbols symbols) {
  return Verifier(object, commands, symbols).Run();
}

uint16_t StorageExtent(const Object& object, const Function& function, const Variable& variable) {
  const std::vector<Symbol>& symbols =
      variable.storage == Storage::kLocal ? function.variables : object.globals;
  if (symbols.empty()) {
    return static_cast<uint16_t>(variable.id < kSlotCount ? kSlotCount - variable.id : 0);
  }
  // The last symbol that begins at the slot or before it.
  auto symbol = std::upper_bound(symbols.begin(), symbols.end(), variable.id,
                                 [](uint16_t id, const Symbol& other) { return id < other.id; });
  if (symbol == symbols.begin()) return 0;
  --symbol;
  auto end = symbol->id + symbol->slots();
  if (variable.id >= end) return 0;
  for (auto next = symbol + 1; next != symbols.end() && SameStructure(*symbol, *next); ++next) {
    end = next->id + next->slots();
  }
  return static_cast<uint16_t>(end - variable.id);
}

}  // namespace oncard::vm
