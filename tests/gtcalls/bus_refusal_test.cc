// What commands of the EtherCAT bus return in every state of the bus, and for every wrong argument.
#include <gtest/gtest.h>

#include "tests/gtcalls/bus_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::WorldEventKind;
using motion::bus::DefaultSlave;
using motion::bus::ObjectId;
using motion::bus::SlaveKind;
using motion::bus::Slaves;

std::vector<double> cell(1);
std::vector<double> a(1), b(1), c(1), d(1);

struct AxisCall {
  std::string_view name;
  std::vector<Argument> rest;  ///< behind the axis
};

/// Every command whose first argument is an axis. GT_StartEcatHoming needs an enabled drive.
const AxisCall kAxisCalls[] = {
    {"GT_SetEcatHomingPrm", {3, 50, 3, 1, 0, 0}},
    {"GT_SetHomingMode", {8}},
    {"GT_StopEcatHoming", {}},
    {"GT_GetEcatHomingStatus", {&cell}},
    {"GT_SetTouchProbeFunction", {0x13}},
    {"GT_SetTouchProbeFunctionEx", {1, 1, 1, 0, 0, 0}},
    {"GT_GetTouchProbeStatus", {&cell, &a, &b, &c, &d}},
    {"GT_GetEcatAxisAI", {1, &cell}},
    {"GT_GetEcatAxisDI", {&cell}},
    {"GT_SetEcatAxisDO", {1}},
    {"GT_GetEcatAxisDO", {&cell}},
    {"GT_SetPosScale", {0}},
    {"GT_GetPosScale", {&cell}},
    {"GT_GetEcatEncPos", {&cell}},
    {"GT_GetEcatEncVel", {&cell}},
    {"GT_GetEcatAxisPE", {&cell}},
    {"GT_SetEcatAxisMode", {8}},
    {"GT_GetEcatAxisMode", {&cell}},
    {"GT_SetEcatAxisPT", {1}},
    {"GT_GetEcatAxisAtlTorque", {&cell}},
    {"GT_GetEcatAxisAtlCurrent", {&cell}},
    {"GT_SetEcatAxisPV", {1}},
};

void ExpectAll(BusCommandCard& card, int16_t code, int axis) {
  for (const AxisCall& each : kAxisCalls) {
    std::vector<Argument> arguments = {axis};
    arguments.insert(arguments.end(), each.rest.begin(), each.rest.end());
    card.Expect(code, each.name, arguments);
  }
  card.Expect(code == 0 ? 1 : code, "GT_StartEcatHoming", {axis});
}

TEST(BusRefusals, AxesNeedTheBusInOperation) {
  BusCommandCard card({CompleteDrive(0)});
  ExpectAll(card, 1, 1);
  card.Expect(0, "GT_InitEcatComm");
  for (int i = 0; i < 3; ++i) {  // INIT, PRE-OP, SAFE-OP
    ExpectAll(card, 1, 1);
    card.Cycles(200);
  }
  ExpectAll(card, 0, 1);
  card.Expect(0, "GT_StartEcatComm");
  ExpectAll(card, 0, 1);
  card.Expect(0, "GT_TerminateEcatComm");
  ExpectAll(card, 1, 1);
}

TEST(BusRefusals, AxesNeedADriveOnTheBusAndANumberOfTheCard) {
  BusCommandCard card({CompleteDrive(0)});
  card.Up();
  ExpectAll(card, 1, 2);
  for (const int axis : {0, -1, 9, 12, 13, -32768, 32767}) ExpectAll(card, 7, axis);
}

