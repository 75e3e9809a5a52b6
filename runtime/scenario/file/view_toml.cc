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

}  // namespace

ViewSetup ReadView(const toml::table& table, int axis_count, TomlKeys& keys) {
  ViewSetup view;
  ReadKeys(table, ViewKeys(), keys, &view);
  CheckMost(table, "x", view.x, axis_count, keys);
  CheckMost(table, "y", view.y, axis_count, keys);
  CheckMost(table, "z", view.z, axis_count, keys);
  for (const toml::table* pin : keys.Tables(table, "view.pin")) {
    view.pins.push_back(ReadPin(*pin, keys));
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
