// ENI files: what is read of them, what is wrong with them, and what is written.
#include "runtime/host/eni_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "runtime/host/host_bus.h"

namespace oncard::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using motion::bus::DefaultSlave;
using motion::bus::PdoEntry;
using motion::bus::SlaveKind;
using motion::bus::Slaves;

/// A file as configuration tools write it, with a PDO that is not assigned and objects that the
/// simulated drive does not have.
constexpr char kFile[] = R"(<?xml version="1.0"?>
<EtherCATConfig Version="1.3">
 <Config>
  <Master><Info><Name>Master</Name></Info></Master>
  <Slave>
   <Info><Name>Drive 1</Name><PhysAddr>1001</PhysAddr><VendorId>#x2E1</VendorId>
    <ProductCode>1026</ProductCode></Info>
   <ProcessData>
    <Send><BitStart>208</BitStart><BitLength>48</BitLength></Send>
    <Recv><BitStart>208</BitStart><BitLength>112</BitLength></Recv>
    <RxPdo Fixed="1" Sm="2"><Index>#x1600</Index><Name>Outputs</Name>
     <Entry><Index>#x6040</Index><SubIndex>0</SubIndex><BitLen>16</BitLen></Entry>
     <Entry><Index>#x607A</Index><SubIndex>0</SubIndex><BitLen>32</BitLen></Entry>
    </RxPdo>
    <RxPdo><Index>#x1601</Index>
     <Entry><Index>#x60FF</Index><SubIndex>0</SubIndex><BitLen>32</BitLen></Entry>
    </RxPdo>
    <TxPdo Sm="3"><Index>#x1A00</Index>
     <Entry><Index>#x6041</Index><SubIndex>0</SubIndex><BitLen>16</BitLen></Entry>
     <Entry><Index>#x2010</Index><SubIndex>1</SubIndex><BitLen>64</BitLen></Entry>
     <Entry><Index>#x6064</Index><SubIndex>0</SubIndex><BitLen>32</BitLen></Entry>
    </TxPdo>
   </ProcessData>
  </Slave>
  <Slave>
   <Info><VendorId>7</VendorId><ProductCode>#x10</ProductCode></Info>
   <ProcessData>
    <TxPdo Sm="3"><Index>#x1A00</Index>
     <Entry><Index>#x6000</Index><SubIndex>1</SubIndex><BitLen>1</BitLen></Entry>
     <Entry><Index>0</Index><BitLen>7</BitLen></Entry>
    </TxPdo>
   </ProcessData>
  </Slave>
 </Config>
</EtherCATConfig>
)";

std::string Without(std::string text, std::string_view what, std::string_view instead = "") {
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), instead);
}

TEST(EniFile, GivesIdentitiesAndTheAssignedProcessData) {
  const auto slaves = ParseEni(kFile, "Gecat.eni");
  ASSERT_TRUE(slaves.ok()) << slaves.error().message.en;
  ASSERT_EQ(slaves.value().size(), 2u);
  const auto& drive = slaves.value()[0];
  EXPECT_EQ(drive.kind, SlaveKind::kDrive);
  EXPECT_EQ(drive.axis, 0);
  EXPECT_EQ(drive.vendor, 0x2E1u);
  EXPECT_EQ(drive.product, 1026u);
  EXPECT_THAT(drive.outputs, ElementsAre(PdoEntry{0x6040, 0, 16}, PdoEntry{0x607A, 0, 32}));
  EXPECT_THAT(drive.inputs,
              ElementsAre(PdoEntry{0x6041, 0, 16}, PdoEntry{0, 0, 64}, PdoEntry{0x6064, 0, 32}));
  const auto& terminals = slaves.value()[1];
  EXPECT_EQ(terminals.kind, SlaveKind::kIo);
  EXPECT_EQ(terminals.axis, -1);
  EXPECT_THAT(terminals.inputs, ElementsAre(PdoEntry{0x6000, 1, 1}, PdoEntry{0, 0, 7}));
}

