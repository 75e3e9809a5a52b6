// Axes with drives on the EtherCAT bus: modes, homing by the drive, touch probes, readings.
// Source: GTS manual S2, chapters 5 and 13. Tested by tests/gtcalls/bus_axis_command_test.cc.
#include "gtcalls/gts/commands/bus_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::BusAxis;
using motion::bus::DriveMode;
using motion::bus::ObjectId;
using motion::bus::SdoAbort;

const BusAxis& LinkOf(const Call& call) {
  return call.card.motion.state().bus->axes[NumberOf(call)];
}

/// 0, or 7 with the reason if argument 1 is no mode of a drive.
int16_t CheckModeNumber(Call& call) {
  if (motion::bus::IsSupportedMode(call.integer(1))) return vm::kOk;
  return call.Refuse(
      vm::kBadParameter,
      MakeMessage("mode {0}: a drive has the modes 0, 1, 3, 4, 6, 8, 9 and 10",
                  "模式 {0}：驱动器的模式为 0、1、3、4、6、8、9、10", call.integer(1)));
}

int16_t ChangeMode(Call& call) {
  int16_t code = CheckModeNumber(call);
  if (code == vm::kOk) code = CheckAxisAtRest(call, NumberOf(call));
  if (code != vm::kOk) return code;
  call.card.motion.bus_axes().SetMode(NumberOf(call), static_cast<DriveMode>(call.integer(1)));
  return vm::kOk;
}

}  // namespace

// --- Modes ---------------------------------------------------------------------------------------

int16_t GT_SetEcatAxisMode(Call& call) {
  int16_t code = CheckBusAxis(call);
  if (code != vm::kOk) return code;
  if (!LineOf(call)->HasOutput(BusSlaveOf(call), ObjectId::kMode)) {
    // The reason of an object that is missing, without writing it.
    return WriteOutput(call, ObjectId::kMode, 0);
  }
  return ChangeMode(call);
}

int16_t GT_GetEcatAxisMode(Call& call) { return ReadInput(call, ObjectId::kModeDisplay, 1); }

/// By process data or, if they do not contain 6060h, by the mailbox.
int16_t GT_SetHomingMode(Call& call) {
  const int16_t code = CheckBusAxis(call);
  return code != vm::kOk ? code : ChangeMode(call);
}

int16_t GT_SetEcatAxisPT(Call& call) {
  return WriteOutput(call, ObjectId::kTargetTorque, call.integer(1));
}

int16_t GT_SetEcatAxisPV(Call& call) {
  return WriteOutput(call, ObjectId::kTargetVelocity, call.integer(1));
}

int16_t GT_SetPosScale(Call& call) {
  int16_t code = CheckBusAxis(call);
  if (code == vm::kOk) code = CheckAxisAtRest(call, NumberOf(call));
  if (code != vm::kOk) return code;
  call.card.motion.bus_axes().SetScale(NumberOf(call), static_cast<uint8_t>(call.integer(1)));
  return vm::kOk;
}

int16_t GT_GetPosScale(Call& call) {
  const int16_t code = CheckBusAxis(call);
  if (code == vm::kOk) call.Set(1, LinkOf(call).scale);
  return code;
}

// --- Homing by the drive -------------------------------------------------------------------------

int16_t GT_SetEcatHomingPrm(Call& call) {
  const int16_t code = CheckBusAxis(call);
  if (code != vm::kOk) return code;
  if (!motion::bus::FindHomingMethod(call.integer(1))) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("homing method {0}: the drive has 1 to 14, 17 to 30, 33 to 35 "
                    "and 37",
                    "回零方式 {0}：驱动器支持 1 至 14、17 至 30、33 至 35 及 37", call.integer(1)));
  }
  const SdoAbort abort = call.card.motion.bus_axes().PrepareHoming(
      NumberOf(call),
      {call.integer(1), call.value(2), call.value(3), call.value(4), call.integer(5)});
  if (abort == SdoAbort::kNone) return vm::kOk;
  return call.Refuse(
      vm::kRefused,
      MakeMessage("the drive of axis {0} refuses the parameters: it is homing, call "
                  "GT_StopEcatHoming",
                  "轴 {0} 的驱动器拒绝参数：正在回零，请调用 GT_StopEcatHoming", call.integer(0)));
}

int16_t GT_StartEcatHoming(Call& call) {
  const int16_t code = CheckBusAxis(call);
  if (code != vm::kOk) return code;
  const auto refuse = [&](std::string_view en, std::string_view zh) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("axis {0}: {1}", "轴 {0}：{2}", call.integer(0), en, zh));
  };
  if (!AxisOf(call).servo_on) {
    return refuse("the drive is not enabled, call GT_AxisOn and wait for bit 9 of GT_GetSts",
                  "驱动器未使能，请调用 GT_AxisOn 并等待 GT_GetSts 的第 9 位");
  }
  // A mode that has just been commanded reaches the drive with the next cycle.
  if (call.card.motion.readings().CommandedBusMode(NumberOf(call)) != DriveMode::kHoming) {
    return refuse("the drive is not in mode 6, call GT_SetHomingMode",
                  "驱动器不处于模式 6，请调用 GT_SetHomingMode");
  }
  if (!LinkOf(call).homing_prepared) {
    return refuse("its homing has no parameters, call GT_SetEcatHomingPrm",
                  "未设置回零参数，请调用 GT_SetEcatHomingPrm");
  }
  call.card.motion.bus_axes().StartHoming(NumberOf(call));
  return vm::kOk;
}

