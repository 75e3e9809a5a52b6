// Every command of the catalogue called by the host with all kinds of invalid arguments: each call
// returns a documented code, and the card continues.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "gtcalls/gts/catalogue.h"
#include "runtime/host/host_api.h"

namespace oncard::runtime {
namespace {

using gtcalls::Command;
using gtcalls::Passing;

/// Space for the largest number of elements of the largest structure that a pointer can refer to.
constexpr size_t kBufferSize = size_t{1} << 20;

/// Calls commands of card 3 with the same value in every scalar parameter.
class Caller {
 public:
  int16_t Call(const Command& command, double value, bool null) {
    std::array<HostArgument, gtcalls::kParameterMax> arguments{};
    for (size_t i = 0; i < command.parameters.size(); ++i) {
      const gtcalls::Parameter& parameter = command.parameters[i];
      if (parameter.passing != Passing::kValue) {
        arguments[i].kind = HostArgument::Kind::kPointer;
        if (!null) arguments[i].pointer = PointerFor(parameter, i);
      } else if (parameter.type == gtcalls::Scalar::kDouble) {
        arguments[i].kind = HostArgument::Kind::kReal;
        arguments[i].real = value;
      } else {
        arguments[i].integer = static_cast<int64_t>(value);
      }
    }
    const int16_t code =
        CallCard(3, command.number, std::span(arguments).first(command.parameters.size()));
    // The host owns the text that it is given.
    if (code == 0 && command.name == "GT_GetVersion") {
      std::free(*static_cast<char**>(arguments[0].pointer));
    }
    return code;
  }
  int16_t Call(const char* name) { return Call(*gtcalls::GtsCatalogue().Find(name), 0, false); }

 private:
  void* PointerFor(const gtcalls::Parameter& parameter, size_t index) {
    if (parameter.passing == Passing::kText) return name_.data();
    std::vector<char>& buffer = buffers_[index];
    buffer.assign(kBufferSize, 0);
    return buffer.data();
  }

  std::string name_ = "no such name";
  std::array<std::vector<char>, gtcalls::kParameterMax> buffers_;
};

/// Commands that the tests themselves use to open and close the card.
bool IsFrame(const Command& command) {
  return command.name == "GT_Open" || command.name == "GT_Close";
}

bool IsDocumented(int16_t code) {
  // From 102 on those of the multi-axis look-ahead; the negative ones are those of GT_InitEcatComm.
  constexpr int16_t kCodes[] = {0, 1, 7, 8, 102, 103, 104, 105, 107, 110, 2007, 2008, -8, -9, -10};
  return std::find(std::begin(kCodes), std::end(kCodes), code) != std::end(kCodes);
}

TEST(HostCatalogueTest, EveryCommandNeedsAnOpenCard) {
  Caller caller;
  for (const Command& command : gtcalls::GtsCatalogue().commands()) {
    if (command.name == "GT_Open" || command.name == "GT_SetCardNo" ||
        command.name == "GT_GetCardNo") {
      continue;
    }
    EXPECT_EQ(caller.Call(command, 0, true), -1) << command.name;
    EXPECT_EQ(caller.Call(command, 1, false), -1) << command.name;
  }
}

TEST(HostCatalogueTest, NoArgumentsBringACardDown) {
  setenv("ONCARD_CLOCK", "virtual", 1);
  Caller caller;
  ASSERT_EQ(caller.Call("GT_Open"), 0);
  for (const double value : {0.0, 1.0, -1.0, 2.0, 31.0, 32.0, 4096.0, 32767.0, -32768.0,
                             2147483647.0, -2147483648.0, 4294967295.0, 1e15, -1e15}) {
    for (const bool null : {false, true}) {
      for (const Command& command : gtcalls::GtsCatalogue().commands()) {
        if (IsFrame(command) || !command.on_host) continue;
        const int16_t code = caller.Call(command, value, null);
        EXPECT_TRUE(IsDocumented(code)) << command.name << " with " << value << ": " << code;
      }
    }
  }
  EXPECT_EQ(caller.Call("GT_Reset"), 0);
  EXPECT_EQ(caller.Call("GT_Close"), 0);
}

TEST(HostCatalogueTest, NullIsRefusedByEveryCommandThatNeedsAPointer) {
  setenv("ONCARD_CLOCK", "virtual", 1);
  Caller caller;
  ASSERT_EQ(caller.Call("GT_Open"), 0);
  for (const Command& command : gtcalls::GtsCatalogue().commands()) {
    const bool needs_pointer =
        std::any_of(command.parameters.begin(), command.parameters.end(),
                    [](const auto& p) { return p.passing != Passing::kValue && !p.nullable; });
    if (!needs_pointer || !command.on_host) continue;
    EXPECT_EQ(caller.Call(command, 1, true), 7) << command.name;
  }
  EXPECT_EQ(caller.Call("GT_Close"), 0);
}

}  // namespace
}  // namespace oncard::runtime
