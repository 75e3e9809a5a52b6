// The modes of a profile (modes.def), and the requirements on the class of a mode.
//
// Such a class contains the registers that commands write, the run that Start() begins, and
// `running`, which is true during a run. It is plain data that lists its members (Fields()). There
// are two kinds, distinguished by their members:
//
//   independent:       Start(now, from)      At(now)
//   follows a master:  Start(from, master)   At(from, master), and the members `master`, `travel`
//
// `from` is the profile's last output; At() returns the next one and ends the run when it is over.
// Halt() ends it because something else controls the profile; the registers are kept. Tested by
// tests/motion/profile_modes_test.cc.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

#include "motion/common/sample.h"
#include "motion/common/sizes.h"
#include "motion/common/state_hash.h"
#include "motion/profiles/follow_mode.h"
#include "motion/profiles/gear_mode.h"
#include "motion/profiles/jog_mode.h"
#include "motion/profiles/master.h"
#include "motion/profiles/pt_mode.h"
#include "motion/profiles/pvt_mode.h"
#include "motion/profiles/s_curve_mode.h"
#include "motion/profiles/trap_mode.h"
#include "motion/profiles/wheel_mode.h"

namespace oncard::motion {

enum class ProfileMode : uint8_t {
#define PROFILE_MODE(enumerator, number, ...) enumerator = number,
#define WRITTEN_MODE(enumerator, number, ...) enumerator = number,
#include "motion/profiles/modes.def"
};

/// The name of a mode in messages: `Trap`, `PT` ...
constexpr std::string_view NameOf(ProfileMode mode) {
  switch (mode) {
#define PROFILE_MODE(enumerator, number, name, ...) \
  case ProfileMode::enumerator:                     \
    return name;
#define WRITTEN_MODE(enumerator, number, name) \
  case ProfileMode::enumerator:                \
    return name;
#include "motion/profiles/modes.def"
  }
  return {};
}

template <typename Mode>
concept HasRun = ListsFields<Mode> && requires(Mode mode) {
  { mode.running } -> std::same_as<bool&>;
  mode.Halt();
};

/// A mode whose output is a function of time.
template <typename Mode>
concept IndependentMode = HasRun<Mode> && requires(Mode mode, Micros now, const Sample& from) {
  mode.Start(now, from);
  { mode.At(now) } -> std::same_as<Sample>;
};

/// An independent mode that can say that its output is nothing but that of a plan: `plan`, from
/// `begin` on.
template <typename Mode>
concept PlannedMode = IndependentMode<Mode> && requires(const Mode mode) {
  { mode.FollowedPlan() } -> std::same_as<const Plan*>;
  { mode.begin } -> std::convertible_to<Micros>;
};

/// An independent mode that plans its smooth stops itself, as part of its run.
template <typename Mode>
concept SmoothlyStoppingMode = IndependentMode<Mode> &&
    requires(Mode mode, Micros now, const Sample& from) {
  mode.StopSmoothly(now, from);
};

/// A mode whose output is a function of its master's.
template <typename Mode>
concept SlaveMode = HasRun<Mode> &&
    requires(Mode mode, const Sample& from, const MasterValue& master) {
  { mode.master } -> std::same_as<Master&>;
  { mode.travel } -> std::same_as<MasterTravel&>;
  mode.Start(from, master);
  { mode.At(from, master) } -> std::same_as<Sample>;
};

#define PROFILE_MODE(enumerator, number, name, member, Class) \
  static_assert(IndependentMode<Class> != SlaveMode<Class>,   \
                #Class " must be either independent or follow a master");
#include "motion/profiles/modes.def"

}  // namespace oncard::motion