TEST(BusRefusals, AxesNeedADriveThatAnswers) {
  for (const WorldEventKind kind : {WorldEventKind::kBusLost, WorldEventKind::kBusSilent}) {
    BusCommandCard card({CompleteDrive(0), CompleteDrive(1)}, {{200'000, kind, 1, 0, 1}});
    card.Up();
    while (card.motion.now() <= 200'000) card.Cycle();
    ExpectAll(card, 0, 1);
    ExpectAll(card, 1, 2);
  }
}

/// A probe, an image or an object that a command cannot reach: its code, and nothing happens.
TEST(BusRefusals, WrongArgumentsReturnSeven) {
  BusCommandCard card({CompleteDrive(0), DefaultSlave(SlaveKind::kIo)});
  card.Up();
  std::vector<double> many(1486);
  const auto size = static_cast<int>(card.bus().image().size());
  card.Expect(0, "GT_GetEcatRawData", {0, size, &many});
  card.Expect(7, "GT_GetEcatRawData", {1, size, &many});
  card.Expect(7, "GT_GetEcatRawData", {size, 1, &many});
  card.Expect(7, "GT_GetEcatRawData", {0, 0, &many});
  card.Expect(7, "GT_GetEcatRawData", {65535, 65535, &many});
  card.Expect(7, "GT_SetEcatRawData", {65535, 1, &many});
  card.Expect(7, "GT_SetEcatRawData", {0, 1, nullptr});
  card.Expect(7, "GT_EcatIOReadInput", {1, 0, 5, &many});
  card.Expect(7, "GT_EcatIOReadInput", {1, 65535, 1, &many});
  card.Expect(7, "GT_EcatIOWriteOutput", {1, 0, 3, &many});
  card.Expect(1, "GT_EcatIOReadInput", {2, 0, 1, &many});
  card.Expect(1, "GT_EcatIOWriteOutput", {65535, 0, 1, &many});
  card.Expect(7, "GT_EcatSDODownload", {0, 0x6081, 0, &many, 4294967295.0, &cell});
  card.Expect(7, "GT_EcatSDOUpload", {0, 0x6081, 0, &many, 0, &a, &cell});
  card.Expect(7, "GT_IsEcatReady", {nullptr});
  card.Expect(7, "GT_GetEcatEncPos", {1, nullptr});
  for (const int channel : {0, 3, -1}) card.Expect(7, "GT_GetEcatAxisAI", {1, channel, &cell});
  for (const int mode : {-1, 2, 5, 7, 11}) {
    card.Expect(7, "GT_SetEcatAxisMode", {1, mode});
    card.Expect(7, "GT_SetHomingMode", {1, mode});
  }
  for (const int method : {0, 15, 16, 31, 32, 36, 38, -1}) {
    card.Expect(7, "GT_SetEcatHomingPrm", {1, method, 50, 3, 1, 0, 0});
  }
  card.Expect(7, "GT_SetEcatHomingPrm", {1, 3, 0, 3, 1, 0, 0});
  card.Expect(7, "GT_SetEcatHomingPrm", {1, 3, 50, -3, 1, 0, 0});
  card.Expect(7, "GT_SetEcatHomingPrm", {1, 3, 50, 3, 0, 0, 0});
  card.Expect(7, "GT_SetPosScale", {1, 65535});
  for (const int enable : {-1, 2}) {
    card.Expect(7, "GT_SetTouchProbeFunctionEx", {1, enable, 0, 1, 0, 0, 0});
  }
  card.Expect(7, "GT_SetTouchProbeFunctionEx", {1, 1, 2, 1, 0, 0, 0});
  card.Expect(7, "GT_SetTouchProbeFunctionEx", {1, 1, 0, 4, 0, 0, 0});
}

/// Services that end with each abort code (ETG.1000.6), as a host sees it. No object of a drive can
/// only be written, so 06010001h has a test of its own.
TEST(BusRefusals, EveryServiceHasItsAbortCode) {
  BusCommandCard card({CompleteDrive(0), CompleteDrive(1)},
                      {{600'000, WorldEventKind::kBusLost, 1, 0, 1}});
  card.Enable();
  std::vector<double> word(2), byte(1), number(4);
  const auto upload = [&](uint32_t code, int slave, int index, int subindex) {
    std::vector<double> target(4);
    card.Expect(code == 0 ? 0 : 1, "GT_EcatSDOUpload",
                {slave, index, subindex, &target, 4, &a, &cell});
    EXPECT_EQ(cell[0], code) << std::hex << index;
  };
  const auto download = [&](uint32_t code, int index, int subindex, std::vector<double>& data) {
    card.Expect(code == 0 ? 0 : 1, "GT_EcatSDODownload",
                {0, index, subindex, &data, static_cast<int>(data.size()), &cell});
    EXPECT_EQ(cell[0], code) << std::hex << index;
  };
  upload(0, 0, 0x6064, 0);
  upload(0x06020000, 0, 0x5000, 0);
  upload(0x06090011, 0, 0x6064, 1);
  upload(0x06070010, 0, 0x1008, 0);  // a text of 12 bytes
  upload(0x05040000, 7, 0x6064, 0);
  download(0x06020000, 0x5000, 0, word);
  download(0x06090011, 0x6099, 3, number);
  download(0x06010002, 0x6041, 0, word);
  download(0x06070010, 0x6081, 0, word);
  byte[0] = 15;
  download(0x06090030, 0x6098, 0, byte);
  download(0x06090030, 0x6083, 0, number);
  card.Expect(0, "GT_SetHomingMode", {1, 6});
  card.Expect(0, "GT_SetEcatHomingPrm", {1, 24, 50, 3, 1, 0, 0});
  card.Expect(0, "GT_StartEcatHoming", {1});
  card.Cycles(4);
  byte[0] = 3;
  download(0x08000022, 0x6098, 0, byte);
  card.Expect(1, "GT_SetEcatHomingPrm", {1, 3, 50, 3, 1, 0, 0});
  while (card.motion.now() <= 600'000) card.Cycle();
  upload(0x05040000, 1, 0x6064, 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
