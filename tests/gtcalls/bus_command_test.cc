// Commands of the EtherCAT bus: communication, process data, objects.
#include <gtest/gtest.h>

#include "tests/gtcalls/bus_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::WorldEventKind;
using motion::bus::DefaultSlave;
using motion::bus::FullDrive;
using motion::bus::SlaveKind;
using motion::bus::Slaves;

constexpr motion::Micros kLater = 400'000;

/// The manual's example of 5.2.2.4: two drives, two slaves with inputs and outputs.
Slaves ManualExample() {
  motion::bus::Slave first = DefaultSlave(SlaveKind::kDrive);
  first.axis = 0;
  motion::bus::Slave second = first;
  second.axis = 1;
  return {first, second, DefaultSlave(SlaveKind::kIo), DefaultSlave(SlaveKind::kIo)};
}

int16_t InitCode(std::shared_ptr<const Slaves> configured, const Slaves& connected,
                 std::string* why = nullptr) {
  CommandTestCard card;
  card.motion.ConnectBus(std::move(configured), std::make_shared<const Slaves>(connected));
  const int16_t code = card.Call("GT_InitEcatComm");
  if (why != nullptr) *why = card.reason.en;
  return code;
}

TEST(BusCommands, InitSaysWhatIsWrong) {
  const auto configured = std::make_shared<const Slaves>(ManualExample());
  std::string why;
  EXPECT_EQ(InitCode(configured, ManualExample()), 0);
  EXPECT_EQ(InitCode(nullptr, ManualExample()), -9);
  EXPECT_EQ(InitCode(configured, {}), -10);
  EXPECT_EQ(InitCode(configured, {ManualExample()[0]}, &why), -8);
  EXPECT_EQ(why, "slave 1 of the configuration is not connected");
  EXPECT_EQ(InitCode(configured, {ManualExample()[2]}, &why), -8);
  EXPECT_EQ(why, "slave 0 has another vendor or product than the configuration says");
}

TEST(BusCommands, ACardWithoutABusHasNoEniFile) {
  CommandTestCard card;
  card.Expect(-9, "GT_InitEcatComm");
  card.Expect(1, "GT_StartEcatComm");
  card.Expect(0, "GT_TerminateEcatComm");
  std::vector<double> cell(1, 7);
  card.Expect(0, "GT_IsEcatReady", {&cell});
  EXPECT_EQ(cell[0], 0);
  card.Expect(0, "GT_GetEcatSlaves", {&cell});
  EXPECT_EQ(cell[0], 0);
  card.Expect(1, "GT_GetEcatEncPos", {1, &cell});
}

TEST(BusCommands, TheBusIsReadyAfterThreeStepsOf50Ms) {
  BusCommandCard card(ManualExample());
  card.Expect(0, "GT_InitEcatComm");
  card.Cycles(599);
  EXPECT_EQ(card.Read("GT_IsEcatReady"), 0);
  card.Expect(1, "GT_StartEcatComm");
  card.Cycle();
  EXPECT_EQ(card.Read("GT_IsEcatReady"), 1);
  card.Expect(0, "GT_StartEcatComm");
  EXPECT_EQ(card.Read("GT_GetEcatSlaves"), 4);
  EXPECT_EQ(card.Read("GT_GetMcEcatAxisNum"), 2);
}

TEST(BusCommands, ALostSlaveIsCountedNoMore) {
  BusCommandCard card(ManualExample(), {{kLater, WorldEventKind::kBusLost, 2, 0, 1}});
  card.Up();
  card.Cycles(static_cast<int>(kLater / 250));
  EXPECT_EQ(card.Read("GT_IsEcatReady"), 0);
  EXPECT_EQ(card.Read("GT_GetEcatSlaves"), 2);
  EXPECT_EQ(card.Read("GT_GetMcEcatAxisNum"), 2);
  std::vector<double> bytes(2);
  card.Expect(1, "GT_EcatIOReadInput", {3, 2, 2, &bytes});
  card.Expect(-8, "GT_InitEcatComm");
  EXPECT_EQ(card.reason.en, "slave 2 does not answer");
}

