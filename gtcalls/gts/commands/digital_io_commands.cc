// Digital inputs and outputs. Inputs and outputs are numbered from 1.
// Source: GTS manual chapter 10.4.3 and table 10-2; the public header for parameters and for the
// timed outputs. Tested by tests/gtcalls/digital_io_command_test.cc.
#include "gtcalls/gts/commands/commands.h"
#include "gtcalls/gts/defaults.h"
#include "gtcalls/gts/numbers.h"
#include "gtcalls/shared/senses.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::DigitalIo;
using motion::DiType;
using motion::DoType;

/// Assumption: GT_EnableDoBitPulse has the same time unit as GT_SetDoBitReverse.
constexpr int64_t kPulseTimeUnitUs = kTimeUnitUs;

/// To read, and to change it, which takes the card out of its lanes.
const DigitalIo& IoOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::io>();
}
DigitalIo& ChangeIo(const Call& call) { return call.card.motion.digital_io(); }
/// The catalogue's range ensures a valid number.
DiType DiOf(const Call& call) { return *DiTypeOf(call.integer(0)); }
DoType DoOf(const Call& call) { return *DoTypeOf(call.integer(0)); }

/// False, with the reason recorded, unless [first, first + count) lies in [1, width].
bool CheckIndex(Call& call, int first, int count, int width) {
  if (first >= 1 && first + count - 1 <= width) return true;
  call.reason =
      MakeMessage("inputs or outputs {0} to {1} of word {2} were requested; the word has 1 to {3}",
                  "访问第 {2} 类数字量的 {0} 到 {1}；其编号为 1 到 {3}", first, first + count - 1,
                  call.integer(0), width);
  return false;
}

bool CheckOutput(Call& call) { return CheckIndex(call, call.integer(1), 1, DoWidth(DoOf(call))); }

int BitOf(const Call& call) { return call.integer(1) - 1; }

}  // namespace

// --- Outputs ---------------------------------------------------------------------------------

int16_t GT_SetDo(Call& call) {
  ChangeIo(call).Write(DoOf(call), ~uint32_t{0}, BitWord(call.value(1)));
  return vm::kOk;
}

int16_t GT_SetDoMask(Call& call) {
  ChangeIo(call).Write(DoOf(call), BitWord(call.value(1)), BitWord(call.value(2)));
  return vm::kOk;
}

int16_t GT_SetDoBit(Call& call) {
  if (!CheckOutput(call)) return vm::kBadParameter;
  ChangeIo(call).WriteForAWhile(DoOf(call), BitOf(call), call.integer(2) != 0, 0);
  return vm::kOk;
}

int16_t GT_SetDoBitReverse(Call& call) {
  if (!CheckOutput(call)) return vm::kBadParameter;
  ChangeIo(call).WriteForAWhile(DoOf(call), BitOf(call), call.integer(2) != 0,
                                call.integer(3) * kTimeUnitUs);
  return vm::kOk;
}

int16_t GT_GetDo(Call& call) {
  call.Set(1, IoOf(call).Register(DoOf(call)));
  return vm::kOk;
}

int16_t GT_EnableDoBitPulse(Call& call) {
  if (!CheckOutput(call)) return vm::kBadParameter;
  const int high = call.integer(2);
  const int low = call.integer(3);
  const int pulses = call.integer(4);
  if (high < 1 || low < 1 || pulses < 0) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("{2} pulses of {0} high and {1} low were requested; times of at least 1, and 0 "
                    "(endless) or more pulses are expected",
                    "脉冲高电平时间 {0}、低电平时间 {1}、个数 {2}；时间至少应为 1，个数不小于 "
                    "0（0 为不限）",
                    high, low, pulses));
  }
  ChangeIo(call).StartPulses(DoOf(call), BitOf(call), high * kPulseTimeUnitUs,
                             low * kPulseTimeUnitUs, pulses, call.integer(5) != 0);
  return vm::kOk;
}

int16_t GT_DisableDoBitPulse(Call& call) {
  if (!CheckOutput(call)) return vm::kBadParameter;
  ChangeIo(call).StopTiming(DoOf(call), BitOf(call));
  return vm::kOk;
}

// --- Inputs ----------------------------------------------------------------------------------

int16_t GT_GetDi(Call& call) {
  call.Set(1, IoOf(call).Read(DiOf(call)));
  return vm::kOk;
}

int16_t GT_GetDiRaw(Call& call) {
  call.Set(1, IoOf(call).Pins(DiOf(call)));
  return vm::kOk;
}

int16_t GT_GetDiReverseCount(Call& call) {
  const int count = call.integer(3);
  if (!CheckIndex(call, call.integer(1), count, DiWidth(DiOf(call)))) return vm::kBadParameter;
  for (int i = 0; i < count; ++i) {
    call.Set(2, IoOf(call).Edges(DiOf(call), BitOf(call) + i), static_cast<size_t>(i));
  }
  return vm::kOk;
}

int16_t GT_SetDiReverseCount(Call& call) {
  const int count = call.integer(3);
  if (!CheckIndex(call, call.integer(1), count, DiWidth(DiOf(call)))) return vm::kBadParameter;
  for (int i = 0; i < count; ++i) {
    ChangeIo(call).SetEdges(DiOf(call), BitOf(call) + i,
                            BitWord(call.cells(2)[static_cast<size_t>(i)]));
  }
  return vm::kOk;
}

int16_t GT_LmtSns(Call& call) {
  InvertLimits(BitWord(call.value(0)), call.card.motion);
  return vm::kOk;
}

/// Assumption: bit n-1 inverts general input n, as for GT_EncSns and encoders.
int16_t GT_GpiSns(Call& call) {
  ChangeIo(call).SetInverted(DiType::kGpi, BitWord(call.value(0)));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
