// The EtherCAT bus: communication, process data, and objects of slaves.
// Source: GTS manual S2, chapters 5 and 13. Tested by tests/gtcalls/bus_command_test.cc.
#include <algorithm>
#include <span>
#include <vector>

#include "gtcalls/gts/commands/bus_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::bus::Bus;
using motion::bus::InitOutcome;
using motion::bus::SdoAbort;
using motion::bus::SlaveDifference;
using motion::bus::SlavePlace;

// GT_InitEcatComm.
constexpr int16_t kSlavesDiffer = -8;
constexpr int16_t kNoEniFile = -9;
constexpr int16_t kNoSlave = -10;

Message Describe(const SlaveDifference& difference) {
  using enum SlaveDifference::What;
  switch (difference.what) {
    case kMissing:
      return MakeMessage("slave {0} of the configuration is not connected", "配置的从站 {0} 未连接",
                         difference.slave);
    case kUnexpected:
      return MakeMessage("slave {0} is connected, but not in the configuration",
                         "从站 {0} 已连接，但不在配置中", difference.slave);
    case kIdentity:
      return MakeMessage("slave {0} has another vendor or product than the configuration says",
                         "从站 {0} 的厂商或产品与配置不符", difference.slave);
    case kProcessData:
      break;
  }
  return MakeMessage("slave {0} has other process data than the configuration says",
                     "从站 {0} 的过程数据与配置不符", difference.slave);
}

/// Why slaves and configuration differ.
Message DescribeDifference(const Bus& line) {
  if (const auto difference = FirstDifference(*line.configured(), *line.connected())) {
    return Describe(*difference);
  }
  size_t lost = 0;
  while (line.Online(lost)) ++lost;
  return MakeMessage("slave {0} does not answer", "从站 {0} 没有应答", lost);
}

}  // namespace

// --- Communication -------------------------------------------------------------------------------

int16_t GT_InitEcatComm(Call& call) {
  if (!call.card.bus_error.en.empty()) return call.Refuse(kSlavesDiffer, call.card.bus_error);
  Bus* line = ChangeLine(call);
  switch (line == nullptr ? InitOutcome::kNoConfiguration : line->CheckInit()) {
    case InitOutcome::kNoConfiguration:
      return call.Refuse(kNoEniFile,
                         {"there is no Gecat.eni in the folder of the program, and the scenario "
                          "has no [[ethercat.slave]]",
                          "程序所在目录中没有 Gecat.eni，场景中也没有 [[ethercat.slave]]"});
    case InitOutcome::kNoSlaves:
      return call.Refuse(kNoSlave, {"no slave answers on the bus", "总线上没有从站应答"});
    case InitOutcome::kDifferent:
      return call.Refuse(kSlavesDiffer, DescribeDifference(*line));
    case InitOutcome::kDone:
      break;
  }
  call.card.motion.TerminateBus();
  line->Init(call.card.motion.now());
  return vm::kOk;
}

int16_t GT_StartEcatComm(Call& call) {
  const int16_t code = CheckBus(call);
  if (code != vm::kOk) return code;
  if (!LineOf(call)->ready()) {
    return call.Refuse(vm::kRefused, {"not all slaves answer", "有从站没有应答"});
  }
  ChangeLine(call)->Start();
  return vm::kOk;
}

int16_t GT_TerminateEcatComm(Call& call) {
  if (LineOf(call) != nullptr) call.card.motion.TerminateBus();
  return vm::kOk;
}

int16_t GT_IsEcatReady(Call& call) {
  const Bus* line = LineOf(call);
  call.Set(0, line != nullptr && line->ready() ? 1 : 0);
  return vm::kOk;
}

namespace {

/// Slaves, or drives only, that answer after GT_InitEcatComm.
int CountOnline(const Call& call, bool drives_only) {
  const Bus* line = LineOf(call);
  if (line == nullptr || line->phase() == motion::bus::BusPhase::kDown) return 0;
  int count = 0;
  for (size_t i = 0; i < line->slave_count(); ++i) {
    if (line->Online(i) && (line->slave(i).drive || !drives_only)) ++count;
  }
  return count;
}

}  // namespace

int16_t GT_GetEcatSlaves(Call& call) {
  call.Set(0, CountOnline(call, false));
  return vm::kOk;
}

int16_t GT_GetMcEcatAxisNum(Call& call) {
  call.Set(0, CountOnline(call, true));
  return vm::kOk;
}

// --- Process data --------------------------------------------------------------------------------

namespace {

/// 0, or 7 with the reason if bytes from `offset` on are not within the `end` of what is accessed.
int16_t CheckBytes(Call& call, int offset, int count, size_t end) {
  if (static_cast<size_t>(offset) + static_cast<size_t>(count) <= end) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{1} bytes from {0} on extend beyond the end, {2}",
                                 "从 {0} 起的 {1} 个字节超出末尾 {2}", offset, count, end));
}

/// The cells of array `array` that a command may touch: argument `count` says how many.
std::span<double> CountedCells(const Call& call, size_t array, size_t count) {
  return call.cells(array).first(static_cast<size_t>(call.integer(count)));
}

void CopyOut(const Call& call, std::span<double> cells, size_t offset) {
  const std::span<const uint8_t> bytes = LineOf(call)->image().bytes();
  std::ranges::copy(bytes.subspan(offset, cells.size()), cells.begin());
}

std::vector<uint8_t> BytesOf(std::span<const double> cells) {
  std::vector<uint8_t> bytes;
  for (const double cell : cells) bytes.push_back(static_cast<uint8_t>(cell));
  return bytes;
}

