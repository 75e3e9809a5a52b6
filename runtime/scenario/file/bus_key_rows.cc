// The keys of a scenario's EtherCAT bus, each in a row.
#include "runtime/scenario/file/key_table.h"

namespace oncard::runtime {
namespace {

constexpr int64_t kIdentityMax = 4'294'967'295;

constexpr Key<BusSetup> kBusKeys[] = {
    {{"slave",
      KeyType::Tables("ethercat.slave"),
      {"a slave that is connected, in the order of the line, below",
       "已连接的从站，按线路顺序，见下"},
      {"no bus", "没有总线"}}},
    {{"configured",
      KeyType::Tables("ethercat.configured"),
      {"a slave that the ENI file describes, below", "ENI 文件中的从站，见下"},
      {"the same as the slaves", "与从站相同"}}},
    {{"input",
      KeyType::Tables("ethercat.input"),
      {"a terminal of a slave shows a value, below", "从站端子的数值变化，见下"},
      {"all show 0", "全部为 0"}}},
};

constexpr KeyType kDriveAxis = KeyType::Whole(1, static_cast<int64_t>(motion::kAxisMax));

// The first six describe a slave, the others its faults.
constexpr Key<BusSlaveSetup> kBusSlaveKeys[] = {
    {{"kind",
      KeyType::Choice(motion::bus::kSlaveKindNames),
      {"`drive`: a servo drive (CiA 402). `io`: inputs and outputs. `coupler`: a coupler with "
       "modules",
       "`drive`：伺服驱动器（CiA 402）。`io`：输入输出模块。`coupler`：带模块的耦合器"},
      {"`drive`", "`drive`"}}},
    {{"axis",
      kDriveAxis,
      {"of a drive: the axis of the card whose motor it moves", "驱动器所驱动的控制卡轴号"},
      {"the number of drives so far, and one", "此前驱动器数加一"}}},
    {{"outputs",
      KeyType::Texts(),
      {"its process data from the controller (RxPdo): `index[:subindex[:bits]]` with a hexadecimal "
       "index, as in `\"6040\"` or `\"7010:1:16\"`, or `gap:bits`; `[\"none\"]`: none",
       "控制器发往从站的过程数据（RxPdo）：`索引[:子索引[:位数]]`，索引为十六进制，如 `\"6040\"`、"
       "`\"7010:1:16\"`，或 `gap:位数`；`[\"none\"]` 表示没有"},
      {"those of its kind: 6040 607A; 7000:1; F200:1 7010:1 7030:1 to 4",
       "由类型决定：6040 607A；7000:1；F200:1 7010:1 7030:1 至 4"}},
     &BusSlaveSetup::outputs},
    {{"inputs",
      KeyType::Texts(),
      {"its process data to the controller (TxPdo)", "从站发往控制器的过程数据（TxPdo）"},
      {"those of its kind: 6041 6064 60FD; 6000:1; F100:1 6000:1 6020:1 to 4",
       "由类型决定：6041 6064 60FD；6000:1；F100:1 6000:1 6020:1 至 4"}},
     &BusSlaveSetup::inputs},
    {{"vendor",
      KeyType::Whole(0, kIdentityMax),
      {"its vendor id", "厂商编号"},
      {"that of its kind", "由类型决定"}},
     &BusSlaveSetup::vendor},
    {{"product",
      KeyType::Whole(0, kIdentityMax),
      {"its product code", "产品编号"},
      {"that of its kind", "由类型决定"}},
     &BusSlaveSetup::product},
    {{"absent",
      KeyType::Flag(),
      {"`true`: it is described, but not connected", "`true`：有描述但未连接"},
      {"`false`", "`false`"}},
     &BusSlaveSetup::absent},
    {{"lost_at_ms",
      KeyType::Time(),
      {"from then on it does not answer, nor do those behind it on the line",
       "自此时刻起它与其后的从站不再应答"},
      {"never", "不发生"}},
     &BusSlaveSetup::lost_at_us},
    {{"working_counter_at_ms",
      KeyType::Time(),
      {"from then on it does not exchange process data: the working counter is wrong",
       "自此时刻起它不再交换过程数据：工作计数器错误"},
      {"never", "不发生"}},
     &BusSlaveSetup::silent_at_us},
};
constexpr size_t kDescribingKeys = 6;

constexpr Key<BusInputEvent> kBusInputKeys[] = {
    {{"slave",
      KeyType::Whole(0, static_cast<int64_t>(motion::bus::kSlaveMax) - 1),
      {"which `[[ethercat.slave]]`, in the order of the file, from 0 as the commands count them",
       "第几个 `[[ethercat.slave]]`，按文件顺序，与指令相同从 0 开始"}},
     &BusInputEvent::slave,
     true},
    {{"object",
      KeyType::Text(),
      {"an input of its process data, as in `\"6000:1\"`; of a drive `60FD` (bits 16 and up), "
       "`20F2`, `20F9`, `probe1` or `probe2`",
       "其过程数据中的输入，如 `\"6000:1\"`；驱动器为 `60FD`（第 16 位起）、`20F2`、`20F9`、"
       "`probe1` 或 `probe2`"}},
     &BusInputEvent::object,
     true},
    {{"value",
      KeyType::Number(-2147483648.0, 4294967295.0),
      {"the value, a whole number; of a probe the level, 0 or 1", "数值，整数；探针为电平 0 或 1"}},
     &BusInputEvent::value,
     true},
    {{"at_ms",
      KeyType::Time(),
      {"the time of the change; probes see it inside the cycle",
       "变化的时刻；探针在周期之内即可见"},
      kZero},
     &BusInputEvent::at_us,
     true},
};

}  // namespace

std::span<const Key<BusSetup>> BusKeys() { return kBusKeys; }
std::span<const Key<BusSlaveSetup>> BusSlaveKeys() { return kBusSlaveKeys; }
std::span<const Key<BusSlaveSetup>> ConfiguredSlaveKeys() {
  return std::span(kBusSlaveKeys).first(kDescribingKeys);
}
std::span<const Key<BusInputEvent>> BusInputKeys() { return kBusInputKeys; }

}  // namespace oncard::runtime
