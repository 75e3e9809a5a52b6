#include "vm/object_reader.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/vm/object_samples.h"
#include "vm/limits.h"
#include "vm/object_writer.h"
#include "vm/verifier.h"

namespace oncard::vm {
namespace {

using testing::HasSubstr;

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

TEST(ObjectReaderTest, NamesOfCComeBack) {
  Object object = ArrayObject();
  object.globals[1].written = "table[2][4]";
  object.functions[0].variables[1].written = "axis[5].a_name_that_is_longer_than_the_card_has_any";
  ExpectRoundTrip(object, false);
  object = StructureObject();
  for (Symbol& symbol : object.functions[0].variables) symbol.written = "page." + symbol.name;
  ExpectRoundTrip(object, false);
}

TEST(ObjectReaderTest, VendorObjectHasWideDoubles) {
  Object object = SumObject();
  object.double_format = DoubleFormat::k16_16;
  const Result<Object> read = ReadObject(WriteObject(object, true));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value().double_format, DoubleFormat::k32_16);
}

// Generates random objects that obey the verifier's rules.
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

  const OperatorInfo& AnyOf(std::span<const OperatorInfo> rows) {
    return rows[static_cast<size_t>(Below(static_cast<int>(rows.size())))];
  }

  Instruction AnyInstruction(DataType return_type, int index, int count) {
    const DataType type = AnyType();
    switch (Below(5)) {
      case 0:
        for (;;) {
          const OperatorInfo& info = AnyOf(UnaryOperators());
          if (!Accepts(info, type)) continue;
          return Unary(static_cast<UnaryOperator>(info.number), type, AnyOperand(type),
                       AnyTarget(ResultOf(info, type)));
        }
      case 1:
        for (;;) {
          const OperatorInfo& info = AnyOf(BinaryOperators());
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

// --- What the .ini may look like ----------------------------------------------------------------

std::string Replaced(std::string text, std::string_view from, std::string_view to) {
  const size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  return text.replace(position, from.size(), to);
}

std::string MessageOf(const ObjectFiles& files, int code = 2008) {
  const Result<Object> object = ReadObject(files);
  if (object.ok()) return "accepted";
  EXPECT_EQ(object.error().code, code);
  EXPECT_FALSE(object.error().message.zh.empty());
  return object.error().message.en;
}

struct IniChange {
  std::string name;
  std::string from;
  std::string to;
  std::string message;  // of a refusal
};

// What C calls a variable is another name, of as many elements. They follow line 26.
TEST(IniNamesTest, AreThoseOfVariables) {
  struct Row {
    std::string names;
    std::string message;
  };
  for (const Row& row : std::vector<Row>{
           {"[names]\nn=m\n", "accepted"},
           {"[names]\ntable=t[2][2].x[2]\n", "accepted"},
           {"[work.names]\na=s.list[5]\n[names]\nn=s.n\n", "accepted"},
           {"[names]\nother=m\n", "line 28 of the .ini: there is no variable 'other'"},
           {"[names]\ni=m\n", "line 28 of the .ini: there is no variable 'i'"},
           {"[names]\nn=\n", "line 28 of the .ini: '' cannot be what C calls 'n'"},
           {"[names]\nn=1m\n", "line 28 of the .ini: '1m' cannot be what C calls 'n'"},
           {"[names]\nn=a..b\n", "line 28 of the .ini: 'a..b' cannot be what C calls 'n'"},
           {"[names]\nn=m[1]\n", "line 28 of the .ini: 'm[1]' cannot be what C calls 'n'"},
           {"[names]\ntable=t[2][5]\n",
            "line 28 of the .ini: 't[2][5]' cannot be what C calls 'table'"},
           {"[names]\ntable=t[-8]\n",
            "line 28 of the .ini: 't[-8]' cannot be what C calls 'table'"},
           {"[names]\ntable=t[65536][65536][2][4]\n",
            "line 28 of the .ini: 't[65536][65536][2][4]' cannot be what C calls 'table'"},
           {"[names]\nn=m\ntable=m\n", "line 29 of the .ini: 'm' cannot be what C calls 'table'"},
           {"[other.names]\nn=m\n",
            "line 27 of the .ini: section 'other.names' belongs to no function"},
       }) {
    ObjectFiles files = WriteObject(ArrayObject(), false);
    files.ini += row.names;
    EXPECT_EQ(MessageOf(files), row.message) << row.names;
  }
}

TEST(IniNamesTest, OfAVendorAreNone) {
  ObjectFiles files = WriteObject(SumObject(), true);
  files.ini += "[names]\nsum=total\n";
  EXPECT_EQ(MessageOf(files), "line 18 of the .ini: section 'names' belongs to no function");
}

// The .ini of SumObject(), for reference:
//    1 [function]   2 add=1,sum.c,1   3 [global]   4 sum=0,1   5 [add.line]   6..12 0=13 .. 6=21
//   13 [add.var]   14 begin=0,1  15 end=1,1  16 i=2,1  17 cc=3,1
//   18 [oncard]  19 format=1  20 double=32.16  21 bin_crc32=e72a6151
class IniTest : public testing::TestWithParam<IniChange> {};

TEST_P(IniTest, IsRefusedWithLineAndReason) {
  ObjectFiles files = WriteObject(SumObject(), false);
  files.ini = Replaced(files.ini, GetParam().from, GetParam().to);
  EXPECT_EQ(MessageOf(files), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Form, IniTest,
    testing::ValuesIn(std::vector<IniChange>{
        {"line_before_any_section", "[function]\n", "",
         "line 1 of the .ini: 'add=1,sum.c,1' is neither a section nor one of its 'name=value' "
         "lines"},
        {"line_without_value", "begin=0,1", "begin",
         "line 14 of the .ini: 'begin' is neither a section nor one of its 'name=value' lines"},
        {"section_not_closed", "[global]", "[global",
         "line 3 of the .ini: '[global' is neither a section nor one of its 'name=value' lines"},
        {"control_character", "sum.c", "sum\x01.c",
         "line 2 of the .ini: control characters in 'add=1,sum\\x01.c,1'"},
        {"lone_carriage_return", "begin=0,1\n", "begin=0,1\r",
         "line 14 of the .ini: control characters in 'begin=0,1\\x0dend=1,1'"},
        {"key_twice", "end=1,1", "begin=1,1",
         "line 15 of the .ini: 'begin' occurs twice in its section"},
        {"section_twice", "[add.var]", "[add.line]",
         "line 13 of the .ini: section 'add.line' is repeated; the first one is in line 5"},
        {"section_of_no_function", "[add.var]", "[sub.var]",
         "line 13 of the .ini: section 'sub.var' belongs to no function"},
        {"section_in_other_case", "[global]", "[Global]",
         "line 3 of the .ini: section 'Global' belongs to no function"},
        {"no_functions", "[function]\nadd=1,sum.c,1\n", "", "the .ini has no section 'function'"},
    }),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Functions, IniTest,
    testing::ValuesIn(std::vector<IniChange>{
        {"one_comma", "add=1,sum.c,1", "add=1,1",
         "line 2 of the .ini: '1,1' is not of the form id,file,returnType"},
        {"no_comma", "add=1,sum.c,1", "add=1",
         "line 2 of the .ini: '1' is not of the form id,file,returnType"},
        {"id_zero", "add=1,", "add=0,",
         "line 2 of the .ini: function 'add' has id '0'; 1 is expected"},
        {"id_is_no_number", "add=1,", "add=one,",
         "line 2 of the .ini: function 'add' has id 'one'; 1 is expected"},
        {"id_with_leading_zero", "add=1,", "add=01,",
         "line 2 of the .ini: function 'add' has id '01'; 1 is expected"},
        {"id_does_not_fit_a_word", "add=1,", "add=65537,",
         "line 2 of the .ini: function 'add' has id '65537'; 1 is expected"},
        {"return_type_three", "sum.c,1", "sum.c,3",
         "line 2 of the .ini: return type '3' is not known; 0, 1 or 2 is expected"},
        {"return_type_missing", "sum.c,1", "sum.c,",
         "line 2 of the .ini: return type '' is not known; 0, 1 or 2 is expected"},
        {"return_type_differs", "sum.c,1", "sum.c,2",
         "function 1 'add': return type 1 in the .bin, 2 in the .ini"},
        {"second_function_is_not_in_the_bin", "sum.c,1\n", "sum.c,1\nsub=2,sum.c,1\n",
         "function 2 'sub': the .bin is truncated"},
        {"only_function_missing", "add=1,sum.c,1\n", "",
         "line 4 of the .ini: section 'add.line' belongs to no function"},
    }),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    LinesAndSymbols, IniTest,
    testing::ValuesIn(std::vector<IniChange>{
        {"line_number_missing", "3=17\n", "",
         "line 9 of the .ini: '4=18' is not the source line of instruction 3"},
        {"line_numbers_exchanged", "3=17\n4=18", "4=18\n3=17",
         "line 9 of the .ini: '4=18' is not the source line of instruction 3"},
        {"line_number_is_negative", "3=17", "3=-17",
         "line 9 of the .ini: '3=-17' is not the source line of instruction 3"},
        {"line_number_does_not_fit", "3=17", "3=65536",
         "line 9 of the .ini: '3=65536' is not the source line of instruction 3"},
        {"last_line_number_missing", "6=21\n", "",
         "function 1 'add': 7 instructions in the .bin, source lines of 6 in the .ini"},
        {"line_number_too_many", "6=21\n", "6=21\n7=22\n",
         "function 1 'add': 7 instructions in the .bin, source lines of 8 in the .ini"},
        {"symbol_without_type", "sum=0,1", "sum=0",
         "line 4 of the .ini: '0' is not of the form id,dataType"},
        {"symbol_without_id", "sum=0,1", "sum=,1",
         "line 4 of the .ini: ',1' is not of the form id,dataType"},
        {"symbol_with_three_numbers", "sum=0,1", "sum=0,1,1",
         "line 4 of the .ini: '0,1,1' is not of the form id,dataType"},
        {"symbol_with_blank", "sum=0,1", "sum=0, 1",
         "line 4 of the .ini: '0, 1' is not of the form id,dataType"},
        {"array_of_nothing", "sum=0,1", "sum[0]=0,1",
         "line 4 of the .ini: 'sum[0]' is not an array of 1 to 1024 elements"},
        {"array_too_large", "sum=0,1", "sum[1025]=0,1",
         "line 4 of the .ini: 'sum[1025]' is not an array of 1 to 1024 elements"},
        {"array_without_size", "sum=0,1", "sum[]=0,1",
         "line 4 of the .ini: 'sum[]' is not an array of 1 to 1024 elements"},
        {"array_not_closed", "sum=0,1", "sum[=0,1",
         "line 4 of the .ini: 'sum[' is not an array of 1 to 1024 elements"},
        {"text_after_the_size", "sum=0,1", "sum[2]x=0,1",
         "line 4 of the .ini: 'sum[2]x' is not an array of 1 to 1024 elements"},
    }),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    OwnSection, IniTest,
    testing::ValuesIn(std::vector<IniChange>{
        {"format_two", "format=1", "format=2",
         "line 19 of the .ini: object format '2' is not known; 1 is expected"},
        {"double_unknown", "double=32.16", "double=64",
         "line 20 of the .ini: double format '64' is not known; 32.16 or 16.16 is expected"},
        {"checksum_differs", "bin_crc32=e", "bin_crc32=f",
         "line 21 of the .ini: checksum 'f72a6151' expected, the .bin has e72a6151: it is damaged "
         "or belongs to another .ini; compile the program again"},
        {"key_unknown", "format=1", "version=1",
         "line 19 of the .ini: 'version' is not known in section 'oncard'"},
        {"key_missing", "double=32.16\n", "",
         "line 18 of the .ini: section 'oncard' is not complete; format, double and bin_crc32 are "
         "expected"},
        {"section_empty", "format=1\ndouble=32.16\nbin_crc32=e72a6151\n", "",
         "line 18 of the .ini: section 'oncard' is not complete; format, double and bin_crc32 are "
         "expected"},
    }),
    [](const auto& row) { return row.param.name; });

TEST(IniToleranceTest, LineEndsOfEitherKindAndEmptyLinesMeanNothing) {
  ObjectFiles files = WriteObject(SumObject(), false);
  std::string windows = "\xEF\xBB\xBF";  // the byte order mark that editors put first
  for (const char c : files.ini) windows += c == '\n' ? std::string("\r\n\r\n") : std::string(1, c);
  windows.resize(windows.size() - 4);  // the last line may have no line end
  files.ini = windows;
  const Result<Object> object = ReadObject(files);
  ASSERT_TRUE(object.ok()) << object.error().message.en;
  EXPECT_EQ(object.value(), SumObject());
}

TEST(IniToleranceTest, SectionsOfNothingMayBeMissing) {
  Object object = ArrayObject();
  object.functions.erase(object.functions.begin());
  object.globals.clear();
  ObjectFiles files = WriteObject(object, true);
  EXPECT_EQ(files.ini,
            "[function]\nnothing=1,array.c,1\n[global]\n[nothing.line]\n[nothing.var]\n");
  files.ini = "[function]\nnothing=1,array.c,1\n";
  const Result<Object> read = ReadObject(files);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value(), object);
}

TEST(IniToleranceTest, FileNamesMayHoldAnythingPrintable) {
  for (const std::string name :
       {"a,b.c", "a=b.c", "a;b:c#.c", "[a].c", "", " a .c", "\xD4\xCB\xB6\xAF.c", "C:\\dir\\a.c"}) {
    Object object = SumObject();
    object.functions[0].file = name;
    ExpectRoundTrip(object, false);
  }
}

TEST(IniToleranceTest, LongLinesAreNotCut) {
  Object object = SumObject();
  object.functions[0].file = std::string(100000, 'x');
  ExpectRoundTrip(object, false);
}

TEST(IniToleranceTest, NamesThatDifferInCaseAreDifferent) {
  Object object = SumObject();
  object.functions[0].variables[1].name = "Begin";
  ExpectRoundTrip(object, false);
}

// --- Damage of the .bin -------------------------------------------------------------------------

// Without a checksum, so that the decoder sees the damage.
std::string MessageWithWord(size_t index, uint16_t word) {
  ObjectFiles files = WriteObject(SumObject(), true);
  files.bin[2 * index] = static_cast<char>(word & 0xFF);
  files.bin[2 * index + 1] = static_cast<char>(word >> 8);
  return MessageOf(files);
}

TEST(BinTest, HeaderAgreesWithTheIni) {
  EXPECT_EQ(MessageWithWord(0, 2), "function 1 'add': its id in the .bin is 2");
  EXPECT_EQ(MessageWithWord(1, 0), "function 1 'add': return type 0 in the .bin, 1 in the .ini");
  EXPECT_EQ(MessageWithWord(2, 6),
            "function 1 'add': 6 instructions in the .bin, source lines of 7 in the .ini");
  EXPECT_EQ(MessageWithWord(2, 32768), "function 1 'add': 32768 instructions; 32767 are allowed");
}

TEST(BinTest, DamagedRecordIsNamed) {
  // Word 4 is the first record's opcode, word 14 the second record's.
  EXPECT_EQ(MessageWithWord(4, 0x1234), "function 1 'add': record 0: opcode 0x1234 is not known");
  EXPECT_EQ(MessageWithWord(14, 0x1234), "function 1 'add': record 1: opcode 0x1234 is not known");
  EXPECT_EQ(MessageWithWord(3, 0xFFFF), "function 1 'add': record 0: the record is truncated");
}

TEST(BinTest, LengthIsExact) {
  ObjectFiles files = WriteObject(SumObject(), true);
  const std::string whole = files.bin;
  files.bin = whole + '\0';
  EXPECT_EQ(MessageOf(files), "the .bin has 141 bytes, which are not whole words of two");
  files.bin = whole + std::string(2, '\0');
  EXPECT_EQ(MessageOf(files), "1 words follow the last function of the .ini");
  files.bin = "";
  EXPECT_EQ(MessageOf(files), "function 1 'add': the .bin is truncated");
  for (size_t size = 0; size < whole.size(); ++size) {
    files.bin = whole.substr(0, size);
    EXPECT_NE(MessageOf(files), "accepted") << size;
  }
}

TEST(BinTest, FilesOfDifferentProgramsAreRefused) {
  const ObjectFiles sum = WriteObject(SumObject(), false);
  const ObjectFiles array = WriteObject(ArrayObject(), false);
  EXPECT_NE(MessageOf({sum.bin, array.ini}), "accepted");
  EXPECT_NE(MessageOf({array.bin, sum.ini}), "accepted");
}

// --- Limits --------------------------------------------------------------------------------------

Object WithEmptyFunctions(int count) {
  Object object;
  for (int i = 0; i < count; ++i) {
    Function function;
    function.name = fmt::format("f{}", i);
    function.file = "f.c";
    object.functions.push_back(function);
  }
  return object;
}

TEST(ObjectLimitTest, Functions) {
  ExpectRoundTrip(WithEmptyFunctions(kFunctionMax), false);
  EXPECT_EQ(MessageOf(WriteObject(WithEmptyFunctions(kFunctionMax + 1), false), 7),
            "the program has more than 32 functions");
}

TEST(ObjectLimitTest, InstructionsAndSlots) {
  Object object = SumObject();
  Function& function = object.functions[0];
  function.instructions.assign(kInstructionMax, Jump(Local(1023), 0));
  function.lines.assign(kInstructionMax, 65535);
  function.variables = {{"a", 0, DataType::kInt, 1024}};
  ExpectRoundTrip(object, false);
}

// --- Pairs of files ------------------------------------------------------------------------------

class ObjectPairTest : public testing::Test {
 protected:
  ObjectPairTest() {
    const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              fmt::format("oncard_{}_{}", info->name(), ::getpid());
    std::filesystem::create_directories(folder_);
  }
  ~ObjectPairTest() override { std::filesystem::remove_all(folder_); }

  std::string Path(std::string_view name) const { return (folder_ / name).string(); }

  void Write(std::string_view name, const std::string& content) const {
    std::ofstream(Path(name), std::ios::binary) << content;
  }

  void WriteSum() const {
    const ObjectFiles files = WriteObject(SumObject(), false);
    Write("sum.bin", files.bin);
    Write("sum.ini", files.ini);
  }

  static Error ErrorOf(const std::string& path) {
    const Result<Object> object = ReadObjectPair(path);
    EXPECT_FALSE(object.ok());
    return object.ok() ? Error{0, {}} : object.error();
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(ObjectPairTest, IsReadFromItsFolder) {
  WriteSum();
  const Result<Object> object = ReadObjectPair(Path("sum.bin"));
  ASSERT_TRUE(object.ok()) << object.error().message.en;
  EXPECT_EQ(object.value(), SumObject());
}

TEST_F(ObjectPairTest, MissingBinIs2007) {
  const Error error = ErrorOf(Path("sum.bin"));
  EXPECT_EQ(error.code, 2007);
  EXPECT_EQ(error.message.en,
            "there is no file '" + Path("sum.bin") + "'; compile the program first");
  EXPECT_EQ(ErrorOf("").code, 2007);
}

TEST_F(ObjectPairTest, NameThatIsNotABinIs2007) {
  WriteSum();
  const Error error = ErrorOf(Path("sum.ini"));
  EXPECT_EQ(error.code, 2007);
  EXPECT_EQ(error.message.en, "the name '" + Path("sum.ini") + "' does not end in '.bin'");
  EXPECT_EQ(ErrorOf(Path("sum")).code, 2007);
}

TEST_F(ObjectPairTest, TooLongNameIs2007) {
  // The name is checked before the file is searched for.
  const std::string longest = std::string(kObjectPathMax - 4, 'a') + ".bin";
  EXPECT_THAT(ErrorOf(longest).message.en, HasSubstr("there is no file"));
  const Error error = ErrorOf("a" + longest);
  EXPECT_EQ(error.code, 2007);
  EXPECT_THAT(error.message.en, HasSubstr("has 126 bytes; 125 are allowed"));
}

TEST_F(ObjectPairTest, MissingIniIs2008) {
  WriteSum();
  std::filesystem::remove(Path("sum.ini"));
  const Error error = ErrorOf(Path("sum.bin"));
  EXPECT_EQ(error.code, 2008);
  EXPECT_EQ(error.message.en, "cannot open '" + Path("sum.ini") + "': No such file or directory");
}

TEST_F(ObjectPairTest, FolderIs2008) {
  std::filesystem::create_directory(Path("sum.bin"));
  const Error error = ErrorOf(Path("sum.bin"));
  EXPECT_EQ(error.code, 2008);
  EXPECT_EQ(error.message.en, "cannot open '" + Path("sum.bin") + "': it is a folder");
}

TEST_F(ObjectPairTest, EndlessDeviceIs2008) {
  WriteSum();
  std::filesystem::remove(Path("sum.bin"));
  std::filesystem::create_symlink("/dev/zero", Path("sum.bin"));
  EXPECT_EQ(ErrorOf(Path("sum.bin")).code, 2008);
}

TEST_F(ObjectPairTest, HugeFileIs2008) {
  WriteSum();
  std::filesystem::resize_file(Path("sum.bin"), uintmax_t{1} << 40);  // sparse
  const Error error = ErrorOf(Path("sum.bin"));
  EXPECT_EQ(error.code, 2008);
  EXPECT_THAT(error.message.en, HasSubstr("an object file has at most 268435456"));
}

TEST_F(ObjectPairTest, DamageIs2008AndNamesTheFile) {
  WriteSum();
  Write("sum.bin", "");
  const Error error = ErrorOf(Path("sum.bin"));
  EXPECT_EQ(error.code, 2008);
  EXPECT_EQ(error.message.en.find(Path("sum.bin") + ": line 21 of the .ini: checksum"), 0u);
}

TEST_F(ObjectPairTest, TooManyFunctionsAre7) {
  const ObjectFiles files = WriteObject(WithEmptyFunctions(33), false);
  Write("many.bin", files.bin);
  Write("many.ini", files.ini);
  EXPECT_EQ(ErrorOf(Path("many.bin")).code, 7);
}

TEST(IniPathTest, ExchangesTheEnding) {
  EXPECT_EQ(IniPathFor("dir/sum.bin"), "dir/sum.ini");
  EXPECT_EQ(IniPathFor("a.bin.bin"), "a.bin.ini");
}

}  // namespace
}  // namespace oncard::vm
