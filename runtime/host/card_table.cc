#include "runtime/host/card_table.h"

#include "runtime/host/host_refusals.h"

namespace oncard::runtime {

CardTable& CardTable::OfProcess() {
  // Never destroyed: other threads of the host may still make calls while the process exits.
  static CardTable& table = *new CardTable;
  return table;
}

void CardSlot::CatchUp(int64_t cost_us) { Advance(clock->TakeUs(cost_us)); }

void CardSlot::PassTick() {
  const int64_t before = controller->cycle();
  while (controller->cycle() == before && !(watch && watch->over())) {
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
    if (!watch->over()) CatchUp(0);
    watch->Finish(controller.get());
  }
  const auto number = static_cast<int>(this - CardTable::OfProcess().slots.data());
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
}

}  // namespace oncard::runtime
