// The linker: turns a verified object into decoded code. One instruction of the object becomes one
// Code, so that program counters, lines and jump displacements remain valid. Where neighbours are
// often executed together, the op of the first one combines them and the interpreter
// executes them with one dispatch; the others keep their own code for jumps that arrive between
// them.
// Tested by tests/vm/image_test.cc, tests/vm/machine_test.cc and the language tests.
#include "vm/image.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "vm/handlers.h"
#include "vm/object_writer.h"
#include "vm/verifier.h"

namespace oncard::vm {
namespace {

// An operator with operands of one type.
constexpr uint32_t Typed(uint16_t op, DataType type) {
  return static_cast<uint32_t>(op) << 16 | static_cast<uint16_t>(type);
}
#define TYPED(kind, name, type) Typed(static_cast<uint16_t>(kind::k##name), DataType::k##type)

// First decoded op of a binary operator.
uint16_t BinaryOp(uint16_t op, DataType type) {
  switch (Typed(op, type)) {
#define INT_BINARY(name, bad, value)     \
  case TYPED(BinaryOperator, name, Int): \
    return kInt##name##LL;
#define DOUBLE_BINARY(name, bad, value)     \
  case TYPED(BinaryOperator, name, Double): \
    return kDouble##name##LL;
#define COMPARE(name, value)     \
  INT_BINARY(name, false, value) \
  DOUBLE_BINARY(name, false, value)
#include "vm/handlers.def"
    default:
      return kEnd;  // the verifier lets nothing else through
  }
}

// First decoded op of a unary operator.
uint16_t UnaryOp(uint16_t op, DataType type) {
  switch (Typed(op, type)) {
#define UNARY(name, type, value)         \
  case TYPED(UnaryOperator, name, type): \
    return k##name##type##L;
#include "vm/handlers.def"
    default:
      return kEnd;  // the verifier lets nothing else through
  }
}
#undef TYPED

bool IsShared(const Operand& operand) {
  if (const auto* variable = std::get_if<Variable>(&operand)) {
    return variable->storage == Storage::kGlobal;
  }
  if (const auto* element = std::get_if<Element>(&operand)) {
    return element->storage == Storage::kGlobal || element->index.storage == Storage::kGlobal;
  }
  return false;
}

uint16_t Displacement(const Instruction& instruction) {
  return static_cast<uint16_t>(instruction.displacement);
}

class FunctionLinker {
 public:
  FunctionLinker(const Object& object, const Function& function, const CommandTable& commands)
      : object_(object), function_(function), commands_(commands) {}

  Result<ImageFunction> Link() {
    linked_.code.reserve(function_.instructions.size() + 1);
    for (const Instruction& instruction : function_.instructions) {
      linked_.code.push_back(Decode(instruction));
    }
    linked_.code.push_back({kEnd, 0, 0, 0});
    if (linked_.constants.size() > kPackedIndexCount ||
        linked_.elements.size() > kPackedIndexCount) {
      return MakeError(2008,
                       "function '{0}' has more than {1} different literals or array accesses; "
                       "split it",
                       "函数“{0}”中不同的常量或数组访问超过 {1} 个；请拆分该函数", function_.name,
                       kPackedIndexCount);
    }
    FuseTests();
    FuseLoops();
    FuseSteps();
    FuseLastOfLoops();
    FusePairs();
    return std::move(linked_);
  }

 private:
  Code Decode(const Instruction& instruction) {
    switch (instruction.opcode) {
      case Opcode::kUnary:
        return DecodeUnary(instruction);
      case Opcode::kBinary:
        return DecodeBinary(instruction);
      case Opcode::kJump:
        return DecodeJump(instruction);
      case Opcode::kReturn:
        return DecodeReturn(instruction);
      case Opcode::kCommand:
        return DecodeCommand(instruction);
    }
    return {};
  }

