#include "runtime/host/marshal.h"
#include "gtcalls/gts/catalogue.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "LookAheadEx.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {
namespace {

const gtcalls::Command& CommandNamed(std::string_view name) {
  return *gtcalls::GtsCatalogue().Find(name);
}

/// The arguments of one call, read from the host.
template <typename... Args>
struct Marshalled {
  explicit Marshalled(std::string_view name, Args... args)
      : command(CommandNamed(name)),
        host{ToHostArgument(args)...},
        read(ReadArguments(command, host, &controller.card(), &call)) {}

  int code() const { return read.ok() ? 0 : read.error().code; }

  const gtcalls::Command& command;
  Controller controller;
  std::array<HostArgument, sizeof...(Args)> host;
  MarshalledCall call;
  Result<void> read;
};

TEST(MarshalTest, ScalarsTravelAsDoubles) {
  Marshalled call("GT_SetDo", static_cast<short>(12), -5L);
  ASSERT_EQ(call.code(), 0);
  EXPECT_EQ(call.call.arguments[0].value, 12);
  EXPECT_EQ(call.call.arguments[1].value, -5);
  EXPECT_FALSE(call.call.arguments[0].null);
}

TEST(MarshalTest, ALongIsAThirtyTwoBitPattern) {
  struct Case {
    int64_t host;
    int64_t value;
  };
  const Case cases[] = {
      {0, 0},
      {-1, -1},
      {0xFFFFFFFF, -1},
      {0x80000000, INT32_MIN},
      {INT32_MIN, INT32_MIN},
      {INT32_MAX, INT32_MAX},
  };
  for (const Case& c : cases) {
    Marshalled call("GT_SetLongVar", static_cast<short>(0), static_cast<long>(c.host));
    ASSERT_EQ(call.code(), 0) << c.host;
    EXPECT_EQ(call.call.arguments[1].value, static_cast<double>(c.value)) << c.host;
  }
}

TEST(MarshalTest, ALongBeyondThirtyTwoBitsIsOutOfRange) {
  if (sizeof(long) == 4) GTEST_SKIP() << "long has 32 bits here";
  for (const int64_t host :
       {int64_t{INT32_MIN} - 1, int64_t{UINT32_MAX} + 1, std::numeric_limits<int64_t>::max()}) {
    Marshalled call("GT_SetLongVar", static_cast<short>(0), static_cast<long>(host));
    EXPECT_EQ(call.code(), 7) << host;
  }
}

TEST(MarshalTest, OfAMaskTheLowerThirtyTwoBitsCount) {
  if (sizeof(long) == 4) GTEST_SKIP() << "long has 32 bits here";
  constexpr auto kGpo = static_cast<short>(12);
  const int64_t from_the_stack = 0x7FFD'1234'0000'0000;
  for (const int64_t bits : {int64_t{3}, int64_t{-1}, int64_t{INT32_MIN}}) {
    const auto host = static_cast<long>(from_the_stack | (bits & UINT32_MAX));
    Marshalled mask("GT_Update", host);
    ASSERT_EQ(mask.code(), 0) << bits;
    EXPECT_EQ(mask.call.arguments[0].value, static_cast<double>(bits)) << bits;
    Marshalled word("GT_SetDo", kGpo, host);
    ASSERT_EQ(word.code(), 0) << bits;
    EXPECT_EQ(word.call.arguments[1].value, static_cast<double>(bits)) << bits;
  }
}

TEST(MarshalTest, AnUnsignedLongIsAThirtyTwoBitPattern) {
  std::array<unsigned char, 6> address{};
  Marshalled call("GetMacAddress", static_cast<unsigned long>(-1), address.data(), 6UL);
  ASSERT_EQ(call.code(), 0);
  EXPECT_EQ(call.call.arguments[0].value, 4294967295.0);
}

TEST(MarshalTest, NullIsRefusedUnlessItMayBeLeftOut) {
  unsigned long clock = 0;
  unsigned long* const null = nullptr;
  EXPECT_EQ(Marshalled("GT_GetClock", &clock, null).code(), 0);
  EXPECT_EQ(Marshalled("GT_GetClock", null, &clock).code(), 7);
  const char* const no_text = nullptr;
  EXPECT_EQ(Marshalled("GT_Download", no_text).code(), 7);
}

TEST(MarshalTest, TheCountIsCheckedBeforeMemoryIsTouched) {
  // Only one element of memory: AddressSanitizer would report reading more.
  double value = 1.5;
  TVarInfo info{};
  for (const int count : {0, -1, 7, 32767, -32768}) {
    Marshalled call("GT_SetVarValue", static_cast<short>(-1), &info, &value,
                    static_cast<short>(count));
    EXPECT_EQ(call.code(), 7) << count;
    EXPECT_TRUE(call.call.arguments[2].null) << count;
  }
  Marshalled call("GT_SetVarValue", static_cast<short>(-1), &info, &value, static_cast<short>(1));
  ASSERT_EQ(call.code(), 0);
  ASSERT_EQ(call.call.arguments[2].cells.size(), 1u);
  EXPECT_EQ(call.call.arguments[2].cells[0], 1.5);
}

TEST(MarshalTest, CaptureOffsetsAreAsManyAsTheListHas) {
  Controller controller;
  controller.card().motion.capture().SetOffsets(1, {10, -20, 30}, 1);
  const gtcalls::Command& command = CommandNamed("GT_GetCaptureOffset");
  struct Case {
    int encoder;
    size_t elements;
  };
  for (const Case& c : {Case{2, 3}, {1, 0}, {0, 0}, {9, 0}, {-1, 0}}) {
    std::array<long, 3> offsets{};
    short count = 0;
    long loop = 0;
    const std::array host = {ToHostArgument(static_cast<short>(c.encoder)),
                             ToHostArgument(offsets.data()), ToHostArgument(&count),
                             ToHostArgument(&loop)};
    MarshalledCall call;
    ASSERT_TRUE(ReadArguments(command, host, &controller.card(), &call).ok());
    EXPECT_EQ(call.arguments[1].cells.size(), c.elements) << c.encoder;
  }
}

TEST(MarshalTest, StructuresAreTheirScalarsWithoutText) {
  TVarInfo info{7, 2, "speed"};
  double value = 0;
  Marshalled call("GT_GetVarValue", static_cast<short>(0), &info, &value, static_cast<short>(1));
  ASSERT_EQ(call.code(), 0);
  const auto cells = call.call.arguments[1].cells;
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0], 7);
  EXPECT_EQ(cells[1], 2);
}