TEST(EniFile, WhatIsWrongIsNamedWithItsPlace) {
  const std::pair<std::string, std::string> kCases[] = {
      {"", "not XML"},
      {"<a>", "not XML"},
      {"<a/>", "EtherCATConfig/Config is missing"},
      {Without(kFile, "<VendorId>#x2E1</VendorId>"), "Gecat.eni:5:4: VendorId is ''"},
      {Without(kFile, "#x2E1", "#x1FFFFFFFF"), "a number from 0 to 4294967295"},
      {Without(kFile, "#x2E1", "-1"), "VendorId is '-1'"},
      {Without(kFile, "<BitLen>16</BitLen>", "<BitLen>0</BitLen>"), "at least 1 bit"},
      {Without(kFile, "<BitLength>48</BitLength>", "<BitLength>64</BitLength>"),
       "BitLength is 64, but the objects take 6 bytes"},
      {Without(Without(kFile, "<BitLen>32</BitLen>", "<BitLen>16</BitLen>"), "48", "32"),
       "object 607Ah of a drive has 32 bits, not 16"},
  };
  for (const auto& [text, expected] : kCases) {
    const auto slaves = ParseEni(text, "Gecat.eni");
    ASSERT_FALSE(slaves.ok()) << expected;
    EXPECT_THAT(slaves.error().message.en, HasSubstr(expected));
  }
}

TEST(EniFile, ABusThatIsTooLargeIsRefused) {
  std::string text = "<EtherCATConfig><Config>";
  for (int i = 0; i < 65; ++i) {
    text += "<Slave><Info><VendorId>1</VendorId><ProductCode>1</ProductCode></Info></Slave>";
  }
  const auto slaves = ParseEni(text + "</Config></EtherCATConfig>", "Gecat.eni");
  ASSERT_FALSE(slaves.ok());
  EXPECT_THAT(slaves.error().message.en, HasSubstr("more than 64 slaves"));
}

TEST(EniFile, IsReadBackAsItWasWritten) {
  Slaves slaves = {DefaultSlave(SlaveKind::kDrive), DefaultSlave(SlaveKind::kIo),
                   DefaultSlave(SlaveKind::kCoupler), DefaultSlave(SlaveKind::kDrive)};
  slaves[0].axis = 0;
  slaves[3].axis = 1;
  slaves[1].inputs = {{0x6000, 1, 1}, {0, 0, 7}};
  const auto again = ParseEni(FormatEni(slaves), "Gecat.eni");
  ASSERT_TRUE(again.ok()) << again.error().message.en;
  EXPECT_EQ(again.value(), slaves);
}

TEST(EniFile, AScenarioTakesItFromTheFolderOfTheProgram) {
  const std::string folder = ::testing::TempDir() + "/eni";
  std::filesystem::create_directories(folder);
  Scenario scenario;
  EXPECT_TRUE(TakeEni(folder, &scenario).en.empty());
  EXPECT_TRUE(scenario.bus.slaves.empty());
  ASSERT_TRUE(WriteFileAtomically(folder + "/Gecat.eni", kFile).ok());
  EXPECT_TRUE(TakeEni(folder, &scenario).en.empty());
  ASSERT_EQ(scenario.bus.slaves.size(), 2u);
  EXPECT_EQ(scenario.bus.slaves, scenario.bus.configured);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(SlaveOf(scenario.bus.slaves[i]), ParseEni(kFile, "").value()[i]);
  }
  // Slaves of the scenario are what is connected; a drive keeps its motor.
  BusSlaveSetup other;
  other.axis = 5;
  scenario.bus.slaves = {other};
  EXPECT_TRUE(TakeEni(folder, &scenario).en.empty());
  EXPECT_EQ(scenario.bus.slaves.size(), 1u);
  EXPECT_EQ(scenario.bus.configured[0].axis, 5);
  ASSERT_TRUE(WriteFileAtomically(folder + "/Gecat.eni", "<a>").ok());
  EXPECT_THAT(TakeEni(folder, &scenario).en, HasSubstr("not XML"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace oncard::runtime
