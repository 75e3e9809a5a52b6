#include "gtcalls/gts/commands/bus_support.h"

#include <fmt/core.h>

namespace oncard::gtcalls::gts {
namespace {

using motion::bus::Bus;
using motion::bus::BusPhase;
using motion::bus::ObjectEntry;
using motion::bus::ObjectId;

/// `6041h`, or `60FEh:1`.
std::string Spell(ObjectId id) {
  const ObjectEntry& entry = EntryOf(id);
  if (entry.subindex == 0) return fmt::format("{:X}h", entry.index);
  return fmt::format("{:X}h:{}", entry.index, entry.subindex);
}

int16_t RefuseObject(Call& call, ObjectId id) {
  return call.Refuse(vm::kRefused,
                     MakeMessage("object {1} is not in the process data of axis {0}: add it to its "
                                 "PDO in the ENI file or in [[ethercat.slave]]",
                                 "轴 {0} 的过程数据中没有对象 {1}：请在 ENI 文件或 "
                                 "[[ethercat.slave]] 中将其配置为 PDO",
                                 call.integer(0), Spell(id)));
}

}  // namespace

const Bus* LineOf(const Call& call) {
  const auto& part = call.card.motion.state().bus;
  return part ? &part->line : nullptr;
}

Bus* ChangeLine(const Call& call) { return call.card.motion.bus_line(); }

int16_t CheckBus(Call& call) {
  const Bus* line = LineOf(call);
  if (line != nullptr && line->phase() == BusPhase::kOp) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     {"the bus does not communicate: call GT_InitEcatComm and wait until "
                      "GT_IsEcatReady reads 1",
                      "总线未通讯：请调用 GT_InitEcatComm 并等待 GT_IsEcatReady 的状态为 1"});
}

int16_t CheckBusAxis(Call& call) {
  const int16_t code = CheckBus(call);
  if (code != vm::kOk) return code;
  if (!call.card.motion.OnBus(NumberOf(call))) {
    return call.Refuse(vm::kRefused, MakeMessage("axis {0} has no drive on the bus",
                                                 "轴 {0} 在总线上没有驱动器", call.integer(0)));
  }
  if (LineOf(call)->Answers(BusSlaveOf(call))) return vm::kOk;
  return call.Refuse(vm::kRefused, MakeMessage("the drive of axis {0}, slave {1}, does not answer",
                                               "轴 {0} 的驱动器（从站 {1}）没有应答",
                                               call.integer(0), BusSlaveOf(call)));
}

int16_t CheckBusStarted(Call& call, size_t axis) {
  const motion::MotionCore& core = call.card.motion;
  if (!core.OnBus(axis) || core.BusStarted()) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("axis {0} is on the bus, which has not been started: call "
                                 "GT_StartEcatComm when GT_IsEcatReady reads 1",
                                 "轴 {0} 在总线上而总线未启动：请在 GT_IsEcatReady 的状态为 1 "
                                 "后调用 GT_StartEcatComm",
                                 axis + 1));
}

int16_t CheckBusObeys(Call& call, size_t axis) {
  const int16_t code = CheckBusStarted(call, axis);
  if (code != vm::kOk || !call.card.motion.OnBus(axis)) return code;
  const auto mode = call.card.motion.BusMode(axis);
  if (mode == motion::bus::DriveMode::kCyclicPosition) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("the drive of axis {0} is in mode {1}; planned motion needs mode "
                                 "8, call GT_SetHomingMode or GT_SetEcatAxisMode",
                                 "轴 {0} 的驱动器处于模式 {1}；规划运动需要模式 8，请调用 "
                                 "GT_SetHomingMode 或 GT_SetEcatAxisMode",
                                 axis + 1, static_cast<int>(mode)));
}

size_t BusSlaveOf(const Call& call) {
  return static_cast<size_t>(call.card.motion.state().bus->axes[NumberOf(call)].slave);
}

int16_t CheckInput(Call& call, ObjectId id) {
  return LineOf(call)->Input(BusSlaveOf(call), id) ? vm::kOk : RefuseObject(call, id);
}

int16_t ReadInput(Call& call, ObjectId id, size_t output) {
  int16_t code = CheckBusAxis(call);
  if (code == vm::kOk) code = CheckInput(call, id);
  if (code != vm::kOk) return code;
  call.Set(output, static_cast<double>(*LineOf(call)->Input(BusSlaveOf(call), id)));
  return vm::kOk;
}

int16_t WriteOutput(Call& call, ObjectId id, int64_t value) {
  const int16_t code = CheckBusAxis(call);
  if (code != vm::kOk) return code;
  return ChangeLine(call)->SetOutput(BusSlaveOf(call), id, value) ? vm::kOk
                                                                  : RefuseObject(call, id);
}

}  // namespace oncard::gtcalls::gts