TEST(MarshalTest, OutputsAreWrittenInTheHostsTypes) {
  TThreadSts status{};
  Marshalled call("GT_GetThreadSts", static_cast<short>(0), &status);
  ASSERT_EQ(call.code(), 0);
  const auto cells = call.call.arguments[1].cells;
  ASSERT_EQ(cells.size(), 4u);
  cells[0] = 1;
  cells[1] = -7;
  cells[2] = 0.5;
  cells[3] = 13;
  WriteOutputs(call.command, call.call, vm::kOk);
  EXPECT_EQ(status.run, 1);
  EXPECT_EQ(status.error, -7);
  EXPECT_EQ(status.result, 0.5);
  EXPECT_EQ(status.line, 13);

  long value = 0;
  Marshalled bits("GT_GetDi", static_cast<short>(4), &value);
  bits.call.arguments[1].cells[0] = -1;
  WriteOutputs(bits.command, bits.call, vm::kOk);
  EXPECT_EQ(value, -1);
}

TEST(MarshalTest, OfARefusedCommandOnlyTheAbortCodeIsWritten) {
  unsigned char target[2] = {1, 2};
  unsigned long size = 7;
  unsigned long abort_code = 0;
  Marshalled call("GT_EcatSDOUpload", static_cast<unsigned short>(0),
                  static_cast<unsigned short>(0x6041), static_cast<unsigned char>(0), &target[0],
                  2UL, &size, &abort_code);
  ASSERT_EQ(call.code(), 0);
  call.call.arguments[6].cells[0] = 0x06020000;
  WriteOutputs(call.command, call.call, vm::kBadParameter);
  EXPECT_EQ(abort_code, 0u);
  WriteOutputs(call.command, call.call, vm::kRefused);
  EXPECT_EQ(abort_code, 0x06020000u);
  EXPECT_EQ(size, 7u);
  EXPECT_EQ(target[0], 1);
}

TEST(MarshalTest, EveryElementOfAnArrayOfStructuresIsRead) {
  T2DCompareData points[3] = {{1, -2}, {3, -4}, {5, -6}};
  Marshalled call("GT_2DCompareData", static_cast<short>(0), static_cast<short>(3), points,
                  static_cast<short>(0));
  ASSERT_EQ(call.code(), 0);
  const auto cells = call.call.arguments[2].cells;
  EXPECT_EQ(std::vector(cells.begin(), cells.end()), (std::vector<double>{1, -2, 3, -4, 5, -6}));
}

TEST(MarshalTest, EveryElementOfAnArrayOfStructuresIsWrittenAndNoMore) {
  TTriggerStatus status[4] = {};
  status[3].position = -77;
  Marshalled call("GT_GetTriggerStatus", static_cast<short>(1), status, static_cast<short>(3));
  ASSERT_EQ(call.code(), 0);
  const auto cells = call.call.arguments[1].cells;
  ASSERT_EQ(cells.size(), 9u);
  for (size_t cell = 0; cell < cells.size(); ++cell) cells[cell] = static_cast<double>(10 + cell);
  WriteOutputs(call.command, call.call, vm::kOk);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(status[i].execute, 10 + 3 * i);
    EXPECT_EQ(status[i].done, 11 + 3 * i);
    EXPECT_EQ(status[i].position, 12 + 3 * i);
  }
  EXPECT_EQ(status[3].position, -77);
}

