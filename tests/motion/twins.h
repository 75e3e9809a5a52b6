// Two cards that do the same, one of them in lanes.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include "motion/motion_core.h"
#include "tests/motion/change_state.h"
#include "tests/motion/random_world.h"

namespace oncard::motion {

/// A number from the environment, so that the comparison can be run for longer than in the tests.
inline int Setting(const char* name, int normal) {
  const char* text = std::getenv(name);
  return text == nullptr ? normal : std::atoi(text);
}

/// Two cards that are given the same commands, one of them advanced by ticks.
class Twins {
 public:
  explicit Twins(uint64_t seed) : Twins(RandomCard(seed), RandomCard(seed)) {}
  Twins(std::unique_ptr<MotionCore> ticks, std::unique_ptr<MotionCore> lanes)
      : ticks_(std::move(ticks)), lanes_(std::move(lanes)) {
    ticks_->Observe([this](const CardEvent& event) { happened_[0] += Text(event, *ticks_); });
    lanes_->Observe([this](const CardEvent& event) { happened_[1] += Text(event, *lanes_); });
  }

  MotionCore& ticks() { return *ticks_; }
  MotionCore& lanes() { return *lanes_; }
  const std::string& happened() const { return happened_[1]; }
  template <typename Change>
  void Both(Change change) {
    change(*ticks_);
    change(*lanes_);
  }
  void Advance(int64_t cycles) {
    for (int64_t i = 0; i < cycles; ++i) ticks_->Tick();
    for (int64_t done = 0; done < cycles;) {
      done += lanes_->Advance(cycles - done);
      if (!lanes_->part<&MotionState::reached>().empty()) lanes_->ClearReached();
    }
  }
  void ExpectEqual() {
    EXPECT_EQ(ticks_->Hash(), lanes_->Hash());
    EXPECT_EQ(happened_[0], happened_[1]);
  }

 private:
  static std::string Text(const CardEvent& event, const MotionCore& core) {
    return std::to_string(core.state().cycle) + ":" + std::to_string(static_cast<int>(event.kind)) +
           "/" + std::to_string(event.item) + "=" + std::to_string(event.value) + " ";
  }

  std::unique_ptr<MotionCore> ticks_;
  std::unique_ptr<MotionCore> lanes_;
  std::array<std::string, 2> happened_;
};

/// Twelve axes under servo control that jog.
inline std::unique_ptr<MotionCore> ServoCard() {
  auto core = std::make_unique<MotionCore>(MotionConfig{.axis_count = 12});
  for (size_t i = 0; i < core->axis_count(); ++i) {
    core->ConnectDrive(i, VelocityDrive(100, 2, 0, core->config().ServoMs()));
    ChangeState(*core).controls[i].sets[0] = {.kp = 20, .kvff = 300};
    core->AxisAt(i).SetClosedLoop(true);
    core->AxisAt(i).ServoOn();
    Profile& profile = ChangeState(*core).profiles[i];
    profile.mode = ProfileMode::kJog;
    profile.jog.velocity = 10 + static_cast<double>(i);
    core->ProfileAt(i).Start();
  }
  return core;
}

}  // namespace oncard::motion