TEST(BusCommands, TheBusCanBeginAgain) {
  BusCommandCard card(ManualExample());
  card.Enable();
  card.Expect(0, "GT_TerminateEcatComm");
  EXPECT_EQ(card.Read("GT_IsEcatReady"), 0);
  EXPECT_EQ(card.Read("GT_GetEcatSlaves"), 0);
  card.Cycle();
  EXPECT_EQ(card.Status() & 0x200, 0u);
  card.Expect(1, "GT_AxisOn", {1});
  card.Enable();
  EXPECT_NE(card.Status() & 0x200, 0u);
}

TEST(BusCommands, ReadAndWriteTheImageAtTheManualsOffsets) {
  BusCommandCard card(ManualExample());
  card.Up();
  card.bus().SetTerminal(2, 0, 0x1234);
  card.bus().SetTerminal(3, 0, 0x5678);
  std::vector<double> output = {0xAB, 0xCD};
  card.Expect(0, "GT_SetEcatRawData", {32, 2, &output});
  card.Cycle();
  std::vector<double> bytes(2);
  card.Expect(0, "GT_GetEcatRawData", {34, 2, &bytes});
  EXPECT_EQ(bytes, (std::vector<double>{0x34, 0x12}));
  card.Expect(0, "GT_GetEcatRawData", {38, 2, &bytes});
  EXPECT_EQ(bytes, (std::vector<double>{0x78, 0x56}));
  card.Expect(0, "GT_EcatIOReadInput", {2, 2, 2, &bytes});
  EXPECT_EQ(bytes, (std::vector<double>{0x34, 0x12}));
  card.Expect(0, "GT_EcatIOReadInput", {2, 0, 2, &bytes});
  EXPECT_EQ(bytes, output);
  card.Expect(0, "GT_EcatIOWriteOutput", {3, 0, 2, &output});
  card.Expect(0, "GT_GetEcatRawData", {36, 2, &bytes});
  EXPECT_EQ(bytes, output);
}

TEST(BusCommands, RefuseWhatIsOutsideOfTheImage) {
  BusCommandCard card(ManualExample());
  std::vector<double> bytes(2);
  card.Expect(1, "GT_GetEcatRawData", {0, 2, &bytes});
  card.Expect(1, "GT_SetEcatRawData", {0, 2, &bytes});
  card.Expect(1, "GT_EcatIOReadInput", {0, 0, 2, &bytes});
  card.Up();
  card.Expect(0, "GT_GetEcatRawData", {38, 2, &bytes});
  card.Expect(7, "GT_GetEcatRawData", {39, 2, &bytes});
  card.Expect(7, "GT_SetEcatRawData", {65535, 2, &bytes});
  card.Expect(0, "GT_EcatIOReadInput", {2, 2, 2, &bytes});
  card.Expect(7, "GT_EcatIOReadInput", {2, 3, 2, &bytes});
  card.Expect(7, "GT_EcatIOWriteOutput", {2, 1, 2, &bytes});
  card.Expect(1, "GT_EcatIOReadInput", {4, 0, 2, &bytes});
}

TEST(BusCommands, ReadAndWriteObjects) {
  BusCommandCard card(ManualExample());
  std::vector<double> data = {1, 2, 3, 4};
  std::vector<double> abort(1);
  std::vector<double> size(1);
  card.Expect(1, "GT_EcatSDODownload", {0, 0x6081, 0, &data, 4, &abort});
  EXPECT_EQ(abort[0], 0x05040000);
  card.Up();
  card.Expect(0, "GT_EcatSDODownload", {0, 0x6081, 0, &data, 4, &abort});
  EXPECT_EQ(abort[0], 0);
  std::vector<double> target(8, 9);
  card.Expect(0, "GT_EcatSDOUpload", {0, 0x6081, 0, &target, 8, &size, &abort});
  EXPECT_EQ(size[0], 4);
  EXPECT_EQ(target, (std::vector<double>{1, 2, 3, 4, 9, 9, 9, 9}));
  std::vector<double> little(2);
  card.Expect(1, "GT_EcatSDOUpload", {0, 0x6081, 0, &little, 2, &size, &abort});
  EXPECT_EQ(abort[0], 0x06070010);
  card.Expect(1, "GT_EcatSDODownload", {0, 0x6041, 0, &little, 2, &abort});
  EXPECT_EQ(abort[0], 0x06010002);
  EXPECT_EQ(card.reason.en, "slave 0, object 6041h:0: it can only be read");
}

}  // namespace
}  // namespace oncard::gtcalls::gts
