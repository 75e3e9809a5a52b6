// Position compare in two dimensions, and its older form in one. Both use the two modules of the
// high-speed outputs. Source: application notes on 2-D compare; public header.
// Tested by tests/gtcalls/compare_command_test.cc.
#include <algorithm>
#include <array>
#include <span>

#include "gtcalls/gts/commands/crd_support.h"
#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::CompareModule;
using motion::CompareParameters;
using motion::ComparePoint;
using motion::CompareUnit;

/// Cells of T2DComparePrm.
enum CompareCell : size_t {
  kEncX,
  kEncY,
  kSource,
  kOutputType,
  kStartLevel,
  kTime,
  kMaxError,
  kThreshold
};

const CompareUnit& CompareOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::compare>();
}
CompareUnit& ChangeCompare(const Call& call) { return call.card.motion.compare(); }
size_t ChannelOf(const Call& call) { return static_cast<size_t>(call.integer(0)); }
const CompareModule& ModuleOf(const Call& call) { return CompareOf(call).module(ChannelOf(call)); }

int16_t CheckStopped(Call& call) {
  if (!ModuleOf(call).running) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("compare is running on channel {0}, call GT_2DCompareStop",
                                 "通道 {0} 正在比较，请调用 GT_2DCompareStop", call.integer(0)));
}

int16_t RefuseCompareMember(Call& call, std::string_view name, double value, double first,
                            double last) {
  return call.Refuse(
      vm::kBadParameter,
      MakeMessage("T2DComparePrm.{0} is {1}; {2} to {3} is expected",
                  "T2DComparePrm.{0} 为 {1}；应为 {2} 到 {3}", name, value, first, last));
}

}  // namespace

int16_t GT_2DCompareMode(Call& call) {
  const int16_t code = CheckStopped(call);
  if (code != vm::kOk) return code;
  CompareParameters parameters = ModuleOf(call).parameters;
  parameters.two_dimensional = call.integer(1) != 0;
  ChangeCompare(call).SetParameters(ChannelOf(call), parameters);
  return vm::kOk;
}

namespace {

/// 0, or 7 with the reason if the arguments from `first` on are no level, type and time of an
/// output.
int16_t CheckOutput(Call& call, size_t first) {
  const int level = call.integer(first);
  const int type = call.integer(first + 1);
  const int time = call.integer(first + 2);
  if (level < 0 || level > 1 || type < 0 || type > 1 || (type == 0 && (level != 1 || time < 1))) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage(
            "level {0}, outputType {1}, time {2}: level and outputType are 0 or 1, and a "
            "pulse (outputType 0) needs level 1 and a time of at least 1 us",
            "level 为 {0}，outputType 为 {1}，time 为 {2}：level 与 outputType 应为 0 或 1；"
            "脉冲方式（outputType 为 0）下 level 应为 1，time 至少为 1 us",
            level, type, time));
  }
  return vm::kOk;
}

/// Outputs a level or a pulse; the arguments from `first` on are level, type and time.
int16_t PutOut(Call& call, size_t first, std::span<const size_t> channels) {
  const int16_t code = CheckOutput(call, first);
  if (code != vm::kOk) return code;
  const int level = call.integer(first);
  const int type = call.integer(first + 1);
  const int time = call.integer(first + 2);
  for (const size_t channel : channels) {
    if (type != 0) {
      ChangeCompare(call).SetLevel(channel, level != 0);
    } else {
      ChangeCompare(call).Pulse(channel, call.card.motion.now(), static_cast<int16_t>(time));
    }
  }
  return vm::kOk;
}

}  // namespace

int16_t GT_2DComparePulse(Call& call) {
  const std::array channels = {ChannelOf(call)};
  return PutOut(call, 1, channels);
}

/// Assumption: acts on both high-speed outputs, because the command has no parameter to choose one.
int16_t GT_ComparePulse(Call& call) {
  constexpr std::array<size_t, 2> kChannels = {0, 1};
  return PutOut(call, 0, kChannels);
}

int16_t GT_BufComparePulse(Call& call) {
  const int16_t code = CheckOutput(call, 1);
  if (code != vm::kOk) return code;
  motion::PathSlot slot;
  slot.command = {
      motion::BufferedKind::kComparePulse, call.integer(2), 0, {call.value(1), call.value(3)}};
  return AppendSlot(call, slot);
}

namespace {

/// 0, or 7 if the encoder does not count the signal that `source` selects.
int16_t CheckSource(Call& call, double number, bool external) {
  const motion::Encoder& encoder = call.card.motion.encoder(static_cast<size_t>(number) - 1);
  if (encoder.external == external) return vm::kOk;
  return call.Refuse(
      vm::kBadParameter,
      external
          ? MakeMessage("source 1 needs the external encoder {0}, call GT_EncOn",
                        "source 为 1 时编码器 {0} 应为外部编码器，请调用 GT_EncOn", number)
          : MakeMessage("source 0 needs the pulse counter as encoder {0}, call GT_EncOff",
                        "source 为 0 时编码器 {0} 应为内部脉冲计数器，请调用 GT_EncOff", number));
}

/// 0, or 7 if the number is not that of an axis, whose encoder is compared.
int16_t CheckComparedAxis(Call& call, std::string_view name, double number) {
  const int axes = call.card.motion.config().axis_count;
  if (number >= 1 && number <= axes) return vm::kOk;
  return RefuseCompareMember(call, name, number, 1, axes);
}

}  // namespace

