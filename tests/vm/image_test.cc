// However the linker encodes a statement, and whichever neighbours it fuses, the program computes
// the same as on the reference machine after every statement.
#include "vm/image.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/vm/program_builder.h"
#include "tests/vm/reference_machine.h"

namespace oncard::vm {
namespace {

// --- Operators -----------------------------------------------------------------------------------

// The place of an operand of the tested statement.
enum class Shape {
  kLiteral,
  kLocal,
  kGlobal,
  kLocalElement,
  kLocalElementByGlobal,
  kGlobalElement,
  kGlobalElementByGlobal
};
constexpr Shape kShapes[] = {Shape::kLiteral,
                             Shape::kLocal,
                             Shape::kGlobal,
                             Shape::kLocalElement,
                             Shape::kLocalElementByGlobal,
                             Shape::kGlobalElement,
                             Shape::kGlobalElementByGlobal};

// The operand is in slots 8 * position .. 8 * position + 3 of either storage; the index is local or
// global slot 0, which is 2.
Operand Place(Shape shape, uint16_t position, const Operand& literal) {
  const auto base = static_cast<uint16_t>(8 * position);
  switch (shape) {
    case Shape::kLiteral:
      return literal;
    case Shape::kLocal:
      return Local(base);
    case Shape::kGlobal:
      return Global(base);
    case Shape::kLocalElement:
      return Element{Storage::kLocal, base, 4, Local(0)};
    case Shape::kLocalElementByGlobal:
      return Element{Storage::kLocal, base, 4, Global(0)};
    case Shape::kGlobalElement:
      return Element{Storage::kGlobal, base, 4, Local(0)};
    case Shape::kGlobalElementByGlobal:
      return Element{Storage::kGlobal, base, 4, Global(0)};
  }
  return literal;
}

std::vector<Operand> EdgeValues(DataType type, DoubleFormat format) {
  if (type == DataType::kInt) {
    std::vector<Operand> values;
    for (const int32_t value : {0, 1, -1, 2, -7, 31, 32, 33, 46341, INT32_MAX, INT32_MIN}) {
      values.push_back(ImmediateInt(value));
    }
    return values;
  }
  const int64_t max =
      format == DoubleFormat::k32_16 ? 0x7FFFFFFFFFFF : 0x7FFFFFFF;  // 48 and 32 bits
  return {Raw(0),     Raw(1),        Raw(-1),  Raw(65536),   Raw(-65536),
          Raw(98304), Raw(-0x18001), Raw(max), Raw(max - 1), Raw(-max - 1)};
}

// Copies values to the operands, applies the operator, and stores each result in a separate slot.
class OperatorProgram {
 public:
  // `shared_statements` are added after each result.
  OperatorProgram(const OperatorInfo& info, DataType type, int shared_statements)
      : info_(info), type_(type), shared_statements_(shared_statements) {}

  void AddUnary(Shape source, Shape target, const Operand& a) {
    Assign(source, 1, a);
    code_.push_back(Unary(static_cast<UnaryOperator>(info_.number), type_, Place(source, 1, a),
                          Place(target, 3, a)));
    Keep(target);
  }

  void AddBinary(Shape left, Shape right, Shape target, const Operand& a, const Operand& b) {
    Assign(left, 1, a);
    Assign(right, 2, b);
    code_.push_back(Binary(static_cast<BinaryOperator>(info_.number), type_, Place(left, 1, a),
                           Place(right, 2, b), Place(target, 3, a)));
    Keep(target);
  }

  std::vector<Instruction> TakeCode() { return std::move(code_); }

 private:
  void Assign(Shape shape, uint16_t position, const Operand& value) {
    if (shape == Shape::kLiteral) return;
    code_.push_back(Unary(UnaryOperator::kCopy, type_, value, Place(shape, position, value)));
  }

