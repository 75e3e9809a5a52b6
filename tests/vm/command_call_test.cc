// How a program's call of a GT command reads its arguments and stores its outputs.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/vm/program_builder.h"

namespace oncard::vm {
namespace {

// One command with a given shape, executed by a function of the test.
class OneCommand final : public CommandTable {
 public:
  using Action = std::function<int16_t(std::span<CommandArgument>)>;

  OneCommand(std::vector<ParameterShape> parameters, Action action)
      : parameters_(std::move(parameters)), action_(std::move(action)) {
    shape_ = {1, "GT_Test", parameters_, true};
  }

  const CommandShape* Find(uint16_t number) const override {
    return number == 1 ? &shape_ : nullptr;
  }
  int16_t Execute(uint16_t, Machine&, int thread, std::span<CommandArgument> arguments) override {
    EXPECT_EQ(thread, 3);
    ++calls;
    return action_(arguments);
  }

  int64_t Elements(uint16_t, size_t parameter, double first) const override {
    EXPECT_EQ(parameter, 1u);
    return static_cast<int64_t>(first) + 1;
  }

  int calls = 0;

 private:
  std::vector<ParameterShape> parameters_;
  Action action_;
  CommandShape shape_;
};

constexpr DataType kIntSlot[] = {DataType::kInt};
constexpr DataType kDoubleSlot[] = {DataType::kDouble};
constexpr DataType kPairSlots[] = {DataType::kInt, DataType::kDouble};
constexpr ParameterShape kIntInput = {"value", false, kIntSlot, -1};
constexpr ParameterShape kDoubleInput = {"value", false, kDoubleSlot, -1};
constexpr ParameterShape kIntOut = {"out", true, kIntSlot, -1};
constexpr ParameterShape kDoubleOut = {"out", true, kDoubleSlot, -1};
constexpr ParameterShape kPair = {"pair", true, kPairSlots, -1};
// Their second parameter is the number of elements.
constexpr ParameterShape kInts = {"values", true, kIntSlot, 1};
constexpr ParameterShape kPairs = {"pairs", true, kPairSlots, 1};

class CommandCallTest : public testing::Test {
 protected:
  // Executes one call on thread 3, page 3; local and global slots have the values in values_.
  void Call(std::vector<ParameterShape> parameters, std::vector<Operand> arguments,
            OneCommand::Action action) {
    table_ = std::make_unique<OneCommand>(std::move(parameters), std::move(action));
    machine_ = std::make_unique<Machine>(table_.get());
    Object object = MakeObject({MakeFunction({Command(1, std::move(arguments))})});
    object.double_format = format_;
    object.functions[0].name = "f";
    object.functions[0].file = "f.c";
    // int i, n; int a[4]; double d[3]; struct { int; double; } s;
    const std::vector<Symbol> symbols = {
        {"i", 0, DataType::kInt, 0},   {"n", 1, DataType::kInt, 0},
        {"a", 2, DataType::kInt, 4},   {"d", 6, DataType::kDouble, 3},
        {"s.k", 9, DataType::kInt, 0}, {"s.x", 10, DataType::kDouble, 0}};
    object.functions[0].variables = symbols;
    for (Symbol symbol : symbols) {
      symbol.name = "g_" + symbol.name;
      object.globals.push_back(symbol);
    }
    const auto image = LinkObject(object, *table_);
    ASSERT_TRUE(image.ok()) << image.error().message.en;
    machine_->Load(image.value());
    for (const auto& [id, raw] : values_) {
      machine_->WriteRaw({false, 3, id}, raw);
      machine_->WriteRaw({true, 0, id}, raw);
    }
    ASSERT_EQ(machine_->Bind(3, 1, 3), kOk);
    ASSERT_EQ(machine_->Run(3), kOk);
    ASSERT_EQ(machine_->Execute(5), 1);
  }

  int64_t LocalRaw(uint16_t id) const { return machine_->state().pages[3][id]; }
  int64_t GlobalRaw(uint16_t id) const { return machine_->state().globals[id]; }
  const ThreadState& thread() const { return machine_->thread(3); }

