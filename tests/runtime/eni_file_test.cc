// ENI files: what is read of them, what is wrong with them, and what is written.
#include "runtime/host/eni_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "runtime/host/host_bus.h"
#include "runtime/scenario/record/call_record.h"
#include "runtime/scenario/run/scenario_card.h"

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
      {Without(kFile, "#x2E1", "#x1FFFFFFFF"), "a number from -2147483648 to 4294967295"},
      {Without(kFile, "#x2E1", "-2147483649"), "VendorId is '-2147483649'"},
      {Without(kFile, "#x2E1", "#x-1"), "VendorId is '#x-1'"},
      {Without(kFile, "#x2E1", "#x"), "VendorId is '#x'"},
      {Without(kFile, "<BitLen>16</BitLen>", ""), "BitLen is ''"},
      {Without(kFile, "<BitLen>16</BitLen>", "<BitLen>65536</BitLen>"), "from 0 to 65535"},
      {Without(kFile, "<Index>#x6040</Index>", ""), "Index is ''"},
      {Without(kFile, "<BitLength>48</BitLength>", ""), "BitLength is ''"},
      {Without(kFile, "<BitLength>48</BitLength>", "<BitLength>4294967295</BitLength>"),
       "the objects take 6 bytes"},
      {Without(kFile, "<VendorId>7", "<PhysAddr>1001</PhysAddr><VendorId>7"),
       "PhysAddr 1001 belongs to another slave"},
      {Without(kFile, "</Config>", "</Config><Config/>"), "a second bus"},
      {"<EtherCATConfig><Config><Master/></Config></EtherCATConfig>", "describes no slave"},
      {"<EtherCATInfo><Descriptions/></EtherCATInfo>", "not an ENI file"},
      {"<e:EtherCATConfig xmlns:e='x'><e:Config/></e:EtherCATConfig>", "not an ENI file"},
      {std::string(kFile).substr(0, 900), "not XML"},
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

/// As the tools of several vendors write it: a namespace, comments, CDATA, blanks around numbers,
/// identities as negative numbers, images in parts, long gaps, objects without a subindex.
TEST(EniFile, IsReadAsDifferentToolsWriteIt) {
  constexpr char kText[] = R"(<?xml version="1.0" encoding="utf-8"?>
<!-- made by a tool -->
<EtherCATConfig xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" Version="1.3">
 <Config>
  <Master><Info><Destination>ffffffffffff</Destination><EtherType>a488</EtherType></Info>
   <InitCmds><InitCmd><Cmd>8</Cmd><Data>00000000</Data></InitCmd></InitCmds></Master>
  <!-- the only one -->
  <Slave>
   <Info><Name><![CDATA[Drive <1> & co]]></Name><PhysAddr> #x3E9 </PhysAddr>
    <VendorId>-2147483646</VendorId><ProductCode><![CDATA[ 0X10 ]]></ProductCode></Info>
   <ProcessData>
    <Send><BitStart>0</BitStart><BitLength>32</BitLength></Send>
    <Send><BitStart>64</BitStart><BitLength>16</BitLength></Send>
    <Recv><BitStart>0</BitStart><BitLength>616</BitLength></Recv>
    <Sm2><Type>Outputs</Type><Pdo>5632</Pdo></Sm2>
    <RxPdo Fixed="true" Sm="2"><Index>#x1600</Index><Name><![CDATA[Outputs]]></Name>
     <Entry><Index>
       #x6040
      </Index><BitLen>16</BitLen><DataType>UINT</DataType></Entry>
     <Entry><Index>#x60<!-- target -->7A</Index><SubIndex>#x00</SubIndex><BitLen>32</BitLen></Entry>
    </RxPdo>
    <TxPdo Sm="3"><Index>#x1A00</Index>
     <Entry><Index>#x6041</Index><SubIndex>0</SubIndex><BitLen>16</BitLen></Entry>
     <Entry><Index>#x2000</Index><SubIndex>1</SubIndex><BitLen>600</BitLen></Entry>
    </TxPdo>
   </ProcessData>
   <Mailbox><CoE><InitCmds><InitCmd><Data>0800</Data></InitCmd></InitCmds></CoE></Mailbox>
  </Slave>
 </Config>
</EtherCATConfig>)";
  const auto slaves = ParseEni(kText, "Gecat.eni");
  ASSERT_TRUE(slaves.ok()) << slaves.error().message.en;
  const auto& drive = slaves.value().front();
  EXPECT_EQ(drive.vendor, 0x80000002u);
  EXPECT_EQ(drive.product, 0x10u);
  EXPECT_THAT(drive.outputs, ElementsAre(PdoEntry{0x6040, 0, 16}, PdoEntry{0x607A, 0, 32}));
  EXPECT_THAT(drive.inputs, ElementsAre(PdoEntry{0x6041, 0, 16}, PdoEntry{0, 0, 255},
                                        PdoEntry{0, 0, 255}, PdoEntry{0, 0, 90}));
}

TEST(EniFile, OfWindowsHasOtherEndsOfLinesAndAMark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : std::string_view(kFile)) text += c == '\n' ? "\r\n" : std::string(1, c);
  const auto slaves = ParseEni(text, "Gecat.eni");
  ASSERT_TRUE(slaves.ok()) << slaves.error().message.en;
  EXPECT_EQ(slaves.value(), ParseEni(kFile, "").value());
}