  void Keep(Shape target) {
    constexpr uint16_t kFirstResult = 100;
    code_.push_back(Unary(UnaryOperator::kCopy, ResultOf(info_, type_),
                          Place(target, 3, ImmediateInt(0)),
                          Local(static_cast<uint16_t>(kFirstResult + kept_++))));
    for (int i = 0; i < shared_statements_; ++i) {
      code_.push_back(Set(Global(60), ImmediateInt(kept_)));
    }
  }

  const OperatorInfo& info_;
  DataType type_;
  int shared_statements_;
  std::vector<Instruction> code_;
  int kept_ = 0;
};

// Runs one function on the given number of threads of both machines.
testing::AssertionResult SameResults(std::vector<Instruction> code, DoubleFormat format,
                                     size_t threads, int64_t statements) {
  Object object = MakeObject({MakeFunction(std::move(code))});
  object.double_format = format;
  ThreadCommands commands;
  Machine machine(&commands);
  machine.Load(LinkRecords(object, commands));
  ReferenceMachine reference(object, 1);
  machine.WriteRaw({true, 0, 0}, 2);
  reference.globals[0] = 2;
  for (size_t i = 0; i < threads; ++i) {
    const int thread = static_cast<int>(i);
    machine.WriteRaw({false, static_cast<uint8_t>(i), 0}, 2);
    reference.pages[i][0] = 2;
    reference.Bind(i, 0, i);
    reference.Start(i);
    if (machine.Bind(thread, 1, thread) != kOk || machine.Run(thread) != kOk) {
      return testing::AssertionFailure();
    }
  }
  reference.Execute(statements);
  if (machine.Execute(statements) != statements) return testing::AssertionFailure() << "stopped";
  const std::string difference = reference.Difference(machine);
  if (!difference.empty()) return testing::AssertionFailure() << difference;
  return testing::AssertionSuccess();
}

struct OperatorCase {
  const OperatorInfo* info;
  bool unary;
};

std::vector<OperatorCase> AllOperators() {
  std::vector<OperatorCase> all;
  for (uint16_t number = 1; FindUnaryOperator(number) != nullptr; ++number) {
    all.push_back({FindUnaryOperator(number), true});
  }
  for (uint16_t number = 1; FindBinaryOperator(number) != nullptr; ++number) {
    all.push_back({FindBinaryOperator(number), false});
  }
  return all;
}

// How the tested statements are executed: one after the other by one thread, or by two threads in
// turn and among so many shared statements that the machine changes the thread after each one.
enum class Execution { kOneThread, kRotation };

testing::AssertionResult SameResults(std::vector<Instruction> code, DoubleFormat format,
                                     Execution execution) {
  const auto size = static_cast<int64_t>(code.size());
  if (execution == Execution::kOneThread) return SameResults(std::move(code), format, 1, size);
  code.push_back(Goto(static_cast<int16_t>(-size)));
  // The machine begins to rotate when it has seen 1024 rounds.
  return SameResults(std::move(code), format, 2, 2 * (1024 + size));
}

int SharedStatements(Execution execution) { return execution == Execution::kRotation ? 2 : 0; }

class OperatorsTest : public testing::TestWithParam<OperatorCase> {
 protected:
  void Check(Execution execution) {
    for (const DataType type : {DataType::kInt, DataType::kDouble}) {
      if (!Accepts(*GetParam().info, type)) continue;
      for (const DoubleFormat format : {DoubleFormat::k32_16, DoubleFormat::k16_16}) {
        // For ints, the format only affects their conversion to double.
        if (GetParam().unary) {
          CheckUnary(type, format, execution);
        } else if (type == DataType::kDouble || format == DoubleFormat::k32_16) {
          CheckBinary(type, format, execution);
        }
      }
    }
  }

 private:
  void CheckUnary(DataType type, DoubleFormat format, Execution execution) {
    for (const Shape source : kShapes) {
      for (const Shape target : kShapes) {
        if (target == Shape::kLiteral) continue;
        OperatorProgram program(*GetParam().info, type, SharedStatements(execution));
        for (const Operand& a : EdgeValues(type, format)) program.AddUnary(source, target, a);
        ASSERT_TRUE(SameResults(program.TakeCode(), format, execution))
            << static_cast<int>(source) << ' ' << static_cast<int>(target);
      }
    }
  }

