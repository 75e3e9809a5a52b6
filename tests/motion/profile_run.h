// Runs one profile without a card: commands at given times, one sample per cycle.
#pragma once

#include <cstdint>

#include "motion/profiles/profile.h"

namespace oncard::motion {

class ProfileRun {
 public:
  explicit ProfileRun(Micros cycle_us = 250) : cycle_us_(cycle_us) {}

  /// Mode Trap with the parameters of example 7-1 of the GTS manual, except for the smoothing.
  void SetTrap(const TrapParameters& parameters = {.acc = 0.25, .dec = 0.125}) {
    profile.mode = ProfileMode::kTrap;
    profile.trap.parameters = parameters;
  }
  void SetJog(const JogParameters& parameters) {
    profile.mode = ProfileMode::kJog;
    profile.jog.parameters = parameters;
  }
  /// Sets the registers of Trap and calls GT_Update.
  void MoveTo(int32_t target, double velocity) {
    profile.trap.target = target;
    profile.trap.velocity = velocity;
    profile.Start(now);
  }
  /// Sets the register of Jog and calls GT_Update.
  void JogAt(double velocity) {
    profile.jog.velocity = velocity;
    profile.Start(now);
  }
  void Stop(double deceleration) { profile.Stop(now, deceleration); }

  const Sample& Tick() {
    now += cycle_us_;
    profile.Advance(now);
    return profile.now;
  }
  /// The sample at a time that is a whole number of cycles and not in the past.
  const Sample& At(double ms) {
    const auto instant = static_cast<Micros>(ms * 1000);
    while (now < instant) Tick();
    return profile.now;
  }
  double now_ms() const { return MsBetween(0, now); }
  double cycle_ms() const { return static_cast<double>(cycle_us_) / 1000; }

  Profile profile;
  Micros now = 0;

 private:
  Micros cycle_us_;
};

}  // namespace oncard::motion
