// Records of host calls: what is written is read back, and a card does the same again.
#include "runtime/scenario/record/call_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "gtcalls/gts/family.h"
#include "runtime/scenario/record/call_replay.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const gtcalls::Command& CommandOf(const std::string& name) {
  return *gtcalls::GtsFamily().catalogue.Find(name);
}

RecordedCall::Argument Value(double value) {
  RecordedCall::Argument argument;
  argument.value = value;
  return argument;
}

RecordedCall Call(int64_t time_us, const std::string& name,
                  std::vector<RecordedCall::Argument> arguments) {
  RecordedCall call;
  call.time_us = time_us;
  call.command = &CommandOf(name);
  call.arguments = std::move(arguments);
  return call;
}

std::string LineOf(const RecordedCall& call) {
  std::string line;
  AppendRecordedCall(0, call, &line);
  return line;
}

/// A record of card 0 with these lines between its opening and its end.
std::string Record(const std::string& lines) {
  return FormatRecordHead() + FormatRecordedOpening(0, Scenario{}, true) + lines;
}

CallRecord Read(const std::string& text) {
  auto records = ParseCallRecords(text, "host.calls");
  EXPECT_TRUE(records.ok()) << records.error().message.en;
  return records.ok() ? std::move(records.value().front()) : CallRecord{};
}

std::string RecordsError(const std::string& text) {
  const auto records = ParseCallRecords(text, "host.calls");
  return records.ok() ? "" : records.error().message.en;
}

// --- Writing and reading -------------------------------------------------------------------------

TEST(CallRecord, KeepsTheInputsOfACall) {
  RecordedCall::Argument prm;
  prm.cells = {0.5, 0.25, -0.0, 20};  // TTrapPrm: acc, dec, velStart, smoothTime
  const CallRecord record = Read(Record(LineOf(Call(100, "GT_SetTrapPrm", {Value(2), prm}))));
  ASSERT_EQ(record.calls.size(), 1u);
  const RecordedCall& call = record.calls[0];
  EXPECT_EQ(call.time_us, 100);
  EXPECT_EQ(call.command->name, "GT_SetTrapPrm");
  EXPECT_EQ(call.arguments[0].value, 2);
  EXPECT_EQ(call.arguments[1].cells, prm.cells);
  EXPECT_TRUE(std::signbit(call.arguments[1].cells[2]));
}

TEST(CallRecord, KeepsNumbersThatJsonDoesNotHave) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const CallRecord record =
      Read(Record(LineOf(Call(0, "GT_SetVel", {Value(1), Value(std::nan(""))})) +
                  LineOf(Call(0, "GT_SetVel", {Value(1), Value(-kInfinity)}))));
  EXPECT_TRUE(std::isnan(record.calls[0].arguments[1].value));
  EXPECT_EQ(record.calls[1].arguments[1].value, -kInfinity);
}

TEST(CallRecord, KeepsEveryByteOfAFile) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) bytes += static_cast<char>(byte);
  RecordedCall call = Call(0, "GT_LoadConfig", {{}});
  call.arguments[0].text = "\xB2\xE2.cfg";
  call.config = bytes;
  const CallRecord record = Read(Record(LineOf(call)));
  EXPECT_EQ(record.calls[0].arguments[0].text, "\xB2\xE2.cfg");
  EXPECT_EQ(record.calls[0].config, bytes);
}

