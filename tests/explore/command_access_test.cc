// The rows of the catalogue say what each command of motion programs accesses, and the explorer
// relies on them: which statements depend on each other, and which do not change the card. Here
// every command is executed on cards in many states, with many arguments, and its effects are
// compared with its row:
//
//   - every part of the card that has changed must be written according to the row
//   - no other thread changes, and no variable except those passed as outputs
//   - parts that the row does not name make no difference: if all of them are taken from another
//     card, the command returns the same code and outputs, and the same state otherwise
//   - a command whose row does not read the clock does the same at any time
//   - a command that is never refused returns the same code in all states
//   - two commands that do not depend on each other lead to the same card in both orders; this is
//     what the parts of resources in the rows promise (gtcalls::Part)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>
#include <tuple>

#include "base/random.h"
#include "gtcalls/card.h"
#include "gtcalls/gts/catalogue.h"
#include "gtcalls/gts/family.h"
#include "gtcalls/gts/numbers.h"
#include "motion/common/state_hash.h"
#include "runtime/observe/statement_access.h"
#include "runtime/sim/controller.h"
#include "tests/base/random_cases.h"
#include "tests/motion/change_state.h"
#include "vm/thread_words.h"

namespace oncard::explore {
namespace {

using gtcalls::Command;
using gtcalls::Resource;
using runtime::StatementAccess;
using runtime::Touched;

constexpr int kCaller = 3;
constexpr int kOther = 5;
constexpr int kAxes = static_cast<int>(motion::kAxisMax);

// --- Parts of a card -----------------------------------------------------------------------------

/// The state of a card outside its virtual machine.
struct CardState {
  motion::MotionState& motion;
  gtcalls::GtsState& gts;
};

/// A part of the card's state, with the resource for it in rows.
struct Part {
  std::string name;
  Resource resource = Resource::kNone;
  uint32_t number = Touched::kAll;
  std::function<uint64_t(const CardState&)> hash;
  /// Copies the part from another state; empty for parts of one that is copied as a whole.
  std::function<void(const CardState&, const CardState&)> take = {};
};

template <typename... Values>
uint64_t HashOf(const Values&... values) {
  motion::StateHash hash;
  (hash.Add(values), ...);
  return hash.value();
}

/// Of a word of inputs (0) or outputs (1).
template <size_t kKind>
uint64_t HashOfWord(const motion::DigitalIo& io, size_t word) {
  return io.Fields(
      [word](const auto&... words) { return HashOf(std::get<kKind>(std::tie(words...))[word]); });
}

std::vector<Part> PartsOfCard() {
  std::vector<Part> parts;
  for (uint32_t i = 0; i < motion::kAxisMax; ++i) {
    parts.push_back({"axis", Resource::kAxis, i + 1,
                     [i](const CardState& s) {
                       return HashOf(s.motion.profiles[i], s.motion.axes[i],
                                     s.motion.compensations[i], s.motion.drives[i],
                                     s.motion.plants[i], s.motion.steps[i], s.motion.homing[i]);
                     },
                     [i](const CardState& from, const CardState& to) {
                       to.motion.profiles[i] = from.motion.profiles[i];
                       to.motion.axes[i] = from.motion.axes[i];
                       to.motion.compensations[i] = from.motion.compensations[i];
                       to.motion.drives[i] = from.motion.drives[i];
                       to.motion.plants[i] = from.motion.plants[i];
                       to.motion.steps[i] = from.motion.steps[i];
                       to.motion.homing[i] = from.motion.homing[i];
                     }});
    parts.push_back({"encoder", Resource::kEncoder, i + 1,
                     [i](const CardState& s) {
                       return HashOf(s.motion.encoders[i], s.motion.encoder_faults[i]);
                     },
                     [i](const CardState& from, const CardState& to) {
                       to.motion.encoders[i] = from.motion.encoders[i];
                       to.motion.encoder_faults[i] = from.motion.encoder_faults[i];
                     }});
    parts.push_back({"control", Resource::kControl, i + 1,
                     [i](const CardState& s) { return HashOf(s.motion.controls[i]); },
                     [i](const CardState& from, const CardState& to) {
                       to.motion.controls[i] = from.motion.controls[i];
                     }});
  }
  for (uint32_t i = 0; i < motion::kCrdCount; ++i) {
    parts.push_back({"coordinate system", Resource::kCrd, i + 1,
                     [i](const CardState& s) { return HashOf(s.motion.crds[i]); },
                     [i](const CardState& from, const CardState& to) {
                       to.motion.crds[i] = from.motion.crds[i];
                     }});
  }
  for (uint32_t i = 0; i < motion::kModuleCount; ++i) {
    parts.push_back({"extension module", Resource::kExtension, i,
                     [i](const CardState& s) { return HashOf(s.motion.modules[i]); },
                     [i](const CardState& from, const CardState& to) {
                       to.motion.modules[i] = from.motion.modules[i];
                     }});
  }
  for (uint32_t i = 0; i < motion::kDiTypeCount; ++i) {
    parts.push_back({"inputs", Resource::kDigitalInput, i,
                     [i](const CardState& s) { return HashOfWord<0>(s.motion.io, i); }});
  }
  for (uint32_t i = 0; i < motion::kDoTypeCount; ++i) {
    parts.push_back({"outputs", Resource::kDigitalOutput, gtcalls::gts::kOutputWordFirst + i,
                     [i](const CardState& s) { return HashOfWord<1>(s.motion.io, i); }});
  }
  parts.push_back({"analogue", Resource::kAnalog, Touched::kAll,
                   [](const CardState& s) { return HashOf(s.motion.dacs, s.motion.adcs); },
                   [](const CardState& from, const CardState& to) {
                     to.motion.dacs = from.motion.dacs;
                     to.motion.adcs = from.motion.adcs;
                   }});
  parts.push_back({"captures", Resource::kCapture, Touched::kAll,
                   [](const CardState& s) { return HashOf(s.motion.capture); },
                   [](const CardState& from, const CardState& to) {
                     to.motion.capture = from.motion.capture;
                   }});
  parts.push_back({"compare", Resource::kCompare, Touched::kAll,
                   [](const CardState& s) { return HashOf(s.motion.compare); },
                   [](const CardState& from, const CardState& to) {
                     to.motion.compare = from.motion.compare;
                   }});
  parts.push_back({"PVT tables", Resource::kPvtTable, Touched::kAll,
                   [](const CardState& s) { return HashOf(s.motion.pvt_tables); },
                   [](const CardState& from, const CardState& to) {
                     to.motion.pvt_tables = from.motion.pvt_tables;
                   }});
  parts.push_back({"user variables", Resource::kUserVariable, Touched::kAll,
                   [](const CardState& s) { return HashOf(s.gts.long_vars, s.gts.double_vars); },
                   [](const CardState& from, const CardState& to) {
                     to.gts.long_vars = from.gts.long_vars;
                     to.gts.double_vars = from.gts.double_vars;
                   }});
  // Everything for which rows have no separate resource.
  parts.push_back({"the rest", Resource::kEverything, Touched::kAll, [](const CardState& s) {
                     return HashOf(s.motion.cycle, s.motion.clock_cycle, s.motion.enable_axes,
                                   s.motion.compensates, s.motion.world, s.motion.switches,
                                   s.motion.index_marks, s.motion.gantry, s.motion.homing_runs,
                                   s.gts.mram, s.gts.plc, s.motion.reached);
                   }});
  return parts;
}

/// True if the row names the part; with `writes` only as written.
bool Names(const StatementAccess& access, const Part& part, bool writes) {
  return std::ranges::any_of(access, [&](const Touched& touched) {
    if (writes && !touched.write) return false;
    if (touched.resource == Resource::kEverything) return true;
    return touched.resource == part.resource &&
           (touched.number == part.number || touched.number == Touched::kAll ||
            part.number == Touched::kAll);
  });
}

// --- Cards in many states ------------------------------------------------------------------------

/// A call that the card must accept.
void Call(runtime::Controller* card, std::string_view name, const std::vector<double>& values,
          std::vector<double> cells = {}) {
  const Command& command = *gtcalls::GtsCatalogue().Find(name);
  std::vector<vm::CommandArgument> arguments(command.parameters.size());
  for (size_t i = 0, next = 0; i < arguments.size(); ++i) {
    if (command.parameters[i].passing == gtcalls::Passing::kValue) {
      if (next < values.size()) arguments[i].value = values[next++];
    } else {
      arguments[i].cells = cells;
    }
  }
  EXPECT_EQ(card->Execute(command, arguments), vm::kOk) << name;
}

/// A coordinate system of axes 6 and 7 with one segment.
void SetUpCrd(double length, double velocity, runtime::Controller* card) {
  motion::CrdParameters parameters;
  parameters.dimension = 2;
  parameters.coordinates = {0, 0, 0, 0, 0, 1, 2};
  parameters.velocity_max = 100;
  parameters.acceleration_max = 1;
  card->motion().CrdAt(0).SetUp(parameters);
  motion::PathSlot slot;
  slot.is_segment = true;
  slot.segment = *motion::MakeLine({}, {length, 50});
  slot.velocity = velocity;
  slot.acceleration = 0.5;
  card->motion().CrdAt(0).Append(0, slot);
}

/// Stage 0 is the card at power-on. Later stages have axes in every mode and other values
/// everywhere; from stage 2 on everything that can move is moving.
void Prepare(int stage, runtime::Controller* card) {
  if (stage == 0) return;
  const auto call = [card](std::string_view name, const std::vector<double>& values,
                           std::vector<double> cells = {}) {
    Call(card, name, values, std::move(cells));
  };
  const double factor = stage;
  const double step = 100.0 * stage;
  if (stage % 2 == 1) {
    call("GT_EncOn", {12});
    call("GT_CtrlMode", {12, 0});
  }
  for (int axis = 1; axis <= kAxes; ++axis) {
    call("GT_AxisOn", {1.0 * axis});
    call("GT_SetStopDec", {1.0 * axis, 1.0 + stage, 2.0 + stage});
  }
  call("GT_SetDac", {1, 1}, {step});
  call("GT_SetDo", {12, step});
  call("GT_SetCaptureMode", {1, 1});
  call("GT_PrfTrap", {1});
  call("GT_SetTrapPrm", {1}, {factor, factor, 0, 0});
  call("GT_SetPos", {1, 1000 * step});
  call("GT_SetVel", {1, 3 * factor});
  call("GT_PrfJog", {2});
  call("GT_SetJogPrm", {2}, {factor, factor, 0});
  call("GT_SetVel", {2, 5 * factor});
  call("GT_Update", {0b11});
  call("GT_PrfPt", {3, 0});
  call("GT_PtData", {3, step, 100, 0, 0});
  call("GT_PtData", {3, 3 * step, 200, 0, 0});
  for (const int axis : {4, 10}) {
    call("GT_PrfGear", {1.0 * axis, 0});
    call("GT_SetGearMaster", {1.0 * axis, 2, 2, 0});
    call("GT_SetGearRatio", {1.0 * axis, 2, factor, 0});
  }
  call("GT_GearStart", {0b1000});
  for (const int axis : {5, 11}) {
    call("GT_PrfFollow", {1.0 * axis, 0});
    call("GT_SetFollowMaster", {1.0 * axis, 2, 2, 0});
    call("GT_FollowData", {1.0 * axis, 2000, step, 0, 0});
    call("GT_FollowData", {1.0 * axis, 2000, step, 0, 1});
  }
  SetUpCrd(step, 10 * factor, card);
  call("GT_PrfPvt", {8});
  call("GT_PvtTable", {1, 4}, {0, 100, 200, 300});
  call("GT_PvtTableSelect", {8, 1});
  call("GT_PrfJog", {9});
  if (stage == 1) return;
  call("GT_PtStart", {0b100, 0});
  call("GT_FollowStart", {0b1'0000, 0});
  call("GT_CrdStart", {1, 0});
  call("GT_AlarmOff", {6});
}

constexpr int kStages = 4;
constexpr int kCycles = 12;

// --- One call ------------------------------------------------------------------------------------

/// A value for a scalar parameter; likely values are chosen often.
double Draw(const gtcalls::Parameter& parameter, uint64_t* random) {
  const bool whole = parameter.type != gtcalls::Scalar::kDouble;
  const double low = std::max(parameter.minimum, -30000.0);
  const double high = std::min(parameter.maximum, 30000.0);
  double value = 0;
  switch (RandomBelow(*random, 5)) {
    case 0:
      value = static_cast<double>(RandomBelow(*random, 13));
      break;
    case 3:
      value = static_cast<double>(1u << RandomBelow(*random, 14));  // a mask with one bit
      break;
    case 1:
      value = static_cast<double>(1 + RandomBelow(*random, 3));
      break;
    case 2:
      value = low + (high - low) * static_cast<double>(RandomBelow(*random, 1001)) / 1000;
      break;
    default:
      value = RandomBelow(*random, 2) == 0 ? low : high;
      break;
  }
  value = std::clamp(value, low, high);
  return whole ? std::trunc(value) : value;
}

/// A program whose functions have one statement each, a command, and the cells of their pointers as
/// globals.
struct OneCall {
  vm::Object object;
  std::vector<int64_t> globals;  ///< the initial raw values
};

/// Adds a function that calls the command.
void AddCall(const Command& command, const std::string& function, uint64_t* random,
             OneCall* added_to) {
  const vm::CommandShape& shape = gtcalls::GtsCatalogue().ShapeOf(command);
  OneCall& call = *added_to;
  vm::Instruction instruction = {
      .opcode = vm::Opcode::kCommand, .op = command.number, .operands = {}};
  for (size_t i = 0; i < shape.parameters.size(); ++i) {
    const vm::ParameterShape& parameter = shape.parameters[i];
    const auto id = static_cast<uint16_t>(call.globals.size());
    if (!parameter.address) {
      const double value = Draw(command.parameters[i], random);
      instruction.operands.emplace_back(
          vm::Immediate{static_cast<int64_t>(value * (1 << vm::kFractionBits))});
      continue;
    }
    instruction.operands.emplace_back(vm::Variable{vm::Storage::kGlobal, id});
    const bool array = parameter.slots.size() == 1;
    for (size_t member = 0; member < parameter.slots.size(); ++member) {
      const auto name = function + std::to_string(i) + (array ? "" : ".m" + std::to_string(member));
      const uint16_t elements = array ? 32 : 0;
      call.object.globals.push_back(
          {name, static_cast<uint16_t>(call.globals.size()), parameter.slots[member], elements});
      for (int k = 0; k < std::max<int>(elements, 1); ++k) {
        const uint64_t value = RandomBelow(*random, 5);
        call.globals.push_back(parameter.slots[member] == vm::DataType::kDouble
                                   ? static_cast<int64_t>(value << (vm::kFractionBits - 1))
                                   : static_cast<int64_t>(value));
      }
    }
  }
  const vm::Instruction give = {.opcode = vm::Opcode::kReturn,
                                .operands = {vm::ImmediateInt(1), vm::ImmediateInt(0)}};
  call.object.functions.push_back({.name = function,
                                   .file = "f.c",
                                   .instructions = {instruction, give},
                                   .lines = {1, 2},
                                   .variables = {},
                                   .asserts = {}});
}

OneCall MakeCall(const Command& command, uint64_t* random) {
  OneCall call;
  AddCall(command, "f", random, &call);
  return call;
}

/// Gives the globals of a program their initial values.
void WriteGlobals(const OneCall& call, vm::Machine* machine) {
  for (const vm::Symbol& symbol : call.object.globals) {
    for (uint16_t k = 0; k < symbol.slots(); ++k) {
      const int64_t raw = call.globals[symbol.id + k];
      const double value = symbol.type == vm::DataType::kDouble ? vm::DoubleFromFixed(raw)
                                                                : static_cast<double>(raw);
      machine->Write({.global = true,
                      .page = 0,
                      .id = static_cast<uint16_t>(symbol.id + k),
                      .type = symbol.type},
                     value);
    }
  }
}

/// A card in a state with the call as its program, and two threads before it.
class CalledCard {
 public:
  CalledCard(const OneCall& call, int stage) {
    runtime::ControllerOptions options;
    options.motion.axis_count = motion::kAxisMax;
    card_ = std::make_unique<runtime::Controller>(options);
    loaded_ = card_->Load(call.object).ok();
    if (!loaded_) return;
    Prepare(stage, card_.get());
    for (int i = 0; i < kCycles; ++i) card_->RunCycle();
    vm::Machine& machine = card_->machine();
    for (const int thread : {kCaller, kOther}) {
      EXPECT_EQ(machine.Bind(thread, 1, thread), vm::kOk);
      EXPECT_EQ(machine.Run(thread), vm::kOk);
    }
    WriteGlobals(call, &machine);
  }

  /// False if the call cannot be loaded: its array has fewer elements than the count.
  bool loaded() const { return loaded_; }
  runtime::Controller& card() { return *card_; }
  CardState state() {
    return {ChangeState(card_->motion()), card_->card().state<gtcalls::GtsState>()};
  }
  StatementAccess Access() const { return NextAccess(*card_, kCaller); }
  int16_t Execute() {
    card_->machine().ExecuteOne(kCaller);
    return card_->machine().thread(kCaller).error;
  }
  const std::array<int64_t, vm::kSlotCount>& globals() const {
    return card_->machine().state().globals;
  }

 private:
  std::unique_ptr<runtime::Controller> card_;
  bool loaded_ = false;
};

std::vector<uint64_t> HashesOf(const std::vector<Part>& parts, const CardState& state) {
  std::vector<uint64_t> hashes;
  hashes.reserve(parts.size());
  for (const Part& part : parts) hashes.push_back(part.hash(state));
  return hashes;
}

class CommandAccessTest : public ::testing::TestWithParam<const Command*> {
 protected:
  /// Calls the command many times; `try_call` returns the code.
  void TryMany(const std::function<int16_t(const OneCall& call, int stage)>& try_call) const {
    uint64_t random = GetParam()->number;
    int accepted = 0;
    for (int i = 0; i < kCalls || (i < kCallsMax && accepted < kAccepted); ++i) {
      accepted += try_call(MakeCall(*GetParam(), &random), i % kStages) == 0 ? 1 : 0;
      if (HasFailure()) return;
    }
    EXPECT_GT(accepted, 0) << "every call was refused: nothing has been tested";
  }

  /// How often a command is called, and how often in addition until it has been accepted a few
  /// times.
  static constexpr int kCalls = 40;
  static constexpr int kCallsMax = 6000;
  static constexpr int kAccepted = 4;
  static constexpr int64_t kMuchLater = 1000;  // cycles
  const std::vector<Part> parts_ = PartsOfCard();
};

TEST_P(CommandAccessTest, WhatChangesIsInTheRow) {
  TryMany([&](const OneCall& call, int stage) {
    CalledCard called(call, stage);
    if (!called.loaded()) return vm::kBadParameter;
    const StatementAccess access = called.Access();
    const auto before = HashesOf(parts_, called.state());
    const uint64_t plc = HashOf(called.state().gts.plc);
    const auto other = vm::WordsOf(called.card().machine().thread(kOther));
    const auto globals = called.globals();
    const int16_t code = called.Execute();
    const auto after = HashesOf(parts_, called.state());
    for (size_t i = 0; i < parts_.size(); ++i) {
      EXPECT_TRUE(before[i] == after[i] || Names(access, parts_[i], true))
          << parts_[i].name << ' ' << parts_[i].number << " has changed, code " << code;
    }
    EXPECT_EQ(HashOf(called.state().gts.plc), plc);
    EXPECT_EQ(vm::WordsOf(called.card().machine().thread(kOther)), other);
    for (uint32_t slot = 0; slot < globals.size(); ++slot) {
      if (globals[slot] == called.globals()[slot]) continue;
      EXPECT_TRUE(Names(access, {"variable", Resource::kVariable, slot, {}}, true))
          << "slot " << slot;
    }
    return code;
  });
}

TEST_P(CommandAccessTest, WhatIsNotInTheRowMakesNoDifference) {
  TryMany([&](const OneCall& call, int stage) {
    CalledCard one(call, stage);
    if (!one.loaded()) return vm::kBadParameter;
    CalledCard other(call, stage);
    const StatementAccess access = one.Access();
    CalledCard strange(call, (stage + 1) % kStages);
    bool all_io = true;
    for (const Part& part : parts_) {
      const bool named = Names(access, part, false);
      if (part.take && !named) part.take(strange.state(), other.state());
      all_io = all_io && (part.take || !named || part.resource == Resource::kEverything);
    }
    if (all_io) other.state().motion.io = strange.state().motion.io;
    const int16_t code = one.Execute();
    EXPECT_EQ(other.Execute(), code);
    EXPECT_EQ(other.globals(), one.globals());
    for (const Part& part : parts_) {
      if (!Names(access, part, true)) continue;
      EXPECT_EQ(part.hash(other.state()), part.hash(one.state()))
          << part.name << ' ' << part.number << ", code " << code;
    }
    return code;
  });
}

bool ReadsClock(const Command& command) {
  return std::ranges::any_of(command.accesses, [](const gtcalls::Access& access) {
    return access.resource == Resource::kClock;
  });
}

TEST_P(CommandAccessTest, TimeMattersOnlyIfTheRowReadsTheClock) {
  if (ReadsClock(*GetParam())) return;
  TryMany([&](const OneCall& call, int stage) {
    CalledCard one(call, stage);
    if (!one.loaded()) return vm::kBadParameter;
    CalledCard later(call, stage);
    later.state().motion.cycle += kMuchLater;
    later.state().motion.clock_cycle += kMuchLater;
    const int16_t code = one.Execute();
    EXPECT_EQ(later.Execute(), code);
    EXPECT_EQ(later.globals(), one.globals());
    for (const Part& part : parts_) {
      if (part.resource == Resource::kEverything) continue;
      EXPECT_EQ(part.hash(later.state()), part.hash(one.state()))
          << part.name << ' ' << part.number << ", code " << code;
    }
    return code;
  });
}

TEST_P(CommandAccessTest, WhatIsNeverRefusedReturnsOneCode) {
  if (!GetParam()->never_refused) return;
  TryMany([&](const OneCall& call, int stage) {
    CalledCard one(call, stage);
    if (!one.loaded()) return vm::kBadParameter;
    const int16_t code = one.Execute();
    for (int other = 0; other < kStages; ++other) {
      EXPECT_EQ(CalledCard(call, other).Execute(), code) << "stage " << other;
    }
    return code;
  });
}

/// The commands that motion programs may call, except those that oncard's cards do not support.
std::vector<const Command*> ProgramCommands() {
  std::vector<const Command*> commands;
  for (const Command& command : gtcalls::GtsCatalogue().commands()) {
    if (command.in_motion_program && gtcalls::GtsFamily().Executes(command))
      commands.push_back(&command);
  }
  return commands;
}

// --- Two calls -----------------------------------------------------------------------------------

/// Cards of all stages at several cycles, into which programs are loaded.
class TwoCalls {
 public:
  TwoCalls() {
    runtime::ControllerOptions options;
    options.motion.axis_count = motion::kAxisMax;
    card_ = std::make_unique<runtime::Controller>(options);
    for (int stage = 0; stage < kStages; ++stage) {
      runtime::Controller staged(options);
      Prepare(stage, &staged);
      for (int i = 0; i < kBodiesPerStage; ++i) {
        for (int cycle = 0; cycle < kCycles; ++cycle) staged.RunCycle();
        bodies_.push_back(staged.Body());
      }
    }
  }

  /// A pair of commands on a card in one of the states. False if the program cannot be loaded.
  bool Load(const Command& one, const Command& other, uint64_t* random) {
    call_ = OneCall();
    AddCall(one, "f", random, &call_);
    AddCall(other, "g", random, &call_);
    body_ = &bodies_[RandomBelow(*random, bodies_.size())];
    if (!card_->Load(call_.object).ok()) return false;
    Reset();
    start_ = card_->machine().state();
    return true;
  }
  /// Through which resource the commands depend on each other.
  bool Depend(StatementAccess (*access)(const runtime::Controller& card, int thread)) const {
    return FindDependence(access(*card_, kCaller), access(*card_, kOther)) != nullptr;
  }
  /// What is left when they are executed in this order: hash of the card, codes, variables.
  std::vector<uint64_t> After(std::array<int, 2> order) {
    card_->machine().Restore(start_);
    card_->RestoreBody(*body_);
    for (const int thread : order) card_->machine().ExecuteOne(thread);
    std::vector<uint64_t> after = {card_->BodyHash()};
    for (const int thread : {kCaller, kOther}) {
      after.push_back(static_cast<uint64_t>(card_->machine().thread(thread).error));
    }
    for (const int64_t value : card_->machine().state().globals) {
      after.push_back(static_cast<uint64_t>(value));
    }
    return after;
  }

 private:
  static constexpr int kBodiesPerStage = 3;

  void Reset() {
    card_->RestoreBody(*body_);
    vm::Machine& machine = card_->machine();
    EXPECT_EQ(machine.Bind(kCaller, 1, kCaller), vm::kOk);
    EXPECT_EQ(machine.Bind(kOther, 2, kOther), vm::kOk);
    for (const int thread : {kCaller, kOther}) EXPECT_EQ(machine.Run(thread), vm::kOk);
    WriteGlobals(call_, &machine);
  }

  std::unique_ptr<runtime::Controller> card_;
  std::vector<runtime::CardBody> bodies_;
  const runtime::CardBody* body_ = nullptr;
  OneCall call_;
  vm::MachineState start_;
};

// Counted: those that only the parts of the rows tell apart, and dependent ones whose order
// matters, without which the comparison would show nothing.
TEST(CommandPairsTest, TheOrderOfIndependentCommandsMakesNoDifference) {
  const auto calls = std::make_unique<TwoCalls>();
  const std::vector<const Command*> commands = ProgramCommands();
  uint64_t random = 34;
  int independent = 0;
  int by_parts = 0;
  int ordered = 0;
  const int enough = RandomCases(20'000);
  for (size_t i = 0; independent < enough; ++i) {
    const Command& one = *commands[i % commands.size()];
    const Command& other = *commands[RandomBelow(random, commands.size())];
    if (!calls->Load(one, other, &random)) continue;
    if (calls->Depend(runtime::NextPreciseAccess)) {
      if (calls->After({kCaller, kOther}) != calls->After({kOther, kCaller})) ++ordered;
      continue;
    }
    ++independent;
    if (calls->Depend(runtime::NextAccess)) ++by_parts;
    ASSERT_EQ(calls->After({kCaller, kOther}), calls->After({kOther, kCaller}))
        << one.name << ", " << other.name;
  }
  EXPECT_GT(by_parts, LeastOfCases(100));
  EXPECT_GT(ordered, LeastOfCases(20));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, CommandAccessTest, ::testing::ValuesIn(ProgramCommands()),
                         [](const auto& test) { return std::string(test.param->name); });

}  // namespace
}  // namespace oncard::explore
