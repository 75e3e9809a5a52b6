// Ferroelectric memory. Source: GTS manual 11.8 and chapter 13.
// Tested by tests/gtcalls/mram_command_test.cc.
#include "gtcalls/gts/commands/commands.h"

namespace oncard::gtcalls::gts {
namespace {

Mram& MramOf(const Call& call) { return call.card.state<GtsState>().mram; }

/// 0, or 7 if the call asks for words after the last one.
int16_t CheckWords(Call& call, int count) {
  const int last = call.integer(0) + count - 1;
  if (last < kMramWords) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("words {0} to {1} were requested; the memory has 0 to {2}",
                                 "访问字 {0} 到 {1}；存储器的序号为 0 到 {2}", call.integer(0),
                                 last, kMramWords - 1));
}

/// 0, or 1 during a transfer, which uses the buffer.
int16_t CheckNoAccess(Call& call) {
  if (!MramOf(call).busy()) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("the memory is being accessed, wait until GT_GetMRAMStatus gives "
                                 "1 or call GT_StopAccessMRAM",
                                 "存储器正在读写，请等待 GT_GetMRAMStatus 返回 1 或调用 "
                                 "GT_StopAccessMRAM"));
}

int16_t CheckAccess(Call& call, int count) {
  const int16_t code = CheckWords(call, count);
  return code != vm::kOk ? code : CheckNoAccess(call);
}

}  // namespace

int16_t GT_SetMRAMData(Call& call) {
  const int16_t code = CheckAccess(call, call.integer(2));
  if (code != vm::kOk) return code;
  for (int i = 0; i < call.integer(2); ++i) {
    MramOf(call).SetWord(call.integer(0) + i,
                         static_cast<int16_t>(call.cells(1)[static_cast<size_t>(i)]));
  }
  return vm::kOk;
}

int16_t GT_GetMRAMData(Call& call) {
  const int16_t code = CheckAccess(call, call.integer(2));
  if (code != vm::kOk) return code;
  for (int i = 0; i < call.integer(2); ++i) {
    call.Set(1, MramOf(call).Word(call.integer(0) + i), static_cast<size_t>(i));
  }
  return vm::kOk;
}

int16_t GT_StartAccessMRAM(Call& call) {
  const int16_t code = CheckAccess(call, call.integer(1));
  if (code != vm::kOk) return code;
  MramOf(call).Start(call.card.motion.now(), call.integer(0), call.integer(1),
                     static_cast<MramAccess>(call.integer(2)));
  return vm::kOk;
}

int16_t GT_StopAccessMRAM(Call& call) {
  MramOf(call).Stop();
  return vm::kOk;
}

int16_t GT_GetMRAMStatus(Call& call) {
  call.Set(0, MramOf(call).busy() ? 0 : 1);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