int16_t GT_StopEcatHoming(Call& call) {
  const int16_t code = CheckBusAxis(call);
  if (code == vm::kOk) call.card.motion.bus_axes().StopHoming(NumberOf(call));
  return code;
}

int16_t GT_GetEcatHomingStatus(Call& call) {
  int16_t code = CheckBusAxis(call);
  if (code == vm::kOk) code = CheckInput(call, ObjectId::kStatusWord);
  if (code == vm::kOk) call.Set(1, LinkOf(call).homing_status);
  return code;
}

// --- Touch probes --------------------------------------------------------------------------------

int16_t GT_SetTouchProbeFunction(Call& call) {
  return WriteOutput(call, ObjectId::kProbeFunction, static_cast<uint16_t>(call.integer(1)));
}

namespace {

/// The byte of 60B8h for a probe, from its three arguments.
int ProbeByte(const Call& call, size_t first) {
  using motion::bus::kProbeContinuous;
  using motion::bus::kProbeEnable;
  using motion::bus::kProbeFalling;
  using motion::bus::kProbeRising;
  if (call.integer(first) == 0) return 0;
  // ECAT_PROBE_TRIGGER_LEVEL_POS and _NEG are bits.
  const int level = call.integer(first + 2);
  return kProbeEnable | (call.integer(first + 1) != 0 ? kProbeContinuous : 0) |
         ((level & 1) != 0 ? kProbeRising : 0) | ((level & 2) != 0 ? kProbeFalling : 0);
}

}  // namespace

int16_t GT_SetTouchProbeFunctionEx(Call& call) {
  return WriteOutput(call, ObjectId::kProbeFunction, ProbeByte(call, 1) | ProbeByte(call, 4) << 8);
}

int16_t GT_GetTouchProbeStatus(Call& call) {
  int16_t code = CheckBusAxis(call);
  for (const ObjectId id :
       {ObjectId::kProbeStatus, ObjectId::kProbe1Rising, ObjectId::kProbe1Falling}) {
    if (code == vm::kOk) code = CheckInput(call, id);
  }
  if (code != vm::kOk) return code;
  const motion::bus::Bus& line = *LineOf(call);
  constexpr ObjectId kOutputs[] = {ObjectId::kProbeStatus, ObjectId::kProbe1Rising,
                                   ObjectId::kProbe1Falling, ObjectId::kProbe2Rising,
                                   ObjectId::kProbe2Falling};
  for (size_t i = 0; i < std::size(kOutputs); ++i) {
    // The values of probe 2 are 0 if the process data do not contain them.
    const auto value = line.Input(BusSlaveOf(call), kOutputs[i]).value_or(0);
    call.Set(i + 1, static_cast<double>(value));
  }
  return vm::kOk;
}

// --- Readings ------------------------------------------------------------------------------------

int16_t GT_GetEcatEncPos(Call& call) { return ReadInput(call, ObjectId::kPositionActual, 1); }
int16_t GT_GetEcatEncVel(Call& call) { return ReadInput(call, ObjectId::kVelocityActual, 1); }
int16_t GT_GetEcatAxisPE(Call& call) { return ReadInput(call, ObjectId::kFollowingError, 1); }

int16_t GT_GetEcatAxisAtlTorque(Call& call) { return ReadInput(call, ObjectId::kTorqueActual, 1); }

int16_t GT_GetEcatAxisAtlCurrent(Call& call) {
  return ReadInput(call, ObjectId::kCurrentActual, 1);
}

int16_t GT_GetEcatAxisAI(Call& call) {
  const bool first = call.integer(1) == 1;
  return ReadInput(call, first ? ObjectId::kAnalogInput1 : ObjectId::kAnalogInput2, 2);
}

int16_t GT_GetEcatAxisDI(Call& call) { return ReadInput(call, ObjectId::kDigitalInputs, 1); }

int16_t GT_SetEcatAxisDO(Call& call) {
  return WriteOutput(call, ObjectId::kDigitalOutputs, BitWord(call.value(1)));
}

/// What the controller commands; the process data contain it as an output.
int16_t GT_GetEcatAxisDO(Call& call) {
  const int16_t code = CheckBusAxis(call);
  if (code != vm::kOk) return code;
  const motion::bus::Bus& line = *LineOf(call);
  const auto outputs = line.Output(BusSlaveOf(call), ObjectId::kDigitalOutputs);
  if (!outputs) return ReadInput(call, ObjectId::kDigitalOutputs, 1);
  call.Set(1, static_cast<double>(*outputs));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
