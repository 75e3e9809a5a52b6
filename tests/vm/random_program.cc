// Local and global slots 0..5 are ints, 6 and 7 ints that usually index arrays, 8..11 doubles,
// 16..23 an array of ints, 24..31 an array of doubles. Sometimes an operand is a slot of the other
// type, as when functions share a page.
#include "tests/vm/random_program.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "tests/vm/program_builder.h"

namespace oncard::vm {
namespace {

constexpr uint16_t kIntArray = 16;
constexpr uint16_t kDoubleArray = 24;
constexpr uint16_t kArraySize = 8;

constexpr BinaryOperator kRelations[] = {BinaryOperator::kEqual,     BinaryOperator::kNotEqual,
                                         BinaryOperator::kLess,      BinaryOperator::kGreater,
                                         BinaryOperator::kLessEqual, BinaryOperator::kGreaterEqual};

class FunctionGenerator {
 public:
  // One operand in `sharing` operands is a global.
  FunctionGenerator(RandomNumbers& random, int64_t sharing) : random_(random), sharing_(sharing) {}

  Function Generate() {
    return_type_ = random_.OneIn(3) ? DataType::kDouble : DataType::kInt;
    const int64_t parts = random_.Between(2, 12);
    for (int64_t i = 0; i < parts; ++i) AddPart();
    if (random_.OneIn(2)) {
      code_.push_back(Return(kAlways, Source(return_type_)));
    } else {
      AddOperation();
    }
    const auto last = static_cast<int64_t>(code_.size()) - 1;
    for (const size_t index : jumps_) {
      const int64_t target = random_.Between(0, last);
      code_[index].displacement = static_cast<int16_t>(target - static_cast<int64_t>(index));
    }
    return MakeFunction(std::move(code_), return_type_);
  }

 private:
  void AddPart() {
    switch (random_.Between(0, 11)) {
      case 0:
      case 1:
      case 2:
        AddLoop();
        break;
      case 3:
        jumps_.push_back(code_.size());
        code_.push_back(Jump(random_.OneIn(3) ? Operand(kAlways) : Operand(IntVariable()), 0));
        break;
      case 4:
        if (random_.OneIn(4)) code_.push_back(Return(IntVariable(), Source(return_type_)));
        break;
      case 5:
        AddCommand();
        break;
      default:
        AddOperation();
        break;
    }
  }

  // cc = i REL n; if (cc) goto end; ... i = i + step; goto loop;
  void AddLoop() {
    const Variable i = Local(static_cast<uint16_t>(random_.Between(0, 7)));
    const Variable cc = Local(static_cast<uint16_t>(random_.Between(0, 5)));
    const auto start = static_cast<int64_t>(code_.size());
    const Operand bound = random_.OneIn(2) ? Operand(ImmediateInt(Small()))
                                           : Operand(Local(static_cast<uint16_t>(Index())));
    code_.push_back(Binary(random_.Pick(kRelations), DataType::kInt, i, bound, cc));
    const size_t exit = code_.size();
    code_.push_back(Jump(cc, 0));
    for (int64_t body = random_.Between(0, 2); body > 0; --body) AddLoopBody(i);
    code_.push_back(Add(i, i, ImmediateInt(random_.OneIn(4) ? -1 : 1)));
    code_.push_back(Goto(static_cast<int16_t>(start - static_cast<int64_t>(code_.size()))));
    code_[exit].displacement = static_cast<int16_t>(code_.size() - exit);
  }

  void AddLoopBody(const Variable& i) {
    const Variable sum = Local(static_cast<uint16_t>(random_.Between(0, 5)));
    switch (random_.Between(0, 4)) {
      case 0:
        code_.push_back(Add(sum, sum, i));
        break;
      case 1:
        code_.push_back(Add(Global(0), Global(0), i));
        break;
      case 2:
        code_.push_back(
            Binary(BinaryOperator::kAdd, DataType::kDouble, Local(8), Local(9), Local(8)));
        break;
      case 3:
        code_.push_back(Set(Element{Storage::kLocal, kIntArray, kArraySize, i}, sum));
        break;
      default:
        AddOperation();
        break;
    }
  }

  void AddOperation() {
    const bool unary = random_.OneIn(3);
    const std::span<const OperatorInfo> rows = unary ? UnaryOperators() : BinaryOperators();
    const auto number = static_cast<uint16_t>(random_.Between(1, static_cast<int>(rows.size())));
    const OperatorInfo& info = rows[number - 1u];
    DataType type = random_.OneIn(3) ? DataType::kDouble : DataType::kInt;
    if (!Accepts(info, type)) type = type == DataType::kInt ? DataType::kDouble : DataType::kInt;
    const Operand target = Target(ResultOf(info, type));
    if (unary) {
      code_.push_back(Unary(static_cast<UnaryOperator>(number), type, Source(type), target));
    } else {
      code_.push_back(
          Binary(static_cast<BinaryOperator>(number), type, Source(type), Source(type), target));
    }
  }

