#include "vm/verifier.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/vm/object_samples.h"
#include "vm/limits.h"

namespace oncard::vm {
namespace {

constexpr DataType kInt = DataType::kInt;
constexpr DataType kDouble = DataType::kDouble;

// An object with one variable of each kind, both local and global: id 0 int i, 1 double d, 2..4 int
// a[3], 5..8 double p[4], 9..12 trap (three doubles, an int), 13 and 14 pair (an int, a double).
Object Workbench(std::vector<Instruction> instructions) {
  const std::vector<Symbol> symbols = {
      {"i", 0, kInt, 0},
      {"d", 1, kDouble, 0},
      {"a", 2, kInt, 3},
      {"p", 5, kDouble, 4},
      {"trap.acc", 9, kDouble, 0},
      {"trap.dec", 10, kDouble, 0},
      {"trap.velStart", 11, kDouble, 0},
      {"trap.smoothTime", 12, kInt, 0},
      {"pair.n", 13, kInt, 0},
      {"pair.x", 14, kDouble, 0},
  };
  Function function;
  function.name = "f";
  function.file = "f.c";
  function.return_type = kInt;
  function.lines.assign(instructions.size(), 7);
  function.instructions = std::move(instructions);
  function.variables = symbols;
  Object object;
  object.functions = {function};
  object.globals = symbols;
  return object;
}

std::string MessageOf(const Object& object, Symbols symbols = Symbols::kRequired) {
  const Result<void> result = Verify(object, FakeCommands(), symbols);
  if (result.ok()) return "accepted";
  EXPECT_FALSE(result.error().message.zh.empty());
  EXPECT_EQ(result.error().code, 2008);
  return result.error().message.en;
}

const Operand kLocalArray = Element{Storage::kLocal, 2, 3, Local(0)};
const Operand kGlobalArray = Element{Storage::kGlobal, 5, 4, Global(0)};

// --- Statements ----------------------------------------------------------------------------------

struct Case {
  std::string name;
  Instruction instruction;
  std::string reason;  // of a refusal
};

class AcceptedTest : public testing::TestWithParam<Case> {};

TEST_P(AcceptedTest, Runs) {
  EXPECT_EQ(MessageOf(Workbench({GetParam().instruction})), "accepted");
}

INSTANTIATE_TEST_SUITE_P(
    Statements, AcceptedTest,
    testing::ValuesIn(std::vector<Case>{
        {"copy_int", Unary(UnaryOperator::kCopy, kInt, Local(0), Global(0)), ""},
        {"copy_double", Unary(UnaryOperator::kCopy, kDouble, Local(1), Global(1)), ""},
        {"copy_element_with_constant_index", Unary(UnaryOperator::kCopy, kInt, Local(4), Local(0)),
         ""},
        {"copy_element", Unary(UnaryOperator::kCopy, kInt, kLocalArray, Local(0)), ""},
        {"assign_element", Unary(UnaryOperator::kCopy, kDouble, Local(1), kGlobalArray), ""},
        {"index_is_a_member",
         Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 2, 3, Local(12)}, Local(0)),
         ""},
        {"cast_to_int", Unary(UnaryOperator::kToInt, kDouble, Local(1), Local(0)), ""},
        {"cast_to_double", Unary(UnaryOperator::kToDouble, kInt, Local(0), Local(1)), ""},
        {"compare_doubles", Binary(BinaryOperator::kLess, kDouble, Local(1), Raw(1), Local(0)), ""},
        {"largest_literals",
         Binary(BinaryOperator::kAdd, kInt, ImmediateInt(2147483647), ImmediateInt(-2147483648),
                Local(0)),
         ""},
        {"largest_double", Unary(UnaryOperator::kCopy, kDouble, Raw(0x7FFFFFFFFFFF), Local(1)), ""},
        {"jump_to_itself", Jump(Local(0), 0), ""},
        {"condition_is_a_member", Jump(Global(12), 0), ""},
        {"condition_is_an_element_with_constant_index", Jump(Local(3), 0), ""},
        {"return_variable", Return(Local(0), Global(0)), ""},
        {"return_element", Return(ImmediateInt(1), kLocalArray), ""},
        {"return_literal", Return(ImmediateInt(1), ImmediateInt(-1)), ""},
        {"command_value_int", Command(kSetDo, {Local(0)}), ""},
        {"command_value_element", Command(kSetDo, {kLocalArray}), ""},
        {"command_value_double", Command(kSetVel, {ImmediateInt(1), Local(1)}), ""},
        {"command_value_double_literal", Command(kSetVel, {ImmediateInt(1), Raw(3)}), ""},
        {"command_value_int_literal_for_double",
         Command(kSetVel, {ImmediateInt(1), ImmediateInt(50)}), ""},
        {"address_of_scalar", Command(kGetClock, {Local(0)}), ""},
        {"address_of_member", Command(kGetClock, {Local(12)}), ""},
        {"address_of_element", Command(kGetClock, {kLocalArray}), ""},
        {"address_of_structure", Command(kSetTrapPrm, {ImmediateInt(1), Global(9)}), ""},
        {"count_one_of_scalar", Command(kGetPos, {ImmediateInt(1), Local(1), ImmediateInt(1)}), ""},
        {"count_fills_the_array", Command(kGetPos, {ImmediateInt(1), Local(5), ImmediateInt(4)}),
         ""},
        {"count_fills_the_rest", Command(kGetPos, {ImmediateInt(1), Local(7), ImmediateInt(2)}),
         ""},
        {"count_over_members_of_one_type",
         Command(kGetPos, {ImmediateInt(1), Local(9), ImmediateInt(3)}), ""},
        {"count_of_an_element", Command(kGetPos, {ImmediateInt(1), kGlobalArray, ImmediateInt(4)}),
         ""},
        {"count_is_a_variable", Command(kGetPos, {ImmediateInt(1), Local(5), Local(0)}), ""},
        {"count_zero_is_the_commands_business",
         Command(kGetPos, {ImmediateInt(1), Local(5), ImmediateInt(0)}), ""},
        {"count_negative_is_the_commands_business",
         Command(kGetPos, {ImmediateInt(1), Local(5), ImmediateInt(-1)}), ""},
        {"one_structure_of_a_counted_parameter", Command(kReadPairs, {Local(13), ImmediateInt(1)}),
         ""},
        {"fifteen_arguments", Command(kFifteen, std::vector<Operand>(15, Local(0))), ""},
    }),
    [](const auto& row) { return row.param.name; });

