#include "runtime/sim/card_event_text.h"

namespace oncard::runtime {

using motion::CardEventKind;

Message DescribeCardEvent(const motion::CardEvent& event,
                          const gtcalls::AdvisedCommands& commands) {
  const size_t item = event.item + 1;
  const double value = event.value;
  const double bound = event.bound;
  switch (event.kind) {
    case CardEventKind::kPositiveLimitSwitch:
      return MakeMessage(
          "axis {0} reached its positive limit switch at {1}: no motion in that direction until "
          "{2}",
          "轴 {0} 在 {1} 处触发正限位开关：调用 {2} 前不能向该方向运动", item, value,
          commands.clear_status);
    case CardEventKind::kNegativeLimitSwitch:
      return MakeMessage(
          "axis {0} reached its negative limit switch at {1}: no motion in that direction until "
          "{2}",
          "轴 {0} 在 {1} 处触发负限位开关：调用 {2} 前不能向该方向运动", item, value,
          commands.clear_status);
    case CardEventKind::kPositiveSoftLimit:
      return MakeMessage(
          "axis {0} passed its positive soft limit {2} at {1}: no motion in that direction until "
          "{3}",
          "轴 {0} 在 {1} 处越过正软限位 {2}：调用 {3} 前不能向该方向运动", item, value, bound,
          commands.clear_status);
    case CardEventKind::kNegativeSoftLimit:
      return MakeMessage(
          "axis {0} passed its negative soft limit {2} at {1}: no motion in that direction until "
          "{3}",
          "轴 {0} 在 {1} 处越过负软限位 {2}：调用 {3} 前不能向该方向运动", item, value, bound,
          commands.clear_status);
    case CardEventKind::kAlarm:
      return MakeMessage("the drive of axis {0} reports an alarm at {1}: it is switched off",
                         "轴 {0} 在 {1} 处驱动器报警：关闭伺服使能", item, value);
    case CardEventKind::kSmoothStopInput:
      return MakeMessage(
          "axis {0} was stopped by its smooth stop input at {1}: no motion until {2}",
          "轴 {0} 在 {1} 处触发平滑停止输入：调用 {2} 前不能运动", item, value,
          commands.clear_status);
    case CardEventKind::kAbruptStopInput:
      return MakeMessage(
          "axis {0} was stopped by its abrupt stop input at {1}: no motion until {2}",
          "轴 {0} 在 {1} 处触发急停输入：调用 {2} 前不能运动", item, value, commands.clear_status);
    case CardEventKind::kFollowingError:
      return MakeMessage(
          "axis {0} has a following error of {1}, its limit is {2} ({3}): the drive is switched "
          "off",
          "轴 {0} 跟随误差为 {1}，超过 {3} 设定的极限 {2}：关闭伺服使能", item, value, bound,
          commands.following_error_limit);
    case CardEventKind::kBeyondErrorLimit:
      return MakeMessage("axis {0} has a following error of {1}, its limit is {2} ({3})",
                         "轴 {0} 跟随误差为 {1}，超过 {3} 设定的极限 {2}", item, value, bound,
                         commands.following_error_limit);
    case CardEventKind::kEncoderSilent:
      return MakeMessage(
          "the encoder of axis {0} measures only {1} pulse/ms while the motor is driven, {3} "
          "expects {2}: the drive is switched off",
          "轴 {0} 有输出而编码器速度仅为 {1} pulse/ms，{3} 要求 {2}：关闭伺服使能", item, value,
          bound, commands.encoder_check);
    case CardEventKind::kGantrySkew:
      return MakeMessage(
          "the gantry of axis {0} has a skew of {1}, its limit is {2} ({3}): both drives are "
          "switched off",
          "轴 {0} 的龙门同步误差为 {1}，超过 {3} 设定的极限 {2}：关闭两轴使能", item, value, bound,
          commands.gantry_error_limit);
    case CardEventKind::kHeldAtLimit:
      return MakeMessage("profile {0} is held at {1}: it would move towards a latched limit",
                         "规划器 {0} 停在 {1}：其运动方向上的限位已锁存", item, value);
    case CardEventKind::kMovedBySegment:
      return MakeMessage(
          "a segment of coordinate system {1} moves axis {0} while its drive is off, call {2} "
          "first",
          "坐标系 {1} 的轨迹段使轴 {0} 在伺服使能关闭时运动，请先调用 {2}", item, bound + 1,
          commands.drive_on);
    case CardEventKind::kMovedByPath:
      return MakeMessage(
          "{2} or {3} of coordinate system {1} moves axis {0} while its drive is off, call {4} "
          "first",
          "坐标系 {1} 的 {2} 或 {3} 使轴 {0} 在伺服使能关闭时运动，请先调用 {4}", item, bound + 1,
          commands.buffered_move, commands.buffered_gear, commands.drive_on);
    case CardEventKind::kTooFast:
      return MakeMessage(
          "axis {0} is planned with {1} pulse/ms, its drive follows up to {2} (max_vel)",
          "轴 {0} 的规划速度为 {1} pulse/ms，其驱动器最多为 {2}（max_vel）", item, value, bound);
    case CardEventKind::kTooSteep:
      return MakeMessage(
          "the velocity of axis {0} changes by {1} pulse/ms^2, its drive follows up to {2} "
          "(max_acc)",
          "轴 {0} 的速度变化为 {1} pulse/ms²，其驱动器最多为 {2}（max_acc）", item, value, bound);
    case CardEventKind::kStarved:
      return MakeMessage(
          "coordinate system {0} ends its run: the FIFO is empty while {1} segments wait in the "
          "look-ahead buffer, call {2} with NULL until it returns 0",
          "坐标系 {0} 运行结束：FIFO 已空而前瞻缓冲区中还有 {1} 段，请以 NULL 调用 {2} 直到返回 0",
          item, value, commands.append_segment);
    case CardEventKind::kEndedMoving:
      return MakeMessage(
          "coordinate system {0} stops at once from {1} pulse/ms: the FIFO is empty and velEnd of "
          "the last segment is not 0, append segments sooner or end with velEnd 0",
          "坐标系 {0} 从 {1} pulse/ms 立即停止：FIFO 已空而最后一段的 velEnd 不为 "
          "0，请及时写入插补段或以 velEnd 0 结束",
          item, value);
    case CardEventKind::kMoveStopped:
      return MakeMessage(
          "coordinate system {0} pauses: axis {2} of a modal {3} was stopped at {1}, {4} continues "
          "the move",
          "坐标系 {0} 暂停：模态 {3} 的轴 {2} 在 {1} 处被停止，{4} 将继续该运动", item, value,
          bound + 1, commands.buffered_move, commands.start_path);
    case CardEventKind::kJunctionLimited:
      return MakeMessage(
          "coordinate system {0} passes the corner before this segment with at most {1} of {2} "
          "pulse/ms, limited by synAcc or DVMax and the time constant of {3}",
          "坐标系 {0} 以不超过 {1} pulse/ms（直线段允许 {2}）通过该段之前的拐角，由 synAcc 或 "
          "DVMax 与 {3} 的时间常数决定",
          item, value, bound, commands.axis_look_ahead);
    case CardEventKind::kCornerLimited:
      break;
  }
  return MakeMessage(
      "coordinate system {0} passes the corner before this segment with at most {1} of {2} "
      "pulse/ms, limited by T and accMax of {3}",
      "坐标系 {0} 以不超过 {1} pulse/ms（指令为 {2}）通过该段之前的拐角，由 {3} 的 T 与 accMax "
      "决定",
      item, value, bound, commands.look_ahead);
}

}  // namespace oncard::runtime
