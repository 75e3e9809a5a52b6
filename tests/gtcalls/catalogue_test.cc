// The catalogue's rows: how many there are, which of them programs may call, and that each is
// consistent. interface_types_test.cc checks that they agree with gts.h.
#include "gtcalls/gts/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace oncard::gtcalls::gts {
namespace {

// The lines of a file in this folder that are not comments.
std::vector<std::string> ReadLines(const std::string& name) {
  std::ifstream file(std::string(ONCARD_SOURCE_DIR "/tests/gtcalls/") + name);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("#")) lines.push_back(line);
  }
  return lines;
}

long CountTier(Tier tier) {
  return std::ranges::count(GtsCatalogue().commands(), tier, &Command::tier);
}

const Parameter& ParameterOf(std::string_view command, std::string_view parameter) {
  const Command& row = *GtsCatalogue().Find(command);
  return *std::ranges::find(row.parameters, parameter, &Parameter::name);
}

// 393 of the public interface, and GT_GetDacValue, GT_GetPtRemainder, GetMacAddress and the five
// commands for ferroelectric memory, which are only in the manual; 31 of the multi-axis look-ahead,
// and 35 of EtherCAT.
TEST(CatalogueTest, HoldsTheWholeInterface) {
  EXPECT_EQ(GtsCatalogue().commands().size(), 467u);
  EXPECT_EQ(CountTier(Tier::kA), 171 + 3 + 5 + 31 + 35);
  EXPECT_EQ(CountTier(Tier::kB), 207);
  EXPECT_EQ(CountTier(Tier::kX), 15);
}

TEST(CatalogueTest, FindsEveryCommandByNameAndByNumber) {
  std::set<std::string_view> names;
  for (const Command& command : GtsCatalogue().commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_EQ(GtsCatalogue().Find(command.name), &command);
    EXPECT_EQ(GtsCatalogue().Find(command.number), &command);
  }
}

TEST(CatalogueTest, FindsNothingForAnUnknownNameOrNumber) {
  EXPECT_EQ(GtsCatalogue().Find("GT_AxisOnn"), nullptr);
  EXPECT_EQ(GtsCatalogue().Find(""), nullptr);
  EXPECT_EQ(GtsCatalogue().Find(uint16_t{0}), nullptr);
  EXPECT_EQ(GtsCatalogue().Find(static_cast<uint16_t>(GtsCatalogue().commands().size() + 1)),
            nullptr);
  EXPECT_EQ(GtsCatalogue().Find(uint16_t{0xFFFF}), nullptr);
  EXPECT_EQ(GtsCatalogue().FindStructure("TNothing"), nullptr);
  EXPECT_EQ(GtsCatalogue().FindConstant("MC_NOTHING"), nullptr);
}

TEST(CatalogueTest, NumbersAreFrozen) {
  const std::vector<std::string> frozen = ReadLines("frozen_numbers.txt");
  ASSERT_EQ(frozen.size(), GtsCatalogue().commands().size()) << "add the new command's line";
  for (size_t i = 0; i < frozen.size(); ++i) {
    const Command& command = GtsCatalogue().commands()[i];
    EXPECT_EQ(std::to_string(command.number) + " " + std::string(command.name), frozen[i]);
  }
}

// --- Motion programs ----------------------------------------------------------------------------

TEST(CatalogueTest, ProgramsMayCallTheCommandsOfTable10_2) {
  const std::vector<std::string> names = ReadLines("table_10_2.txt");
  ASSERT_EQ(names.size(), 86u);
  for (const std::string& name : names) {
    ASSERT_NE(GtsCatalogue().Find(name), nullptr) << name;
    EXPECT_TRUE(GtsCatalogue().Find(name)->in_motion_program) << name;
  }
}

TEST(CatalogueTest, ProgramsMayCallWhatTheVendorsCompilerAccepts) {
  const std::vector<std::string> names = ReadLines("vendor_compiler.txt");
  ASSERT_EQ(names.size(), 134u);
  for (const std::string& name : names) {
    ASSERT_NE(GtsCatalogue().Find(name), nullptr) << name;
    EXPECT_TRUE(GtsCatalogue().Find(name)->in_motion_program) << name;
  }
}

TEST(CatalogueTest, ProgramsMayCallNothingElse) {
  std::set<std::string> allowed;
  for (const char* file : {"table_10_2.txt", "vendor_compiler.txt"}) {
    for (const std::string& name : ReadLines(file)) allowed.insert(name);
  }
  EXPECT_EQ(allowed.size(), 137u);
  for (const Command& command : GtsCatalogue().commands()) {
    EXPECT_EQ(command.in_motion_program, allowed.contains(std::string(command.name)))
        << command.name;
  }
}