  void CheckBinary(DataType type, DoubleFormat format, Execution execution) {
    for (const Shape left : kShapes) {
      for (const Shape right : kShapes) {
        for (const Shape target : kShapes) {
          if (target == Shape::kLiteral) continue;
          const BinaryShapes shapes{left, right, target};
          ASSERT_TRUE(SameResults(BinaryCode(shapes, type, format, execution), format, execution))
              << static_cast<int>(left) << ' ' << static_cast<int>(right) << ' '
              << static_cast<int>(target);
        }
      }
    }
  }

  struct BinaryShapes {
    Shape left, right, target;
  };

  std::vector<Instruction> BinaryCode(const BinaryShapes& shapes, DataType type,
                                      DoubleFormat format, Execution execution) {
    const OperatorInfo& info = *GetParam().info;
    const bool divides = info.spelling == "/" || info.spelling == "%";
    OperatorProgram program(info, type, SharedStatements(execution));
    for (const Operand& a : EdgeValues(type, format)) {
      for (const Operand& b : EdgeValues(type, format)) {
        if (divides && std::get<Immediate>(b).raw == 0) continue;
        program.AddBinary(shapes.left, shapes.right, shapes.target, a, b);
      }
    }
    return program.TakeCode();
  }
};

TEST_P(OperatorsTest, ComputeTheSameWithEveryKindOfOperand) { Check(Execution::kOneThread); }

TEST_P(OperatorsTest, ComputeTheSameWhereThreadsChangeAfterEveryStatement) {
  Check(Execution::kRotation);
}

INSTANTIATE_TEST_SUITE_P(All, OperatorsTest, testing::ValuesIn(AllOperators()));

// --- Pairs ---------------------------------------------------------------------------------------

// The slots of a pair of statements: the first one computes kFirst from kLeft and kRight.
constexpr Variable kLeft = Local(1);
constexpr Variable kRight = Local(2);
constexpr Variable kFirst = Local(3);
constexpr Variable kOther = Local(4);

// Executes `budget` statements and then the rest on both machines. `values` are those of kLeft,
// kRight and kOther.
testing::AssertionResult SamePair(const Object& object, const std::shared_ptr<const Image>& image,
                                  int64_t budget, std::array<int64_t, 3> values) {
  ThreadCommands commands;
  Machine machine(&commands);
  machine.Load(image);
  ReferenceMachine reference(object, 1);
  for (size_t i = 0; i < values.size(); ++i) {
    const uint16_t slot = std::array{kLeft.id, kRight.id, kOther.id}[i];
    machine.WriteRaw({false, 0, slot}, values[i]);
    reference.pages[0][slot] = values[i];
  }
  reference.Bind(0, 0, 0);
  reference.Start(0);
  machine.Bind(0, 1, 0);
  machine.Run(0);
  for (const int64_t piece : {budget, int64_t{9}}) {
    reference.Execute(piece);
    machine.Execute(piece);
    const std::string difference = reference.Difference(machine);
    if (!difference.empty()) return testing::AssertionFailure() << difference;
  }
  return testing::AssertionSuccess();
}

// A jump to one of the statements, the statements, a return.
testing::AssertionResult SamePairs(const Instruction& first, const Instruction& second,
                                   DataType type) {
  const ThreadCommands commands;
  for (const int16_t entry : {int16_t{1}, int16_t{2}}) {
    const Object object =
        MakeObject({MakeFunction({Goto(entry), first, second, Return(kAlways, ImmediateInt(0))})});
    const auto image = LinkRecords(object, commands);
    for (const int64_t budget : {2, 3}) {
      const auto same = SamePair(object, image, budget, {-70001, 65537, 6});
      if (!same) {
        return testing::AssertionFailure()
               << same.message() << " entered at " << entry << ", budget " << budget
               << (type == DataType::kInt ? ", int" : ", double");
      }
    }
  }
  return testing::AssertionSuccess();
}

// The second statement in every relation to the first one: with its result on the left, on the
// right, on both sides, with a literal, with the same target or another one, and without it.
std::vector<Instruction> SecondStatements(BinaryOperator op, DataType type,
                                          const Operand& literal) {
  return {Binary(op, type, kFirst, kOther, kFirst), Binary(op, type, kOther, kFirst, kFirst),
          Binary(op, type, kFirst, kOther, kOther), Binary(op, type, kOther, kFirst, kOther),
          Binary(op, type, kFirst, kFirst, kLeft),  Binary(op, type, kFirst, literal, kFirst),
          Binary(op, type, kFirst, literal, kLeft), Binary(op, type, literal, kFirst, kFirst),
          Binary(op, type, kFirst, kRight, kRight), Binary(op, type, kLeft, kRight, kOther),
          Binary(op, type, kOther, literal, kOther)};
}

TEST(PairsTest, ComputeAsTwoStatementsWhereverTheyAreEnteredAndHoweverManyAreAllowed) {
  for (const DataType type : {DataType::kInt, DataType::kDouble}) {
    const Operand literal = type == DataType::kInt ? Operand(ImmediateInt(5)) : Raw(98304);
    for (const OperatorInfo& info : BinaryOperators()) {
      if (!Accepts(info, type)) continue;
      const auto op = static_cast<BinaryOperator>(info.number);
      for (const OperatorInfo& second_info : BinaryOperators()) {
        if (!Accepts(second_info, type)) continue;
        const auto second_op = static_cast<BinaryOperator>(second_info.number);
        for (const Instruction& second : SecondStatements(second_op, type, literal)) {
          for (const Operand& right : {Operand(kRight), literal}) {
            ASSERT_TRUE(SamePairs(Binary(op, type, kLeft, right, kFirst), second, type))
                << info.spelling << ' ' << second_info.spelling;
          }
        }
      }
    }
  }
}

TEST(PairsTest, CopyTwiceInTheirOrder) {
  for (const DataType type : {DataType::kInt, DataType::kDouble}) {
    const auto copy = [&](const Operand& from, const Operand& to) {
      return Unary(UnaryOperator::kCopy, type, from, to);
    };
    EXPECT_TRUE(SamePairs(copy(kLeft, kRight), copy(kOther, kLeft), type));
    EXPECT_TRUE(SamePairs(copy(kLeft, kRight), copy(kRight, kOther), type));
    EXPECT_TRUE(SamePairs(copy(kLeft, kRight), copy(kRight, kLeft), type));
    EXPECT_TRUE(SamePairs(copy(kLeft, kRight), copy(kOther, kRight), type));
  }
}

// --- Loops ---------------------------------------------------------------------------------------

// The statement of a loop before its increment.
enum class Body { kNothing, kSumInt, kSumGlobal, kSumDouble, kStore, kStoreThenSum, kTestInside };
// The step of a loop, and where its comparison is.
enum class Step { kLiteral, kVariable, kLiteralBeforeTest };
constexpr Body kBodies[] = {Body::kNothing, Body::kSumInt,       Body::kSumGlobal, Body::kSumDouble,
                            Body::kStore,   Body::kStoreThenSum, Body::kTestInside};

constexpr Variable kI = Local(1);
constexpr Variable kCondition = Local(2);
constexpr Variable kBound = Local(3);
constexpr Variable kSum = Local(4);
constexpr Variable kStep = Local(5);

// goto entry; loop: cc = i REL n; if (cc) goto end; BODY; i = i + 1; goto loop; end: return sum;
// `entry` is the statement of the loop that is executed first.
// With kLiteralBeforeTest, the loop ends with: i = i + 1; cc = i REL n; if (cc) goto body; goto
// loop.
std::vector<Instruction> Loop(BinaryOperator relation, bool literal_bound, Body body, Step step,
                              int16_t entry) {
  std::vector<Instruction> code;
  code.push_back(Goto(static_cast<int16_t>(entry + 1)));
  code.push_back(Binary(relation, DataType::kInt, kI,
                        literal_bound ? Operand(ImmediateInt(3)) : Operand(kBound), kCondition));
  code.push_back(Jump(kCondition, 0));
  const Element element{Storage::kLocal, 32, 4, kI};
  const Instruction store = Set(element, kSum);
  switch (body) {
    case Body::kNothing:
      break;
    case Body::kSumInt:
      code.push_back(Add(kSum, kSum, kI));
      break;
    case Body::kSumGlobal:
      code.push_back(Add(Global(4), Global(4), kI));
      break;
    case Body::kSumDouble:
      code.push_back(Binary(BinaryOperator::kAdd, DataType::kDouble, Local(8), Local(9), Local(8)));
      break;
    case Body::kStore:
      code.push_back(store);
      break;
    case Body::kStoreThenSum:
      code.push_back(store);
      code.push_back(Binary(BinaryOperator::kAdd, DataType::kInt, kSum, element, kSum));
      break;
    case Body::kTestInside:
      code.push_back(Binary(BinaryOperator::kAnd, DataType::kInt, kI, ImmediateInt(1), kCondition));
      code.push_back(Jump(kCondition, 2));
      code.push_back(Add(kSum, kSum, kI));
      break;
  }
  code.push_back(Add(kI, kI, step == Step::kVariable ? Operand(kStep) : ImmediateInt(1)));
  if (step == Step::kLiteralBeforeTest) {
    code.push_back(code[1]);
    code.push_back(Jump(kCondition, static_cast<int16_t>(3 - static_cast<int>(code.size()))));
  }
  code.push_back(Goto(static_cast<int16_t>(1 - static_cast<int>(code.size()))));
  code[2].displacement = static_cast<int16_t>(code.size() - 2);
  code.push_back(Return(kAlways, kSum));
  return code;
}

// Executes `budget` statements of the loop on `threads` threads of both machines, then 40 more.
testing::AssertionResult SameLoop(const Object& object, const std::shared_ptr<const Image>& image,
                                  int threads, int64_t budget) {
  ThreadCommands commands;
  Machine machine(&commands);
  machine.Load(image);
  ReferenceMachine reference(object, 1);
  for (size_t thread = 0; thread < static_cast<size_t>(threads); ++thread) {
    // The second thread begins with another i, so that the two leave the loop at different times.
    const std::pair<uint16_t, int64_t> values[] = {{kI.id, static_cast<int64_t>(thread)},
                                                   {kBound.id, 3},
                                                   {kSum.id, 100},
                                                   {kStep.id, 1},
                                                   {8, 5},
                                                   {9, 70000}};
    for (const auto& [id, value] : values) {
      machine.WriteRaw({false, static_cast<uint8_t>(thread), id}, value);
      reference.pages[thread][id] = value;
    }
    reference.Bind(thread, 0, thread);
    reference.Start(thread);
    machine.Bind(static_cast<int>(thread), 1, static_cast<int>(thread));
    machine.Run(static_cast<int>(thread));
  }
  for (const int64_t piece : {budget, int64_t{40}}) {
    reference.Execute(piece);
    machine.Execute(piece);
    const std::string difference = reference.Difference(machine);
    if (!difference.empty()) return testing::AssertionFailure() << difference;
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult SameWithEveryBudget(std::vector<Instruction> loop) {
  const ThreadCommands commands;
  const Object object = MakeObject({MakeFunction(std::move(loop))});
  const auto image = LinkRecords(object, commands);
  for (int64_t budget = 1; budget <= 20; ++budget) {
    const auto same = SameLoop(object, image, 1, budget);
    if (!same) return testing::AssertionFailure() << same.message() << ", budget " << budget;
  }
  for (const int64_t budget : {8, 9, 23}) {
    const auto same = SameLoop(object, image, 2, budget);
    if (!same) return testing::AssertionFailure() << same.message() << ", two, budget " << budget;
  }
  return testing::AssertionSuccess();
}

class LoopsTest : public testing::TestWithParam<BinaryOperator> {};

TEST_P(LoopsTest, StopExactlyWhereTheBudgetEndsWhereverTheyAreEntered) {
  for (const bool literal_bound : {false, true}) {
    for (const Body body : kBodies) {
      for (const Step step : {Step::kLiteral, Step::kVariable, Step::kLiteralBeforeTest}) {
        const auto size = Loop(GetParam(), literal_bound, body, step, 0).size();
        for (int16_t entry = 0; entry + 1 < static_cast<int16_t>(size); ++entry) {
          ASSERT_TRUE(SameWithEveryBudget(Loop(GetParam(), literal_bound, body, step, entry)))
              << static_cast<int>(body) << ", step " << static_cast<int>(step) << ", entered at "
              << entry;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Relations, LoopsTest,
                         testing::Values(BinaryOperator::kEqual, BinaryOperator::kNotEqual,
                                         BinaryOperator::kLess, BinaryOperator::kGreater,
                                         BinaryOperator::kLessEqual,
                                         BinaryOperator::kGreaterEqual));

// --- The image -----------------------------------------------------------------------------------

TEST(ImageTest, KeepsOneCodePerInstructionAndTheEnd) {
  const ThreadCommands commands;
  const auto image = LinkRecords(SumObject(), commands);
  ASSERT_EQ(image->functions.size(), 1u);
  EXPECT_EQ(image->functions[0].code.size(), 7u + 1);
  EXPECT_EQ(image->object, SumObject());
}

TEST(ImageTest, FindsFunctionsAndVariablesByName) {
  const FakeCommands commands;
  const auto image = LinkObject(ArrayObject(), commands);
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(FindFunction(*image.value(), "work"), 0);
  EXPECT_EQ(FindFunction(*image.value(), "nothing"), 1);
  EXPECT_EQ(FindFunction(*image.value(), "Work"), -1);
  ASSERT_NE(FindGlobal(*image.value(), "pos"), nullptr);
  EXPECT_EQ(FindGlobal(*image.value(), "pos")->id, 9);
  EXPECT_EQ(FindGlobal(*image.value(), "a"), nullptr);
  ASSERT_NE(FindLocal(*image.value(), 0, "a"), nullptr);
  EXPECT_EQ(FindLocal(*image.value(), 0, "a")->array_size, 5);
  EXPECT_EQ(FindLocal(*image.value(), 1, "a"), nullptr);
}

TEST(ImageTest, RefusesWhatTheVerifierRefuses) {
  const ThreadCommands commands;
  const Object object = MakeObject({MakeFunction({Goto(1)})});
  const auto image = LinkObject(object, commands, Symbols::kAbsent);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, 2008);
}

TEST(ImageTest, RefusesMoreDistinctLiteralsThanInstructionsCanNumber) {
  const ThreadCommands commands;
  std::vector<Instruction> code;
  for (int32_t i = 0; i < 16384; ++i) code.push_back(Set(Local(0), ImmediateInt(i)));
  EXPECT_NE(LinkRecords(MakeObject({MakeFunction(code)}), commands), nullptr);
  code.push_back(Set(Local(0), ImmediateInt(-1)));
  const auto image = LinkObject(MakeObject({MakeFunction(code)}), commands, Symbols::kAbsent);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, 2008);
}

TEST(ImageTest, HashDependsOnWhatTheProgramDoesOnly) {
  const ThreadCommands commands;
  const Object original = SumObject();
  const uint64_t hash = LinkRecords(original, commands)->hash;

  Object renamed = original;
  renamed.functions[0].lines.assign(7, 1);
  renamed.functions[0].variables[0].name = "first";
  EXPECT_EQ(LinkRecords(renamed, commands)->hash, hash);

  Object narrow = original;
  narrow.double_format = DoubleFormat::k16_16;
  EXPECT_NE(LinkRecords(narrow, commands)->hash, hash);

  Object changed = original;
  changed.functions[0].instructions[4].operands[1] = ImmediateInt(2);
  EXPECT_NE(LinkRecords(changed, commands)->hash, hash);
}

}  // namespace
}  // namespace oncard::vm