TEST(CallRecord, HasOneRecordForEachOpeningOfACard) {
  const std::string text =
      FormatRecordHead() + FormatRecordedOpening(3, Scenario{}, true) +
      FormatRecordedOpening(1, Scenario{}, true) + FormatRecordedEnd(3, {0, 1}) +
      FormatRecordedOpening(3, Scenario{}, true) + FormatRecordedEnd(3, {0, 2});
  auto records = ParseCallRecords(text, "host.calls");
  ASSERT_TRUE(records.ok());
  ASSERT_EQ(records.value().size(), 3u);
  EXPECT_EQ(ChooseCallRecord(records.value(), {}, 1).value().card, 1);
  EXPECT_EQ(ChooseCallRecord(records.value(), 3, 2).value().end->hash, 2u);
  EXPECT_EQ(ChooseCallRecord(records.value(), 3, 3).error().message.en,
            "the record of card 3 has openings 1 to 2, not 3");
  EXPECT_EQ(ChooseCallRecord(records.value(), 0, 1).error().message.en,
            "the host has not opened card 0");
}

// --- Damaged records -----------------------------------------------------------------------------

TEST(CallRecord, NamesTheFirstLineThatIsDamaged) {
  const std::string good = LineOf(Call(100, "GT_Stop", {Value(1), Value(0)}));
  const std::string lines[] = {
      good.substr(0, good.size() / 2) + '\n',
      "[]\n",
      "{\"card\":0,\"us\":100,\"call\":\"GT_Halt\",\"in\":[],\"code\":0}\n",
      "{\"card\":0,\"us\":100,\"call\":\"GT_Stop\",\"in\":[1],\"code\":0}\n",
      "{\"card\":0,\"us\":100,\"call\":\"GT_Stop\",\"in\":[1,1.5],\"code\":0}\n",
      "{\"card\":0,\"us\":100,\"call\":\"GT_Stop\",\"in\":[1,null],\"code\":0}\n",
      "{\"card\":0,\"us\":100,\"call\":\"GT_Stop\",\"in\":[1,0],\"code\":\"0\"}\n",
      "{\"card\":0,\"us\":99,\"call\":\"GT_Stop\",\"in\":[1,0],\"code\":0}\n",
      "{\"card\":1,\"us\":100,\"call\":\"GT_Stop\",\"in\":[1,0],\"code\":0}\n",
      "{\"card\":0,\"us\":100,\"call\":\"GT_SetTrapPrm\",\"in\":[1,[0]],\"code\":0}\n",
      "{\"close\":0,\"us\":100,\"hash\":\"x\"}\n",
  };
  for (const std::string& line : lines) {
    EXPECT_THAT(RecordsError(Record(good + line)), StartsWith("host.calls:4: this is no line"))
        << line;
  }
}

TEST(CallRecord, LeavesNothingOpen) {
  Scenario open;
  open.world.inputs.push_back({.at_us = 1000, .index = 1, .last_us = 2000});
  const auto read =
      ParseCallRecords(FormatRecordHead() + FormatRecordedOpening(0, open, true), "host.calls");
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message.en, HasSubstr("host.calls:2:"));
}

TEST(CallRecord, EndsBeforeALastLineThatWasCut) {
  const std::string good = LineOf(Call(100, "GT_Stop", {Value(1), Value(0)}));
  for (size_t size = 0; size < good.size() - 1; ++size) {
    const CallRecord record = Read(Record(good + good.substr(0, size)));
    EXPECT_EQ(record.calls.size(), 1u) << size;
    EXPECT_FALSE(record.end) << size;
  }
}

TEST(CallRecord, EndsAtTheFirstZeroByte) {
  const std::string good = LineOf(Call(100, "GT_Stop", {Value(1), Value(0)}));
  const std::string zeros(5000, '\0');
  // The line that was being written when the host was killed lacks its first byte.
  for (const std::string& rest : {std::string(), good.substr(1), good.substr(1, 20)}) {
    const CallRecord record = Read(Record(good) + '\0' + rest + zeros);
    EXPECT_EQ(record.calls.size(), 1u) << rest;
    EXPECT_FALSE(record.end) << rest;
  }
  EXPECT_THAT(RecordsError(zeros), HasSubstr("this is no record of host calls"));
}

