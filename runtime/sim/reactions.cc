#include "runtime/sim/reactions.h"

#include <algorithm>

#include "runtime/sim/card_clock.h"

namespace oncard::runtime {

void Reactions::Act(int64_t now_ns, motion::MotionCore* core) {
  const Look look = conditions_();
  const uint64_t rising = look.hold & ~state_.held;
  state_.held = look.hold;
  started_ |= rising;
  existed_ |= look.exist;
  for (size_t i = 0; i < reactions_.size(); ++i) {
    if ((rising >> i & 1) != 0) Start(i, now_ns);
  }
  std::vector<Pending>& pending = state_.pending;
  auto next = pending.begin();
  for (; next != pending.end() && next->at_ns <= now_ns; ++next) {
    for (const motion::WorldEvent& event : reactions_[next->reaction].events) core->Happen(event);
  }
  pending.erase(pending.begin(), next);
}

void Reactions::Start(size_t reaction, int64_t now_ns) {
  const int64_t at_ns = now_ns + reactions_[reaction].after_us * CardClock::kNsPerUs;
  const auto behind = std::ranges::upper_bound(state_.pending, at_ns, {}, &Pending::at_ns);
  state_.pending.insert(behind, {at_ns, static_cast<uint32_t>(reaction)});
}

}  // namespace oncard::runtime
