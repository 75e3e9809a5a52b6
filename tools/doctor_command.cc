// oncard doctor: shows versions, what this build supports, and what is missing.
#include <fmt/format.h>
#include <toml++/impl/preprocessor.h>
#include <xxhash.h>

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "compiler/gbk_decoder.h"
#include "gtcalls/families.h"
#include "gtcalls/family.h"
#include "tools/commands.h"
#include "tools/gnuplot.h"

namespace oncard::tools {
namespace {

struct DoctorArguments {
  bool commands = false;
  std::string family{gtcalls::Families().front()->name};
  std::string format = "text";
};

/// True if the card executes the command or the host library answers it.
bool IsAnswered(const gtcalls::Family& family, const gtcalls::Command& command) {
  return family.why_unsupported(command) == nullptr;
}

std::vector<std::string> FamilyNames() {
  std::vector<std::string> names;
  for (const gtcalls::Family* family : gtcalls::Families()) names.emplace_back(family->name);
  return names;
}

/// The family of a name that the option has checked.
const gtcalls::Family& FamilyNamed(std::string_view name) {
  return **std::ranges::find(gtcalls::Families(), name, &gtcalls::Family::name);
}

struct Fact {
  std::string key;
  Message name;
  std::string value;
};

std::vector<Fact> Facts(const gtcalls::Family& family) {
  const auto commands = family.catalogue.commands();
  const auto implemented =
      std::count_if(commands.begin(), commands.end(),
                    [&](const gtcalls::Command& command) { return IsAnswered(family, command); });
  const auto in_programs =
      std::count_if(commands.begin(), commands.end(),
                    [](const gtcalls::Command& command) { return command.in_motion_program; });
  const auto count = [](auto number) { return fmt::format("{}", number); };
  std::vector<Fact> facts = {
      {"version", {"oncard", "oncard"}, ONCARD_VERSION},
      {"compiler", {"built by", "编译器"}, ONCARD_COMPILER},
      {"build_type", {"build type", "构建类型"}, ONCARD_BUILD_TYPE},
      {"cli11", {"CLI11", "CLI11"}, CLI11_VERSION},
      {"fmt",
       {"fmt", "fmt"},
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann_json",
       {"nlohmann-json", "nlohmann-json"},
       fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                   NLOHMANN_JSON_VERSION_PATCH)},
      {"tomlplusplus",
       {"toml++", "toml++"},
       fmt::format("{}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
      {"xxhash",
       {"xxhash", "xxhash"},
       fmt::format("{}.{}.{}", XXH_VERSION_MAJOR, XXH_VERSION_MINOR, XXH_VERSION_RELEASE)},
      {"eigen", {"Eigen", "Eigen"}, ONCARD_EIGEN_VERSION},
      {"fast_float", {"fast_float", "fast_float"}, ONCARD_FAST_FLOAT_VERSION},
      {"cpp_httplib", {"cpp-httplib", "cpp-httplib"}, ONCARD_HTTPLIB_VERSION},
      {"cards", {"cards", "控制卡型号"}, fmt::to_string(fmt::join(gtcalls::CardTypeNames(), ", "))},
      {"commands", {"commands in the catalogue", "指令目录中的指令"}, count(commands.size())},
      {"commands_in_programs",
       {"... allowed in motion programs", "……可在运动程序中使用"},
       count(in_programs)},
      {"commands_implemented", {"... that are implemented", "……已实现"}, count(implemented)},
      {"diagnostics",
       {"diagnostics of the compiler", "编译器诊断"},
       count(compiler::DiagnosticTable().size())},
  };
  // A library that this build does not have has no version.
  std::erase_if(facts, [](const Fact& fact) { return fact.value.empty(); });
  return facts;
}

// A feature that needs something else to be installed.
struct OptionalPart {
  std::string key;
  Message name;
  bool present = false;
  Message remedy;
};

std::vector<OptionalPart> OptionalParts() {
  return {{"gbk",
           {"GBK comments in messages", "消息中显示 GBK 注释"},
           compiler::GbkDecoder().Available(),
           {"the C library's converters are missing: install libc-bin and libc6",
            "缺少 C 库的字符转换模块：请安装 libc-bin 和 libc6"}},
          {"gnuplot",
           {"pictures (--plot)", "图形（--plot）"},
           !GnuplotVersion().empty(),
           GnuplotRemedy()}};
}

void PrintText(const gtcalls::Family& family, const Invocation& invocation) {
  std::string text;
  for (const Fact& fact : Facts(family)) {
    text += fmt::format("{}: {}\n", invocation.Say(fact.name), fact.value);
  }
  for (const OptionalPart& part : OptionalParts()) {
    const Message found = {"yes", "有"};
    text += fmt::format("{}: {}\n", invocation.Say(part.name),
                        invocation.Say(part.present ? found : part.remedy));
  }
  PrintResult(text);
}

void PrintJson(const gtcalls::Family& family, const Invocation& invocation) {
  nlohmann::ordered_json json;
  for (const Fact& fact : Facts(family)) json[fact.key] = fact.value;
  for (const OptionalPart& part : OptionalParts()) {
    json["optional"][part.key]["present"] = part.present;
    if (!part.present) json["optional"][part.key]["remedy"] = invocation.Say(part.remedy);
  }
  PrintResult(JsonText(json, 2) + '\n');
}

void PrintCommands(const gtcalls::Family& family, bool as_json, const Invocation& invocation) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text;
  for (const gtcalls::Command& command : family.catalogue.commands()) {
    const bool implemented = IsAnswered(family, command);
    Message state =
        implemented ? Message{"implemented", "已实现"} : Message{"not supported", "不支持"};
    const Message* why = implemented ? nullptr : family.why_unsupported(command);
    if (why != nullptr) {
      state.en += ": " + why->en;
      state.zh += "：" + why->zh;
    }
    text += fmt::format("{:<28} {}\n", command.name, invocation.Say(state));
    list.push_back({{"name", command.name},
                    {"implemented", implemented},
                    {"in_motion_program", command.in_motion_program}});
    if (why != nullptr) list.back()["reason"] = invocation.Say(*why);
  }
  PrintResult(as_json ? JsonText(list, 2) + '\n' : text);
}

int Doctor(const DoctorArguments& arguments, const Invocation& invocation) {
  const bool json = arguments.format == "json";
  const gtcalls::Family& family = FamilyNamed(arguments.family);
  if (arguments.commands) {
    PrintCommands(family, json, invocation);
  } else if (json) {
    PrintJson(family, invocation);
  } else {
    PrintText(family, invocation);
  }
  return kExitOk;
}

}  // namespace

void AddDoctor(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* command =
      AddCommand(app, invocation, "doctor",
                 {"show versions and the capabilities of this build", "显示版本以及本构建的能力"},
                 [arguments, &invocation] { return Doctor(*arguments, invocation); });
  command->add_flag("--commands", arguments->commands,
                    invocation.Say({"list every GT command and whether it is implemented",
                                    "列出全部 GT 指令及其实现情况"}));
  command
      ->add_option("--family", arguments->family,
                   invocation.Say(MakeMessage("the family of cards whose commands are counted or "
                                              "listed: {0}",
                                              "统计或列出哪个系列控制卡的指令：{0}",
                                              fmt::to_string(fmt::join(FamilyNames(), ", ")))))
      ->check(CLI::IsMember(FamilyNames()).description(""))
      ->type_name("FAMILY");
  AddFormatOption(*command, invocation, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