  Code DecodeBinary(const Instruction& instruction) {
    const auto& operands = instruction.operands;
    const uint16_t first = BinaryOp(instruction.op, instruction.type);
    uint16_t a = Pack(operands[0], instruction.type);
    uint16_t b = Pack(operands[1], instruction.type);
    const uint16_t d = Pack(operands[2], instruction.type);
    if (ClassOf(a) == OperandClass::kConstant && Commutes(first)) std::swap(a, b);
    const bool shared = AnyShared(instruction);
    const Forms forms{ClassOf(a), ClassOf(b), ClassOf(d), shared};
    const bool is_int = instruction.type == DataType::kInt;
    const uint16_t variant = is_int ? IntVariantOf(forms) : DoubleVariantOf(forms);
    const uint16_t op = static_cast<uint16_t>(first + variant);
    const bool packed = is_int ? variant == kVariantP || variant == kVariantS
                               : variant == kDoubleVariantP || variant == kDoubleVariantS;
    if (packed) return {op, a, b, d};
    return {op, IndexOf(a), IndexOf(b), IndexOf(d)};
  }

  // The classes of a binary operation's operands, and whether one of them is shared.
  struct Forms {
    OperandClass a, b, d;
    bool shared;
    bool Are(OperandClass first, OperandClass second, OperandClass target) const {
      return a == first && b == second && d == target;
    }
  };

  static uint16_t IntVariantOf(const Forms& forms) {
    using enum OperandClass;
    if (forms.Are(kLocal, kLocal, kLocal)) return kVariantLL;
    if (forms.Are(kLocal, kConstant, kLocal)) return kVariantLK;
    if (forms.Are(kConstant, kLocal, kLocal)) return kVariantKL;
    if (forms.Are(kGlobal, kLocal, kGlobal)) return kVariantGL;
    if (forms.Are(kGlobal, kConstant, kGlobal)) return kVariantGK;
    if (forms.Are(kGlobal, kLocal, kLocal)) return kVariantGLToL;
    if (forms.Are(kGlobal, kConstant, kLocal)) return kVariantGKToL;
    if (forms.Are(kLocal, kConstant, kGlobal)) return kVariantLKToG;
    if (forms.shared) return kVariantS;
    if (forms.Are(kLocal, kElement, kLocal)) return kVariantLE;
    if (forms.Are(kElement, kConstant, kLocal)) return kVariantEK;
    return kVariantP;
  }

  static uint16_t DoubleVariantOf(const Forms& forms) {
    using enum OperandClass;
    if (forms.Are(kLocal, kLocal, kLocal)) return kDoubleVariantLL;
    if (forms.Are(kLocal, kConstant, kLocal)) return kDoubleVariantLK;
    if (forms.Are(kConstant, kLocal, kLocal)) return kDoubleVariantKL;
    if (forms.shared) return kDoubleVariantS;
    return forms.Are(kLocal, kElement, kLocal) ? kDoubleVariantLE : kDoubleVariantP;
  }

  Code DecodeUnary(const Instruction& instruction) {
    const uint16_t first = UnaryOp(instruction.op, instruction.type);
    const uint16_t a = Pack(instruction.operands[0], instruction.type);
    const uint16_t d = Pack(instruction.operands[1], instruction.type);
    const uint16_t variant = UnaryVariantOf(ClassOf(a), ClassOf(d), AnyShared(instruction));
    const auto op = static_cast<uint16_t>(first + variant);
    if (variant == kUnaryVariantP || variant == kUnaryVariantS) return {op, a, 0, d};
    return {op, IndexOf(a), 0, IndexOf(d)};
  }

  static uint16_t UnaryVariantOf(OperandClass a, OperandClass d, bool shared) {
    using enum OperandClass;
    if (a == kLocal && d == kLocal) return kUnaryVariantL;
    if (a == kConstant && d == kLocal) return kUnaryVariantK;
    if (a == kGlobal && d == kLocal) return kUnaryVariantG;
    if (a == kLocal && d == kGlobal) return kUnaryVariantLG;
    if (a == kConstant && d == kGlobal) return kUnaryVariantKG;
    if (shared) return kUnaryVariantS;
    if (a == kElement && d == kLocal) return kUnaryVariantE;
    if (a == kLocal && d == kElement) return kUnaryVariantLE;
    if (a == kConstant && d == kElement) return kUnaryVariantKE;
    return kUnaryVariantP;
  }