int16_t GT_2DCompareSetPrm(Call& call) {
  const std::span<double> cells = call.cells(1);
  for (const auto& [cell, name] : {std::pair{kEncX, "encx"}, {kEncY, "ency"}}) {
    const int16_t code = CheckComparedAxis(call, name, cells[cell]);
    if (code != vm::kOk) return code;
  }
  const struct {
    CompareCell cell;
    std::string_view name;
    double first, last;
  } bounds[] = {{kSource, "source", 0, 1},
                {kOutputType, "outputType", 0, 1},
                {kStartLevel, "startLevel", 0, 1},
                {kMaxError, "maxerr", 0, 511},
                {kThreshold, "threshold", 0, 0}};
  for (const auto& bound : bounds) {
    const double value = cells[bound.cell];
    if (value < bound.first || value > bound.last) {
      return RefuseCompareMember(call, bound.name, value, bound.first, bound.last);
    }
  }
  if (cells[kOutputType] == 0 && cells[kTime] < 1) {
    return RefuseCompareMember(call, "time", cells[kTime], 1, 32767);
  }
  const bool two_dimensional = ModuleOf(call).parameters.two_dimensional;
  int16_t code = CheckSource(call, cells[kEncY], cells[kSource] != 0);
  if (code == vm::kOk && two_dimensional) {
    code = CheckSource(call, cells[kEncX], cells[kSource] != 0);
  }
  if (code == vm::kOk) code = CheckStopped(call);
  if (code != vm::kOk) return code;
  CompareParameters p;
  p.two_dimensional = two_dimensional;
  p.x = static_cast<uint8_t>(cells[kEncX] - 1);
  p.y = static_cast<uint8_t>(cells[kEncY] - 1);
  p.source = static_cast<int16_t>(cells[kSource]);
  p.level_output = cells[kOutputType] != 0;
  p.start_level = cells[kStartLevel] != 0;
  p.time = static_cast<int16_t>(cells[kTime]);
  p.max_error = static_cast<int16_t>(cells[kMaxError]);
  ChangeCompare(call).SetParameters(ChannelOf(call), p);
  return vm::kOk;
}

namespace {

size_t FreeSpace(const CompareModule& module) {
  return motion::kCompareFifoSize + motion::kCompareBufferSize - module.waiting();
}

}  // namespace

int16_t GT_2DCompareData(Call& call) {
  const auto count = static_cast<size_t>(call.integer(1));
  const std::span<double> cells = call.cells(2);
  if (count > FreeSpace(ModuleOf(call))) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("{0} points do not fit, {1} do: wait, or call GT_2DCompareClear",
                                   "{0} 个数据放不下，剩余空间 {1}：请等待或调用 GT_2DCompareClear",
                                   count, FreeSpace(ModuleOf(call))));
  }
  std::vector<ComparePoint> points;
  for (size_t i = 0; 2 * i + 1 < cells.size() && i < count; ++i) {
    points.push_back({static_cast<int32_t>(cells[2 * i]), static_cast<int32_t>(cells[2 * i + 1])});
  }
  ChangeCompare(call).Append(ChannelOf(call), points);
  return vm::kOk;
}

int16_t GT_2DCompareStart(Call& call) {
  const int16_t code = CheckStopped(call);
  if (code != vm::kOk) return code;
  const CompareModule& module = ModuleOf(call);
  if (module.waiting() == 0) {
    return call.Refuse(vm::kRefused, MakeMessage("channel {0} has no points, call GT_2DCompareData",
                                                 "通道 {0} 没有比较数据，请调用 GT_2DCompareData",
                                                 call.integer(0)));
  }
  const motion::MotionCore& core = call.card.motion;
  ChangeCompare(call).Start(ChannelOf(call), core.encoder(module.parameters.x).position,
                            core.encoder(module.parameters.y).position);
  return vm::kOk;
}

int16_t GT_2DCompareStop(Call& call) {
  ChangeCompare(call).Stop(ChannelOf(call));
  return vm::kOk;
}

int16_t GT_2DCompareClear(Call& call) {
  const int16_t code = CheckStopped(call);
  if (code != vm::kOk) return code;
  ChangeCompare(call).Clear(ChannelOf(call));
  return vm::kOk;
}

int16_t GT_2DCompareStatus(Call& call) {
  const CompareModule& module = ModuleOf(call);
  const size_t in_fifo = std::min(module.waiting(), motion::kCompareFifoSize);
  call.Set(1, module.running ? 0 : 1);
  call.Set(2, module.hits);
  call.Set(3, 0);
  call.Set(4, static_cast<double>(motion::kCompareBufferSize - (module.waiting() - in_fifo)));
  call.Set(5, static_cast<double>(motion::kCompareFifoSize - in_fifo));
  return vm::kOk;
}