class RefusedTest : public testing::TestWithParam<Case> {};

TEST_P(RefusedTest, SaysWhereAndWhy) {
  EXPECT_EQ(MessageOf(Workbench({GetParam().instruction})),
            "function 'f', instruction 0 (source line 7): " + GetParam().reason);
}

INSTANTIATE_TEST_SUITE_P(
    Operators, RefusedTest,
    testing::ValuesIn(std::vector<Case>{
        {"unknown_opcode", Malformed(static_cast<Opcode>(0x5042), 0, {}),
         "opcode 0x5042 is not known"},
        {"unary_zero", Unary(static_cast<UnaryOperator>(0), kInt, Local(0), Local(0)),
         "no operator has number 0"},
        {"unary_past_the_last",
         Unary(static_cast<UnaryOperator>(UnaryOperators().size() + 1), kInt, Local(0), Local(0)),
         fmt::format("no operator has number {}", UnaryOperators().size() + 1)},
        {"binary_past_the_last",
         Binary(static_cast<BinaryOperator>(BinaryOperators().size() + 1), kInt, Local(0), Local(0),
                Local(0)),
         fmt::format("no operator has number {}", BinaryOperators().size() + 1)},
        {"remainder_of_doubles",
         Binary(BinaryOperator::kRemainder, kDouble, Local(1), Local(1), Local(1)),
         "operator '%' (number 5) does not take operands of type double"},
        {"fabs_of_int", Unary(UnaryOperator::kFabs, kInt, Local(0), Local(0)),
         "operator 'fabs' (number 5) does not take operands of type int"},
        {"void_operands", Unary(UnaryOperator::kCopy, DataType::kVoid, Local(0), Local(0)),
         "operator '' (number 1) does not take operands of type void"},
        {"operand_missing", Malformed(Opcode::kBinary, 1, {Local(0), Local(0)}),
         "2 operands; 3 are expected"},
        {"operand_too_many", Malformed(Opcode::kUnary, 1, {Local(0), Local(0), Local(0)}),
         "3 operands; 2 are expected"},
        {"target_is_a_literal", Unary(UnaryOperator::kCopy, kInt, Local(0), ImmediateInt(1)),
         "the target is a literal; it must be a variable"},
        {"double_source_for_int", Unary(UnaryOperator::kCopy, kInt, Local(1), Local(0)),
         "'d' is of type double; int is expected"},
        {"int_target_for_double", Unary(UnaryOperator::kCopy, kDouble, Local(1), Global(0)),
         "'i' is of type int; double is expected"},
        {"double_target_of_a_comparison",
         Binary(BinaryOperator::kEqual, kDouble, Local(1), Local(1), Local(1)),
         "'d' is of type double; int is expected"},
        {"mixed_operands", Binary(BinaryOperator::kAdd, kInt, Local(0), Local(1), Local(0)),
         "'d' is of type double; int is expected"},
        {"fraction_in_an_int", Unary(UnaryOperator::kCopy, kInt, Raw(0x18000), Local(0)),
         "literal 1.5 is not an int"},
        {"literal_one_past_the_largest",
         Unary(UnaryOperator::kCopy, kDouble, Raw(0x800000000000), Local(1)),
         "literal 2147483648 does not fit the type double"},
        {"literal_one_past_the_smallest",
         Unary(UnaryOperator::kCopy, kInt, Raw(-0x800000010000), Local(0)),
         "literal -2147483649 does not fit the type int"},
    }),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Storage, RefusedTest,
    testing::ValuesIn(std::vector<Case>{
        {"local_past_the_last", Unary(UnaryOperator::kCopy, kInt, Local(15), Local(0)),
         "local variable 15 is not declared"},
        {"global_past_the_last", Unary(UnaryOperator::kCopy, kInt, Local(0), Global(0xFFFF)),
         "global variable 65535 is not declared"},
        {"element_of_a_scalar",
         Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 0, 1, Local(0)}, Local(0)),
         "no array of 1 elements begins at local variable 0"},
        {"element_from_the_middle",
         Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 3, 2, Local(0)}, Local(0)),
         "no array of 2 elements begins at local variable 3"},
        {"element_of_a_longer_array",
         Unary(UnaryOperator::kCopy, kDouble, Element{Storage::kGlobal, 5, 5, Local(0)}, Local(1)),
         "no array of 5 elements begins at global variable 5"},
        {"element_of_a_shorter_array",
         Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 2, 2, Local(0)}, Local(0)),
         "no array of 2 elements begins at local variable 2"},
        {"element_nowhere",
         Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 999, 3, Local(0)}, Local(0)),
         "no array of 3 elements begins at local variable 999"},
        {"element_of_another_type", Unary(UnaryOperator::kCopy, kInt, kGlobalArray, Local(0)),
         "'p' is of type double; int is expected"},
        {"index_is_a_double",
         Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 2, 3, Local(1)}, Local(0)),
         "'d' is of type double; int is expected"},
        {"index_is_not_declared",
         Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 2, 3, Global(99)}, Local(0)),
         "global variable 99 is not declared"},
    }),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Flow, RefusedTest,
    testing::ValuesIn(std::vector<Case>{
        {"jump_before_the_first", Jump(ImmediateInt(1), -1),
         "the jump goes to instruction -1; the function has 0 to 0"},
        {"jump_past_the_last", Jump(Local(0), 1),
         "the jump goes to instruction 1; the function has 0 to 0"},
        {"condition_is_a_double", Jump(Local(1), 0), "'d' is of type double; int is expected"},
        {"condition_is_zero", Jump(ImmediateInt(0), 0),
         "the condition is neither an int variable nor the constant 1"},
        {"condition_is_two", Return(ImmediateInt(2), Local(0)),
         "the condition is neither an int variable nor the constant 1"},
        {"condition_is_an_element", Jump(kLocalArray, 0),
         "the condition is neither an int variable nor the constant 1"},
        {"condition_is_not_declared", Return(Local(15), Local(0)),
         "local variable 15 is not declared"},
        {"return_of_another_type", Return(ImmediateInt(1), Local(1)),
         "'d' is of type double; int is expected"},
        {"return_of_a_fraction", Return(ImmediateInt(1), Raw(1)),
         "literal 1.52587890625e-05 is not an int"},
        {"return_without_value", Malformed(Opcode::kReturn, 0, {ImmediateInt(1)}),
         "1 operands; 2 are expected"},
    }),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Commands, RefusedTest,
    testing::ValuesIn(std::vector<Case>{
        {"unknown_command", Command(4711, {}), "no command has number 4711"},
        {"not_for_programs", Command(kOpen, {Local(0)}),
         "GT_Open cannot be called in a motion program"},
        {"argument_missing", Command(kSetVel, {ImmediateInt(1)}),
         "GT_SetVel takes 2 arguments, not 1"},
        {"argument_too_many", Command(kSetDo, {Local(0), Local(0)}),
         "GT_SetDo takes 1 arguments, not 2"},
        {"sixteen_arguments", Command(kSixteen, std::vector<Operand>(16, Local(0))),
         "16 arguments; a record holds 15"},
        {"double_for_int", Command(kSetDo, {Local(1)}),
         "argument 'value' of GT_SetDo: 'd' is of type double; int is expected"},
        {"int_for_double", Command(kSetVel, {Local(0), Local(0)}),
         "argument 'vel' of GT_SetVel: 'i' is of type int; double is expected"},
        {"fraction_for_int", Command(kSetDo, {Raw(0x8000)}),
         "argument 'value' of GT_SetDo: literal 0.5 is not an int"},
        {"address_of_a_literal", Command(kGetClock, {ImmediateInt(1)}),
         "argument 'clock' of GT_GetClock: a literal has no address; a variable is expected"},
        {"address_of_another_type", Command(kGetClock, {Local(1)}),
         "argument 'clock' of GT_GetClock: 'd' is of type double; int is expected"},
        {"address_of_an_array_of_another_type", Command(kGetClock, {kGlobalArray}),
         "argument 'clock' of GT_GetClock: 'p' is of type double; int is expected"},
        {"address_of_nothing", Command(kGetClock, {Local(15)}),
         "argument 'clock' of GT_GetClock: local variable 15 is not declared"},
        {"count_past_a_scalar", Command(kGetPos, {ImmediateInt(1), Local(1), ImmediateInt(2)}),
         "argument 'pos' of GT_GetPos: 2 slots are needed, the variable has 1 from there on"},
        {"count_past_the_array", Command(kGetPos, {ImmediateInt(1), Local(6), ImmediateInt(4)}),
         "argument 'pos' of GT_GetPos: 4 slots are needed, the variable has 3 from there on"},
        {"count_past_any_element",
         Command(kGetPos, {ImmediateInt(1), kGlobalArray, ImmediateInt(5)}),
         "argument 'pos' of GT_GetPos: 5 slots are needed, the variable has 4 from there on"},
        {"count_over_members_of_two_types",
         Command(kGetPos, {ImmediateInt(1), Local(9), ImmediateInt(4)}),
         "argument 'pos' of GT_GetPos: the command may reach 'trap.smoothTime', which is of "
         "another type"},
        {"variable_count_over_members_of_two_types",
         Command(kGetPos, {ImmediateInt(1), Local(10), Local(0)}),
         "argument 'pos' of GT_GetPos: the command may reach 'trap.smoothTime', which is of "
         "another type"},
        {"structure_from_its_middle", Command(kSetTrapPrm, {ImmediateInt(1), Local(10)}),
         "argument 'trap' of GT_SetTrapPrm: 4 slots are needed, the variable has 3 from there on"},
        {"structure_of_other_types", Command(kSetTrapPrm, {ImmediateInt(1), Local(5)}),
         "argument 'trap' of GT_SetTrapPrm: 'p' is of type double; int is expected"},
        {"structure_from_an_element", Command(kSetTrapPrm, {ImmediateInt(1), kGlobalArray}),
         "argument 'trap' of GT_SetTrapPrm: 'p' is of type double; int is expected"},
        {"two_structures", Command(kReadPairs, {Local(13), ImmediateInt(2)}),
         "argument 'pairs' of GT_ReadPairs: 4 slots are needed, the variable has 2 from there on"},
        {"text", Command(kLoad, {Local(0)}),
         "argument 'file' of GT_Load: a motion program has no variables of its type"},
    }),
    [](const auto& row) { return row.param.name; });

