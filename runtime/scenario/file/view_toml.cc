#include "runtime/scenario/file/view_toml.h"

#include "runtime/observe/quantity.h"
#include "runtime/scenario/file/key_table.h"
#include "runtime/scenario/file/keyed_toml.h"

namespace oncard::runtime {
namespace {

/// The largest number depends on other keys. A number beyond the range of its row has an error
/// already, and was not read.
void CheckMost(const toml::table& table, std::string_view key, int value, int most,
               TomlKeys& keys) {
  if (table.contains(key) && value > most) keys.Whole(table, key, 0, 1, most);
}

ViewPin ReadPin(const toml::table& table, TomlKeys& keys) {
  ViewPin pin;
  ReadKeys(table, ViewPinKeys(), keys, &pin);
  for (const char* key : {"index", "name"}) {
    if (table.contains(key)) continue;
    keys.Fail(table.source(),
              MakeMessage("'{0}' is missing: a pin is named as in {{ type = \"gpo\", index = 1, "
                          "name = \"Pen\" }}",
                          "缺少“{0}”：管脚的写法如 {{ type = \"gpo\", index = 1, name = \"Pen\" }}",
                          key));
  }
  CheckMost(table, "index", pin.index, WordWidth(pin.type), keys);
  return pin;
}

/// A table moves along axes of its own.
void CheckTable(const toml::table& table, const ViewSetup& view, TomlKeys& keys) {
  if (view.kind != "xy") return;
  const bool has_twice = view.x == view.y || view.x == view.z || view.y == view.z;
  if (!has_twice) return;
  keys.Fail(
      table.source(),
      MakeMessage("'x', 'y' and 'z' of a table are different axes, not {0}, {1} and {2}",
                  "平台的“x”、“y”、“z”应为不同的轴，而不是 {0}、{1}、{2}", view.x, view.y, view.z));
}

/// A pin without a number has an error already.
bool IsOfSamePin(const ViewPin& a, const ViewPin& b) {
  return a.index != 0 && a.type == b.type && a.index == b.index;
}

}  // namespace

ViewSetup ReadView(const toml::table& table, int axis_count, TomlKeys& keys) {
  ViewSetup view;
  ReadKeys(table, ViewKeys(), keys, &view);
  CheckMost(table, "x", view.x, axis_count, keys);
  CheckMost(table, "y", view.y, axis_count, keys);
  CheckMost(table, "z", view.z, axis_count, keys);
  CheckTable(table, view, keys);
  for (const toml::table* named : keys.Tables(table, "view.pin")) {
    ViewPin pin = ReadPin(*named, keys);
    for (const ViewPin& other : view.pins) {
      if (!IsOfSamePin(pin, other)) continue;
      keys.Fail(named->source(), MakeMessage("{0} {1} is named twice: '{2}' and '{3}'",
                                             "{0} {1} 被命名两次：“{2}”和“{3}”", pin.type,
                                             pin.index, other.name, pin.name));
    }
    view.pins.push_back(std::move(pin));
  }
  return view;
}

std::string FormatView(const ViewSetup& view) {
  const std::vector<std::string> keys = WriteKeys(view, ViewKeys());
  std::string text = keys.empty() ? std::string() : AsTable("[view]", keys);
  for (const ViewPin& pin : view.pins) {
    text += AsTable("[[view.pin]]", WriteKeys(pin, ViewPinKeys()));
  }
  return text;
}

}  // namespace oncard::runtime
