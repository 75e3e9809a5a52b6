#include "explore/engines/walk.h"

namespace oncard::explore {
namespace {

/// In keys: greater than all cell numbers of a model.
constexpr uint32_t kPlaceOfReached = 0xfffffff8;
constexpr uint32_t kPlaceOfOwed = 0xfffffff9;
constexpr uint32_t kPlaceOfRaces = 0xfffffffa;

}  // namespace

ProgramWalk::ProgramWalk(const Problem& problem, StatementCoverage* coverage)
    : problem_(problem), model_(problem.model) {
  if (coverage != nullptr) model_.NoteIn(coverage);
  marks_.push_back(Judge({}, {}));
  if (problem.races != RaceRule::kAny) detectors_.emplace_back(model_, problem.sync);
}

ProgramWalk::Mark ProgramWalk::Judge(const Mark& before, const Race& race) const {
  Mark mark = before;
  if (mark.fault) return mark;
  mark.fault = FindFault(problem_, model_);
  if (!mark.fault && race) {
    mark.fault.kind = Fault::Kind::kRace;
    mark.fault.race = race;
  }
  uint32_t bit = 1;
  uint32_t leads_bit = 1;
  for (size_t i = 0; i < problem_.requirements.size(); ++i) {
    const BoundRequirement& requirement = problem_.requirements[i];
    bool met = true;
    if (requirement.scope == Scope::kEventually) {
      if (requirement.property.Holds(model_)) mark.reached |= bit;
      met = (mark.reached & bit) != 0;
      bit <<= 1;
    } else if (requirement.scope == Scope::kLeads) {
      if (requirement.property.Holds(model_)) mark.owed |= leads_bit;
      if (requirement.then->Holds(model_)) mark.owed &= ~leads_bit;
      met = (mark.owed & leads_bit) == 0;
      leads_bit <<= 1;
    }
    if (!met && !mark.fault && ended()) {
      mark.fault = {Fault::Kind::kRequirement, static_cast<int>(i), 0};
    }
  }
  return mark;
}

void ProgramWalk::Step(int thread) {
  Race race;
  if (!detectors_.empty()) {
    detectors_.push_back(detectors_.back());
    race = detectors_.back().BeforeStep(model_, thread);
  }
  model_.Step(thread);
  marks_.push_back(Judge(marks_.back(), race));
}

void ProgramWalk::Undo() {
  model_.Undo();
  marks_.pop_back();
  if (!detectors_.empty()) detectors_.pop_back();
}

void ProgramWalk::Restart() {
  while (marks_.size() > 1) Undo();
}

StateKey ProgramWalk::Key() const {
  StateKey key = model_.key();
  AddToKey(kPlaceOfReached, static_cast<int64_t>(marks_.back().reached), &key);
  if (const uint32_t owed = marks_.back().owed; owed != 0) {
    AddToKey(kPlaceOfOwed, static_cast<int64_t>(owed), &key);
  }
  if (!detectors_.empty()) {
    const StateKey races = detectors_.back().Key();
    AddToKey(kPlaceOfRaces, static_cast<int64_t>(races.low), &key);
    AddToKey(kPlaceOfRaces + 1, static_cast<int64_t>(races.high), &key);
  }
  return key;
}

}  // namespace oncard::explore
