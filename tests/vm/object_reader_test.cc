#include "vm/object_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/vm/object_samples.h"
#include "vm/limits.h"
#include "vm/object_writer.h"
#include "vm/verifier.h"

namespace oncard::vm {
namespace {

// --- Round trips ---------------------------------------------------------------------------------

void ExpectRoundTrip(const Object& object, bool vendor_format) {
  const ObjectFiles files = WriteObject(object, vendor_format);
  const Result<Object> read = ReadObject(files);
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_EQ(read.value(), object);
  const Result<void> verified = Verify(read.value(), FakeCommands());
  EXPECT_TRUE(verified.ok()) << verified.error().message.en;
}

TEST(ObjectReaderTest, SamplesComeBack) {
  ExpectRoundTrip(SumObject(), false);
  ExpectRoundTrip(SumObject(), true);
  ExpectRoundTrip(ArrayObject(), false);
  ExpectRoundTrip(ArrayObject(), true);
  ExpectRoundTrip(StructureObject(), false);
}

TEST(ObjectReaderTest, VendorObjectHasWideDoubles) {
  Object object = SumObject();
  object.double_format = DoubleFormat::k16_16;
  const Result<Object> read = ReadObject(WriteObject(object, true));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value().double_format, DoubleFormat::k32_16);
}

// Random objects that obey the verifier's rules, from a seed.
class ObjectGenerator {
 public:
  explicit ObjectGenerator(uint32_t seed) : random_(seed) {}

  Object Generate() {
    Object object;
    object.double_format = Chance(2) ? DoubleFormat::k32_16 : DoubleFormat::k16_16;
    narrow_ = object.double_format == DoubleFormat::k16_16;
    object.globals = MakeSymbols("g");
    globals_ = &object.globals;
    const int count = Below(5);
    for (int i = 0; i < count; ++i) object.functions.push_back(MakeFunction(i));
    return object;
  }

 private:
  int Below(int limit) { return static_cast<int>(random_() % static_cast<uint32_t>(limit)); }
  bool Chance(int of) { return Below(of) == 0; }
  DataType AnyType() { return Chance(2) ? DataType::kInt : DataType::kDouble; }

  // Always begins with an int and a double scalar, so that every type has a variable.
  std::vector<Symbol> MakeSymbols(const std::string& prefix) {
    std::vector<Symbol> symbols = {{prefix + "_int", 0, DataType::kInt, 0},
                                   {prefix + "_double", 1, DataType::kDouble, 0}};
    int next = 2;
    const int count = Below(6);
    for (int i = 0; i < count; ++i) {
      const std::string name = fmt::format("{}{}", prefix, i);
      const auto id = static_cast<uint16_t>(next);
      if (Chance(3)) {
        symbols.push_back({name + ".a", id, AnyType(), 0});
        symbols.push_back({name + ".b", static_cast<uint16_t>(next + 1), AnyType(), 0});
        next += 2;
      } else {
        const auto size = static_cast<uint16_t>(Chance(2) ? 0 : 1 + Below(9));
        symbols.push_back({name, id, AnyType(), size});
        next += symbols.back().slots();
      }
    }
    return symbols;
  }

  Variable AnyVariable(DataType type) {
    const bool global = Chance(2);
    const std::vector<Symbol>& symbols = global ? *globals_ : *locals_;
    for (;;) {
      const Symbol& symbol = symbols[static_cast<size_t>(Below(static_cast<int>(symbols.size())))];
      if (symbol.type != type) continue;
      return {global ? Storage::kGlobal : Storage::kLocal,
              static_cast<uint16_t>(symbol.id + Below(symbol.slots()))};
    }
  }

  Operand AnyTarget(DataType type) {
    const bool global = Chance(2);
    for (const Symbol& symbol : global ? *globals_ : *locals_) {
      if (symbol.array_size == 0 || symbol.type != type || Chance(2)) continue;
      return Element{global ? Storage::kGlobal : Storage::kLocal, symbol.id, symbol.array_size,
                     AnyVariable(DataType::kInt)};
    }
    return AnyVariable(type);
  }

  Operand AnyOperand(DataType type) {
    if (!Chance(3)) return AnyTarget(type);
    if (type == DataType::kInt) return ImmediateInt(static_cast<int32_t>(random_()));
    const auto low = static_cast<int32_t>(random_());
    return Raw(narrow_ ? low : int64_t{low} * 65536 + Below(65536));
  }

  Operand AnyCondition() {
    if (Chance(2)) return ImmediateInt(1);
    return AnyVariable(DataType::kInt);
  }

  Instruction AnyInstruction(DataType return_type, int index, int count) {
    const DataType type = AnyType();
    switch (Below(5)) {
      case 0:
        for (;;) {
          const OperatorInfo& info = *FindUnaryOperator(static_cast<uint16_t>(1 + Below(7)));
          if (!Accepts(info, type)) continue;
          return Unary(static_cast<UnaryOperator>(info.number), type, AnyOperand(type),
                       AnyTarget(ResultOf(info, type)));
        }
      case 1:
        for (;;) {
          const OperatorInfo& info = *FindBinaryOperator(static_cast<uint16_t>(1 + Below(18)));
          if (!Accepts(info, type)) continue;
          return Binary(static_cast<BinaryOperator>(info.number), type, AnyOperand(type),
                        AnyOperand(type), AnyTarget(ResultOf(info, type)));
        }
      case 2:
        return Jump(AnyCondition(), static_cast<int16_t>(Below(count) - index));
      case 3:
        return Return(AnyCondition(), return_type == DataType::kVoid ? Operand(ImmediateInt(0))
                                                                     : AnyOperand(return_type));
      default:
        break;
    }
    switch (Below(4)) {
      case 0:
        return Command(kSetDo, {AnyOperand(DataType::kInt)});
      case 1:
        return Command(kSetVel, {AnyOperand(DataType::kInt), AnyOperand(DataType::kDouble)});
      case 2:
        return Command(kGetClock, {AnyTarget(DataType::kInt)});
      default: {
        std::vector<Operand> arguments;
        for (int i = 0; i < kCommandArgumentMax; ++i) {
          arguments.push_back(AnyOperand(DataType::kInt));
        }
        return Command(kFifteen, std::move(arguments));
      }
    }
  }

  Function MakeFunction(int number) {
    Function function;
    function.name = fmt::format("f{}", number);
    function.file = Chance(2) ? "a,b=c;d:[e].c" : "\xCE\xC4\xBC\xFE.c";
    function.return_type = static_cast<DataType>(Below(3));
    function.variables = MakeSymbols("v");
    locals_ = &function.variables;
    const int count = Below(20);
    for (int i = 0; i < count; ++i) {
      function.instructions.push_back(AnyInstruction(function.return_type, i, count));
      function.lines.push_back(static_cast<uint16_t>(random_()));
    }
    return function;
  }

  std::mt19937 random_;
  bool narrow_ = false;
  const std::vector<Symbol>* globals_ = nullptr;
  const std::vector<Symbol>* locals_ = nullptr;
};

TEST(ObjectReaderTest, RandomObjectsComeBack) {
  for (uint32_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    ExpectRoundTrip(ObjectGenerator(seed).Generate(), false);
    if (HasFatalFailure() || HasNonfatalFailure()) return;
  }
}

}  // namespace
}  // namespace oncard::vm
