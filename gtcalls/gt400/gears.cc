#include "gtcalls/gt400/gears.h"

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/gt400/drives.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::GearMode;
using motion::MasterType;

/// The plan of an axis, or its encoder where voltages move it that no plan commands.
MasterType LeadingPart(const Card& card, size_t axis) {
  return IsInOpenLoop(card, axis) ? MasterType::kEncoder : MasterType::kProfile;
}

}  // namespace

void ChooseMaster(Card& card, size_t axis, int number) {
  const int index = number - 1;
  const auto encoder =
      static_cast<uint8_t>(static_cast<int>(motion::kAuxiliaryFirst) + index - kAxisMax);
  card.motion.ProfileAt(axis).gear().master =
      index < kAxisMax
          ? motion::Master{true, MasterType::kProfile, static_cast<uint8_t>(index), false}
          : motion::Master{true, MasterType::kEncoder, encoder, false};
}

void Engage(Card& card, size_t axis) {
  const motion::ProfileHandle profile = card.motion.ProfileAt(axis);
  GearMode& gear = profile.gear();
  gear.direct.given = true;
  gear.direct.value = AxisState(card, axis).valid.ratio;
  const MasterType followed = gear.master.type;
  if (const auto master = MasterAxis(card.view(), axis)) {
    gear.master.type = LeadingPart(card, *master);
  }
  if (gear.running && gear.master.type == followed) {
    gear.ChangeRatio(card.motion.profile(axis).now);
  } else {
    profile.Start();
  }
}

bool IsEngaged(const CardView& card, size_t axis) {
  const motion::Profile& profile = card.motion.profile(axis);
  return profile.mode == motion::ProfileMode::kGear && profile.gear.running;
}

std::optional<size_t> MasterAxis(const CardView& card, size_t slave) {
  const size_t index = card.motion.profile(slave).gear.master.index;
  return index < kAxisMax ? std::optional(index) : std::nullopt;
}

void StopMaster(Card& card, size_t slave) {
  std::optional<size_t> master = MasterAxis(card.view(), slave);
  // Gears can form a ring, which nothing leads.
  for (int links = 0; links < kAxisMax && master; ++links) {
    if (!IsEngaged(card.view(), *master)) {
      if (!IsInOpenLoop(card, *master)) card.motion.ProfileAt(*master).Stop(true);
      return;
    }
    master = MasterAxis(card.view(), *master);
  }
}

}  // namespace oncard::gtcalls::gt400