/// 0, or 1 with the reason if argument 0 is no slave that answers.
int16_t CheckSlave(Call& call) {
  const int16_t code = CheckBus(call);
  if (code != vm::kOk) return code;
  const auto number = static_cast<size_t>(call.integer(0));
  if (number < LineOf(call)->slave_count() && LineOf(call)->Answers(number)) return vm::kOk;
  return call.Refuse(vm::kRefused, MakeMessage("slave {0} does not answer; the bus has {1} slaves, "
                                               "counted from 0",
                                               "从站 {0} 没有应答；总线上有 {1} 个从站，从 0 "
                                               "开始编号",
                                               number, LineOf(call)->slave_count()));
}

const SlavePlace& PlaceOf(const Call& call) {
  return LineOf(call)->place(static_cast<size_t>(call.integer(0)));
}

}  // namespace

int16_t GT_GetEcatRawData(Call& call) {
  int16_t code = CheckBus(call);
  if (code != vm::kOk) return code;
  code = CheckBytes(call, call.integer(0), call.integer(1), LineOf(call)->image().size());
  if (code == vm::kOk) {
    CopyOut(call, CountedCells(call, 2, 1), static_cast<size_t>(call.integer(0)));
  }
  return code;
}

int16_t GT_SetEcatRawData(Call& call) {
  int16_t code = CheckBus(call);
  if (code != vm::kOk) return code;
  code = CheckBytes(call, call.integer(0), call.integer(1), LineOf(call)->image().size());
  if (code != vm::kOk) return code;
  ChangeLine(call)->image().WriteByHost(static_cast<size_t>(call.integer(0)),
                                        BytesOf(CountedCells(call, 2, 1)));
  return vm::kOk;
}

int16_t GT_EcatIOReadInput(Call& call) {
  int16_t code = CheckSlave(call);
  if (code != vm::kOk) return code;
  const SlavePlace& place = PlaceOf(call);
  code = CheckBytes(call, call.integer(1), call.integer(2), place.end() - place.outputs);
  if (code == vm::kOk) {
    CopyOut(call, CountedCells(call, 3, 2), place.outputs + static_cast<size_t>(call.integer(1)));
  }
  return code;
}

int16_t GT_EcatIOWriteOutput(Call& call) {
  int16_t code = CheckSlave(call);
  if (code != vm::kOk) return code;
  const SlavePlace& place = PlaceOf(call);
  code = CheckBytes(call, call.integer(1), call.integer(2), place.output_bytes);
  if (code != vm::kOk) return code;
  const size_t offset = place.outputs + static_cast<size_t>(call.integer(1));
  ChangeLine(call)->image().WriteByHost(offset, BytesOf(CountedCells(call, 3, 2)));
  return vm::kOk;
}

// --- Objects -------------------------------------------------------------------------------------

namespace {

Message DescribeAbort(const Call& call, SdoAbort abort) {
  const auto describe = [&](std::string_view en, std::string_view zh) {
    return MakeMessage("slave {0}, object {1:X}h:{2}: {3}", "从站 {0}，对象 {1:X}h:{2}：{4}",
                       call.integer(0), call.integer(1), call.integer(2), en, zh);
  };
  switch (abort) {
    case SdoAbort::kWriteOnly:
      return describe("it can only be written", "只能写入");
    case SdoAbort::kReadOnly:
      return describe("it can only be read", "只能读取");
    case SdoAbort::kNoObject:
      return describe("there is no such object", "没有该对象");
    case SdoAbort::kNoSubindex:
      return describe("the object has no such subindex", "该对象没有此子索引");
    case SdoAbort::kLength:
      return describe("it has another length", "长度不符");
    case SdoAbort::kRange:
      return describe("the value is out of its range", "数值超出范围");
    case SdoAbort::kState:
      return describe("it cannot change while the drive homes", "驱动器回零时不能更改");
    case SdoAbort::kTimeout:
    case SdoAbort::kNone:
      break;
  }
  return describe("the slave does not answer", "从站没有应答");
}

/// The end of a service: argument `output` is its abort code.
int16_t EndService(Call& call, SdoAbort abort, size_t output) {
  call.Set(output, static_cast<double>(abort));
  return abort == SdoAbort::kNone ? vm::kOk : call.Refuse(vm::kRefused, DescribeAbort(call, abort));
}

}  // namespace

int16_t GT_EcatSDODownload(Call& call) {
  Bus* line = ChangeLine(call);
  if (line == nullptr) return EndService(call, SdoAbort::kTimeout, 5);
  const SdoAbort abort =
      line->Download(static_cast<size_t>(call.integer(0)), static_cast<uint16_t>(call.integer(1)),
                     static_cast<uint8_t>(call.integer(2)), BytesOf(CountedCells(call, 3, 4)));
  return EndService(call, abort, 5);
}

int16_t GT_EcatSDOUpload(Call& call) {
  call.Set(5, 0);
  const Bus* line = LineOf(call);
  std::vector<uint8_t> data;
  SdoAbort abort = SdoAbort::kTimeout;
  if (line != nullptr) {
    abort =
        line->Upload(static_cast<size_t>(call.integer(0)), static_cast<uint16_t>(call.integer(1)),
                     static_cast<uint8_t>(call.integer(2)), &data);
  }
  const std::span<double> cells = CountedCells(call, 3, 4);
  if (abort == SdoAbort::kNone && data.size() > cells.size()) abort = SdoAbort::kLength;
  if (abort != SdoAbort::kNone) return EndService(call, abort, 6);
  std::ranges::copy(data, cells.begin());
  call.Set(5, static_cast<double>(data.size()));
  return EndService(call, abort, 6);
}

}  // namespace oncard::gtcalls::gts
