#include "editor/command_help.h"

#include <fmt/core.h>

#include "base/markup.h"

namespace oncard::editor {
namespace {

using gtcalls::Command;
using gtcalls::Parameter;
using gtcalls::Passing;

std::string Elements(const Command& command, const Parameter& parameter, Language language) {
  Message text;
  if (parameter.count_parameter >= 0) {
    const auto count = static_cast<size_t>(parameter.count_parameter);
    text = MakeMessage("array of {0}", "数组，元素个数为 {0}", command.parameters[count].name);
  } else if (parameter.array_size > 1) {
    text = MakeMessage("array of {0}", "数组，元素个数为 {0}", parameter.array_size);
  } else if (parameter.per_dimension) {
    text = MakeMessage("one element per axis of the coordinate system", "坐标系每轴一个元素");
  } else if (parameter.per_offset) {
    text = MakeMessage("one element per capture offset", "每个捕获偏置一个元素");
  } else if (parameter.per_axis) {
    text = MakeMessage("one element per axis of the card", "控制卡每轴一个元素");
  }
  return text.In(language);
}

}  // namespace

std::string ParameterLabel(const Parameter& parameter) {
  std::string label = gtcalls::DeclareParameter(parameter);
  if (!parameter.default_text.empty()) label += fmt::format(" = {}", parameter.default_text);
  return label;
}

std::string Prototype(const Command& command) {
  std::string prototype = fmt::format("{}(", command.name);
  for (const Parameter& parameter : command.parameters) {
    if (!prototype.ends_with('(')) prototype += ", ";
    prototype += ParameterLabel(parameter);
  }
  return prototype + ')';
}

bool IsPointer(const Parameter& parameter) {
  return parameter.passing == Passing::kInput || parameter.passing == Passing::kOutput ||
         parameter.passing == Passing::kLent;
}

std::string ParameterNote(const Command& command, const Parameter& parameter, Language language) {
  std::string note;
  const auto add = [&note](std::string_view part) {
    if (!part.empty()) note += fmt::format("{}{}", note.empty() ? "" : ", ", part);
  };
  if (parameter.passing == Passing::kOutput) add(MakeMessage("output", "输出").In(language));
  add(gtcalls::SpellUnit(parameter.unit));
  add(gtcalls::SpellRange(parameter));
  add(Elements(command, parameter, language));
  if (parameter.axis_number || parameter.encoder_number) {
    add(MakeMessage("a card may have fewer axes", "控制卡的轴数可能更少").In(language));
  }
  if (parameter.nullable) add(MakeMessage("may be NULL", "可为 NULL").In(language));
  return note;
}

nlohmann::ordered_json ParameterJson(const Command& command, const Parameter& parameter,
                                     Language language) {
  nlohmann::ordered_json json = {
      {"name", parameter.name},
      {"label", ParameterLabel(parameter)},
      {"type", parameter.structure != nullptr ? parameter.structure->name
                                              : gtcalls::SpellScalar(parameter.type)}};
  if (IsPointer(parameter)) {
    json["passing"] = parameter.passing == Passing::kOutput  ? "output"
                      : parameter.passing == Passing::kInput ? "input"
                                                             : "unused";
  }
  const std::string_view unit = gtcalls::SpellUnit(parameter.unit);
  if (!unit.empty()) json["unit"] = unit;
  const std::string range = gtcalls::SpellRange(parameter);
  if (!range.empty()) json["range"] = range;
  if (!parameter.default_text.empty()) json["default"] = parameter.default_text;
  const std::string note = ParameterNote(command, parameter, language);
  if (!note.empty()) json["note"] = note;
  return json;
}

std::string_view Brief(const Command& command, Language language) {
  return language == Language::kChinese ? command.brief_zh : command.brief;
}

std::string Callers(const Command& command, Language language) {
  if (!command.in_motion_program) {
    return MakeMessage("can only be called by a host program", "只能由主机程序调用").In(language);
  }
  return (command.on_host
              ? MakeMessage("for motion programs and host programs", "运动程序与主机程序均可调用")
              : MakeMessage("for motion programs only", "只能由运动程序调用"))
      .In(language);
}

std::string CommandMarkdown(const Command& command, Language language) {
  const std::string_view brief = Brief(command, language);
  const std::string callers = Callers(command, language);
  std::string text = fmt::format("```c\n{}\n```\n", Prototype(command)) +
                     MakeMessage("{0}; {1}\n", "{0}；{1}\n", brief, callers).In(language);
  if (!command.parameters.empty()) {
    text += MakeMessage("\n| parameter | type | unit, range |\n|---|---|---|\n",
                        "\n| 参数 | 类型 | 单位、范围 |\n|---|---|---|\n")
                .In(language);
    for (const Parameter& parameter : command.parameters) {
      const std::string_view type = parameter.structure != nullptr
                                        ? parameter.structure->name
                                        : gtcalls::SpellScalar(parameter.type);
      text += fmt::format("| `{}` | `{}{}` | {} |\n", parameter.name, type,
                          IsPointer(parameter) ? " *" : "",
                          EscapeTableCell(ParameterNote(command, parameter, language)));
    }
  }
  text += MakeMessage(
              "\nreturn codes: 0 done; 1 not possible now; 7 a parameter is out of range; they go "
              "to the status of the thread\n",
              "\n返回值：0 成功；1 当前状态下不能执行；7 参数超出范围；返回值存入线程状态\n")
              .In(language);
  text += MakeMessage("\nsource: {0}; no. {1}, tier {2}\n", "\n来源：{0}；编号 {1}，等级 {2}\n",
                      command.source, command.number,
                      command.tier == gtcalls::Tier::kA   ? "A"
                      : command.tier == gtcalls::Tier::kB ? "B"
                                                          : "X")
              .In(language);
  return text;
}

}  // namespace oncard::editor
