// A record is `len word[len] k link[k]`: word[0] is the opcode, the other words are its operands;
// bit n of link[0] says that operand n is a variable, and the following links give the storage of
// each flagged operand. Encoding and decoding use the same table of fields, so that one reads what
// the other writes. docs/object-format.md shows the bytes.
// Tested by tests/vm/record_test.cc.
#include "vm/record.h"

#include <optional>

#include "vm/limits.h"
#include "vm/object_error.h"

namespace oncard::vm {
namespace {

// The meaning of the words after the opcode. Each field is one operand of the link mask; kArguments
// is one operand per argument.
enum class Field : uint8_t {
  kNumber,        // of an operator or a command
  kType,          // data type of the operands
  kValue,         // literal or variable
  kTarget,        // variable
  kCondition,     // variable, or the one-word constant 1
  kDisplacement,  // of a jump
  kArguments,     // values up to the end of the record
};

constexpr Field kUnaryFields[] = {Field::kNumber, Field::kValue, Field::kType, Field::kTarget};
constexpr Field kBinaryFields[] = {Field::kNumber, Field::kValue, Field::kValue, Field::kType,
                                   Field::kTarget};
constexpr Field kJumpFields[] = {Field::kCondition, Field::kDisplacement};
constexpr Field kReturnFields[] = {Field::kCondition, Field::kValue};
constexpr Field kCommandFields[] = {Field::kNumber, Field::kArguments};

std::span<const Field> FieldsOf(Opcode opcode) {
  switch (opcode) {
    case Opcode::kUnary:
      return kUnaryFields;
    case Opcode::kBinary:
      return kBinaryFields;
    case Opcode::kJump:
      return kJumpFields;
    case Opcode::kReturn:
      return kReturnFields;
    case Opcode::kCommand:
      return kCommandFields;
  }
  return {};
}

// Storage classes: the low digit is that of the variable or the array; for an element with a
// variable index, the high digit is that of the index variable.
constexpr int kIndexStorageShift = 4;

constexpr bool IsStorage(int digit) {
  return digit == static_cast<int>(Storage::kLocal) || digit == static_cast<int>(Storage::kGlobal);
}

class RecordEncoder {
 public:
  std::vector<uint16_t> Encode(const Instruction& instruction) {
    words_.push_back(static_cast<uint16_t>(instruction.opcode));
    auto operand = instruction.operands.begin();
    for (const Field field : FieldsOf(instruction.opcode)) {
      switch (field) {
        case Field::kNumber:
          AddWord(instruction.op);
          break;
        case Field::kType:
          AddWord(static_cast<uint16_t>(instruction.type));
          break;
        case Field::kDisplacement:
          AddWord(static_cast<uint16_t>(instruction.displacement));
          break;
        case Field::kCondition:
          AddCondition(*operand++);
          break;
        case Field::kValue:
        case Field::kTarget:
          AddValue(*operand++);
          break;
        case Field::kArguments:
          while (operand != instruction.operands.end()) AddValue(*operand++);
          break;
      }
    }
    std::vector<uint16_t> record;
    record.reserve(words_.size() + links_.size() + 3);
    record.push_back(static_cast<uint16_t>(words_.size()));
    record.insert(record.end(), words_.begin(), words_.end());
    record.push_back(static_cast<uint16_t>(1 + links_.size()));
    record.push_back(static_cast<uint16_t>(mask_));
    record.insert(record.end(), links_.begin(), links_.end());
    return record;
  }

 private:
  void AddWord(uint16_t word) {
    words_.push_back(word);
    ++operand_count_;
  }

  void AddFlaggedWord(uint16_t word, int storage_class) {
    mask_ |= 1u << operand_count_;
    links_.push_back(static_cast<uint16_t>(storage_class));
    AddWord(word);
  }

  void AddReference(const Operand& operand) {
    if (const auto* variable = std::get_if<Variable>(&operand)) {
      AddFlaggedWord(variable->id, static_cast<int>(variable->storage));
    } else if (const auto* element = std::get_if<Element>(&operand)) {
      AddFlaggedWord(element->base,
                     static_cast<int>(element->storage) | static_cast<int>(element->index.storage)
                                                              << kIndexStorageShift);
      links_.push_back(element->size);
      links_.push_back(element->index.id);
    }
  }

  void AddCondition(const Operand& operand) {
    if (const auto* literal = std::get_if<Immediate>(&operand)) {
      AddWord(static_cast<uint16_t>(literal->raw >> kFractionBits));
    } else {
      AddReference(operand);
    }
  }

  void AddValue(const Operand& operand) {
    if (const auto* literal = std::get_if<Immediate>(&operand)) {
      words_.push_back(static_cast<uint16_t>(literal->raw >> kFractionBits));
      words_.push_back(static_cast<uint16_t>(literal->raw >> 2 * kFractionBits));
      AddWord(static_cast<uint16_t>(literal->raw));
    } else {
      AddReference(operand);
    }
  }

  std::vector<uint16_t> words_;
  std::vector<uint16_t> links_;
  unsigned mask_ = 0;
  int operand_count_ = 0;
};

// Keeps the first error; after it, every read returns 0.
class RecordDecoder {
 public:
  RecordDecoder(std::span<const uint16_t> words, std::span<const uint16_t> links)
      : words_(words), mask_(links[0]), links_(links.subspan(1)) {}

  Result<Instruction> Decode() {
    instruction_.opcode = static_cast<Opcode>(NextWord());
    const std::span<const Field> fields = FieldsOf(instruction_.opcode);
    if (!error_ && fields.empty()) {
      Fail("opcode 0x{0:04x} is not known", "未知的操作码 0x{0:04x}",
           static_cast<uint16_t>(instruction_.opcode));
    }
    for (const Field field : fields) {
      if (field == Field::kArguments) {
        while (!error_ && !words_.empty()) DecodeField(Field::kValue);
      } else {
        DecodeField(field);
      }
    }
    CheckEnd();
    if (error_) return *error_;
    return std::move(instruction_);
  }

