#include "gtcalls/gts/commands/look_ahead_support.h"

#include <algorithm>
#include <cmath>

namespace oncard::gtcalls::gts {

LookAheadSetup& SetupOf(const Call& call) {
  return call.card.state<GtsState>().look_ahead[NumberOf(call)];
}

LookAheadBuffer& BufferOf(const Call& call) { return SetupOf(call).buffers[FifoNumber(call)]; }

int16_t RefuseParameter(Call& call, std::string_view name, double value, std::string_view range) {
  return call.Refuse(kLookAheadParameter,
                     MakeMessage("{0} is {1}; the range is {2}", "{0} 为 {1}；取值范围为 {2}", name,
                                 value, range));
}

int16_t CheckWhole(Call& call, std::string_view name, double value, double first, double last) {
  if (value >= first && value <= last && value == std::floor(value)) return vm::kOk;
  const Message range = MakeMessage("[{0}, {1}]", "[{0}, {1}]", first, last);
  return RefuseParameter(call, name, value, range.en);
}

int16_t CheckSize(Call& call, std::string_view name, double value, double low, double high) {
  // Written so that the check fails for a NaN.
  if (value >= low && value < high) return vm::kOk;
  const Message range = MakeMessage("[{0}, {1})", "[{0}, {1})", low, high);
  return RefuseParameter(call, name, value, range.en);
}

int16_t CheckNumbers(Call& call) {
  const int16_t code = CheckWhole(call, "crd", call.value(0), 1, kCrdMax);
  if (code != vm::kOk) return code;
  for (size_t i = 1; i < call.arguments.size(); ++i) {
    if (call.command.parameters[i].name == "fifo") {
      return CheckWhole(call, "fifo", call.value(i), 0, motion::kCrdFifoCount - 1);
    }
  }
  return vm::kOk;
}

int16_t CheckEstablished(Call& call) {
  const int16_t code = CheckNumbers(call);
  if (code != vm::kOk) return code;
  if (!SetupOf(call).established) {
    return call.Refuse(
        kNotEstablished,
        MakeMessage("coordinate system {0} has no multi-axis look-ahead, call "
                    "GT_SetupLookAheadCrd",
                    "坐标系 {0} 尚未建立多轴前瞻，请调用 GT_SetupLookAheadCrd", call.integer(0)));
  }
  return CheckCrd(call, NumberOf(call)) == vm::kOk ? vm::kOk : kPlatformRefuses;
}

int16_t CheckInitialised(Call& call) {
  const int16_t code = CheckEstablished(call);
  if (code != vm::kOk) return code;
  if (!FifoOf(call).plans_axes()) {
    return call.Refuse(kNotInitialised,
                       MakeMessage("the look-ahead of FIFO {0} has not been initialised, or not "
                                   "since GT_SetCrdPrm or GT_SetupLookAheadCrd: call "
                                   "GT_InitLookAheadEx",
                                   "FIFO {0} 的前瞻尚未初始化，或在 GT_SetCrdPrm、"
                                   "GT_SetupLookAheadCrd 之后未重新初始化：请调用 "
                                   "GT_InitLookAheadEx",
                                   FifoNumber(call)));
  }
  if (!BufferOf(call).in_pulses) return vm::kOk;
  return call.Refuse(
      kLookAheadParameter,
      MakeMessage("FIFO {0} takes commands in pulses since GT_InitLookAheadPara: call "
                  "GT_InitLookAheadEx for commands in mm",
                  "调用 GT_InitLookAheadPara 之后，FIFO {0} 只接受以脉冲为单位的指令：如需使用以"
                  "毫米为单位的指令，请调用 GT_InitLookAheadEx",
                  FifoNumber(call)));
}

int16_t CheckAuxiliaries(Call& call) {
  if (BufferOf(call).auxiliaries < kAuxiliaryMax) return vm::kOk;
  return call.Refuse(
      kLookAheadParameter,
      MakeMessage("there are already {0} commands without motion in a row: append a "
                  "segment first",
                  "已连续调用 {0} 条缓冲区辅助指令：请先追加一段插补运动", kAuxiliaryMax));
}

int16_t CheckDrained(Call& call) {
  const size_t held = FifoOf(call).Ahead().size();
  if (held == 0) return vm::kOk;
  return call.Refuse(kPlatformRefuses,
                     MakeMessage("the look-ahead of FIFO {0} still holds {1} commands: call "
                                 "GT_CrdDataEx with NULL until it gives 0, or GT_CrdClear",
                                 "FIFO {0} 的前瞻缓冲区中还有 {1} 条指令：请以 NULL 调用 "
                                 "GT_CrdDataEx 直到返回 0，或调用 GT_CrdClear",
                                 FifoNumber(call), held));
}

}  // namespace oncard::gtcalls::gts
