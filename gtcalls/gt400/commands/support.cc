// What the commands of GT400 cards have in common.
#include <utility>

#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/shared/drives.h"

namespace oncard::gtcalls::gt400 {

int16_t RefuseFor(Call& call, CommandCause cause, Message why) {
  call.cause = cause;
  return call.Refuse(vm::kRefused, std::move(why));
}

int16_t CheckServoCard(Call& call) {
  if (HasVoltages(call.card.motion)) return vm::kOk;
  return RefuseFor(call, kIllegal,
                   {"only the SV card has this command, this card puts out pulses only",
                    "仅 SV 卡支持该指令，本控制卡只有脉冲输出"});
}

int16_t CheckAtRest(Call& call, CommandCause cause) {
  const size_t axis = CurrentAxis(call);
  const bool geared = call.card.motion.profile(axis).mode == motion::ProfileMode::kGear;
  if (!geared && !Moves(call.card.view(), axis)) return vm::kOk;
  return RefuseFor(call, cause,
                   MakeMessage("axis {0} is moving, wait until bit 10 of GT_GetSts is 0; a gear "
                               "slave must be given another mode first",
                               "轴 {0} 正在运动，请等待 GT_GetSts 的第 10 位变为 "
                               "0；电子齿轮从轴须先切换为其他模式",
                               axis + 1));
}

int16_t CheckPosition(Call& call, double position) {
  if (position >= kPositionMin && position <= kPositionMax) return vm::kOk;
  return RefuseFor(
      call, kOverflow,
      MakeMessage("the position is {0}; the range is [{1}, {2}]",
                  "位置为 {0}；取值范围为 [{1}, {2}]", position, kPositionMin, kPositionMax));
}

}  // namespace oncard::gtcalls::gt400