TEST(CatalogueTest, CommandsThatMeanTheCallingThreadAreNotForHosts) {
  std::vector<std::string_view> program_only;
  for (const Command& command : GtsCatalogue().commands()) {
    if (!command.on_host) program_only.push_back(command.name);
  }
  EXPECT_EQ(program_only, (std::vector<std::string_view>{"GT_Delay", "GT_DelayHighPrecision",
                                                         "GT_SetDataPage", "GT_WaitForVarEq"}));
}

TEST(CatalogueTest, NoCommandWithTextIsForPrograms) {
  for (const Command& command : GtsCatalogue().commands()) {
    for (const Parameter& parameter : command.parameters) {
      if (parameter.passing == Passing::kText || parameter.passing == Passing::kTextOutput) {
        EXPECT_FALSE(command.in_motion_program) << command.name;
      }
    }
  }
}

// --- Time ---------------------------------------------------------------------------------------

// GTS manual, end of chapter 7.
TEST(CatalogueTest, FourStartCommandsTakeAMillisecond) {
  std::vector<std::string_view> slow;
  for (const Command& command : GtsCatalogue().commands()) {
    if (command.cost == Cost::kMillisecond) slow.push_back(command.name);
  }
  std::ranges::sort(slow);
  EXPECT_EQ(slow, (std::vector<std::string_view>{"GT_FollowStart", "GT_GearStart", "GT_PtStart",
                                                 "GT_Update"}));
}

TEST(CatalogueTest, OnlyOpenCloseAndCompileTakeNoTime) {
  for (const Command& command : GtsCatalogue().commands()) {
    const bool local =
        command.name == "GT_Open" || command.name == "GT_Close" || command.name == "GT_Compile";
    EXPECT_EQ(command.cost == Cost::kNone, local) << command.name;
  }
}

// --- Rows that are sound in themselves ----------------------------------------------------------

TEST(CatalogueTest, EveryRowSaysWhatItDoesAndWhatItRestsOn) {
  for (const Command& command : GtsCatalogue().commands()) {
    EXPECT_FALSE(command.brief.empty()) << command.name;
    EXPECT_FALSE(command.brief.ends_with(".")) << command.name;
    EXPECT_FALSE(command.source.empty()) << command.name;
  }
}

// Whether a text in UTF-8 has a character from U+4E00 to U+9FFF; these begin with E4 B8 to E9 BF.
bool HasChineseCharacter(std::string_view text) {
  return std::ranges::any_of(text, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0xE4 && byte <= 0xE9;
  });
}

TEST(CatalogueTest, EveryRowSaysInChineseWhatItDoes) {
  for (const Command& command : GtsCatalogue().commands()) {
    EXPECT_TRUE(HasChineseCharacter(command.brief_zh)) << command.name;
    EXPECT_FALSE(command.brief_zh.ends_with("。")) << command.name;
    EXPECT_FALSE(command.brief_zh.ends_with(".")) << command.name;
    EXPECT_FALSE(HasChineseCharacter(command.brief)) << command.name;
  }
}

TEST(CatalogueTest, CommandsDifferInBothLanguagesOrInNone) {
  std::map<std::string_view, std::string_view> chinese;
  std::map<std::string_view, std::string_view> english;
  for (const Command& command : GtsCatalogue().commands()) {
    EXPECT_EQ(chinese.emplace(command.brief, command.brief_zh).first->second, command.brief_zh)
        << command.name;
    EXPECT_EQ(english.emplace(command.brief_zh, command.brief).first->second, command.brief)
        << command.name;
  }
}

TEST(CatalogueTest, NoCommandHasMoreParametersThanFitACall) {
  for (const Command& command : GtsCatalogue().commands()) {
    EXPECT_LE(command.parameters.size(), static_cast<size_t>(kParameterMax)) << command.name;
  }
}

TEST(CatalogueTest, CountsAreBoundedIntegersOfTheSameCommand) {
  for (const Command& command : GtsCatalogue().commands()) {
    for (const Parameter& parameter : command.parameters) {
      const int index = parameter.count_parameter;
      if (index < 0) continue;
      EXPECT_TRUE(parameter.passing == Passing::kInput || parameter.passing == Passing::kOutput)
          << command.name;
      ASSERT_LT(static_cast<size_t>(index), command.parameters.size()) << command.name;
      const Parameter& count = command.parameters[static_cast<size_t>(index)];
      EXPECT_EQ(count.passing, Passing::kValue) << command.name;
      EXPECT_NE(count.type, Scalar::kDouble) << command.name;
      EXPECT_GE(count.minimum, 0) << command.name;
      EXPECT_LE(count.maximum, 32767) << command.name;
    }
  }
}