TEST(MarshalTest, ACountOfZeroWhereItIsAllowedCoversNothing) {
  long positions[1] = {5};
  Marshalled call("GT_CompareData", static_cast<short>(1), static_cast<short>(0),
                  static_cast<short>(0), static_cast<short>(0), static_cast<short>(10), positions,
                  static_cast<short>(1), positions, static_cast<short>(0));
  ASSERT_EQ(call.code(), 0);
  EXPECT_EQ(call.call.arguments[5].cells.size(), 1u);
  EXPECT_EQ(call.call.arguments[7].cells.size(), 0u);
  EXPECT_FALSE(call.call.arguments[7].null);
}

// The vendor's library uses the host's memory for its look-ahead; the simulated card has its own.
TEST(MarshalTest, ANumberIsNoAddress) {
  const auto axis = static_cast<short>(1);
  auto* const number = reinterpret_cast<double*>(sizeof(double));
  EXPECT_EQ(Marshalled("GT_GetVel", axis, number).code(), 7);
}

// int has 32 bits on every host, as the enumerations of LookAheadEx.h.
TEST(MarshalTest, AnArrayHasAsManyElementsAsItsRowSays) {
  int modes[9] = {1, -2, 3, 4, 5, 6, 7, INT32_MAX, 99};
  Marshalled call("GT_SetAxisLimitModeLa", static_cast<short>(1), modes);
  ASSERT_EQ(call.code(), 0);
  EXPECT_EQ(
      std::vector<double>(call.call.arguments[1].cells.begin(), call.call.arguments[1].cells.end()),
      (std::vector<double>{1, -2, 3, 4, 5, 6, 7, INT32_MAX}));
  Marshalled mode("GT_SetupLookAheadCrd", static_cast<short>(1), MULTI_AXES);
  EXPECT_EQ(mode.call.arguments[1].value, 1);
}

TEST(MarshalTest, LentMemoryIsNotTouched) {
  TCrdData* const no_buffer = nullptr;
  TCrdData* const no_address = reinterpret_cast<TCrdData*>(sizeof(TCrdData));
  const auto crd = static_cast<short>(1);
  const auto fifo = static_cast<short>(0);
  const auto count = static_cast<short>(200);
  Marshalled call("GT_InitLookAhead", crd, fifo, 5.0, 10.0, count, no_address);
  EXPECT_EQ(call.code(), 0);
  EXPECT_FALSE(call.call.arguments[5].null);
  EXPECT_TRUE(call.call.cells.empty());
  EXPECT_EQ(Marshalled("GT_InitLookAhead", crd, fifo, 5.0, 10.0, count, no_buffer).code(), 7);
}

TEST(MarshalTest, AValueThatDoesNotFitTheHostsTypeIsCut) {
  short index = 0;
  Marshalled call("GT_GetCardNo", &index);
  for (const auto& [cell, expected] :
       {std::pair{1e300, SHRT_MAX}, std::pair{-1e300, SHRT_MIN},
        std::pair{std::numeric_limits<double>::quiet_NaN(), SHRT_MIN}}) {
    call.call.arguments[0].cells[0] = cell;
    WriteOutputs(call.command, call.call, vm::kOk);
    EXPECT_EQ(index, expected) << cell;
  }
}

TEST(MarshalTest, EveryCommandTakesNullAndZeroWithoutACrash) {
  for (const gtcalls::Command& command : gtcalls::GtsCatalogue().commands()) {
    std::array<HostArgument, gtcalls::kParameterMax> host{};
    for (size_t i = 0; i < command.parameters.size(); ++i) {
      if (command.parameters[i].passing != gtcalls::Passing::kValue) {
        host[i].kind = HostArgument::Kind::kPointer;
      }
    }
    MarshalledCall call;
    const auto arguments = std::span(host).first(command.parameters.size());
    const auto read = ReadArguments(command, arguments, nullptr, &call);
    bool needs_pointer = false;
    for (const gtcalls::Parameter& parameter : command.parameters) {
      needs_pointer =
          needs_pointer || (parameter.passing != gtcalls::Passing::kValue && !parameter.nullable);
    }
    EXPECT_EQ(read.ok(), !needs_pointer) << command.name;
    WriteOutputs(command, call, vm::kOk);
  }
}

}  // namespace
}  // namespace oncard::runtime
