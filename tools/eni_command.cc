// oncard eni: the ENI file that fits the bus of a scenario.
#include "runtime/host/eni_file.h"
#include "runtime/scenario/file/scenario.h"
#include "tools/commands.h"

namespace oncard::tools {
namespace {

struct EniOptions {
  std::string scenario;
  std::string output;
};

/// The configuration of a bus: its own, or that of the slaves.
motion::bus::Slaves ConfiguredSlaves(const runtime::BusSetup& bus) {
  motion::bus::Slaves slaves;
  for (const runtime::BusSlaveSetup& setup : bus.configured.empty() ? bus.slaves : bus.configured) {
    slaves.push_back(SlaveOf(setup));
  }
  return slaves;
}

int WriteEni(const EniOptions& options, const Invocation& invocation) {
  const auto scenario = runtime::LoadScenario(options.scenario, runtime::ScenarioUse::kHost);
  if (!scenario.ok()) return Fail(invocation, kExitUnreadable, scenario.error().message);
  const motion::bus::Slaves slaves = ConfiguredSlaves(scenario.value().bus);
  if (slaves.empty()) {
    return Fail(invocation, kExitUsage,
                MakeMessage("{0} has no [[ethercat.slave]]", "{0} 中没有 [[ethercat.slave]]",
                            options.scenario));
  }
  const std::string text = runtime::FormatEni(slaves);
  if (!options.output.empty()) return WriteOutput(invocation, options.output, text);
  PrintResult(text);
  return kExitOk;
}

}  // namespace

void AddEni(CLI::App& app, Invocation& invocation) {
  auto options = std::make_shared<EniOptions>();
  CLI::App* command =
      AddCommand(app, invocation, "eni",
                 {"write the ENI file (ETG.2100) that fits the EtherCAT bus of a scenario",
                  "输出与场景的 EtherCAT 总线相符的 ENI 文件（ETG.2100）"},
                 [options, &invocation] { return WriteEni(*options, invocation); });
  command
      ->add_option("scenario", options->scenario,
                   invocation.Say({"scenario file with [[ethercat.slave]]",
                                   "带有 [[ethercat.slave]] 的场景文件"}))
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->output,
                   invocation.Say({"output file, such as Gecat.eni (default: standard output)",
                                   "输出文件，如 Gecat.eni（默认：标准输出）"}))
      ->type_name("FILE");
}

}  // namespace oncard::tools