// The operators by number, and their operand types according to the language's rules: arithmetic
// and comparisons take both types, the others ints; the casts and fabs are exceptions.
TEST(VerifierTest, OperatorsTakeTheirTypesAndNoOthers) {
  // + - * / % && || == != < > <= >= & | ^ << >>
  const std::string kBinaryInt = "yyyyyyyyyyyyyyyyyy";
  const std::string kBinaryDouble = "yyyynnnyyyyyynnnnn";
  for (uint16_t number = 1; number <= 18; ++number) {
    const auto op = static_cast<BinaryOperator>(number);
    const bool compares = number >= 8 && number <= 13;
    EXPECT_EQ(MessageOf(Workbench({Binary(op, kInt, Local(0), Local(0), Local(0))})) == "accepted",
              kBinaryInt[number - 1u] == 'y')
        << number;
    EXPECT_EQ(MessageOf(Workbench({Binary(op, kDouble, Local(1), Local(1),
                                          compares ? Local(0) : Local(1))})) == "accepted",
              kBinaryDouble[number - 1u] == 'y')
        << number;
  }
  const auto unary_is_accepted = [](uint16_t number, DataType type) {
    const bool gives_int = number == 6 || (number != 7 && type == kInt);
    return MessageOf(Workbench(
               {Unary(static_cast<UnaryOperator>(number), type, type == kInt ? Local(0) : Local(1),
                      gives_int ? Local(0) : Local(1))})) == "accepted";
  };
  // copy ! ~ abs fabs (int) (double)
  const std::string kUnaryInt = "yyyynny";
  const std::string kUnaryDouble = "ynnnyyn";
  for (uint16_t number = 1; number <= 7; ++number) {
    EXPECT_EQ(unary_is_accepted(number, kInt), kUnaryInt[number - 1u] == 'y') << number;
    EXPECT_EQ(unary_is_accepted(number, kDouble), kUnaryDouble[number - 1u] == 'y') << number;
  }
}

