// Object dictionaries and their services: the abort code of every wrong access.
#include "motion/bus/objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/motion/bus/bus_card.h"

namespace oncard::motion::bus {
namespace {

using ::testing::ElementsAre;

class Mailbox : public ::testing::Test {
 protected:
  Mailbox() : card_({FullDrive(0), DefaultSlave(SlaveKind::kIo)}) {
    card_.Power();
    card_.Up();
  }
  SdoAbort Read(size_t slave, uint16_t index, uint8_t subindex) {
    return card_.bus().Upload(slave, index, subindex, &data_);
  }
  SdoAbort Write(size_t slave, uint16_t index, uint8_t subindex, std::vector<uint8_t> data) {
    return card_.bus().Download(slave, index, subindex, data);
  }

  BusCard card_;
  std::vector<uint8_t> data_;
};

TEST_F(Mailbox, EveryWrongAccessHasItsAbortCode) {
  struct Case {
    size_t slave;
    uint16_t index;
    uint8_t subindex;
    std::vector<uint8_t> data;  ///< empty: an upload
    SdoAbort abort;
  };
  const Case cases[] = {
      {0, 0x6064, 0, {}, SdoAbort::kNone},
      {0, 0x5FFF, 0, {}, SdoAbort::kNoObject},
      {0, 0x6064, 1, {}, SdoAbort::kNoSubindex},
      {0, 0x6099, 3, {1, 0, 0, 0}, SdoAbort::kNoSubindex},
      {0, 0x6064, 0, {0, 0, 0, 0}, SdoAbort::kReadOnly},
      {0, 0x1008, 0, {0}, SdoAbort::kReadOnly},
      {0, 0x1018, 1, {0, 0, 0, 0}, SdoAbort::kReadOnly},
      {0, 0x6098, 0, {1, 0}, SdoAbort::kLength},
      {0, 0x607A, 0, {1}, SdoAbort::kLength},
      {0, 0x6098, 0, {15}, SdoAbort::kRange},  // a reserved homing method
      {0, 0x6060, 0, {2}, SdoAbort::kRange},   // a mode that the drive has not
      {0, 0x6083, 0, {0, 0, 0, 0}, SdoAbort::kRange},
      {0, 0x6098, 0, {3}, SdoAbort::kNone},
      {1, 0x1018, 2, {}, SdoAbort::kNone},
      {1, 0x6041, 0, {}, SdoAbort::kNoObject},
      {1, 0x6000, 2, {}, SdoAbort::kNoSubindex},
      {1, 0x6000, 1, {0, 0}, SdoAbort::kReadOnly},
      {1, 0x7000, 1, {0}, SdoAbort::kLength},
      {1, 0x7000, 1, {1, 2}, SdoAbort::kNone},
      {2, 0x1000, 0, {}, SdoAbort::kTimeout},
  };
  for (const Case& each : cases) {
    const SdoAbort abort = each.data.empty()
                               ? Read(each.slave, each.index, each.subindex)
                               : Write(each.slave, each.index, each.subindex, each.data);
    EXPECT_EQ(abort, each.abort) << each.slave << " " << std::hex << each.index << ":"
                                 << int{each.subindex};
  }
}

/// Every object that a drive has, with the length and the access that CiA 402 and ETG.1000.6 give
/// it.
TEST_F(Mailbox, ADriveHasTheObjectsOfTheStandard) {
  constexpr bool kRead = false;
  constexpr bool kWrite = true;
  struct Row {
    uint16_t index;
    uint8_t subindex;
    size_t bytes;
    bool writes;
  };
  const Row rows[] = {
      {0x1000, 0, 4, kRead},  {0x1018, 0, 1, kRead},  {0x1018, 1, 4, kRead},
      {0x1018, 2, 4, kRead},  {0x1018, 3, 4, kRead},  {0x1018, 4, 4, kRead},
      {0x20F2, 0, 2, kRead},  {0x20F9, 0, 2, kRead},  {0x6040, 0, 2, kWrite},
      {0x6041, 0, 2, kRead},  {0x605A, 0, 2, kWrite}, {0x6060, 0, 1, kWrite},
      {0x6061, 0, 1, kRead},  {0x6062, 0, 4, kRead},  {0x6064, 0, 4, kRead},
      {0x6065, 0, 4, kWrite}, {0x606C, 0, 4, kRead},  {0x6071, 0, 2, kWrite},
      {0x6072, 0, 2, kWrite}, {0x6073, 0, 2, kWrite}, {0x6074, 0, 2, kRead},
      {0x6077, 0, 2, kRead},  {0x6078, 0, 2, kRead},  {0x607A, 0, 4, kWrite},
      {0x607C, 0, 4, kWrite}, {0x607D, 0, 1, kRead},  {0x607D, 1, 4, kWrite},
      {0x607D, 2, 4, kWrite}, {0x607F, 0, 4, kWrite}, {0x6080, 0, 4, kWrite},
      {0x6081, 0, 4, kWrite}, {0x6083, 0, 4, kWrite}, {0x6084, 0, 4, kWrite},
      {0x6085, 0, 4, kWrite}, {0x6086, 0, 2, kWrite}, {0x6098, 0, 1, kWrite},
      {0x6099, 0, 1, kRead},  {0x6099, 1, 4, kWrite}, {0x6099, 2, 4, kWrite},
      {0x609A, 0, 4, kWrite}, {0x60B8, 0, 2, kWrite}, {0x60B9, 0, 2, kRead},
      {0x60BA, 0, 4, kRead},  {0x60BB, 0, 4, kRead},  {0x60BC, 0, 4, kRead},
      {0x60BD, 0, 4, kRead},  {0x60C1, 0, 1, kRead},  {0x60C1, 1, 4, kWrite},
      {0x60C2, 0, 1, kRead},  {0x60C2, 1, 1, kWrite}, {0x60C2, 2, 1, kWrite},
      {0x60F4, 0, 4, kRead},  {0x60FD, 0, 4, kRead},  {0x60FE, 0, 1, kRead},
      {0x60FE, 1, 4, kWrite}, {0x60FE, 2, 4, kWrite}, {0x60FF, 0, 4, kWrite},
      {0x6502, 0, 4, kRead},
  };
  EXPECT_EQ(std::size(rows), ObjectEntries().size());
  for (const Row& row : rows) {
    const testing::Message where = testing::Message()
                                   << std::hex << row.index << ":" << int{row.subindex};
    ASSERT_EQ(Read(0, row.index, row.subindex), SdoAbort::kNone) << where;
    EXPECT_EQ(data_.size(), row.bytes) << where;
    const std::vector<uint8_t> present = data_;
    const SdoAbort written = Write(0, row.index, row.subindex, present);
    EXPECT_EQ(written, row.writes ? SdoAbort::kNone : SdoAbort::kReadOnly) << where;
    if (!row.writes) continue;
    EXPECT_EQ(Write(0, row.index, row.subindex, std::vector<uint8_t>(row.bytes + 1)),
              SdoAbort::kLength)
        << where;
  }
}

TEST_F(Mailbox, ADriveSaysWhatItIs) {
  EXPECT_EQ(Read(0, 0x1000, 0), SdoAbort::kNone);
  EXPECT_THAT(data_, ElementsAre(0x92, 0x01, 0x02, 0x00));  // CiA 402, a servo drive
  EXPECT_EQ(Read(0, 0x6502, 0), SdoAbort::kNone);
  EXPECT_THAT(data_, ElementsAre(0xAD, 0x03, 0, 0));  // modes 1, 3, 4, 6, 8, 9 and 10
  EXPECT_EQ(Read(0, 0x1018, 1), SdoAbort::kNone);
  EXPECT_THAT(data_, ElementsAre(0xE1, 0x02, 0, 0));
}

TEST_F(Mailbox, AnObjectThatIsOnlyWrittenCannotBeRead) {
  EXPECT_EQ(CheckUpload({.access = ObjectAccess::kWriteOnly}), SdoAbort::kWriteOnly);
}

TEST_F(Mailbox, DataAreLittleEndianAndKeepTheirSign) {
  EXPECT_EQ(Write(0, 0x607C, 0, {0xFE, 0xFF, 0xFF, 0xFF}), SdoAbort::kNone);
  EXPECT_EQ(card_.object(ObjectId::kHomeOffset), -2);
  EXPECT_EQ(Read(0, 0x607C, 0), SdoAbort::kNone);
  EXPECT_THAT(data_, ElementsAre(0xFE, 0xFF, 0xFF, 0xFF));
}

TEST_F(Mailbox, TheNameIsAText) {
  EXPECT_EQ(Read(0, 0x1008, 0), SdoAbort::kNone);
  EXPECT_EQ(std::string(data_.begin(), data_.end()), "oncard drive");
}

TEST_F(Mailbox, ATerminalIsReadAsTheImageShowsIt) {
  EXPECT_EQ(Write(1, 0x7000, 1, {0x34, 0x12}), SdoAbort::kNone);
  EXPECT_EQ(card_.bus().image().bytes()[card_.bus().place(1).outputs], 0x34);
  card_.bus().SetTerminal(1, 0, 0xBEEF);
  EXPECT_EQ(Read(1, 0x6000, 1), SdoAbort::kNone);
  EXPECT_THAT(data_, ElementsAre(0xEF, 0xBE));
}

TEST_F(Mailbox, HomingParametersAreLockedWhileTheDriveHomes) {
  card_.core.AxisAt(0).ServoOn();
  card_.Ticks(8);
  card_.core.bus_axes().SetMode(0, DriveMode::kHoming);
  EXPECT_EQ(Write(0, 0x6098, 0, {33}), SdoAbort::kNone);
  card_.core.bus_axes().StartHoming(0);
  card_.Ticks(4);
  ASSERT_TRUE(card_.drive().homing().running());
  EXPECT_EQ(Write(0, 0x609A, 0, {1, 0, 0, 0}), SdoAbort::kState);
  EXPECT_EQ(Write(0, 0x6081, 0, {1, 0, 0, 0}), SdoAbort::kNone);
}

TEST_F(Mailbox, WorksFromPreOpOn) {
  card_.core.TerminateBus();
  EXPECT_EQ(Read(0, 0x6064, 0), SdoAbort::kTimeout);
  card_.bus().Init(card_.core.now());
  EXPECT_EQ(Read(0, 0x6064, 0), SdoAbort::kTimeout);
  while (card_.bus().phase() == BusPhase::kInit) card_.Ticks(1);
  EXPECT_EQ(Read(0, 0x6064, 0), SdoAbort::kNone);
}

}  // namespace
}  // namespace oncard::motion::bus