TEST(EniFile, ASlaveWithMoreObjectsThanTheImageHoldsIsRefused) {
  std::string text =
      "<EtherCATConfig><Config><Slave><Info><VendorId>1</VendorId><ProductCode>1</ProductCode>"
      "</Info><ProcessData><TxPdo><Index>#x1A00</Index>";
  for (int i = 0; i < 12'000; ++i) text += "<Entry><Index>0</Index><BitLen>1</BitLen></Entry>";
  text += "</TxPdo></ProcessData></Slave></Config></EtherCATConfig>";
  const auto slaves = ParseEni(text, "Gecat.eni");
  ASSERT_FALSE(slaves.ok());
  EXPECT_THAT(slaves.error().message.en, HasSubstr("1486 bytes of process data"));
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

/// A folder with a file, or without one.
class EniFolder : public ::testing::Test {
 protected:
  EniFolder() : folder_(::testing::TempDir() + "/eni") {
    std::filesystem::create_directories(folder_);
  }
  ~EniFolder() override { std::filesystem::remove_all(folder_); }
  void Write(const std::string& text) {
    ASSERT_TRUE(WriteFileAtomically(folder_ + "/Gecat.eni", text).ok());
  }
  /// The bus of a scenario with these slaves.
  BusSetup Take(const std::vector<BusSlaveSetup>& slaves = {}, int axis_count = 8) {
    Scenario scenario;
    scenario.axis_count = axis_count;
    scenario.bus.slaves = slaves;
    TakeEni(folder_, &scenario);
    return scenario.bus;
  }

  const std::string folder_;
};

Slaves Drives(size_t count) { return Slaves(count, DefaultSlave(SlaveKind::kDrive)); }

BusSlaveSetup DriveOfAxis(int axis) {
  BusSlaveSetup drive;
  drive.axis = axis;
  return drive;
}

TEST_F(EniFolder, WithoutAFileLeavesTheScenarioAsItIs) { EXPECT_EQ(Take(), BusSetup()); }

TEST_F(EniFolder, DescribesTheSlavesOfAScenarioThatHasNone) {
  Write(kFile);
  const BusSetup bus = Take();
  EXPECT_TRUE(bus.eni_error.en.empty());
  ASSERT_EQ(bus.slaves.size(), 2u);
  EXPECT_EQ(bus.slaves, bus.configured);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(SlaveOf(bus.slaves[i]), ParseEni(kFile, "").value()[i]);
  }
}

TEST_F(EniFolder, DoesNotChangeWhatIsConnected) {
  Write(kFile);
  const BusSetup bus = Take({DriveOfAxis(5)});
  EXPECT_EQ(bus.slaves.size(), 1u);
  EXPECT_EQ(bus.configured.size(), 2u);
  EXPECT_EQ(bus.configured[0].axis, 5);
}

TEST_F(EniFolder, TheOtherDrivesHaveTheAxesThatAreFree) {
  Write(FormatEni(Drives(3)));
  const BusSetup bus = Take({DriveOfAxis(2)});
  EXPECT_EQ(bus.configured[0].axis, 2);
  EXPECT_EQ(bus.configured[1].axis, 1);
  EXPECT_EQ(bus.configured[2].axis, 3);
}

TEST_F(EniFolder, MoreDrivesThanAxesAreAMistake) {
  Write(FormatEni(Drives(9)));
  EXPECT_THAT(Take().eni_error.en, HasSubstr("more drives than the card has axes, 8"));
  EXPECT_TRUE(Take({}, 12).eni_error.en.empty());
}

TEST_F(EniFolder, WhyTheFileCannotBeUsedIsKept) {
  Write("<a>");
  const BusSetup bus = Take({DriveOfAxis(1)});
  EXPECT_THAT(bus.eni_error.en, HasSubstr("not XML"));
  EXPECT_EQ(bus.slaves.size(), 1u);
  EXPECT_TRUE(bus.configured.empty());
}

TEST_F(EniFolder, AFileThatIsTooLargeIsNotRead) {
  Write(std::string(kEniKind.bytes_max + 1, ' '));
  EXPECT_THAT(Take().eni_error.en, HasSubstr("an ENI file has at most 8388608"));
}

/// What the card of a record says, as the card of the host did.
TEST_F(EniFolder, ARecordOfHostCallsKeepsIt) {
  for (const std::string& text : {std::string("<a>"), FormatEni(Drives(9)), FormatEni(Drives(3))}) {
    Write(text);
    Scenario scenario;
    scenario.bus = Take({DriveOfAxis(2)});
    const auto records =
        ParseCallRecords(FormatRecordHead() + FormatRecordedOpening(0, scenario, false) +
                             FormatRecordedEnd(0, {0, 1}),
                         "host.calls");
    ASSERT_TRUE(records.ok()) << records.error().message.en;
    const Scenario& again = records.value().front().scenario;
    EXPECT_EQ(again.bus, scenario.bus);
    EXPECT_EQ(again.bus.eni_error.zh, scenario.bus.eni_error.zh);
    Controller controller(CardOptions(again));
    ApplyWorld(again, &controller);
    EXPECT_EQ(controller.card().bus_error.en, scenario.bus.eni_error.en);
  }
}

}  // namespace
}  // namespace oncard::runtime