TEST(VerifierTest, SamplesAreAccepted) {
  EXPECT_EQ(MessageOf(SumObject()), "accepted");
  EXPECT_EQ(MessageOf(ArrayObject()), "accepted");
  EXPECT_EQ(MessageOf(StructureObject()), "accepted");
  EXPECT_EQ(MessageOf(Object()), "accepted");
}

TEST(VerifierTest, NarrowDoublesLimitDoubleLiteralsOnly) {
  const auto message_of = [](Instruction instruction) {
    Object object = Workbench({std::move(instruction)});
    object.double_format = DoubleFormat::k16_16;
    return MessageOf(object);
  };
  EXPECT_EQ(message_of(Unary(UnaryOperator::kCopy, kDouble, Raw(0x7FFFFFFF), Local(1))),
            "accepted");
  EXPECT_EQ(message_of(Unary(UnaryOperator::kCopy, kDouble, Raw(-0x80000000LL), Local(1))),
            "accepted");
  EXPECT_EQ(message_of(Unary(UnaryOperator::kCopy, kDouble, Raw(0x80000000LL), Local(1))),
            "function 'f', instruction 0 (source line 7): literal 32768 does not fit the type "
            "double");
  EXPECT_EQ(message_of(Unary(UnaryOperator::kCopy, kInt, ImmediateInt(100000), Local(0))),
            "accepted");
}

