// The generated conversions between structures of gts.h and cells.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

#include "gtcalls/gts/catalogue.h"
#include "runtime/host/host_structures.h"

// Last, because its constants are macros.
#include "LookAheadEx.h"

namespace oncard::runtime {
namespace {

using gtcalls::GtsCatalogue;

template <typename T>
std::vector<double> ToCells(const char* name, const T& value) {
  const gtcalls::Structure& structure = *GtsCatalogue().FindStructure(name);
  std::vector<double> cells(static_cast<size_t>(gtcalls::CellCount(structure)));
  StructureToCells(structure, &value, cells);
  return cells;
}

TEST(StructureCellsTest, AreTheMembersInTheirOrder) {
  EXPECT_EQ(ToCells("TTrapPrm", TTrapPrm{0.25, 0.125, 1.5, 25}),
            (std::vector{0.25, 0.125, 1.5, 25.0}));
  EXPECT_EQ(ToCells("TThreadSts", TThreadSts{1, 7, -2.5, 30}), (std::vector{1.0, 7.0, -2.5, 30.0}));
}

// On a host whose long has 64 bits: 32-bit values are read as signed; larger values are left for
// the command's range check.
TEST(StructureCellsTest, ReadLongsAsTheCardDoes) {
  TPid pid = {};
  pid.integralLimit = static_cast<long>(0xffffffffu);
  pid.derivativeLimit = std::numeric_limits<long>::max();
  const std::vector<double> cells = ToCells("TPid", pid);
  EXPECT_EQ(cells[5], -1);
  EXPECT_EQ(cells[6], static_cast<double>(std::numeric_limits<long>::max()));
}

TEST(StructureCellsTest, GiveBackNumbersWithinTheirTypes) {
  TPid pid = {};
  StructureFromCells(*GtsCatalogue().FindStructure("TPid"),
                     std::vector<double>{0, 0, 0, 0, 0, 1e30, -1e30, 1e30}, &pid);
  EXPECT_EQ(pid.integralLimit, std::numeric_limits<long>::max());
  EXPECT_EQ(pid.derivativeLimit, std::numeric_limits<long>::min());
  EXPECT_EQ(pid.limit, 32767);
}

TEST(StructureCellsTest, CountArraysElementByElement) {
  EXPECT_EQ(ToCells("TCompensate2DTable", TCompensate2DTable{{1, 2}, {-3, 4}, {5, 6}}),
            (std::vector<double>{1, 2, -3, 4, 5, 6}));
}

TEST(StructureCellsTest, LookAheadParameters) {
  TLookAheadParameter parameter = {};
  parameter.lookAheadNum = 200;
  parameter.time = 0.1;
  parameter.radiusRatio = 0.01;
  parameter.vMax[0] = 1;
  parameter.aMax[1] = 2;
  parameter.DVMax[2] = 3;
  parameter.scale[3] = 4;
  parameter.axisRelation[7] = 8;
  std::strcpy(parameter.machineCfgFileName, "machine.cfg");
  std::vector<double> cells(43);
  cells[0] = 200;
  cells[1] = 0.1;
  cells[2] = 0.01;
  cells[3] = 1;
  cells[12] = 2;
  cells[21] = 3;
  cells[30] = 4;
  cells[42] = 8;
  EXPECT_EQ(ToCells("TLookAheadParameter", parameter), cells);
}

TEST(StructureCellsTest, LeaveTextOut) {
  EXPECT_EQ(ToCells("TVarInfo", TVarInfo{3, 2, "sum"}), (std::vector<double>{3, 2}));
}

TEST(StructureCellsTest, KeepTheTextOfAStructureThatIsWritten) {
  TVarInfo variable = {0, 0, "sum"};
  StructureFromCells(*GtsCatalogue().FindStructure("TVarInfo"), std::vector<double>{4, 1},
                     &variable);
  EXPECT_EQ(variable.id, 4);
  EXPECT_EQ(variable.dataType, 1);
  EXPECT_STREQ(variable.name, "sum");
}

// motionType, circlePlat, pos[8], radius, circleDir, center[3], vel, acc, velEndZero: 18 cells
// precede the nested operation, whose 7 cells precede cos.
TEST(StructureCellsTest, HoldANestedStructureInItsPlace) {
  TCrdData data;
  std::memset(&data, 0, sizeof data);
  std::vector<double> cells(36);
  std::iota(cells.begin(), cells.end(), 0);
  StructureFromCells(*GtsCatalogue().FindStructure("TCrdData"), cells, &data);
  EXPECT_EQ(data.circlePlat, 1);
  EXPECT_EQ(data.pos[7], 9);
  EXPECT_EQ(data.velEndZero, 17);
  EXPECT_EQ(data.operation.flag, 18);
  EXPECT_EQ(data.operation.dataExt[1], 24);
  EXPECT_EQ(data.cos[0], 25);
  EXPECT_EQ(data.r, 35);
  EXPECT_EQ(ToCells("TCrdData", data), cells);
}

TEST(StructureCellsTest, ComeBackUnchangedForEveryStructure) {
  for (const gtcalls::Structure& structure : gtcalls::GtsCatalogue().structures()) {
    std::vector<double> cells(static_cast<size_t>(gtcalls::CellCount(structure)));
    std::iota(cells.begin(), cells.end(), 1);
    std::vector<std::max_align_t> host(64);
    StructureFromCells(structure, cells, host.data());
    std::vector<double> back(cells.size());
    StructureToCells(structure, host.data(), back);
    EXPECT_EQ(back, cells) << structure.name;
  }
}

}  // namespace
}  // namespace oncard::runtime