// --- One dimension -----------------------------------------------------------------------------

namespace {

/// The common part of the one-dimensional commands: argument 0 is the encoder, `source` and `time`
/// are the indices of the other arguments. Clears both modules; after a refusal nothing has
/// changed.
int16_t PrepareLinear(Call& call, size_t source, size_t time, CompareParameters* parameters) {
  const int16_t code = CheckSource(call, call.value(0), call.integer(source) != 0);
  if (code != vm::kOk) return code;
  if (CompareOf(call).running()) {
    return call.Refuse(vm::kRefused, MakeMessage("compare is running, call GT_CompareStop",
                                                 "位置比较正在运行，请调用 GT_CompareStop"));
  }
  for (size_t channel = 0; channel < motion::kHsioCount; ++channel) {
    ChangeCompare(call).Clear(channel);
    ChangeCompare(call).ClearHits(channel);
  }
  parameters->y = static_cast<uint8_t>(NumberOf(call));
  parameters->source = static_cast<int16_t>(call.integer(source));
  parameters->time = static_cast<int16_t>(call.integer(time));
  return vm::kOk;
}

void StartLinear(const Call& call, size_t channel, const CompareParameters& parameters) {
  ChangeCompare(call).SetParameters(channel, parameters);
  ChangeCompare(call).Start(channel, 0, call.card.motion.encoder(parameters.y).position);
}

}  // namespace

/// Assumption: positions are relative to the encoder's current position, like those of
/// GT_2DCompareData; the first list is for HSIO0, the second for HSIO1.
int16_t GT_CompareData(Call& call) {
  constexpr std::array<size_t, 2> kLists = {5, 7};
  const bool level_output = call.integer(2) != 0;
  if (!level_output && call.integer(4) < 1) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("time is {0}; a pulse lasts 1 to 32767 us",
                                   "time 为 {0}；脉冲宽度应为 1 到 32767 us", call.integer(4)));
  }
  std::array<std::vector<ComparePoint>, motion::kHsioCount> points;
  for (size_t channel = 0; channel < kLists.size(); ++channel) {
    const size_t list = kLists[channel];
    const auto count = static_cast<size_t>(call.integer(list + 1));
    if (count != 0 && !call.given(list)) {
      return call.Refuse(vm::kBadParameter, MakeMessage("{0} is NULL", "{0} 为 NULL",
                                                        channel == 0 ? "pBuf1" : "pBuf2"));
    }
    for (size_t i = 0; i < count; ++i) {
      points[channel].push_back({.y = static_cast<int32_t>(call.cells(list)[i])});
    }
  }
  if (points[0].empty() && points[1].empty()) {
    return call.Refuse(vm::kBadParameter, MakeMessage("count1 and count2 are 0: there is no point",
                                                      "count1 与 count2 均为 0：没有比较数据"));
  }
  CompareParameters parameters;
  const int16_t code = PrepareLinear(call, 1, 4, &parameters);
  if (code != vm::kOk) return code;
  parameters.level_output = level_output;
  parameters.start_level = call.integer(3) != 0;
  for (size_t channel = 0; channel < points.size(); ++channel) {
    if (points[channel].empty()) continue;
    ChangeCompare(call).Append(channel, points[channel]);
    StartLinear(call, channel, parameters);
  }
  return vm::kOk;
}

/// Assumption: `repeatTimes` is the number of pulses, and the first one is output `startPos` pulses
/// from the encoder's current position.
int16_t GT_CompareLinear(Call& call) {
  const auto channel = static_cast<size_t>(call.integer(1));
  const int64_t first = call.integer(2);
  const int64_t count = call.integer(3);
  const int64_t interval = call.integer(4);
  if (interval == 0 && count > 1) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("interval is 0: {0} pulses need a distance",
                                   "interval 为 0：输出 {0} 个脉冲需要间隔", count));
  }
  // |interval| and count are below 2^31, so their product is below 2^62.
  const int64_t last = first + interval * (count - 1);
  if (last != static_cast<int32_t>(last)) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("the last position {0} does not fit in a long",
                                   "最后一个位置 {0} 超出 long 的范围", last));
  }
  CompareParameters parameters;
  const int16_t code = PrepareLinear(call, 6, 5, &parameters);
  if (code != vm::kOk) return code;
  ChangeCompare(call).Repeat(channel, static_cast<int32_t>(first), static_cast<int32_t>(count - 1),
                             static_cast<int32_t>(interval));
  StartLinear(call, channel, parameters);
  return vm::kOk;
}

/// Assumption: the status is that of GT_2DCompareStatus: 0 while there are points left, then 1; the
/// count is the sum for both outputs.
int16_t GT_CompareStatus(Call& call) {
  const CompareUnit& compare = CompareOf(call);
  call.Set(0, compare.running() ? 0 : 1);
  call.Set(1, compare.module(0).hits + compare.module(1).hits);
  return vm::kOk;
}

int16_t GT_CompareStop(Call& call) {
  for (size_t channel = 0; channel < motion::kHsioCount; ++channel)
    ChangeCompare(call).Stop(channel);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