 private:
  void DecodeField(Field field) {
    if (error_) return;
    // The mask has one bit per operand, so a record cannot have more operands.
    if (operand_ > kCommandArgumentMax) {
      Fail("a command has more than {0} arguments", "指令的参数超过 {0} 个", kCommandArgumentMax);
      return;
    }
    const bool flagged = (mask_ >> operand_ & 1) != 0;
    switch (field) {
      case Field::kNumber:
        instruction_.op = ConstantWord(flagged);
        break;
      case Field::kType:
        DecodeType(ConstantWord(flagged));
        break;
      case Field::kDisplacement:
        instruction_.displacement = static_cast<int16_t>(ConstantWord(flagged));
        break;
      case Field::kCondition:
        instruction_.operands.push_back(flagged ? NextReference()
                                                : Operand(ImmediateInt(NextWord())));
        break;
      case Field::kTarget:
        if (!flagged) Fail("operand {0} is not a variable", "操作数 {0} 不是变量", operand_);
        [[fallthrough]];
      case Field::kValue:
        instruction_.operands.push_back(flagged ? NextReference() : NextLiteral());
        break;
      case Field::kArguments:
        break;
    }
    ++operand_;
  }

  uint16_t ConstantWord(bool flagged) {
    if (flagged) {
      Fail("operand {0} is marked as a variable, but can only be a number",
           "操作数 {0} 被标为变量，但只能是数", operand_);
    }
    return NextWord();
  }

  void DecodeType(uint16_t type) {
    instruction_.type = static_cast<DataType>(type);
    if (instruction_.type != DataType::kInt && instruction_.type != DataType::kDouble) {
      Fail("data type {0} is not known; 1 (int) or 2 (double) is expected",
           "未知的数据类型 {0}；应为 1（int）或 2（double）", type);
    }
  }

  Operand NextLiteral() {
    const uint32_t low = NextWord();
    const uint32_t high = NextWord();
    const uint16_t fraction = NextWord();
    return Immediate{ImmediateInt(static_cast<int32_t>(low | high << 16)).raw + fraction};
  }

  Operand NextReference() {
    const uint16_t id = NextWord();
    const uint16_t storage_class = NextLink();
    if (IsStorage(storage_class)) return Variable{static_cast<Storage>(storage_class), id};
    const int array_digit = storage_class & ((1 << kIndexStorageShift) - 1);
    const int index_digit = storage_class >> kIndexStorageShift;
    if (!IsStorage(array_digit) || !IsStorage(index_digit)) {
      Fail("storage class 0x{0:x} of operand {1} is not known", "操作数 {1} 的存储类 0x{0:x} 未知",
           storage_class, operand_);
      return Immediate{};
    }
    Element element{static_cast<Storage>(array_digit), id, 0, {}};
    element.size = NextLink();
    element.index = {static_cast<Storage>(index_digit), NextLink()};
    return element;
  }

  void CheckEnd() {
    if (!words_.empty()) {
      Fail("{0} words are left over", "多出 {0} 个字", words_.size());
    } else if (!links_.empty()) {
      Fail("{0} link words are left over", "多出 {0} 个链接字", links_.size());
    } else if (mask_ >> operand_ != 0) {
      Fail("link mask 0x{0:04x} marks operands that do not exist; there are {1}",
           "链接掩码 0x{0:04x} 标记了不存在的操作数；共有 {1} 个", mask_, operand_);
    }
  }

  uint16_t NextWord() {
    return Next(words_, "the record ends within operand {0}", "记录在操作数 {0} 处中断");
  }
  uint16_t NextLink() {
    return Next(links_, "the links end at operand {0}", "链接字在操作数 {0} 处中断");
  }

  uint16_t Next(std::span<const uint16_t>& from, std::string_view en, std::string_view zh) {
    if (error_) return 0;
    if (from.empty()) {
      Fail(en, zh, operand_);
      return 0;
    }
    const uint16_t word = from.front();
    from = from.subspan(1);
    return word;
  }

  template <typename... Args>
  void Fail(std::string_view en, std::string_view zh, const Args&... args) {
    if (!error_) error_ = DamagedObject(en, zh, args...);
  }

  std::span<const uint16_t> words_;
  unsigned mask_;
  std::span<const uint16_t> links_;
  int operand_ = 0;
  Instruction instruction_;
  std::optional<Error> error_;
};

}  // namespace

std::vector<uint16_t> EncodeRecord(const Instruction& instruction) {
  return RecordEncoder().Encode(instruction);
}

Result<DecodedRecord> DecodeRecord(std::span<const uint16_t> words) {
  const Error cut_off = DamagedObject("the record is truncated", "记录被截断");
  if (words.empty()) return cut_off;
  const size_t length = words[0];
  if (length == 0) return DamagedObject("the record is empty", "记录为空");
  if (words.size() < length + 2) return cut_off;
  const size_t link_count = words[length + 1];
  if (link_count == 0) return DamagedObject("the record has no link mask", "记录没有链接掩码");
  const size_t word_count = length + 2 + link_count;
  if (words.size() < word_count) return cut_off;
  Result<Instruction> instruction =
      RecordDecoder(words.subspan(1, length), words.subspan(length + 2, link_count)).Decode();
  if (!instruction.ok()) return instruction.error();
  return DecodedRecord{std::move(instruction).value(), word_count};
}

}  // namespace oncard::vm