TEST(VerifierTest, VoidFunctionReturnsTheLiteralZeroOnly) {
  Object object = Workbench({Return(ImmediateInt(1), ImmediateInt(0))});
  object.functions[0].return_type = DataType::kVoid;
  EXPECT_EQ(MessageOf(object), "accepted");
  for (const Operand& value : {Operand(ImmediateInt(1)), Operand(Local(0)), kLocalArray}) {
    object.functions[0].instructions[0].operands[1] = value;
    EXPECT_EQ(MessageOf(object),
              "function 'f', instruction 0 (source line 7): a void function returns a value");
  }
}

TEST(VerifierTest, DoubleFunctionReturnsDoubles) {
  Object object = Workbench({Return(ImmediateInt(1), Raw(0x8000))});
  object.functions[0].return_type = kDouble;
  EXPECT_EQ(MessageOf(object), "accepted");
  object.functions[0].instructions[0].operands[1] = Local(0);
  EXPECT_EQ(MessageOf(object),
            "function 'f', instruction 0 (source line 7): 'i' is of type int; double is expected");
}

TEST(VerifierTest, PlaceNamesTheInstruction) {
  const Instruction good = Jump(ImmediateInt(1), 0);
  Object object = Workbench({good, good, Jump(ImmediateInt(1), 9)});
  object.functions[0].lines = {4, 5, 6};
  EXPECT_EQ(MessageOf(object),
            "function 'f', instruction 2 (source line 6): the jump goes to instruction 11; the "
            "function has 0 to 2");
}

