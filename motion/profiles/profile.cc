#include "motion/profiles/profile.h"

namespace oncard::motion {

void Profile::Start(Micros instant) {
  stopping = false;
  driven = false;
  VisitSelected(*this, [&]<typename Mode>(Mode& selected) {
    if constexpr (IndependentMode<Mode>) {
      selected.Start(instant, now);
      now.moving = selected.running;
    }
  });
}

void Profile::StartSlave(const MasterValue& master) {
  stopping = false;
  driven = false;
  VisitSelected(*this, [&]<typename Mode>(Mode& selected) {
    if constexpr (SlaveMode<Mode>) {
      selected.Start(now, master);
      now.moving = selected.running;
    }
  });
}

void Profile::ShiftMaster(double shift) {
  VisitSelected(*this, [&]<typename Mode>(Mode& selected) {
    if constexpr (SlaveMode<Mode>) selected.travel.last += shift;
  });
}

void Profile::Stop(Micros instant, double deceleration) {
  if (!now.moving) return;
  if (stopping && deceleration <= stop_deceleration) return;
#define PROFILE_MODE(enumerator, number, name, member, Class) member.Halt();
#include "motion/profiles/modes.def"
  stopping = true;
  stop_deceleration = deceleration;
  stop_begin = instant;
  stop_plan = PlanStop(now.position, now.velocity, deceleration);
  if (stop_plan.count > 0) return;
  now = AtRest(now.position);
  stopping = false;
}

void Profile::ForgetRuns() {
  trap.ForgetRun();
  if (stopping) return;
  stop_deceleration = 0;
  stop_begin = 0;
  stop_plan = {};
}

bool Profile::HoldAtLimit() {
  if (mode != ProfileMode::kGear || !gear.running || !gear.direct.given) return false;
  now = {now.position, 0, 0, true};
  gear.Hold(now);
  return true;
}

void Profile::StopSmoothly(Micros instant) {
  bool planned = false;
  VisitSelected(*this, [&]<typename Mode>(Mode& selected) {
    if constexpr (SmoothlyStoppingMode<Mode>) {
      planned = selected.running;
      if (!planned) return;
      selected.StopSmoothly(instant, now);
      now.moving = selected.running;
    }
  });
  if (!planned) Stop(instant, smooth_stop);
}

void Profile::Advance(Micros instant) {
  if (!now.moving || driven) return;
  if (stopping) {
    now = stop_plan.At(MsBetween(stop_begin, instant));
    stopping = now.moving;
    return;
  }
  VisitSelected(*this, [&]<typename Mode>(Mode& selected) {
    if constexpr (IndependentMode<Mode>) now = selected.At(instant);
  });
}

std::pair<const Plan*, Micros> Profile::FollowedPlan() const {
  if (stopping) return {&stop_plan, stop_begin};
  std::pair<const Plan*, Micros> followed = {nullptr, 0};
  VisitSelected(*this, [&]<typename Mode>(const Mode& selected) {
    if constexpr (PlannedMode<Mode>) followed = {selected.FollowedPlan(), selected.begin};
  });
  return followed;
}

void Profile::AdvanceSlave(const MasterValue& master) {
  VisitSelected(*this, [&]<typename Mode>(Mode& selected) {
    if constexpr (SlaveMode<Mode>) now = selected.At(now, master);
  });
}

}  // namespace oncard::motion