TEST(CatalogueTest, DefaultsStandOnlyAtTheEnd) {
  for (const Command& command : GtsCatalogue().commands()) {
    bool seen = false;
    for (const Parameter& parameter : command.parameters) {
      EXPECT_TRUE(!seen || !parameter.default_text.empty())
          << command.name << " " << parameter.name;
      seen = seen || !parameter.default_text.empty();
    }
  }
}

TEST(CatalogueTest, DefaultsAreNullOrAConstantOrANumberInRange) {
  for (const Command& command : GtsCatalogue().commands()) {
    for (const Parameter& parameter : command.parameters) {
      const std::string text(parameter.default_text);
      if (text.empty()) continue;
      if (parameter.passing != Passing::kValue) {
        EXPECT_EQ(text, "NULL") << command.name;
        EXPECT_TRUE(parameter.nullable) << command.name;
        continue;
      }
      const Constant* constant = GtsCatalogue().FindConstant(text);
      const double value =
          constant != nullptr ? static_cast<double>(constant->value) : std::stod(text);
      EXPECT_GE(value, parameter.minimum) << command.name << " " << parameter.name;
      EXPECT_LE(value, parameter.maximum) << command.name << " " << parameter.name;
    }
  }
}

TEST(CatalogueTest, OnlyValuesHaveRangesAndNoneIsEmpty) {
  for (const Command& command : GtsCatalogue().commands()) {
    for (const Parameter& parameter : command.parameters) {
      EXPECT_LT(parameter.minimum, parameter.maximum) << command.name << " " << parameter.name;
      if (parameter.passing == Passing::kValue) {
        EXPECT_EQ(parameter.structure, nullptr) << command.name;
      } else {
        EXPECT_EQ(SpellRange(parameter), "") << command.name << " " << parameter.name;
      }
    }
  }
}

TEST(CatalogueTest, AccessesNameValuesOfTheCommand) {
  for (const Command& command : GtsCatalogue().commands()) {
    for (const Access& access : command.accesses) {
      EXPECT_NE(access.resource, Resource::kNone) << command.name;
      EXPECT_LT(access.selector, static_cast<int>(command.parameters.size())) << command.name;
      EXPECT_LT(access.count_parameter, static_cast<int>(command.parameters.size()))
          << command.name;
      EXPECT_TRUE(!access.mask || access.selector >= 0) << command.name;
    }
  }
}

// The explorer treats commands that share no resource as independent.
TEST(CatalogueTest, EveryCommandOfProgramsSaysWhatItTouches) {
  for (const Command& command : GtsCatalogue().commands()) {
    if (command.in_motion_program) {
      EXPECT_FALSE(command.accesses.empty()) << command.name;
    }
  }
}

TEST(CatalogueTest, WritersWriteAndReadersOnlyRead) {
  const auto writes = [](std::string_view name) {
    return std::ranges::any_of(GtsCatalogue().Find(name)->accesses, &Access::write);
  };
  for (const char* name :
       {"GT_SetPos", "GT_Update", "GT_ClrSts", "GT_SetDo", "GT_AxisOn", "GT_ClearCaptureStatus",
        "GT_ClearTriggerStatus", "GT_PtClear", "GT_RunThread", "GT_SetVarValue", "GT_Reset"}) {
    EXPECT_TRUE(writes(name)) << name;
  }
  for (const char* name : {"GT_GetPos", "GT_GetSts", "GT_GetDi", "GT_GetDo", "GT_CrdSpace",
                           "GT_CrdStatus", "GT_PtSpace", "GT_GetThreadSts", "GT_GetVarValue"}) {
    EXPECT_FALSE(writes(name)) << name;
  }
}

/// The numbers that the integer types of a card hold, as 32-bit hosts pass them.
const std::map<Scalar, std::pair<double, double>> kHeld = {
    {Scalar::kChar, {-128, 127}},
    {Scalar::kUnsignedChar, {0, 255}},
    {Scalar::kShort, {-32768, 32767}},
    {Scalar::kUnsignedShort, {0, 65535}},
    {Scalar::kInt, {-0x1p31, 0x1p31 - 1}},
    {Scalar::kLong, {-0x1p31, 0x1p31 - 1}},
    {Scalar::kUnsignedLong, {0, 0x1p32 - 1}}};