  Code DecodeJump(const Instruction& instruction) {
    const auto* condition = std::get_if<Variable>(&instruction.operands[0]);
    if (condition == nullptr) return {kGoto, 0, 0, Displacement(instruction)};
    const uint16_t op = condition->storage == Storage::kLocal ? kIfLocal : kIfGlobal;
    return {op, condition->id, 0, Displacement(instruction)};
  }

  Code DecodeReturn(const Instruction& instruction) {
    const uint16_t op = AnyShared(instruction) ? kReturnS : kReturnP;
    return {op, Pack(instruction.operands[0], DataType::kInt),
            Pack(instruction.operands[1], function_.return_type), 0};
  }

  Code DecodeCommand(const Instruction& instruction) {
    CallSite site;
    site.command = instruction.op;
    const auto parameters = commands_.Find(instruction.op)->parameters;
    for (size_t i = 0; i < parameters.size(); ++i) {
      const ParameterShape& parameter = parameters[i];
      CallSite::Argument argument;
      argument.type = parameter.slots[0];
      argument.operand = Pack(instruction.operands[i], argument.type);
      argument.address = parameter.address;
      if (parameter.address) {
        argument.count_argument = parameter.count_parameter;
        argument.elements_on_card = parameter.elements_on_card;
        argument.slots.assign(parameter.slots.begin(), parameter.slots.end());
        argument.extent = ExtentOf(instruction.operands[i]);
      }
      site.arguments.push_back(std::move(argument));
    }
    linked_.calls.push_back(std::move(site));
    return {kCommand, static_cast<uint16_t>(linked_.calls.size() - 1), 0, 0};
  }

  uint16_t ExtentOf(const Operand& operand) const {
    if (const auto* element = std::get_if<Element>(&operand)) return element->size;
    const auto* variable = std::get_if<Variable>(&operand);
    return variable != nullptr ? StorageExtent(object_, function_, *variable) : uint16_t{1};
  }

  static bool AnyShared(const Instruction& instruction) {
    return std::any_of(instruction.operands.begin(), instruction.operands.end(), IsShared);
  }

  // Operand `operand` of type `type`, packed.
  uint16_t Pack(const Operand& operand, DataType type) {
    if (const auto* variable = std::get_if<Variable>(&operand)) {
      const bool local = variable->storage == Storage::kLocal;
      return PackOperand(local ? OperandClass::kLocal : OperandClass::kGlobal, variable->id);
    }
    if (const auto* element = std::get_if<Element>(&operand)) return PackElement(*element);
    const int64_t raw = std::get<Immediate>(operand).raw;
    return PackConstant(type == DataType::kDouble ? raw : raw >> kFractionBits);
  }

  uint16_t PackConstant(int64_t value) {
    const auto [entry, added] = constant_index_.try_emplace(value, linked_.constants.size());
    if (added) linked_.constants.push_back(value);
    return PackOperand(OperandClass::kConstant, entry->second & kOperandIndexMask);
  }

  uint16_t PackElement(const Element& element) {
    const ElementReference reference{element.base, element.size, element.index.id,
                                     BaseOf(element.storage), BaseOf(element.index.storage)};
    const std::array<uint16_t, 5> key{reference.base, reference.size, reference.index,
                                      reference.array_class, reference.index_class};
    const auto [entry, added] = element_index_.try_emplace(key, linked_.elements.size());
    if (added) linked_.elements.push_back(reference);
    return PackOperand(OperandClass::kElement, entry->second & kOperandIndexMask);
  }

  static uint8_t BaseOf(Storage storage) {
    return static_cast<uint8_t>(storage == Storage::kGlobal ? OperandClass::kGlobal
                                                            : OperandClass::kLocal);
  }

  // Combines a comparison with the conditional jump that follows and tests its result.
  void FuseTests() {
    auto& code = linked_.code;
    for (size_t i = 0; i + 1 < code.size(); ++i) {
      if (code[i + 1].op != kIfLocal || code[i + 1].a != code[i].d) continue;
      switch (code[i].op) {
#define COMPARE(name, value)      \
  case kInt##name##LL:            \
    code[i].op = kTest##name##LL; \
    break;                        \
  case kInt##name##LK:            \
    code[i].op = kTest##name##LK; \
    break;
#include "vm/handlers.def"
        default:
          break;
      }
    }
  }

