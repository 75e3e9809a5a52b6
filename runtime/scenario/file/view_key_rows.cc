// The keys of a scenario's view, each in a row.
#include "runtime/scenario/file/key_table.h"

namespace oncard::runtime {
namespace {

constexpr std::string_view kPinNames[] = {
    "gpi", "gpo", "home", "limit_positive", "limit_negative", "alarm", "arrive", "mpg"};

constexpr KeyType kViewAxis = KeyType::Whole(1, static_cast<int64_t>(motion::kAxisMax));
/// Of the widest word.
constexpr int64_t kPinMax = 16;
constexpr double kTurnMin = 0.001;
constexpr double kTurnMax = 1e9;

constexpr Key<ViewSetup> kViewKeys[] = {
    {{"title", KeyType::Text(), {"the name of the machine", "机器的名称"}, {"none", "无"}},
     &ViewSetup::title},
    {{"title_zh",
      KeyType::Text(),
      {"the same in Chinese", "机器的中文名称"},
      {"that of `title`", "与 `title` 相同"}},
     &ViewSetup::title_zh},
    {{"kind",
      KeyType::Choice(kMachineKinds),
      {"what it looks like: a stage for each axis, an XY table, a rotary table, a gripper on a "
       "stage, a conveyor; `auto`: a table for a coordinate system or two axes without "
       "switches, otherwise stages",
       "机器的样子：每轴一个滑台、XY 平台、转台、滑台上的夹爪、传送带；`auto`："
       "建立了坐标系或只用两个无开关的轴时为平台，否则为滑台"},
      {"`\"auto\"`", "`\"auto\"`"}},
     &ViewSetup::kind},
    {{"x",
      kViewAxis,
      {"the axis of its first coordinate, or of the part that moves", "第一坐标或运动部分的轴"},
      {"1", "1"}},
     &ViewSetup::x},
    {{"y", kViewAxis, {"the axis of Y of an XY table", "XY 平台的 Y 轴"}, {"2", "2"}},
     &ViewSetup::y},
    {{"z", kViewAxis, {"the axis of Z of an XY table", "XY 平台的 Z 轴"}, {"none", "无"}},
     &ViewSetup::z},
    {{"turn",
      KeyType::Number(kTurnMin, kTurnMax),
      {"how far the axis of a rotary table goes in a turn, in its unit",
       "转台每转一周其轴走过的距离，以其单位计"},
      {"10000", "10000"}},
     &ViewSetup::turn},
    {{"pin",
      KeyType::Tables("view.pin"),
      {"an input or output that the machine names, below", "机器命名的输入或输出"},
      {"all are shown by their numbers", "全部以编号显示"}}},
};

constexpr Key<ViewPin> kViewPinKeys[] = {
    {{"type",
      KeyType::Choice(kPinNames),
      {"the word of the pin", "管脚所在的字"},
      {"`gpi`", "`gpi`"}},
     &ViewPin::type},
    {{"index", KeyType::Whole(1, kPinMax), {"the pin, from 1", "管脚，从 1 开始"}},
     &ViewPin::index},
    {{"name", KeyType::Text(), {"its name", "管脚的名称"}}, &ViewPin::name},
    {{"name_zh",
      KeyType::Text(),
      {"the same in Chinese", "管脚的中文名称"},
      {"that of `name`", "与 `name` 相同"}},
     &ViewPin::name_zh},
};

}  // namespace

std::span<const Key<ViewSetup>> ViewKeys() { return kViewKeys; }
std::span<const Key<ViewPin>> ViewPinKeys() { return kViewPinKeys; }

}  // namespace oncard::runtime
