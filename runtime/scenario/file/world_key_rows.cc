// The keys of a scenario's world, each in a row.
#include "motion/io/analog.h"
#include "motion/io/extension.h"
#include "runtime/scenario/file/key_table.h"

namespace oncard::runtime {
namespace {

/// Limit of positions in the world, pulses: the range of an axis.
constexpr double kPositionMax = 2147483648.0;
constexpr double kTauMsMax = 10'000;
constexpr int64_t kNoiseMax = 1'000'000;
constexpr double kSlipMax = 1000;
/// What a limit of an axis can be: of its velocity, pulse/ms, and of its acceleration, pulse/ms^2.
constexpr double kFollowedMin = 0.001;
constexpr double kFollowedMax = kWorldVelocityMax;

/// The bits of the widest word of inputs, and its largest value.
constexpr int kInputsMax = 16;
constexpr int64_t kLevelsMax = (int64_t{1} << kInputsMax) - 1;

constexpr int kAuxiliaryLowest = static_cast<int>(motion::kAuxiliaryFirst) + 1;
constexpr int kAuxiliaryHighest = kAuxiliaryLowest + static_cast<int>(motion::kAuxiliaryCount) - 1;

constexpr std::string_view kInputNames[] = {
    "limit_positive", "limit_negative", "alarm", "home", "gpi", "arrive", "mpg"};

constexpr KeyType kAxis = KeyType::Whole(1, static_cast<int64_t>(motion::kAxisMax));
constexpr KeyType kPosition =
    KeyType::Measured(AxisMeasure::kPosition, -kPositionMax, kPositionMax);
constexpr KeyType kVelocity = KeyType::Measured(AxisMeasure::kVelocity, 0, kWorldVelocityMax);
/// Pulses in a unit.
constexpr double kUnitMin = 0.001;
constexpr double kUnitMax = 1e9;
constexpr Words kTimeOfChange = {"the time of the change", "变化的时刻"};
constexpr Words kAtMs = {"`at_ms`", "`at_ms`"};

constexpr Key<World> kWorldKeys[] = {
    {{"input",
      KeyType::Tables("world.input"),
      {"a change of an input, below", "输入的变化"},
      {"none", "无"}}},
    {{"react",
      KeyType::Tables("world.react"),
      {"an input changes because of what the card does, below", "输入因控制卡的动作而变化"},
      {"none", "无"}}},
    {{"axis",
      KeyType::Tables("world.axis"),
      {"the drive and the mechanics of an axis, below", "轴的驱动器与机械"},
      {"ideal drives", "理想驱动器"}}},
    {{"switch",
      KeyType::Tables("world.switch"),
      {"a switch that the mechanics of an axis operate, below", "由轴的机械触动的开关"},
      {"none", "无"}}},
    {{"move",
      KeyType::Tables("world.move"),
      {"a switch is moved, below", "移动开关"},
      {"none", "无"}}},
    {{"fault",
      KeyType::Tables("world.fault"),
      {"a fault of the mechanics, the encoder, the drive or the wiring, below",
       "机械、编码器、驱动器或接线的故障"},
      {"none", "无"}}},
    {{"hand",
      KeyType::Tables("world.hand"),
      {"an axis or an encoder shaft is turned by hand, below", "用手转动轴或编码器"},
      {"none", "无"}}},
    {{"analog",
      KeyType::Tables("world.analog"),
      {"the voltage at an analogue input, below", "模拟量输入端的电压"},
      {"0 V", "0 V"}}},
    {{"module",
      KeyType::Tables("world.module"),
      {"an extension module, below", "扩展模块"},
      {"all modules are present", "所有模块都存在"}}},
};

constexpr Key<InputEvent> kInputKeys[] = {
    {{"type", KeyType::Choice(kInputNames), {"the kind of input", "输入类型"}, {"`gpi`", "`gpi`"}}},
    {{"index",
      KeyType::Whole(1, kInputsMax),
      {"the input, from 1", "输入的编号，从 1 开始"},
      {"all inputs of the type", "该类型的所有输入"}}},
    {{"value",
      KeyType::Level(kLevelsMax),
      {"level of the pin, 0 or 1; without `index` a word with one bit for each pin. `\"any\"`, "
       "with `index` only, is a choice of 0 or 1, below",
       "管脚电平，0 或 1；没有 `index` 时为每位对应一个管脚的字。`\"any\"` 须有 `index`，"
       "为 0 与 1 之间的选择"}}},
    {{"at_ms",
      KeyType::Time(),
      {"the time; the first cycle that begins at or after it sees the change",
       "时刻；在此时或之后开始的第一个周期起可见"},
      kZero},
     &InputEvent::at_us,
     true},
    {{"between_ms",
      KeyType::Times(),
      {"instead of `at_ms`: the change comes with any cycle that begins in this time, both ends "
       "included: a choice, below",
       "代替 `at_ms`：变化发生在此时间段内任一周期开始时，含两端；为选择"},
      kAtMs}},
};

// Of the input it has the keys of `[[world.input]]`, but nothing is left open.
constexpr Key<InputReaction> kReactionKeys[] = {
    {{"when",
      KeyType::Text(),
      {"a condition, below. Each time it becomes true, the input changes later; true at the start "
       "counts, too",
       "条件。每次变为真之后，输入延时变化；开始时即为真也算一次"}},
     &InputReaction::when},
    {{"after_ms",
      KeyType::Time(),
      {"how much later: at most 60000; the first cycle that begins then or after it sees the "
       "change",
       "延时，至多 60000；在此时或之后开始的第一个周期起可见"},
      kZero},
     &InputReaction::after_us,
     true},
    {kInputKeys[0].about},
    {kInputKeys[1].about},
    {{"value",
      KeyType::Whole(0, kLevelsMax),
      {"level of the pin, 0 or 1; without `index` a word with one bit for each pin",
       "管脚电平，0 或 1；没有 `index` 时为每位对应一个管脚的字"}}},
};

constexpr Key<MotorSetup> kMotorKeys[] = {
    {{"axis", kAxis, {"the axis", "轴号"}}},
    {{"unit",
      KeyType::Text(),
      {"the unit in which the axis is measured, such as `\"mm\"`, in this file and wherever its "
       "values are shown",
       "轴的计量单位，如 `\"mm\"`，用于本文件以及显示其值之处"},
      {"pulses and milliseconds", "脉冲与毫秒"}},
     &MotorSetup::unit},
    {{"pulses_per_unit",
      KeyType::Number(kUnitMin, kUnitMax),
      {"how many pulses are one `unit`", "一个 `unit` 的脉冲数"},
      {"an error with `unit`", "有 `unit` 时为错误"}},
     &MotorSetup::pulses_per_unit},
    {{"drive",
      KeyType::Choice(kDriveNames),
      {"`ideal`: an enabled drive follows its commands exactly. `velocity`: the drive converts the "
       "voltage of the axis' analogue output to a speed, with a lag; it receives no pulses, so the "
       "servo loop must be closed (`GT_CtrlMode`, `GT_SetPid`)",
       "`ideal`：使能的驱动器精确跟随指令。`velocity`：驱动器把轴的模拟量输出电压变为速度，带滞后；"
       "它不接收脉冲，因此须闭环（`GT_CtrlMode`、`GT_SetPid`）"},
      {"`ideal`", "`ideal`"}}},
    {{"gain",
      kVelocity,
      {"of a velocity drive: pulse/ms at full output", "速度型驱动器：满幅输出时的速度，pulse/ms"},
      {"100", "100"}},
     &MotorSetup::gain,
     true},
    {{"tau_ms",
      KeyType::Number(0, kTauMsMax),
      {"of a velocity drive: time constant of the lag", "速度型驱动器：滞后的时间常数"},
      {"2", "2"}},
     &MotorSetup::tau_ms,
     true},
    {{"friction",
      kVelocity,
      {"of a velocity drive: pulse/ms that friction takes from the commanded speed",
       "速度型驱动器：摩擦使指令速度减小的量，pulse/ms"},
      kZero},
     &MotorSetup::friction,
     true},
    {{"position",
      kPosition,
      {"position of the mechanics at power-on, in pulses. The encoder reads 0 there; switches and "
       "index marks are at positions of the mechanics",
       "上电时机械的位置，单位脉冲。编码器在该处读数为 0；开关与零位标记按机械位置给出"},
      kZero},
     &MotorSetup::position,
     true},
    {{"index_offset",
      kPosition,
      {"position of an index mark of the encoder, in pulses",
       "编码器的一个零位标记的位置，单位脉冲"},
      kZero},
     &MotorSetup::index_offset,
     true},
    {{"index_period",
      KeyType::Measured(AxisMeasure::kPosition, 0, kPositionMax),
      {"index marks are at every whole multiple of it from `index_offset`, in pulses; 0: none",
       "自 `index_offset` 起每隔此距离有一个零位标记，单位脉冲；0 表示没有"},
      {"10000", "10000"}},
     &MotorSetup::index_period,
     true},
    {{"max_vel",
      KeyType::Measured(AxisMeasure::kVelocity, kFollowedMin, kFollowedMax),
      {"pulse/ms that the drive and the mechanics can follow; the warning `axis-limit` tells of a "
       "planned velocity beyond it",
       "驱动器与机械能够跟随的速度，pulse/ms；规划速度超过时以 `axis-limit` 警告"},
      {"no limit", "不限"}},
     &MotorSetup::max_vel},
    {{"max_acc",
      KeyType::Measured(AxisMeasure::kAcceleration, kFollowedMin, kFollowedMax),
      {"the same for the change of the planned velocity, pulse/ms^2",
       "规划速度的变化率的同类极限，pulse/ms^2"},
      {"no limit", "不限"}},
     &MotorSetup::max_acc},
};

constexpr Key<SwitchSetup> kSwitchKeys[] = {
    {{"axis", kAxis, {"the axis that operates it", "触动它的轴"}}},
    {{"type",
      KeyType::Choice(kInputNames),
      {"type of the input that it is wired to", "所接输入的类型"},
      {"`home`", "`home`"}}},
    {{"index",
      KeyType::Whole(1, kInputsMax),
      {"number of the input. An input can have only one switch, and no `[[world.input]]` as well",
       "输入的编号。一个输入只能接一个开关，且不能同时有 `[[world.input]]`"},
      {"the axis number; an error if there is no such input", "轴号；没有此编号的输入时为错误"}}},
    {{"from",
      kPosition,
      {"the position in pulses from which it is operated", "开始触动的位置，单位脉冲"},
      {"unlimited; an error without `to`", "不限；也没有 `to` 时为错误"}},
     &SwitchSetup::from},
    {{"to",
      kPosition,
      {"the position in pulses up to which it is operated", "停止触动的位置，单位脉冲"},
      {"unlimited", "不限"}},
     &SwitchSetup::to},
    {{"active_low",
      KeyType::Flag(),
      {"`true`: the pin is low while the switch is operated, and high otherwise",
       "`true`：触动时管脚为低电平，否则为高电平"},
      {"`false`", "`false`"}},
     &SwitchSetup::active_low},
};

constexpr Key<SwitchMove> kMoveKeys[] = {
    {{"switch",
      KeyType::Ordinal(),
      {"which `[[world.switch]]`, in the order of the file", "第几个 `[[world.switch]]`"}}},
    {{"from",
      kPosition,
      {"the position in pulses from which it is now operated", "此后开始触动的位置，单位脉冲"},
      {"unlimited; an error without `to`", "不限；也没有 `to` 时为错误"}},
     &SwitchMove::from},
    {{"to",
      kPosition,
      {"the position in pulses up to which it is now operated", "此后停止触动的位置，单位脉冲"},
      {"unlimited", "不限"}},
     &SwitchMove::to},
    {{"at_ms", KeyType::Time(), kTimeOfChange, kZero}, &SwitchMove::at_us, true},
};

constexpr Key<WorldFault> kFaultKeys[] = {
    {{"kind",
      KeyType::Choice(kFaultNames),
      {"`stall`: the mechanics do not move. `lost_encoder`: the encoder no longer counts. `noise`: "
       "the encoder reads up to `pulses` too much or too little. `slip`: the encoder slips by "
       "`velocity`. `alarm`: the drive's alarm input is high. `cut_switch`: the wire of a switch "
       "is "
       "cut, its input stays at the level of a switch that is not operated. Faults of the same "
       "kind "
       "must not overlap",
       "`stall`：机械不动。`lost_encoder`：编码器不再计数。`noise`：编码器读数误差不超过 `pulses`。"
       "`slip`：编码器以 `velocity` 打滑。`alarm`：驱动器报警输入为高电平。`cut_switch`：开关断线，"
       "其输入保持未触动的电平。同类故障在时间上不能重叠"}}},
    {{"axis",
      kAxis,
      {"the axis", "轴号"},
      {"an error, except for `cut_switch`", "错误，`cut_switch` 除外"}}},
    {{"switch",
      KeyType::Ordinal(),
      {"which `[[world.switch]]`, in the order of the file", "第几个 `[[world.switch]]`"},
      {"an error for `cut_switch`", "`cut_switch` 时为错误"}}},
    {{"at_ms", KeyType::Time(), {"when the fault begins", "故障开始的时刻"}, kZero},
     &WorldFault::at_us,
     true},
    {{"between_ms",
      KeyType::Times(),
      {"instead of `at_ms`: the fault begins with any cycle that begins in this time, both ends "
       "included: a choice, below",
       "代替 `at_ms`：故障在此时间段内任一周期开始时发生，含两端；为选择"},
      kAtMs}},
    {{"until_ms", KeyType::Time(), {"when it ends", "故障结束的时刻"}, {"never", "不结束"}},
     &WorldFault::until_us},
    {{"pulses",
      KeyType::Whole(1, kNoiseMax),
      {"of `noise`: the largest error of a reading", "`noise` 的读数最大误差"},
      {"an error for `noise`", "`noise` 时为错误"}}},
    {{"velocity",
      KeyType::Measured(AxisMeasure::kVelocity, -kSlipMax, kSlipMax),
      {"of `slip`, pulse/ms", "`slip` 的速度，pulse/ms"},
      {"an error for `slip`", "`slip` 时为错误"}}},
};

constexpr Key<HandTurn> kHandKeys[] = {
    {{"axis",
      kAxis,
      {"the axis", "轴号"},
      {"an error without `encoder`", "没有 `encoder` 时为错误"}}},
    {{"encoder",
      KeyType::Whole(kAuxiliaryLowest, kAuxiliaryHighest),
      {"an auxiliary encoder of a card of up to 8 axes", "辅助编码器，用于至多 8 轴的控制卡"},
      {"an axis is turned", "转动的是轴"}}},
    {{"pulses",
      KeyType::Number(-kPositionMax, kPositionMax),
      {"the distance; negative: backwards", "转动的脉冲数，反向为负"}},
     &HandTurn::pulses,
     true},
    {{"at_ms", KeyType::Time(), {"when it begins", "开始的时刻"}, kZero}, &HandTurn::at_us, true},
    {{"until_ms",
      KeyType::Time(),
      {"when it ends, at least 4 ms later. Turns of the same axis must not overlap",
       "结束的时刻，至少晚 4 ms。同一轴的转动在时间上不能重叠"}},
     &HandTurn::until_us,
     true},
};

constexpr Key<VoltageEvent> kVoltageKeys[] = {
    {{"channel",
      KeyType::Whole(1, static_cast<int64_t>(motion::kAdcCount)),
      {"the input", "通道号"},
      {"1", "1"}},
     &VoltageEvent::channel,
     true},
    {{"volts",
      KeyType::Number(-motion::kAdcFullVolts, motion::kAdcFullVolts),
      {"the voltage", "电压"}},
     &VoltageEvent::volts,
     true},
    {{"at_ms", KeyType::Time(), kTimeOfChange, kZero}, &VoltageEvent::at_us, true},
};

constexpr Key<ModuleEvent> kModuleKeys[] = {
    {{"module",
      KeyType::Whole(0, static_cast<int64_t>(motion::kModuleCount) - 1),
      {"its number, as the commands count them", "模块号，与指令中的编号相同"},
      kZero},
     &ModuleEvent::module,
     true},
    {{"inputs",
      KeyType::Whole(0, 0xffff),
      {"its digital inputs, one bit each", "数字量输入，每位一个"},
      {"unchanged; 0 at power-on", "不变；上电时为 0"}}},
    {{"volts",
      KeyType::Numbers(motion::kModuleChannels, -motion::kModuleFullVolts,
                       motion::kModuleFullVolts),
      {"voltages at its analogue inputs, from the first on", "各模拟量输入的电压，从首个起"},
      {"unchanged; 0 at power-on", "不变；上电时为 0"}}},
    {{"at_ms", KeyType::Time(), kTimeOfChange, kZero}, &ModuleEvent::at_us, true},
};

}  // namespace

std::span<const Key<World>> WorldKeys() { return kWorldKeys; }
std::span<const Key<InputEvent>> InputKeys() { return kInputKeys; }
std::span<const Key<InputReaction>> ReactionKeys() { return kReactionKeys; }
std::span<const Key<MotorSetup>> MotorKeys() { return kMotorKeys; }
std::span<const Key<SwitchSetup>> SwitchKeys() { return kSwitchKeys; }
std::span<const Key<SwitchMove>> MoveKeys() { return kMoveKeys; }
std::span<const Key<WorldFault>> FaultKeys() { return kFaultKeys; }
std::span<const Key<HandTurn>> HandKeys() { return kHandKeys; }
std::span<const Key<VoltageEvent>> VoltageKeys() { return kVoltageKeys; }
std::span<const Key<ModuleEvent>> ModuleKeys() { return kModuleKeys; }

}  // namespace oncard::runtime
