// Calls the commands of a card of each family, in any order, with any numbers and with time between
// them, while the supervisor watches: every state that a host can bring a card into. A new family
// takes part by its row in families.def.
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "gtcalls/card_elements.h"
#include "gtcalls/card_type.h"
#include "gtcalls/family.h"
#include "gtcalls/rows/words.h"
#include "runtime/observe/supervisor.h"
#include "runtime/sim/controller.h"
#include "tests/fuzz/argument_bytes.h"
#include "tests/fuzz/fuzz.h"

namespace oncard::fuzz {
namespace {

using gtcalls::Command;
using gtcalls::Parameter;
using gtcalls::Passing;
using gtcalls::Scalar;

/// A card to which the calls of an input happen.
class FuzzedCard {
 public:
  explicit FuzzedCard(const gtcalls::NamedCard& card)
      : controller_({.motion = {.axis_count = card.type->axis_count}, .family = card.family}),
        supervisor_(&controller_) {}

  void CallAll(Bytes bytes) {
    const auto commands = controller_.family().catalogue.commands();
    while (!bytes.empty()) {
      Call(commands[bytes.Value<uint16_t>() % commands.size()], &bytes);
      controller_.RunCycles(CyclesAfter(bytes.Byte()));
    }
    supervisor_.JudgeEnd();
  }

  const motion::MotionCore& motion() const { return controller_.motion(); }
  uint64_t Hash() const { return controller_.Hash(); }

 private:
  /// Between most calls there are none.
  static int64_t CyclesAfter(uint8_t kind) {
    if (kind < 192) return 0;
    return kind < 240 ? kind - 191 : (kind - 239) * 25;
  }

  void Call(const Command& command, Bytes* bytes) {
    const gtcalls::Family& family = controller_.family();
    if (family.Resets(command)) return controller_.Reset();
    // What is left are commands of the host library.
    if (!family.Executes(command)) return;
    controller_.AdvanceUs(family.cost_us(command));
    std::array<vm::CommandArgument, gtcalls::kParameterMax> arguments{};
    const auto used = std::span(arguments).first(command.parameters.size());
    // Values first: among them are the numbers of elements.
    for (size_t i = 0; i < used.size(); ++i) {
      const Parameter& parameter = command.parameters[i];
      if (parameter.passing == Passing::kValue) used[i].value = Value(parameter.type, bytes);
    }
    std::array<std::vector<double>, gtcalls::kParameterMax> cells;
    for (size_t i = 0; i < used.size(); ++i) {
      const Parameter& parameter = command.parameters[i];
      if (parameter.passing == Passing::kValue) continue;
      const auto elements = gtcalls::ElementsBehind(command, parameter, used, &controller_.card());
      used[i].null = bytes->Byte() % 16 == 0 || !elements;
      used[i].host = name_.data();
      if (used[i].null) continue;
      cells[i] = Cells(parameter, *elements, bytes);
      used[i].cells = cells[i];
    }
    Message reason;
    controller_.Execute(command, used, &reason);
  }

  /// The values behind a pointer: zeros for an output.
  static std::vector<double> Cells(const Parameter& parameter, size_t elements, Bytes* bytes) {
    if (parameter.passing != Passing::kInput && parameter.passing != Passing::kOutput) return {};
    std::vector<double> cells(elements * gtcalls::CellsPerElement(parameter));
    if (parameter.passing == Passing::kOutput) return cells;
    size_t next = 0;
    const auto fill = [&](Scalar type) { cells[next++] = Value(type, bytes); };
    while (next < cells.size()) {
      if (parameter.structure != nullptr) {
        gtcalls::words::ForEachCell(*parameter.structure, fill);
      } else {
        fill(parameter.type);
      }
    }
    return cells;
  }

  /// A number as the host library passes it on.
  static double Value(Scalar type, Bytes* bytes) {
    switch (type) {
      case Scalar::kDouble:
        return bytes->Real();
      case Scalar::kInt:
      case Scalar::kLong:
        return static_cast<int32_t>(bytes->Integer(type));
      case Scalar::kUnsignedLong:
        return static_cast<uint32_t>(bytes->Integer(type));
      default:
        return static_cast<double>(bytes->Integer(type));
    }
  }

  runtime::Controller controller_;
  runtime::Supervisor supervisor_;
  /// What texts are; working memory of the host is not accessed.
  std::string name_ = ONCARD_SOURCE_DIR "/tests/fuzz/seeds/card.cfg";
};

}  // namespace

void FuzzFamilies(std::string_view input) {
  Bytes bytes(input);
  const std::vector<std::string_view> names = gtcalls::CardTypeNames();
  const auto card = gtcalls::FindCard(names[bytes.Byte() % names.size()]);
  FuzzedCard first(*card);
  first.CallAll(bytes);
  for (size_t i = 0; i < first.motion().axis_count(); ++i) {
    FUZZ_CHECK(std::isfinite(first.motion().profile(i).now.position));
  }
  FuzzedCard second(*card);
  second.CallAll(bytes);
  FUZZ_CHECK(first.Hash() == second.Hash());
}

}  // namespace oncard::fuzz
