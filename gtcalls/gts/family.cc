#include "gtcalls/gts/family.h"

#include <vector>

#include "gtcalls/gts/catalogue.h"
#include "gtcalls/gts/commands/commands.h"
#include "gtcalls/gts/unsupported.h"

namespace oncard::gtcalls {
namespace {

/// GTS: not supported by the firmware.
constexpr int16_t kNotSupported = 8;

/// GTS manual 10.2: a host calls at a fifth of the card's rate; and the end of its chapter 7.
constexpr int64_t kHostCallUs = 50;
constexpr int64_t kMillisecondUs = 1000;

int64_t CostUs(const Command& command) {
  switch (command.cost) {
    case Cost::kMillisecond:
      return kMillisecondUs;
    case Cost::kNone:
      return 0;
    case Cost::kHostCall:
      break;
  }
  return kHostCallUs;
}

std::vector<CommandFunction> FunctionsByNumber() {
  std::vector<CommandFunction> functions(GtsCatalogue().commands().size());
  for (const CommandEntry& entry : AllCommands()) {
    const Command* command = GtsCatalogue().Find(entry.name);
    if (command == nullptr) continue;  // a misspelt name, which a test reports
    functions[command->number - 1u] = entry.function;
  }
  return functions;
}

}  // namespace

std::vector<CommandEntry> AllCommands() {
  std::vector<CommandEntry> all;
  for (const std::span<const CommandEntry> topic :
       {ThreadCommands(),       VariableCommands(), TimeCommands(),      DigitalIoCommands(),
        UserVariableCommands(), AnalogCommands(),   ExtensionCommands(), EncoderCommands(),
        ServoCommands(),        PlcCommands(),      PlcWordCommands(),   AxisCommands(),
        PositionCommands(),     TrapCommands(),     GearCommands(),      FollowCommands(),
        PtCommands(),           PvtCommands(),      CrdCommands(),       SegmentCommands(),
        BufferCommands(),       CaptureCommands(),  HomeCommands(),      CompareCommands(),
        CompensationCommands(), GantryCommands(),   MramCommands(),      ConfigCommands()}) {
    all.insert(all.end(), topic.begin(), topic.end());
  }
  return all;
}

const Family& GtsFamily() {
  static const std::vector<CommandFunction> kFunctions = FunctionsByNumber();
  static const Family kFamily = {GtsCatalogue(), kFunctions, kNotSupported, WhyUnsupported, CostUs};
  return kFamily;
}

}  // namespace oncard::gtcalls