TEST(CallRecord, TellsAnotherFileFromARecord) {
  EXPECT_THAT(RecordsError(""), HasSubstr("this is no record of host calls"));
  EXPECT_THAT(RecordsError("{}\n"), HasSubstr("this is no record of host calls"));
  EXPECT_THAT(RecordsError("{\"oncard\":1,\"format\":1}\n"),
              HasSubstr("this is no record of host calls"));
  EXPECT_THAT(RecordsError("{\"oncard\":\"host calls\",\"format\":2}\n"),
              HasSubstr("this record has format 2; this version reads 1"));
  EXPECT_THAT(RecordsError(FormatRecordHead()), HasSubstr("the host has opened no card"));
}

// --- Replay --------------------------------------------------------------------------------------

/// What a replay of these lines finds wrong.
std::string DeviationOf(const std::string& lines) {
  const CallRecord record = Read(Record(lines));
  Controller controller(CardOptions(record.scenario));
  SwitchOn(record, &controller);
  const auto replay = CallReplay::Create(record, controller.commands());
  if (!replay.ok()) return replay.error().message.en;
  for (size_t i = 0; i < replay.value().size(); ++i) {
    controller.AdvanceUs(replay.value().TimeUs(i) - controller.NowUs());
    const auto done = replay.value().Execute(i, &controller);
    if (done.deviation) return done.deviation->en;
  }
  return {};
}

TEST(CallReplay, EndsWhereTheCardEnded) {
  Controller card;
  card.AdvanceUs(100);
  std::array<vm::CommandArgument, 1> arguments;
  arguments[0].value = 1;
  ASSERT_EQ(card.Execute(CommandOf("GT_AxisOn"), arguments), 0);
  card.AdvanceUs(1300);
  const std::string call = LineOf(Call(100, "GT_AxisOn", {Value(1)}));
  EXPECT_EQ(DeviationOf(call + FormatRecordedEnd(0, {1400, card.Hash()})), "");
  EXPECT_THAT(DeviationOf(call + FormatRecordedEnd(0, {1401, card.Hash()})),
              HasSubstr("the card is in another state than it was"));
}

TEST(CallReplay, ComparesTheCodes) {
  EXPECT_THAT(DeviationOf(LineOf(Call(0, "GT_AxisOn", {Value(9)}))),
              StartsWith("GT_AxisOn(9) returns 7 (parameter axis is 9; this card has 1 to 8) "
                         "instead of 0 as in the record"));
}

TEST(CallReplay, ReadsNoMoreThanTheRecordHas) {
  // Four values are announced, one is there.
  RecordedCall::Argument values;
  values.cells = {1};
  RecordedCall::Argument info;
  info.cells = {0, 0};
  RecordedCall call = Call(0, "GT_SetVarValue", {Value(-1), info, values, Value(4)});
  EXPECT_THAT(DeviationOf(LineOf(call)),
              HasSubstr("has inputs of another size than the card reads"));
}

TEST(CallReplay, KnowsWhichCallsChangeTheCard) {
  RecordedCall::Argument status;
  status.null = true;
  const CallRecord record = Read(Record(LineOf(Call(0, "GT_AxisOn", {Value(1)})) +
                                        LineOf(Call(50, "GT_GetThreadSts", {Value(0), status})) +
                                        FormatRecordedEnd(0, {100, 0})));
  const auto replay = CallReplay::Create(record, Controller().commands());
  ASSERT_TRUE(replay.ok());
  EXPECT_TRUE(replay.value().ChangesCard(0));
  EXPECT_FALSE(replay.value().ChangesCard(1)) << "it reads";
  EXPECT_FALSE(replay.value().ChangesCard(2)) << "the end";
}

TEST(CallReplay, RefusesADamagedProgram) {
  RecordedCall call = Call(0, "GT_Download", {{}});
  call.arguments[0].text = "sum.bin";
  call.program = {"not a program", ""};
  EXPECT_NE(DeviationOf(LineOf(call)), "");
}

}  // namespace
}  // namespace oncard::runtime
