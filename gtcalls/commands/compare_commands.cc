// Position compare in two dimensions. Source: application notes on 2-D compare; public header.
// Tested by tests/gtcalls/compare_command_test.cc.
#include <array>
#include <span>

#include "gtcalls/commands/motion_support.h"

namespace oncard::gtcalls {
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

CompareUnit& CompareOf(const Call& call) { return call.card.motion.state().compare; }
size_t ChannelOf(const Call& call) { return static_cast<size_t>(call.integer(0)); }
CompareModule& ModuleOf(const Call& call) { return CompareOf(call).module(ChannelOf(call)); }

int16_t CheckStopped(Call& call) {
  if (!ModuleOf(call).running) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("compare is running on channel {0}, call GT_2DCompareStop",
                                 "通道 {0} 正在比较，请调用 GT_2DCompareStop", call.integer(0)));
}

int16_t RefuseMember(Call& call, std::string_view name, double value, double first, double last) {
  return call.Refuse(
      vm::kBadParameter,
      MakeMessage("T2DComparePrm.{0} is {1}; {2} to {3} is expected",
                  "T2DComparePrm.{0} 为 {1}；应为 {2} 到 {3}", name, value, first, last));
}

int16_t Mode2D(Call& call) {
  const int16_t code = CheckStopped(call);
  if (code != vm::kOk) return code;
  ModuleOf(call).parameters.two_dimensional = call.integer(1) != 0;
  return vm::kOk;
}

/// Puts out a level, or a pulse, of which the arguments from `first` on are level, type and time.
int16_t PutOut(Call& call, size_t first, std::span<const size_t> channels) {
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
  for (const size_t channel : channels) {
    if (type != 0) {
      CompareOf(call).SetLevel(channel, level != 0);
    } else {
      CompareOf(call).Pulse(channel, call.card.motion.now(), static_cast<int16_t>(time));
    }
  }
  return vm::kOk;
}

int16_t Pulse2D(Call& call) {
  const std::array channels = {ChannelOf(call)};
  return PutOut(call, 1, channels);
}

/// Assumption: both high-speed outputs, as the command names none.
int16_t ComparePulse(Call& call) {
  constexpr std::array<size_t, 2> kChannels = {0, 1};
  return PutOut(call, 0, kChannels);
}

/// 0, or 7 when an encoder does not count what `source` asks for.
int16_t CheckSource(Call& call, double number, bool external) {
  const motion::Encoder& encoder =
      call.card.motion.state().encoders[static_cast<size_t>(number) - 1];
  if (encoder.external == external) return vm::kOk;
  return call.Refuse(
      vm::kBadParameter,
      external
          ? MakeMessage("source 1 needs the external encoder {0}, call GT_EncOn",
                        "source 为 1 时编码器 {0} 应为外部编码器，请调用 GT_EncOn", number)
          : MakeMessage("source 0 needs the pulse counter as encoder {0}, call GT_EncOff",
                        "source 为 0 时编码器 {0} 应为内部脉冲计数器，请调用 GT_EncOff", number));
}

int16_t SetPrm2D(Call& call) {
  const std::span<double> cells = call.cells(1);
  const int axes = call.card.motion.config().axis_count;
  const struct {
    CompareCell cell;
    std::string_view name;
    double first, last;
  } bounds[] = {{kEncX, "encx", 1.0, double(axes)}, {kEncY, "ency", 1.0, double(axes)},
                {kSource, "source", 0, 1},          {kOutputType, "outputType", 0, 1},
                {kStartLevel, "startLevel", 0, 1},  {kMaxError, "maxerr", 0, 511},
                {kThreshold, "threshold", 0, 0}};
  for (const auto& bound : bounds) {
    const double value = cells[bound.cell];
    if (value < bound.first || value > bound.last) {
      return RefuseMember(call, bound.name, value, bound.first, bound.last);
    }
  }
  if (cells[kOutputType] == 0 && cells[kTime] < 1) {
    return RefuseMember(call, "time", cells[kTime], 1, 32767);
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
  ModuleOf(call).parameters = p;
  return vm::kOk;
}

size_t FreeSpace(const CompareModule& module) {
  return motion::kCompareFifoSize + motion::kCompareBufferSize - module.waiting();
}

int16_t Data2D(Call& call) {
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
  CompareOf(call).Append(ChannelOf(call), points);
  return vm::kOk;
}

int16_t Start2D(Call& call) {
  const int16_t code = CheckStopped(call);
  if (code != vm::kOk) return code;
  const CompareModule& module = ModuleOf(call);
  if (module.waiting() == 0) {
    return call.Refuse(vm::kRefused, MakeMessage("channel {0} has no points, call GT_2DCompareData",
                                                 "通道 {0} 没有比较数据，请调用 GT_2DCompareData",
                                                 call.integer(0)));
  }
  const auto& encoders = call.card.motion.state().encoders;
  CompareOf(call).Start(ChannelOf(call), encoders[module.parameters.x].position,
                        encoders[module.parameters.y].position);
  return vm::kOk;
}

int16_t Stop2D(Call& call) {
  CompareOf(call).Stop(ChannelOf(call));
  return vm::kOk;
}

int16_t Clear2D(Call& call) {
  const int16_t code = CheckStopped(call);
  if (code != vm::kOk) return code;
  CompareOf(call).Clear(ChannelOf(call));
  return vm::kOk;
}

int16_t Status2D(Call& call) {
  const CompareModule& module = ModuleOf(call);
  const size_t in_fifo = std::min(module.waiting(), motion::kCompareFifoSize);
  call.Set(1, module.running ? 0 : 1);
  call.Set(2, module.hits);
  call.Set(3, 0);
  call.Set(4, static_cast<double>(motion::kCompareBufferSize - (module.waiting() - in_fifo)));
  call.Set(5, static_cast<double>(motion::kCompareFifoSize - in_fifo));
  return vm::kOk;
}

constexpr CommandEntry kEntries[] = {
    {"GT_ComparePulse", ComparePulse}, {"GT_2DCompareMode", Mode2D},
    {"GT_2DComparePulse", Pulse2D},    {"GT_2DCompareSetPrm", SetPrm2D},
    {"GT_2DCompareData", Data2D},      {"GT_2DCompareStart", Start2D},
    {"GT_2DCompareStop", Stop2D},      {"GT_2DCompareClear", Clear2D},
    {"GT_2DCompareStatus", Status2D},
};

}  // namespace

std::span<const CommandEntry> CompareCommands() { return kEntries; }

}  // namespace oncard::gtcalls