// --- Functions and symbols -----------------------------------------------------------------------

struct Damage {
  std::string name;
  std::function<void(Object*)> apply;
  std::string message;
};

class DamagedObjectTest : public testing::TestWithParam<Damage> {};

TEST_P(DamagedObjectTest, IsRefusedWithTheReason) {
  Object object = SumObject();
  GetParam().apply(&object);
  EXPECT_EQ(MessageOf(object), GetParam().message);
}

Function& First(Object* object) { return object->functions[0]; }

INSTANTIATE_TEST_SUITE_P(
    Rules, DamagedObjectTest,
    testing::ValuesIn(std::vector<Damage>{
        {"return_type_three", [](Object* o) { First(o).return_type = static_cast<DataType>(3); },
         "function 'add': return type 3 is not known; 0 (void), 1 (int) or 2 (double) is expected"},
        {"line_missing", [](Object* o) { First(o).lines.pop_back(); },
         "function 'add': 6 source lines for 7 instructions"},
        {"function_without_name", [](Object* o) { First(o).name.clear(); },
         "function '': '' is not the name of a function"},
        {"function_name_with_a_dot", [](Object* o) { First(o).name = "a.b"; },
         "function 'a.b': 'a.b' is not the name of a function"},
        {"function_name_too_long", [](Object* o) { First(o).name = std::string(32, 'f'); },
         "function 'ffffffffffffffffffffffffffffffff': 'ffffffffffffffffffffffffffffffff' is not "
         "the name of a function"},
        {"function_twice", [](Object* o) { o->functions.push_back(First(o)); },
         "function 'add': 'add' is defined twice"},
        {"line_break_in_the_file_name", [](Object* o) { First(o).file = "a\nb"; },
         "function 'add': the source file's name 'a\\x0ab' has control characters"},
        {"name_begins_with_a_digit", [](Object* o) { o->globals[0].name = "1a"; },
         "globals: '1a' is not the name of a variable or of a structure's member"},
        {"name_with_a_bracket", [](Object* o) { o->globals[0].name = "a["; },
         "globals: 'a[' is not the name of a variable or of a structure's member"},
        {"name_beyond_ascii", [](Object* o) { o->globals[0].name = "\xB1\xE4"; },
         "globals: '\\xb1\\xe4' is not the name of a variable or of a structure's member"},
        {"name_too_long", [](Object* o) { First(o).variables[3].name = std::string(32, 'v'); },
         "function 'add': 'vvvvvvvvvvvvvvvvvvvvvvvvvvvvvvvv' is not the name of a variable or of "
         "a structure's member"},
        {"member_of_a_member", [](Object* o) { o->globals[0].name = "a.b.c"; },
         "globals: 'a.b.c' is not the name of a variable or of a structure's member"},
        {"member_without_name", [](Object* o) { o->globals[0].name = "a."; },
         "globals: 'a.' is not the name of a variable or of a structure's member"},
        {"member_is_an_array",
         [](Object* o) {
           o->globals[0] = {"a.b", 0, kInt, 2};
         },
         "globals: 'a.b' is not the name of a variable or of a structure's member"},
        {"variable_twice", [](Object* o) { First(o).variables[3].name = "begin"; },
         "function 'add': 'begin' is declared twice"},
        {"member_twice",
         [](Object* o) {
           First(o).variables[1].name = "s.x";
           First(o).variables[2].name = "s.x";
         },
         "function 'add': 's.x' is declared twice"},
        {"structure_in_two_places",
         [](Object* o) {
           First(o).variables[0].name = "s.x";
           First(o).variables[2].name = "s.y";
         },
         "function 'add': 's.y' is declared twice"},
        {"structure_named_like_a_variable",
         [](Object* o) { First(o).variables[1].name = "begin.x"; },
         "function 'add': 'begin.x' is declared twice"},
        {"type_zero", [](Object* o) { o->globals[0].type = DataType::kVoid; },
         "globals: 'sum' has data type 0; 1 (int) or 2 (double) is expected"},
        {"ids_do_not_begin_at_0", [](Object* o) { o->globals[0].id = 1; },
         "globals: 'sum' has id 1; 0 is expected, ids count the slots from 0"},
        {"ids_leave_a_gap", [](Object* o) { First(o).variables[3].id = 4; },
         "function 'add': 'cc' has id 4; 3 is expected, ids count the slots from 0"},
        {"ids_overlap_an_array", [](Object* o) { First(o).variables[2].array_size = 2; },
         "function 'add': 'cc' has id 3; 4 is expected, ids count the slots from 0"},
        {"slots_beyond_the_page",
         [](Object* o) {
           First(o).variables.push_back({"big", 4, kInt, 1021});
         },
         "function 'add': 'big' ends at slot 1025; there are 1024"},
        {"array_of_65535",
         [](Object* o) {
           o->globals.push_back({"big", 1, kInt, 0xFFFF});
         },
         "globals: 'big' ends at slot 65536; there are 1024"},
    }),
    [](const auto& row) { return row.param.name; });