TEST(CatalogueTest, NoRangeNamesNumbersThatItsTypeDoesNotHold) {
  for (const Command& command : GtsCatalogue().commands()) {
    for (const Parameter& parameter : command.parameters) {
      const auto held = kHeld.find(parameter.type);
      if (held == kHeld.end() || parameter.passing != Passing::kValue) continue;
      const auto& [first, last] = held->second;
      const std::string name = std::string(command.name) + " " + std::string(parameter.name);
      if (std::isfinite(parameter.minimum)) {
        EXPECT_GE(parameter.minimum, first) << name;
      }
      if (std::isfinite(parameter.maximum)) {
        EXPECT_LE(parameter.maximum, last) << name;
      }
    }
  }
}

// --- Ranges of the manual -----------------------------------------------------------------------

struct RangeCase {
  const char* command;
  const char* parameter;
  const char* range;
};

class RangeTest : public testing::TestWithParam<RangeCase> {};

TEST_P(RangeTest, IsTheManuals) {
  EXPECT_EQ(SpellRange(ParameterOf(GetParam().command, GetParam().parameter)), GetParam().range);
}

INSTANTIATE_TEST_SUITE_P(
    CatalogueTest, RangeTest,
    testing::Values(
        RangeCase{"GT_SetPos", "pos", "[-1073741823, 1073741823]"},
        RangeCase{"GT_SetStopDec", "decSmoothStop", "[1e-09, 32767]"},
        RangeCase{"GT_SetStopDec", "decAbruptStop", "[1e-09, 32767]"},
        RangeCase{"GT_ProfileScale", "alpha", "[-32766, 32766]"},
        RangeCase{"GT_EncScale", "beta", "[-32766, 32766]"},
        RangeCase{"GT_SetPosErr", "error", "[1, 2147483647]"},
        RangeCase{"GT_SetFollowLoop", "loop", "[-32768, 32767]"},
        RangeCase{"GT_SetPtLoop", "loop", "[0, inf)"}, RangeCase{"GT_PrfGear", "dir", "[-1, 1]"},
        RangeCase{"GT_LmtsOn", "limitType", "[-1, 1]"}, RangeCase{"GT_Bind", "thread", "[0, 31]"},
        RangeCase{"GT_Bind", "page", "[0, 31]"}, RangeCase{"GT_GetVarValue", "page", "[-1, 31]"},
        RangeCase{"GT_GetVarValue", "count", "[1, 6]"},
        RangeCase{"GT_GetEncPos", "encoder", "[1, 12]"},
        RangeCase{"GT_GetEncPos", "count", "[1, 8]"},
        RangeCase{"GT_SetCaptureSense", "sense", "[0, 1]"},
        RangeCase{"GT_SetOverride", "synVelRatio", "[1e-09, 1]"},
        RangeCase{"GT_SetVel", "vel", "(-32767, 32767)"}, RangeCase{"GT_GetSts", "pSts", ""}),
    [](const auto& param_info) {
      return std::string(param_info.param.command) + "_" + param_info.param.parameter;
    });

// --- Shapes for the machine ---------------------------------------------------------------------

TEST(CatalogueTest, ShapesMirrorTheRows) {
  for (const Command& command : GtsCatalogue().commands()) {
    const vm::CommandShape& shape = GtsCatalogue().ShapeOf(command);
    EXPECT_EQ(shape.number, command.number);
    EXPECT_EQ(shape.name, command.name);
    EXPECT_EQ(shape.in_motion_program, command.in_motion_program);
    ASSERT_EQ(shape.parameters.size(), command.parameters.size()) << command.name;
    for (size_t i = 0; i < shape.parameters.size(); ++i) {
      EXPECT_EQ(shape.parameters[i].name, command.parameters[i].name);
      EXPECT_EQ(shape.parameters[i].address, command.parameters[i].passing != Passing::kValue);
      EXPECT_EQ(shape.parameters[i].count_parameter, command.parameters[i].count_parameter);
      if (command.in_motion_program) {
        EXPECT_FALSE(shape.parameters[i].slots.empty()) << command.name;
      }
    }
  }
}

