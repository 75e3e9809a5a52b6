// The keys of a scenario file outside its world, each in a row.
#include "gtcalls/card_type.h"
#include "runtime/scenario/key_table.h"
#include "runtime/scenario/search_names.h"
#include "vm/limits.h"

namespace oncard::runtime {
namespace {

using enum KeyUse;

constexpr std::string_view kDoubleNames[] = {"32.16", "16.16"};

constexpr Words kNone = {"none", "无"};

/// The largest `rate` for the longest cycle.
constexpr int64_t kCycleStatementsMax = 4'000'000;
constexpr int64_t kCountMax = 1'000'000'000'000;
constexpr int64_t kStatesMax = 4'000'000'000;

constexpr Key<Scenario> kScenarioKeys[] = {
    {{"program",
      KeyType::Text(),
      {"`.c` is compiled, `.bin` is loaded with the `.ini` beside it; relative to the scenario's "
       "folder",
       "`.c` 会被编译，`.bin` 与同目录的 `.ini` 一起装入；相对于场景所在文件夹"},
      {"an error, except for `oncard exec`", "错误，`oncard exec` 除外"},
      {kUsed, kUsed, kRefused}},
     &Scenario::program,
     true},
    {{"title",
      KeyType::Text(),
      {"title of a picture of the run", "运行曲线图的标题"},
      {"the file's name", "文件名"},
      {kUsed, kMeansNothing, kUsed}},
     &Scenario::title},
    {{"include",
      KeyType::Texts(),
      {"folders searched for `#include`, relative to the scenario's folder",
       "查找 `#include` 的文件夹，相对于场景所在文件夹"},
      kNone,
      {kUsed, kUsed, kRefused}},
     &Scenario::include_folders},
    {{"structured",
      KeyType::Flag(),
      {"the program is structured C (`structured.md`), even if its first line is not "
       "`//@ structured`",
       "程序为结构化 C（`structured.md`），即使其首行不是 `//@ structured`"},
      {"`false`", "`false`"},
      {kUsed, kUsed, kRefused}},
     &Scenario::structured},
    {{"double",
      KeyType::Choice(kDoubleNames),
      {"width of the type `double` of a source", "源程序中 `double` 类型的宽度"},
      {"`\"32.16\"`", "`\"32.16\"`"},
      {kUsed, kUsed, kRefused}}},
    // The explorer takes every schedule, this one included.
    {{"schedule",
      KeyType::Text(),
      {"`rr[:N]`, `priority`, `random:SEED`, `pct:SEED:D[:K]` or `replay:FILE`",
       "`rr[:N]`、`priority`、`random:种子`、`pct:种子:D[:K]` 或 `replay:文件`"},
      {"`\"rr\"`", "`\"rr\"`"},
      {kUsed, kMeansNothing, kRefused}},
     &Scenario::schedule,
     true},
    {{"rate",
      KeyType::Whole(1, 1'000'000),
      {"statements per millisecond, all threads together", "每毫秒执行的语句数，所有线程合计"},
      {"100", "100"}},
     &Scenario::rate,
     true},
    {{"card",
      KeyType::Choice(gtcalls::kCardTypeNames),
      {"the type of the card, which determines its number of axes", "控制卡的型号，它决定轴数"},
      {"a GTS card with the number of axes of `axes`; under `oncard exec` the one of `ONCARD_CARD`",
       "轴数由“axes”给出的 GTS 卡；`oncard exec` 下为 `ONCARD_CARD` 给出的卡"}},
     &Scenario::card},
    {{"axes",
      KeyType::Whole(4, 12, 4),
      {"number of axes of the card", "控制卡的轴数"},
      {"that of `card`, otherwise 8", "“card”的轴数，否则为 8"}},
     &Scenario::axis_count,
     true},
    {{"cycle_us",
      KeyType::Whole(125, 4000, 125),
      {"length of a profile cycle in µs", "规划周期，单位 µs"},
      {"250", "250"}},
     &Scenario::cycle_us,
     true},
    {{"limit_ms",
      KeyType::Whole(1, kTimeMsMax),
      {"a run that lasts longer has failed; ms", "运行超过此时间即为失败，单位 ms"},
      {"60000; no limit under `oncard exec`", "60000；`oncard exec` 下不限"}},
     &Scenario::limit_ms,
     true},
    {{"until_ms",
      KeyType::Time(),
      {"the run ends exactly at this time, whatever the threads do; this is not a failure",
       "运行恰在此时结束，无论线程在做什么；这不算失败"},
      {"when no thread runs", "没有线程运行时"}},
     &Scenario::until_us},
    {{"trace",
      KeyType::Texts(),
      {"names whose values a trace or picture shows", "轨迹或曲线图所显示的量的名称"},
      {"all values that change", "所有变化的量"}},
     &Scenario::trace},
    {{"keys",
      KeyType::Tables("keys"),
      {"keys for a host program under `oncard exec`, below", "`oncard exec` 下主机程序收到的按键"},
      kNone,
      {kRefused, kRefused, kUsed}}},
    {{"expect",
      KeyType::Texts(),
      {"expectations, below", "期望：在结束时或某一时刻应成立的条件"},
      kNone}},
    {{"final",
      KeyType::Texts(),
      {"conditions that must hold at the end of every run (`interleavings.md`)",
       "每次运行结束时应成立的条件（`interleavings.md`）"},
      kNone},
     &Scenario::final},
    {{"always",
      KeyType::Texts(),
      {"conditions that must hold in every state", "在每个状态都应成立的条件"},
      kNone},
     &Scenario::always},
    {{"never",
      KeyType::Texts(),
      {"conditions that must hold in no state", "在任何状态都不应成立的条件"},
      kNone},
     &Scenario::never},
    {{"eventually",
      KeyType::Texts(),
      {"conditions, each of which must hold in some state of every run",
       "每次运行中至少在一个状态成立的条件"},
      kNone},
     &Scenario::eventually},
    {{"races",
      KeyType::Choice(kRaceRuleNames),
      {"for explorations and sessions: which data races are allowed (`interleavings.md`)",
       "供探索与会话使用：允许哪些数据竞争（`interleavings.md`）"},
      {"`any`", "`any`"},
      {kRefused, kUsed, kRefused}},
     &Scenario::races},
    {{"sync",
      KeyType::Texts(),
      {"for explorations and sessions: globals that synchronise threads and are not themselves "
       "checked for races (`interleavings.md`)",
       "供探索与会话使用：用于线程同步的全局变量，其自身不检查竞争（`interleavings.md`）"},
      kNone,
      {kRefused, kUsed, kRefused}},
     &Scenario::sync},
    // Speaks to `oncard test` and `oncard explore`.
    {{"explore",
      KeyType::Wish("explore"),
      {"`oncard test` explores the scenario instead of running it: `\"prove\"`, or a table with "
       "what is wanted, below",
       "`oncard test` 探索该场景而不是运行一次：`\"prove\"`，或给出具体要求的表"},
      {"the scenario is run", "运行一次"},
      {kMeansNothing, kUsed, kRefused}}},
    {{"globals",
      KeyType::Values(),
      {"values of globals before the start, an array's from its first element on: `name = number` "
       "or `name = [number, ...]`",
       "启动前全局变量的值，数组从首个元素起：`变量 = 数字` 或 `变量 = [数字, ...]`"},
      kZero,
      {kUsed, kUsed, kRefused}},
     &Scenario::globals},
    {{"thread",
      KeyType::Tables("thread"),
      {"a thread to bind and start, below", "要绑定并启动的线程"},
      {"thread 0 runs `main`, or the first function, on page 0",
       "线程 0 在数据页 0 运行 `main` 或首个函数"},
      {kUsed, kUsed, kRefused}}},
    {{"world",
      KeyType::Table("world"),
      {"what is around the card, below", "控制卡的外部世界"},
      {"ideal drives, no inputs", "理想驱动器，没有输入"}}},
    {{"ethercat",
      KeyType::Table("ethercat"),
      {"the EtherCAT bus of the card, below", "控制卡的 EtherCAT 总线"},
      {"no bus", "没有总线"}}},
    // The uses are those of the tables; the reader decides about the table.
    {{"host",
      KeyType::Either("host program", "host"),
      {"a table: the host program that `oncard test` runs; tables: the host writes variables, "
       "below",
       "一个表：`oncard test` 运行的主机程序；多个表：主机写入变量"},
      kNone,
      {kUsed, kRefused, kRefused}}},
};

constexpr Key<ExploreWish> kWishKeys[] = {
    {{"engine",
      KeyType::Choice(kEngineNames),
      {"the search (`interleavings.md`); `oncard explore --engine` overrides it",
       "搜索引擎（`interleavings.md`）；`oncard explore --engine` 优先"},
      {"`auto`", "`auto`"}},
     &ExploreWish::engine,
     true},
    {{"verdict",
      KeyType::Choice(kVerdictNames),
      {"the verdict that is expected", "期望的结论"},
      {"`PROVED`", "`PROVED`"}},
     &ExploreWish::verdict,
     true},
    {{"max_executions",
      KeyType::Whole(1, kCountMax),
      {"limit of the engines `auto` and `dpor`", "`auto`、`dpor` 引擎的上限"},
      {"the engine's", "由引擎决定"}},
     &ExploreWish::max_executions},
    {{"max_states",
      KeyType::Whole(1, kStatesMax),
      {"limit of the engines `auto`, `stateful` and `bounded`",
       "`auto`、`stateful`、`bounded` 引擎的上限"},
      {"the engine's", "由引擎决定"}},
     &ExploreWish::max_states},
    {{"runs",
      KeyType::Whole(1, kCountMax),
      {"number of runs of the engines `random`, `pct` and `pos`",
       "`random`、`pct`、`pos` 引擎的运行次数"},
      {"the engine's", "由引擎决定"}},
     &ExploreWish::runs},
    {{"follow",
      KeyType::Text(),
      {"a schedule file: only this schedule is checked", "调度文件：只检查这一个调度"},
      {"all schedules", "所有调度"}},
     &ExploreWish::follow},
};

constexpr Key<ThreadStart> kThreadKeys[] = {
    {{"thread", KeyType::Whole(0, vm::kThreadCount - 1), {"its number", "线程号"}, kZero},
     &ThreadStart::thread,
     true},
    {{"function", KeyType::Text(), {"name of the function", "函数名"}},
     &ThreadStart::function,
     true},
    {{"page",
      KeyType::Whole(0, vm::kPageCount - 1),
      {"data page", "数据页"},
      {"the thread's number", "线程号"}},
     &ThreadStart::page,
     true},
    {{"init",
      KeyType::Values(),
      {"parameters and locals: `{ begin = 1, a = [1, 2], \"a[3]\" = 4 }`",
       "参数与局部变量：`{ begin = 1, a = [1, 2], \"a[3]\" = 4 }`"},
      kZero},
     &ThreadStart::values},
    {{"period_ms",
      KeyType::Whole(0, kTimeMsMax),
      {"the thread is started again with this period, as by `GT_RunThreadPeriod`",
       "按此周期重复启动线程，同 `GT_RunThreadPeriod`"},
      {"started once", "只启动一次"}},
     &ThreadStart::period_ms},
    {{"priority",
      KeyType::Whole(-32768, 32767),
      {"of a periodic thread; an error without `period_ms`",
       "周期线程的优先级；没有 `period_ms` 时为错误"},
      {"4", "4"}},
     &ThreadStart::priority,
     true},
};

constexpr Key<HostProgram> kHostProgramKeys[] = {
    {{"source",
      KeyType::Text(),
      {"a host in C or C++, relative to the scenario's folder, which is compiled and linked with "
       "`libgts`",
       "C 或 C++ 主机程序，相对于场景所在文件夹；会被编译并与 `libgts` 链接"},
      {"an error without `command`", "没有 `command` 时为错误"}},
     &HostProgram::source},
    {{"flags",
      KeyType::Texts(),
      {"further options of the compiler for `source`: `[\"-I..\", \"-O2\"]`",
       "编译 `source` 时的其它编译选项：`[\"-I..\", \"-O2\"]`"},
      kNone},
     &HostProgram::flags},
    {{"arguments",
      KeyType::Texts(),
      {"arguments of the host of `source`", "`source` 的主机程序的参数"},
      kNone},
     &HostProgram::arguments},
    {{"command",
      KeyType::Texts(),
      {"a host that is there already, with its arguments: `[\"./host\", \"1\"]`, `[\"python3\", "
       "\"host.py\"]`",
       "已有的主机程序及其参数：`[\"./host\", \"1\"]`、`[\"python3\", \"host.py\"]`"},
      {"an error without `source`", "没有 `source` 时为错误"}},
     &HostProgram::command},
};

constexpr Key<HostEvent> kHostKeys[] = {
    {{"at_ms",
      KeyType::Time(),
      {"the time; the first cycle that begins at or after it sees the change",
       "时刻；在此时或之后开始的第一个周期起可见"},
      kZero},
     &HostEvent::at_us,
     true},
    {{"after_statements",
      KeyType::Whole(0, kCycleStatementsMax - 1),
      {"in the middle of the cycle at `at_ms`, when the threads have executed so many of its "
       "statements; at its end if they execute fewer",
       "在 `at_ms` 的周期中途，各线程在该周期内合计执行完这么多条语句时；不足时在周期末"},
      {"at the end of that cycle", "在该周期末"}},
     &HostEvent::after_statements},
    {{"set",
      KeyType::Values(),
      {"variables, as `GT_SetVarValue` writes them: `{ go = 1, \"page0.n\" = 5, a = [1, 2] }`",
       "变量，同 `GT_SetVarValue`：`{ go = 1, \"page0.n\" = 5, a = [1, 2] }`"}},
     &HostEvent::values,
     true},
};

constexpr Key<KeyPress> kPressKeys[] = {
    {{"at_ms", KeyType::Time(), {"when they are pressed", "按下的时刻"}, kZero},
     &KeyPress::at_us,
     true},
    {{"text", KeyType::Text(), {"the keys", "按下的键"}}, &KeyPress::text, true},
};

template <typename Structure>
KeySection SectionOf(std::string_view path, std::span<const Key<Structure>> rows) {
  KeySection section = {path, {}};
  for (const Key<Structure>& row : rows) section.keys.push_back(row.about);
  return section;
}

}  // namespace

std::span<const Key<Scenario>> ScenarioKeys() { return kScenarioKeys; }
std::span<const Key<ExploreWish>> WishKeys() { return kWishKeys; }
std::span<const Key<ThreadStart>> ThreadKeys() { return kThreadKeys; }
std::span<const Key<HostProgram>> HostProgramKeys() { return kHostProgramKeys; }
std::span<const Key<HostEvent>> HostKeys() { return kHostKeys; }
std::span<const Key<KeyPress>> PressKeys() { return kPressKeys; }

std::vector<KeySection> KeySections() {
  return {
      SectionOf("", ScenarioKeys()),
      SectionOf("explore", WishKeys()),
      SectionOf("thread", ThreadKeys()),
      SectionOf("world", WorldKeys()),
      SectionOf("world.input", InputKeys()),
      SectionOf("world.axis", MotorKeys()),
      SectionOf("world.switch", SwitchKeys()),
      SectionOf("world.move", MoveKeys()),
      SectionOf("world.fault", FaultKeys()),
      SectionOf("world.hand", HandKeys()),
      SectionOf("world.analog", VoltageKeys()),
      SectionOf("world.module", ModuleKeys()),
      SectionOf("ethercat", BusKeys()),
      SectionOf("ethercat.slave", BusSlaveKeys()),
      SectionOf("ethercat.configured", ConfiguredSlaveKeys()),
      SectionOf("ethercat.input", BusInputKeys()),
      SectionOf("host program", HostProgramKeys()),
      SectionOf("host", HostKeys()),
      SectionOf("keys", PressKeys()),
  };
}

}  // namespace oncard::runtime