// --- Limits: at the limit and one past it --------------------------------------------------------

Object WithFunctions(int count) {
  Object object = SumObject();
  for (int i = 1; i < count; ++i) {
    object.functions.push_back(object.functions[0]);
    object.functions.back().name = fmt::format("add{}", i);
  }
  return object;
}

TEST(VerifierLimitTest, Functions) {
  EXPECT_EQ(MessageOf(WithFunctions(kFunctionMax)), "accepted");
  const Result<void> result = Verify(WithFunctions(kFunctionMax + 1), FakeCommands());
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, 7);
  EXPECT_EQ(result.error().message.en, "the program has 33 functions; 32 are allowed");
}

TEST(VerifierLimitTest, Instructions) {
  const Instruction step = Jump(ImmediateInt(1), 0);
  EXPECT_EQ(MessageOf(Workbench(std::vector<Instruction>(kInstructionMax, step))), "accepted");
  EXPECT_EQ(MessageOf(Workbench(std::vector<Instruction>(kInstructionMax + 1, step))),
            "function 'f': 32768 instructions; 32767 are allowed");
}

TEST(VerifierLimitTest, SlotsAndArraySize) {
  Object object;
  object.globals = {{"a", 0, kInt, kSlotCount}};
  EXPECT_EQ(MessageOf(object), "accepted");
  object.globals.push_back({"b", kSlotCount, kInt, 0});
  EXPECT_EQ(MessageOf(object), "globals: 'b' ends at slot 1025; there are 1024");
}

TEST(VerifierLimitTest, NameLength) {
  Object object;
  object.globals = {{std::string(31, 's') + "." + std::string(31, 'm'), 0, kInt, 0}};
  EXPECT_EQ(MessageOf(object), "accepted");
  object.globals[0].name += 'm';
  EXPECT_NE(MessageOf(object), "accepted");
}

TEST(VerifierLimitTest, FarthestJumps) {
  std::vector<Instruction> instructions(kInstructionMax, Jump(ImmediateInt(1), 0));
  instructions.front() = Jump(ImmediateInt(1), kInstructionMax - 1);
  instructions.back() = Jump(ImmediateInt(1), -(kInstructionMax - 1));
  EXPECT_EQ(MessageOf(Workbench(std::move(instructions))), "accepted");
}