TEST(CatalogueTest, ShapeOfAStructureHasASlotPerMember) {
  const vm::CommandShape& shape = GtsCatalogue().ShapeOf(*GtsCatalogue().Find("GT_SetTrapPrm"));
  using enum vm::DataType;
  const std::vector<vm::DataType> slots(shape.parameters[1].slots.begin(),
                                        shape.parameters[1].slots.end());
  EXPECT_EQ(slots, (std::vector{kDouble, kDouble, kDouble, kInt}));
}

TEST(CatalogueTest, ShapeOfAnArrayNamesItsCount) {
  const vm::CommandShape& shape = GtsCatalogue().ShapeOf(*GtsCatalogue().Find("GT_GetPrfPos"));
  ASSERT_EQ(shape.parameters.size(), 4u);
  EXPECT_FALSE(shape.parameters[0].address);
  EXPECT_TRUE(shape.parameters[1].address);
  EXPECT_EQ(shape.parameters[1].count_parameter, 2);
  EXPECT_EQ(shape.parameters[1].slots[0], vm::DataType::kDouble);
  EXPECT_EQ(shape.parameters[3].count_parameter, -1);
  EXPECT_EQ(shape.parameters[3].slots[0], vm::DataType::kInt);
}

// --- Structures and constants -------------------------------------------------------------------

TEST(CatalogueTest, HoldsAllStructuresAndConstants) {
  // 44 of the public interface, and TCrdBufOperation, which one of them contains.
  EXPECT_EQ(GtsCatalogue().structures().size(), 47u);
  EXPECT_EQ(GtsCatalogue().constants().size(), 214u);
  for (const Structure& structure : GtsCatalogue().structures()) {
    EXPECT_EQ(GtsCatalogue().FindStructure(structure.name), &structure);
  }
  for (const Constant& constant : GtsCatalogue().constants()) {
    EXPECT_EQ(GtsCatalogue().FindConstant(constant.name), &constant);
  }
}

TEST(CatalogueTest, ProgramsMayDeclareThreeStructures) {
  std::vector<std::string_view> names;
  for (const Structure& structure : GtsCatalogue().structures()) {
    if (structure.in_motion_program) names.push_back(structure.name);
  }
  EXPECT_EQ(names, (std::vector<std::string_view>{"TTrapPrm", "TJogPrm", "TPid"}));
}

TEST(CatalogueTest, ParametersReferToTheStructuresOfTheTable) {
  for (const Command& command : GtsCatalogue().commands()) {
    for (const Parameter& parameter : command.parameters) {
      if (parameter.structure != nullptr) {
        EXPECT_EQ(GtsCatalogue().FindStructure(parameter.structure->name), parameter.structure)
            << command.name;
      }
    }
  }
}

TEST(CatalogueTest, CellsCountNestedMembersAndElementsButNoTextAndNoPointers) {
  EXPECT_EQ(CellCount(*GtsCatalogue().FindStructure("TTrapPrm")), 4);
  EXPECT_EQ(CellCount(*GtsCatalogue().FindStructure("TVarInfo")), 2);
  EXPECT_EQ(CellCount(*GtsCatalogue().FindStructure("TCompileInfo")), 0);
  EXPECT_EQ(CellCount(*GtsCatalogue().FindStructure("TCrdPrm")), 1 + 8 + 1 + 1 + 1 + 1 + 8);
  EXPECT_EQ(CellCount(*GtsCatalogue().FindStructure("TCrdBufOperation")), 7);
  EXPECT_EQ(CellCount(*GtsCatalogue().FindStructure("TCrdData")),
            2 + 8 + 1 + 1 + 3 + 2 + 1 + 7 + 8 + 1 + 1 + 1);
}

TEST(CatalogueTest, DeclaresParametersAsCDoes) {
  EXPECT_EQ(DeclareParameter(ParameterOf("GT_GetPrfPos", "pValue")), "double *pValue");
  EXPECT_EQ(DeclareParameter(ParameterOf("GT_GetPrfPos", "pClock")), "unsigned long *pClock");
  EXPECT_EQ(DeclareParameter(ParameterOf("GT_SetTrapPrm", "pPrm")), "TTrapPrm *pPrm");
  EXPECT_EQ(DeclareParameter(ParameterOf("GT_Download", "pFileName")), "const char *pFileName");
  EXPECT_EQ(DeclareParameter(ParameterOf("GT_GetVersion", "pVersion")), "char **pVersion");
  EXPECT_EQ(DeclareParameter(ParameterOf("GT_EncSns", "sense")), "unsigned short sense");
}

}  // namespace
}  // namespace oncard::gtcalls::gts
