// The family: cards of two and of three axes, whose one motion is a jog.
#include "gtcalls/family.h"

#include <numeric>

#include "gtcalls/card.h"
#include "gtcalls/card_elements.h"
#include "motion/profiles/modes.h"
#include "tests/families/toy/catalogue.h"

namespace oncard::gtcalls {
namespace {

constexpr CardType kCardTypes[] = {{"TOY-2", 2, {}}, {"TOY-3", 3, {}}};

int16_t Move(Call& call) {
  const std::span<const double> motion = call.cells(1);
  if (!(motion[1] > 0)) {
    return call.Refuse(vm::kBadParameter, MakeMessage("acceleration is {}; it must be above 0",
                                                      "acceleration 为 {}；应大于 0", motion[1]));
  }
  const auto axis = static_cast<size_t>(call.integer(0) - 1);
  const motion::ProfileHandle profile = call.card.motion.ProfileAt(axis);
  profile.SelectMode(motion::ProfileMode::kJog);
  profile.SetParameters(motion::JogParameters{motion[1], motion[1], 0});
  profile.SetVelocity(motion[0]);
  call.card.motion.AxisAt(axis).ServoOn();
  profile.Start();
  return vm::kOk;
}

int16_t SetCycle(Call& call) {
  constexpr double kNsPerUs = 1000;
  call.card.set_cycle_ns(static_cast<int64_t>(call.value(0) * kNsPerUs + 0.5));
  return vm::kOk;
}

int16_t Tick(Call& call) {
  if (!call.ticked) return call.WaitForTick();
  call.Set(0, static_cast<double>(call.card.motion.cycle()));
  return vm::kOk;
}

/// Of axes that move with a constant velocity. Positions must be given, velocities may be.
int16_t Sample(Call& call) {
  HostArrays arrays(call.cells(0), call.command.parameters[0]);
  for (size_t axis = 0; axis < arrays.arrays() / 2; ++axis) {
    const size_t position = 2 * axis;
    const size_t velocity = position + 1;
    if (!arrays.given(position)) {
      return call.Refuse(vm::kBadParameter, {"an array of positions is NULL", "位置数组为 NULL"});
    }
    const motion::Profile& profile = call.card.motion.profile(axis);
    for (size_t i = 0; i < arrays.elements(); ++i) {
      const double back = static_cast<double>(i) * profile.now.velocity;
      arrays.Set(position, i, profile.now.position - back);
      arrays.Set(velocity, i, profile.now.velocity);
    }
    if (profile.now.velocity == 0) arrays.LeaveOut(velocity);
  }
  return vm::kOk;
}

int16_t Sum(Call& call) {
  const std::span<const double> bytes = call.cells(0);
  call.Set(2, std::accumulate(bytes.begin(), bytes.end(), 0.0));
  return vm::kOk;
}

/// In the order of the commands' numbers.
constexpr CommandFunction kFunctions[] = {nullptr, nullptr, Move, nullptr, nullptr, SetCycle,
                                          Tick,    Sample,  Sum,  nullptr, nullptr};

/// The card interrupts its host so often while axis 2 moves.
constexpr int64_t kInterruptCycles = 10;

bool Interrupts(const CardView& card) {
  return (card.motion.Conditions(1) & motion::kMovingBit) != 0;
}

void InterruptHost(Card& card) {
  const int64_t cycle = card.motion.cycle();
  if (!Interrupts(card.view()) || cycle % kInterruptCycles != 0) return;
  card.interrupt_host(MakeMessage("interrupt in cycle {}", "第 {} 周期的中断", cycle));
}

int64_t CyclesBeforeInterrupt(const CardView& card) {
  if (!Interrupts(card)) return kNeverActs;
  return kInterruptCycles - card.motion.cycle() % kInterruptCycles;
}

}  // namespace

const Family& ToyFamily() {
  static const Family kFamily = {
      .name = "toy",
      .catalogue = ToyCatalogue(),
      .functions = kFunctions,
      .not_supported = 8,
      .not_open = -1,
      .open_failed = -5,
      .open_command = "TOY_Open",
      .close_command = "TOY_Close",
      .reset_commands = {},
      .advised = {},
      .finish = nullptr,
      .card_types = kCardTypes,
      .default_card = kCardTypes[0],
      .cycle_ns = 1'000'000,
      .array_elements = [](const CardView&) -> size_t { return 3; },
      .status_word = [](const CardView& card, size_t axis) { return card.motion.Conditions(axis); },
      .mode_number = [](motion::ProfileMode mode) { return static_cast<int>(mode); },
      // A family that keeps something has an alternative of its own in family_state.h.
      .new_state = [] { return FamilyState(); },
      .reset = [](FamilyState&) {},
      .after_tick = InterruptHost,
      .cycles_before_act = [](const CardView& card) { return CyclesBeforeInterrupt(card) - 1; },
      .cycles_before_interrupt = CyclesBeforeInterrupt,
  };
  return kFamily;
}

}  // namespace oncard::gtcalls