// --- Without symbols -----------------------------------------------------------------------------

Object Bare(Instruction instruction) {
  Object object;
  object.functions.resize(1);
  object.functions[0].instructions = {std::move(instruction)};
  return object;
}

TEST(VerifierWithoutSymbolsTest, EverySlotMayBeUsed) {
  for (const Instruction& instruction : {
           Unary(UnaryOperator::kCopy, kDouble, Local(1023), Global(1023)),
           Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 0, 1024, Global(1023)},
                 Local(0)),
           Jump(Local(1023), 0),
           Return(ImmediateInt(1), Global(1023)),
           Command(kGetPos, {Local(0), Local(1020), ImmediateInt(4)}),
           Command(kSetTrapPrm, {Local(0), Global(1020)}),
       }) {
    EXPECT_EQ(MessageOf(Bare(instruction), Symbols::kAbsent), "accepted");
  }
}

TEST(VerifierWithoutSymbolsTest, NoSlotBeyondThePage) {
  const std::string place = "function '', instruction 0: ";
  const auto message_of = [](Instruction instruction) {
    return MessageOf(Bare(std::move(instruction)), Symbols::kAbsent);
  };
  EXPECT_EQ(message_of(Jump(Local(1024), 0)), place + "slot 1024 does not exist; there are 1024");
  EXPECT_EQ(message_of(Unary(UnaryOperator::kCopy, kInt,
                             Element{Storage::kLocal, 1, 1024, Local(0)}, Local(0))),
            place + "slot 1024 does not exist; there are 1024");
  EXPECT_EQ(message_of(Unary(UnaryOperator::kCopy, kInt, Element{Storage::kLocal, 1, 0, Local(0)},
                             Local(0))),
            place + "an array has no elements");
  EXPECT_EQ(message_of(Unary(UnaryOperator::kCopy, kInt,
                             Element{Storage::kLocal, 0, 1, Local(1024)}, Local(0))),
            place + "slot 1024 does not exist; there are 1024");
  EXPECT_EQ(message_of(Command(kSetTrapPrm, {Local(0), Global(1021)})),
            place +
                "argument 'trap' of GT_SetTrapPrm: 4 slots are needed, the variable has 3 from "
                "there on");
}

TEST(VerifierWithoutSymbolsTest, DeclarationsAreRequiredUnlessToldSo) {
  EXPECT_EQ(MessageOf(Bare(Jump(Local(0), 0))), "function '': '' is not the name of a function");
}

// --- StorageExtent -------------------------------------------------------------------------------

TEST(StorageExtentTest, IsTheRestOfTheVariable) {
  const Object object = Workbench({});
  const std::vector<uint16_t> expected = {1, 1, 3, 2, 1, 4, 3, 2, 1, 4, 3, 2, 1, 2, 1, 0};
  for (uint16_t id = 0; id < expected.size(); ++id) {
    EXPECT_EQ(StorageExtent(object, object.functions[0], Local(id)), expected[id]) << id;
    EXPECT_EQ(StorageExtent(object, object.functions[0], Global(id)), expected[id]) << id;
  }
}

TEST(StorageExtentTest, LocalsAndGlobalsAreApart) {
  Object object = SumObject();
  object.globals[0].array_size = 5;
  EXPECT_EQ(StorageExtent(object, object.functions[0], Global(0)), 5);
  EXPECT_EQ(StorageExtent(object, object.functions[0], Local(0)), 1);
}

TEST(StorageExtentTest, ReachesTheEndOfThePageWithoutSymbols) {
  const Object object = Bare(Jump(ImmediateInt(1), 0));
  EXPECT_EQ(StorageExtent(object, object.functions[0], Local(0)), 1024);
  EXPECT_EQ(StorageExtent(object, object.functions[0], Global(1023)), 1);
  EXPECT_EQ(StorageExtent(object, object.functions[0], Global(1024)), 0);
}

}  // namespace
}  // namespace oncard::vm
