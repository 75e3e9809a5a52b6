#include "runtime/host/card_table.h"

#include <algorithm>
#include <utility>

#include "runtime/host/host_interrupts.h"
#include "runtime/host/host_refusals.h"

namespace oncard::runtime {

CardTable& CardTable::OfProcess() {
  // Never destroyed: other threads of the host may still make calls while the process exits.
  static CardTable& table = *new CardTable;
  return table;
}

void CardSlot::CatchUp(int64_t cost_us) {
  const int64_t passed_us = clock->TakeUs(cost_us);
  Advance(std::exchange(late_us_, 0) + passed_us);
}

void CardSlot::NoteTime() { late_us_ += clock->TakeUs(0); }

// Between two cycles that may interrupt the host all are passed at once.
bool CardSlot::AdvanceToInterrupt() {
  while (!controller->TakeInterrupt()) {
    if (late_us_ == 0 || over()) return false;
    const int64_t cycles = controller->CyclesBeforeInterrupt();
    const int64_t step_us =
        cycles == gtcalls::kNeverActs ? late_us_ : std::min(late_us_, controller->UsToTick(cycles));
    late_us_ -= step_us;
    Advance(step_us);
  }
  return true;
}

int64_t CardSlot::EarliestInterruptNs() const {
  const int64_t cycles = controller->CyclesBeforeInterrupt();
  if (cycles == gtcalls::kNeverActs || over()) return VirtualTime::kNeverNs;
  return clock->EarliestNs(controller->UsToTick(cycles) - late_us_);
}

void CardSlot::PassTick() {
  const int64_t before = controller->cycle();
  while (controller->cycle() == before && !over()) {
    Advance(clock->WaitUs(controller->UsToNextTick()));
  }
}

void CardSlot::Advance(int64_t passed_us) {
  if (watch) {
    watch->AdvanceUs(controller.get(), passed_us);
  } else {
    controller->AdvanceUs(passed_us);
  }
  clock->CaughtUp();
}

void CardSlot::FindEarliestEnd() {
  const auto end_us = watch ? watch->EndUs(controller->clock()) : std::nullopt;
  earliest_end_ns = end_us ? clock->EarliestNs(*end_us - controller->NowUs()) : INT64_MAX;
}

void CardSlot::SwitchOff() {
  if (controller == nullptr) return;
  earliest_end_ns = INT64_MAX;
  if (watch) {
    if (!over()) CatchUp(0);
    watch->Finish(controller.get());
  }
  const auto number = static_cast<int>(this - CardTable::OfProcess().slots.data());
  HostInterrupts::OfProcess().Answer(number, {});
  if (recorder != nullptr) recorder->Close(number, {controller->NowUs(), controller->Hash()});
  recorder = nullptr;
  if (memory && !HostIsJudgedByParent()) {
    const auto kept = memory->Keep(*controller);
    if (!kept.ok()) FailHost(OfCard(number, kept.error().message));
  }
  memory.reset();
  HostRefusals::OfProcess().AddProgram(number, refused.list());
  refused = {};
  if (supervisor) {
    supervisor->JudgeEnd();
    HostRefusals::OfProcess().AddFindings(number, supervisor->findings());
  }
  supervisor.reset();
  watch.reset();
  controller.reset();
  clock.reset();
  late_us_ = 0;
}

}  // namespace oncard::runtime