  // Combines a goto with the comparison and conditional jump that it leads to.
  void FuseLoops() {
    auto& code = linked_.code;
    for (size_t i = 0; i < code.size(); ++i) {
      if (code[i].op != kGoto) continue;
      const auto target = static_cast<ptrdiff_t>(i) + static_cast<int16_t>(code[i].d);
      switch (code[static_cast<size_t>(target)].op) {
#define COMPARE(name, value)      \
  case kTest##name##LL:           \
    code[i].op = kLoop##name##LL; \
    break;                        \
  case kTest##name##LK:           \
    code[i].op = kLoop##name##LK; \
    break;
#include "vm/handlers.def"
        default:
          break;
      }
    }
  }

  // Combines `x = x + K` and `x = x + y` with the test that follows, or with the goto to a loop's
  // test, when the test compares x; and any operation with a conditional jump that follows.
  void FuseSteps() {
    auto& code = linked_.code;
    for (size_t i = 0; i + 1 < code.size(); ++i) {
      uint16_t& op = code[i].op;
      switch (code[i + 1].op) {
#define FUSE_STEP(test)                                                            \
  case kTest##test:                                                                \
    if (op == kIntAddLK && Steps(code[i], code[i + 1])) op = kIncrementTest##test; \
    break;                                                                         \
  case kLoop##test:                                                                \
    if (!Steps(code[i], TargetOf(i + 1))) break;                                   \
    if (op == kIntAddLK) op = kIncrementLoop##test;                                \
    if (op == kIntAddLL) op = kStepLoop##test;                                     \
    break;
#define COMPARE(name, value) FUSE_STEP(name##LL) FUSE_STEP(name##LK)
#include "vm/handlers.def"
#undef FUSE_STEP
        case kIfLocal:
          FuseIf(op);
          break;
        default:
          break;
      }
    }
  }

  // True when the target of an operation is its operand a, and that of the comparison `test`.
  static bool Steps(const Code& step, const Code& test) {
    return step.a == step.d && test.a == step.d;
  }

  // Where the goto at i leads.
  const Code& TargetOf(size_t i) const {
    const auto target = static_cast<ptrdiff_t>(i) + static_cast<int16_t>(linked_.code[i].d);
    return linked_.code[static_cast<size_t>(target)];
  }

  // Makes an operation on ints the one that also executes the kIfLocal after it.
  static void FuseIf(uint16_t& op) {
    if (op >= kIntOpEnd) return;
    const auto variant = static_cast<uint16_t>(op % kIntVariantCount);
    for (const auto& [plain, fused] : {std::pair{kVariantLL, kVariantLLIf},
                                       {kVariantLK, kVariantLKIf},
                                       {kVariantEK, kVariantEKIf},
                                       {kVariantGKToL, kVariantGKToLIf}}) {
      if (variant == plain) op = static_cast<uint16_t>(op - plain + fused);
    }
  }

  // Combines the last statement of a loop, `s = s + x` or `a[i] = x`, with the increment and the
  // goto that follow.
  void FuseLastOfLoops() {
    auto& code = linked_.code;
    for (size_t i = 0; i + 1 < code.size(); ++i) {
      uint16_t& op = code[i].op;
      if (code[i].a != code[i].d && op != kCopyIntLE) continue;
      switch (code[i + 1].op) {
#define FUSE_LAST(test)                                       \
  case kIncrementLoop##test:                                  \
    if (op == kIntAddLL) op = kAccumulateIntLoop##test;       \
    if (op == kIntAddGL) op = kAccumulateGlobalLoop##test;    \
    if (op == kDoubleAddLL) op = kAccumulateDoubleLoop##test; \
    if (op == kCopyIntLE) op = kStoreIntLoop##test;           \
    break;
#define COMPARE(name, value) FUSE_LAST(name##LL) FUSE_LAST(name##LK)
#include "vm/handlers.def"
#undef FUSE_LAST
        default:
          break;
      }
    }
  }

