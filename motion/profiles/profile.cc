#include "motion/profiles/profile.h"

namespace oncard::motion {

void Profile::Start(Micros instant) {
  stopping = false;
  driven = false;
  if (mode == ProfileMode::kTrap) {
    trap.Start(instant, now);
    now.moving = trap.running;
  } else if (mode == ProfileMode::kJog) {
    jog.Start(instant, now);
    now.moving = jog.running;
  } else if (mode == ProfileMode::kPt) {
    pt.Start(instant, now.position);
    now.moving = true;
  } else if (mode == ProfileMode::kPvt) {
    pvt.Start(instant, now.position);
    now.moving = true;
  }
}

void Profile::StartGear(const MasterValue& master) {
  stopping = false;
  driven = false;
  gear.Start(now, master);
  now.moving = true;
}

void Profile::StartFollow(uint8_t fifo, const MasterValue& master) {
  stopping = false;
  driven = false;
  follow.Start(fifo, now, master);
  now.moving = true;
}

void Profile::Stop(Micros instant, double deceleration) {
  if (!now.moving) return;
  if (stopping && deceleration <= stop_deceleration) return;
  HaltMode();
  stopping = true;
  stop_deceleration = deceleration;
  stop_begin = instant;
  stop_plan = PlanStop(now.position, now.velocity, deceleration);
  if (stop_plan.count > 0) return;
  now = AtRest(now.position);
  stopping = false;
}

void Profile::Advance(Micros instant) {
  if (!now.moving || driven) return;
  if (stopping) {
    now = stop_plan.At(MsBetween(stop_begin, instant));
    stopping = now.moving;
    return;
  }
  now = SampleMode(instant);
}

void Profile::AdvanceSlave(const MasterValue& master) {
  now = mode == ProfileMode::kGear ? gear.At(now, master) : follow.At(now, master);
}

void Profile::HaltMode() {
  gear.Halt();
  follow.Halt();
  trap.Halt();
  jog.Halt();
  pt.Halt();
  pvt.Halt();
}

Sample Profile::SampleMode(Micros instant) {
  switch (mode) {
    case ProfileMode::kTrap:
      return trap.At(instant);
    case ProfileMode::kJog:
      return jog.At(instant);
    case ProfileMode::kPt:
      return pt.At(instant);
    case ProfileMode::kGear:
    case ProfileMode::kFollow:
    case ProfileMode::kCrd:
      break;
    case ProfileMode::kPvt:
      return pvt.At(instant);
  }
  return now;
}

}  // namespace oncard::motion