  void AddCommand() {
    switch (random_.Between(0, 6)) {
      case 0:
        code_.push_back(Command(kDelay, {ImmediateInt(static_cast<int>(random_.Between(0, 2)))}));
        break;
      case 1:
        code_.push_back(Command(kWaitFor, {Global(static_cast<uint16_t>(random_.Between(0, 2))),
                                           ImmediateInt(Small())}));
        break;
      case 2:
        code_.push_back(
            Command(kUsePage, {ImmediateInt(static_cast<int>(random_.Between(-1, 33)))}));
        break;
      case 3:
        code_.push_back(Command(
            kAddToEach, {Target(DataType::kInt),
                         random_.OneIn(2) ? Operand(IntVariable()) : Operand(ImmediateInt(1)),
                         Source(DataType::kInt)}));
        break;
      case 4:
        code_.push_back(Command(kHalve, {Target(DataType::kDouble)}));
        break;
      default:
        code_.push_back(Command(kRefuse, {Target(DataType::kInt)}));
        break;
    }
  }

  Storage AnyStorage() { return random_.OneIn(sharing_) ? Storage::kGlobal : Storage::kLocal; }
  int32_t Small() { return static_cast<int32_t>(random_.Between(-2, 7)); }
  int64_t Index() { return random_.OneIn(6) ? random_.Between(0, 5) : random_.Between(6, 7); }

  Variable IntVariable() { return {AnyStorage(), static_cast<uint16_t>(random_.Between(0, 7))}; }

  Operand Target(DataType type) {
    if (random_.OneIn(60)) type = type == DataType::kInt ? DataType::kDouble : DataType::kInt;
    if (random_.OneIn(5)) {
      return Element{AnyStorage(), type == DataType::kInt ? kIntArray : kDoubleArray, kArraySize,
                     Variable{AnyStorage(), static_cast<uint16_t>(Index())}};
    }
    if (type == DataType::kDouble) {
      return Variable{AnyStorage(), static_cast<uint16_t>(random_.Between(8, 11))};
    }
    // The last two ints index arrays and are rarely overwritten.
    return Variable{AnyStorage(),
                    static_cast<uint16_t>(random_.Between(0, random_.OneIn(20) ? 7 : 5))};
  }

  Operand Source(DataType type) {
    if (!random_.OneIn(4)) return Target(type);
    if (type == DataType::kInt) return ImmediateInt(Small());
    return Raw(random_.Between(-3 * 65536, 5 * 65536));
  }

  RandomNumbers& random_;
  int64_t sharing_;
  DataType return_type_ = DataType::kInt;
  std::vector<Instruction> code_;
  std::vector<size_t> jumps_;
};

void AddValues(RandomNumbers& random, bool global, int page, RandomProgram& program) {
  for (uint16_t id = 0; id < kDoubleArray + kArraySize; ++id) {
    const bool is_double = (id >= 8 && id < 12) || id >= kDoubleArray;
    const SlotAddress slot{global, static_cast<uint8_t>(page), id, DataType::kInt};
    const int64_t raw = is_double            ? random.Between(-9 * 65536, 9 * 65536)
                        : id == 6 || id == 7 ? random.Between(0, kArraySize)
                                             : random.Between(-3, 9);
    program.values.push_back({slot, raw});
  }
}

}  // namespace

RandomProgram MakeRandomProgram(RandomNumbers& random) {
  RandomProgram program;
  constexpr int64_t kSharing[] = {2, 5, 20};
  const int64_t sharing = random.Pick(kSharing);
  const int64_t functions = random.Between(1, 4);
  for (int64_t i = 0; i < functions; ++i) {
    program.object.functions.push_back(FunctionGenerator(random, sharing).Generate());
  }
  if (random.OneIn(3)) program.object.double_format = DoubleFormat::k16_16;

  std::vector<int> threads(kThreadCount);
  std::iota(threads.begin(), threads.end(), 0);
  std::vector<int> pages = threads;
  for (size_t i = kThreadCount - 1; i > 0; --i) {
    std::swap(threads[i], threads[static_cast<size_t>(random.Between(0, static_cast<int64_t>(i)))]);
    std::swap(pages[i], pages[static_cast<size_t>(random.Between(0, static_cast<int64_t>(i)))]);
  }
  constexpr size_t kThreadCounts[] = {1, 1, 2, 2, 2, 3, 4, 7, 16, 32};
  const size_t count = random.Pick(kThreadCounts);
  AddValues(random, true, 0, program);
  for (size_t i = 0; i < count; ++i) {
    const int function = static_cast<int>(random.Between(0, functions - 1));
    program.bindings.push_back({threads[i], function, pages[i]});
    AddValues(random, false, pages[i], program);
  }
  return program;
}

void StartProgram(const RandomProgram& program, const Policy& policy, const CommandTable& commands,
                  Machine* machine) {
  machine->SetPolicy(policy);
  machine->Load(LinkRecords(program.object, commands));
  for (const auto& value : program.values) machine->WriteRaw(value.slot, value.raw);
  for (const auto& binding : program.bindings) {
    machine->Bind(binding.thread, binding.function + 1, binding.page);
    machine->Run(binding.thread);
  }
}

}  // namespace oncard::vm