  DoubleFormat format_ = DoubleFormat::k32_16;
  std::vector<std::pair<uint16_t, int64_t>> values_;
  std::unique_ptr<OneCommand> table_;
  std::unique_ptr<Machine> machine_;
};

Element A(Storage storage, Storage index) { return {storage, 2, 4, {index, 0}}; }

// --- Inputs --------------------------------------------------------------------------------------

TEST_F(CommandCallTest, ValuesOfEveryKindArrive) {
  values_ = {{0, 2}, {1, -7}, {4, 44}, {6, -0x18000}};
  std::vector<double> seen;
  Call({kIntInput, kIntInput, kIntInput, kIntInput, kIntInput, kIntInput, kDoubleInput,
        kDoubleInput, kDoubleInput},
       {ImmediateInt(INT32_MIN), Local(1), Global(1), A(kL, kL), A(kG, kL), A(kL, kG), Raw(0x8000),
        Local(6), Global(6)},
       [&](auto arguments) {
         for (const auto& argument : arguments) seen.push_back(argument.value);
         return kOk;
       });
  EXPECT_EQ(seen, (std::vector<double>{-2147483648.0, -7, -7, 44, 44, 44, 0.5, -1.5, -1.5}));
  EXPECT_EQ(thread().run, ThreadRun::kStopped);
}

TEST_F(CommandCallTest, IntArgumentIsTheLowHalfOfItsSlot) {
  values_ = {{1, (int64_t{1} << 40) + 5}};
  Call({kIntInput}, {Local(1)}, [](auto arguments) {
    EXPECT_EQ(arguments[0].value, 5);
    return kOk;
  });
}

TEST_F(CommandCallTest, OutputsHoldTheOldValuesFirst) {
  values_ = {{2, 10}, {3, 11}, {6, 0x4000}};
  Call({kInts, kIntInput, kDoubleOut}, {Local(2), ImmediateInt(2), Global(6)}, [](auto arguments) {
    EXPECT_EQ(arguments[0].cells.size(), 2u);
    EXPECT_EQ(arguments[0].cells[0], 10);
    EXPECT_EQ(arguments[0].cells[1], 11);
    EXPECT_EQ(arguments[2].cells[0], 0.25);
    return kOk;
  });
}

TEST_F(CommandCallTest, TheCardSaysHowManyElementsThereAre) {
  const ParameterShape list = {"list", true, kIntSlot, -1, true};
  values_ = {{2, 10}, {3, 11}, {4, 12}};
  Call({kIntInput, list}, {ImmediateInt(2), Local(2)}, [](auto arguments) {
    EXPECT_EQ(arguments[1].cells.size(), 3u);
    EXPECT_EQ(arguments[1].cells[2], 12);
    arguments[1].cells[2] = 22;
    return kOk;
  });
  EXPECT_EQ(LocalRaw(4), 22);
  EXPECT_EQ(LocalRaw(5), 0);
  Call({kIntInput, list}, {ImmediateInt(4), Local(2)}, [](auto) { return kOk; });
  EXPECT_EQ(thread().error, static_cast<int>(Fault::kOutputBeyondStorage));
  EXPECT_EQ(table_->calls, 0);
}

TEST_F(CommandCallTest, AddressNamesItsSlot) {
  values_ = {{0, 3}};
  Call({kIntOut, kDoubleOut}, {A(kG, kL), Local(7)}, [](auto arguments) {
    EXPECT_TRUE(arguments[0].slot.global);
    EXPECT_EQ(arguments[0].slot.id, 5);
    EXPECT_EQ(arguments[0].slot.type, DataType::kInt);
    EXPECT_FALSE(arguments[1].slot.global);
    EXPECT_EQ(arguments[1].slot.page, 3);
    EXPECT_EQ(arguments[1].slot.id, 7);
    EXPECT_EQ(arguments[1].slot.type, DataType::kDouble);
    return kOk;
  });
}

// --- Outputs -------------------------------------------------------------------------------------

TEST_F(CommandCallTest, IntOutputsAreTruncatedAndWrapped) {
  const struct {
    double value;
    int64_t stored;
  } kCases[] = {{5.9, 5},
                {-5.9, -5},
                {65535, 65535},
                {4294967295.0, -1},
                {2147483648.0, INT32_MIN},
                {-2147483649.0, INT32_MAX},
                {std::numeric_limits<double>::quiet_NaN(), 0},
                {std::numeric_limits<double>::infinity(), 0},
                {1e300, 0}};
  for (const auto& c : kCases) {
    Call({kIntOut}, {Local(1)}, [&](auto arguments) {
      arguments[0].cells[0] = c.value;
      return kOk;
    });
    EXPECT_EQ(LocalRaw(1), c.stored) << c.value;
  }
}

TEST_F(CommandCallTest, DoubleOutputsAreTruncatedAndWrappedToTheFormat) {
  const struct {
    double value;
    int64_t wide;
    int64_t narrow;
  } kCases[] = {{-1.5, -0x18000, -0x18000},
                {1.9 / 65536, 1, 1},
                {-1.9 / 65536, -1, -1},
                {40000, int64_t{40000} << 16, (int64_t{40000} << 16) - (int64_t{1} << 32)},
                {2147483648.0, -(int64_t{1} << 47), 0},
                {std::numeric_limits<double>::quiet_NaN(), 0, 0}};
  for (const auto& c : kCases) {
    for (const DoubleFormat format : {DoubleFormat::k32_16, DoubleFormat::k16_16}) {
      format_ = format;
      Call({kDoubleOut}, {Global(8)}, [&](auto arguments) {
        arguments[0].cells[0] = c.value;
        return kOk;
      });
      EXPECT_EQ(GlobalRaw(8), format == DoubleFormat::k32_16 ? c.wide : c.narrow) << c.value;
    }
  }
}

TEST_F(CommandCallTest, StructureIsWrittenMemberByMember) {
  Call({kPair}, {Local(9)}, [](auto arguments) {
    EXPECT_EQ(arguments[0].cells.size(), 2u);
    arguments[0].cells[0] = 7.9;
    arguments[0].cells[1] = 0.5;
    return kOk;
  });
  EXPECT_EQ(LocalRaw(9), 7);
  EXPECT_EQ(LocalRaw(10), 0x8000);
}

TEST_F(CommandCallTest, OutputGoesToTheElementThatTheIndexNames) {
  for (const Storage array : {kL, kG}) {
    for (const Storage index : {kL, kG}) {
      values_ = {{0, 3}};
      Call({kIntOut}, {A(array, index)}, [](auto arguments) {
        arguments[0].cells[0] = 99;
        return kOk;
      });
      EXPECT_EQ(array == kL ? LocalRaw(5) : GlobalRaw(5), 99);
    }
  }
}

TEST_F(CommandCallTest, RefusedCommandWritesNothing) {
  values_ = {{2, 1}, {3, 2}};
  Call({kInts, kIntInput}, {Local(2), ImmediateInt(2)}, [](auto arguments) -> int16_t {
    arguments[0].cells[0] = arguments[0].cells[1] = 77;
    return 7;
  });
  EXPECT_EQ(LocalRaw(2), 1);
  EXPECT_EQ(LocalRaw(3), 2);
  EXPECT_EQ(thread().error, 7);
  EXPECT_EQ(thread().run, ThreadRun::kStopped) << "it went on to its end";
}

TEST_F(CommandCallTest, ReturnCodeGoesToTheThread) {
  constexpr int16_t kCodes[] = {0, 1, 7, -1, -7};
  for (const int16_t code : kCodes) {
    Call({}, {}, [&](auto) { return code; });
    EXPECT_EQ(thread().error, code);
  }
}

// --- Counts --------------------------------------------------------------------------------------

TEST_F(CommandCallTest, CountFromAVariableMayReachTheEndOfTheArray) {
  const struct {
    Operand first;
    int32_t index;
    int32_t count;
    int64_t limit;  // slots up to the end of the array
  } kCases[] = {{Local(2), 0, 4, 4},         {Local(2), 0, 5, 4},        {Local(3), 0, 3, 3},
                {Local(3), 0, 4, 3},         {Global(5), 0, 1, 1},       {Global(5), 0, 2, 1},
                {A(kL, kL), 1, 3, 3},        {A(kL, kL), 1, 4, 3},       {A(kG, kG), 3, 1, 1},
                {A(kG, kG), 3, 2, 1},        {Local(2), 0, 0, 4},        {Local(2), 0, -5, 4},
                {Local(2), 0, INT32_MAX, 4}, {Local(2), 0, INT32_MIN, 4}};
  for (const auto& c : kCases) {
    values_ = {{0, c.index}, {1, c.count}};
    size_t cells = 0;
    double seen = 0;
    Call({kInts, kIntInput}, {c.first, Local(1)}, [&](auto arguments) {
      cells = arguments[0].cells.size();
      seen = arguments[1].value;
      return kOk;
    });
    if (c.count > c.limit) {
      EXPECT_EQ(table_->calls, 0);
      EXPECT_EQ(thread().run, ThreadRun::kFaulted);
      EXPECT_EQ(thread().error, static_cast<int16_t>(Fault::kOutputBeyondStorage));
      EXPECT_EQ(thread().fault_value, c.count);
      EXPECT_EQ(thread().fault_limit, c.limit);
    } else {
      EXPECT_EQ(thread().run, ThreadRun::kStopped);
      EXPECT_EQ(cells, static_cast<size_t>(std::max(0, c.count))) << "none for a negative count";
      EXPECT_EQ(seen, c.count) << "the command sees the count itself";
    }
  }
}

TEST_F(CommandCallTest, CountOfStructuresCountsTheirSlots) {
  values_ = {{1, 2}};
  Call({kPairs, kIntInput}, {Local(9), ImmediateInt(1)}, [](auto arguments) {
    EXPECT_EQ(arguments[0].cells.size(), 2u);
    return kOk;
  });
  EXPECT_EQ(thread().run, ThreadRun::kStopped);
}

TEST_F(CommandCallTest, IndexOutOfBoundsFaultsBeforeTheCommand) {
  values_ = {{0, 4}};
  for (const ParameterShape& parameter : {kIntInput, kIntOut}) {
    Call({parameter}, {A(kL, kL)}, [](auto) { return kOk; });
    EXPECT_EQ(table_->calls, 0);
    EXPECT_EQ(thread().error, static_cast<int16_t>(Fault::kIndexOutOfBounds));
    EXPECT_EQ(thread().fault_value, 4);
    EXPECT_EQ(thread().fault_limit, 4);
  }
}

}  // namespace
}  // namespace oncard::vm