  // Combines two copies, and two operations of one expression, unless one of them is already
  // combined with others.
  void FusePairs() {
    auto& code = linked_.code;
    for (size_t i = 0; i + 1 < code.size(); ++i) {
      Code& first = code[i];
      Code& second = code[i + 1];
      if (first.op == second.op && first.op == kCopyIntL) {
        first.op = kCopyIntTwice;
      } else if (first.op == second.op && first.op == kCopyDoubleL) {
        first.op = kCopyDoubleTwice;
      } else if (second.a != first.d && second.b == first.d && Commutes(second.op)) {
        std::swap(second.a, second.b);
      }
      FuseExpression(first, second);
    }
  }

  // True when the operation is on two local slots and computes the same with its operands
  // exchanged.
  static bool Commutes(uint16_t op) {
    switch (op) {
      case kIntAddLL:
      case kIntMultiplyLL:
      case kIntAndLL:
      case kIntOrLL:
      case kIntXorLL:
      case kDoubleAddLL:
      case kDoubleMultiplyLL:
        return true;
      default:
        return false;
    }
  }

  static void FuseExpression(Code& first, const Code& second) {
    // The subtractions whose operand b is the first operation's target.
    constexpr uint16_t kIntFromLR = kDecodedOpCount;
    constexpr uint16_t kDoubleFromLR = kIntFromLR + 1;
    uint16_t op = second.op;
    if (second.a != first.d) {
      if (second.b != first.d) return;
      if (op != kIntSubtractLL && op != kDoubleSubtractLL) return;
      op = op == kIntSubtractLL ? kIntFromLR : kDoubleFromLR;
    }
    switch (uint32_t{first.op} << 16 | op) {
#define PAIR(type, left, form, right, operand)                           \
  case uint32_t{k##type##left##form} << 16 | k##type##right##L##operand: \
    first.op = k##type##left##form##Then##right##operand;                \
    break;
      ONCARD_PAIRS(PAIR)
#undef PAIR
      default:
        break;
    }
  }

  const Object& object_;
  const Function& function_;
  const CommandTable& commands_;
  ImageFunction linked_;
  std::map<int64_t, size_t> constant_index_;
  std::map<std::array<uint16_t, 5>, size_t> element_index_;
};

// The object's code and storage without names and lines: neither a new comment nor a renamed
// variable makes it a different program.
uint64_t HashProgram(const Object& object) {
  std::string bytes = WriteObject(object, true).bin;
  bytes.push_back(static_cast<char>(object.double_format));
  return XXH64(bytes.data(), bytes.size(), 0);
}

const Symbol* FindSymbol(const std::vector<Symbol>& symbols, std::string_view name) {
  const auto found = std::find_if(symbols.begin(), symbols.end(),
                                  [&](const Symbol& symbol) { return symbol.name == name; });
  return found == symbols.end() ? nullptr : &*found;
}

}  // namespace

Result<std::shared_ptr<const Image>> LinkObject(Object object, const CommandTable& commands,
                                                Symbols symbols) {
  if (auto verified = Verify(object, commands, symbols); !verified.ok()) return verified.error();
  auto image = std::make_shared<Image>();
  for (const Function& function : object.functions) {
    auto linked = FunctionLinker(object, function, commands).Link();
    if (!linked.ok()) return linked.error();
    image->functions.push_back(std::move(linked).value());
  }
  image->hash = HashProgram(object);
  image->object = std::move(object);
  return std::shared_ptr<const Image>(std::move(image));
}

int FindFunction(const Image& image, std::string_view name) {
  const auto& functions = image.object.functions;
  for (size_t i = 0; i < functions.size(); ++i) {
    if (functions[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

const Symbol* FindGlobal(const Image& image, std::string_view name) {
  return FindSymbol(image.object.globals, name);
}

const Symbol* FindLocal(const Image& image, int function, std::string_view name) {
  return FindSymbol(image.object.functions[static_cast<size_t>(function)].variables, name);
}

}  // namespace oncard::vm
