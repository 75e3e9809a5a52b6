#include "runtime/scenario/file/requirement.h"

#include <fmt/core.h>

#include <array>

#include "base/milliseconds.h"

namespace oncard::runtime {
namespace {

struct ScopeKey {
  Scope scope;
  std::string_view name;
  std::vector<std::string> Scenario::*texts;  ///< nullptr: tables
};

/// In the order in which a scenario's requirements are checked and reported.
constexpr std::array<ScopeKey, 6> kScopes = {{
    {Scope::kFinal, "final", &Scenario::final},
    {Scope::kAlways, "always", &Scenario::always},
    {Scope::kNever, "never", &Scenario::never},
    {Scope::kEventually, "eventually", &Scenario::eventually},
    {Scope::kLeads, "leads", &Scenario::leads},
    {Scope::kWithin, "within", nullptr},
}};

const ScopeKey& KeyOf(Scope scope) { return kScopes[static_cast<size_t>(scope)]; }

}  // namespace

std::string_view ScopeName(Scope scope) {
  return scope == Scope::kAssert ? "assert" : KeyOf(scope).name;
}

std::optional<Scope> ScopeNamed(std::string_view name) {
  for (const ScopeKey& key : kScopes) {
    if (key.name == name) return key.scope;
  }
  return std::nullopt;
}

std::string Requirement::Expression() const {
  if (!written.empty()) return written;
  return then.empty() ? text : fmt::format("{} {} {}", text, kArrow, then);
}

std::string Requirement::Title() const {
  if (scope != Scope::kWithin) return fmt::format("{}: {}", ScopeName(scope), Expression());
  return fmt::format("{} {} ms: {}", ScopeName(scope), FormatMs(within_us), Expression());
}

Result<void> CheckForm(const Requirement& requirement) {
  if (!requirement.IsResponse()) return {};
  for (const std::string& side : {requirement.text, requirement.then}) {
    if (side.find(kArrow) == std::string::npos) continue;
    return MakeError(1, "'{0}' has more than one '->': write a requirement for each of them",
                     "“{0}”含有多个“->”：应分别写成单独的要求", requirement.Expression());
  }
  if (!requirement.text.empty() && !requirement.then.empty()) return {};
  return MakeError(1,
                   "'{0}' must be two conditions with '->' between them, as in 'gpi[1] == 1 -> "
                   "axis1.moving == 0'",
                   "“{0}”应为两个条件，中间为“->”，如“gpi[1] == 1 -> axis1.moving == 0”",
                   requirement.Expression());
}

std::vector<Requirement> RequirementsOf(const Scenario& scenario) {
  std::vector<Requirement> requirements;
  for (const ScopeKey& key : kScopes) {
    if (key.texts == nullptr) continue;
    const std::vector<std::string>& texts = scenario.*key.texts;
    for (size_t i = 0; i < texts.size(); ++i) {
      const TextPlace place = PlaceOfText(scenario, key.name, i);
      requirements.push_back(
          key.scope == Scope::kLeads
              ? ReadResponse(key.scope, texts[i],
                             [&](std::string_view) -> const TextPlace& { return place; })
              : Requirement{key.scope, texts[i], place});
    }
  }
  for (const TimedResponse& within : scenario.within) {
    requirements.push_back({Scope::kWithin, within.after, within.after_place, within.then,
                            within.then_place, within.us, within.us_place});
  }
  return requirements;
}

std::vector<std::pair<TextPlace, Message>> ClashesWithEndless(
    const Scenario& scenario, const std::vector<Requirement>& requirements) {
  std::vector<std::pair<TextPlace, Message>> clashes;
  if (!scenario.endless) return clashes;
  for (const Requirement& requirement : requirements) {
    if (requirement.scope != Scope::kFinal && requirement.scope != Scope::kEventually) continue;
    clashes.emplace_back(
        requirement.place,
        MakeMessage(
            "'{0}' is about the end of runs, and an endless program has none: use 'always' "
            "or 'never', or remove 'endless'",
            "“{0}”针对运行的结束，而标为“endless”的程序不结束：请用“always”或“never”，或去掉"
            "“endless”",
            requirement.Title()));
  }
  for (const Expectation& expectation : scenario.expectations) {
    if (expectation.at_us) continue;
    clashes.emplace_back(
        expectation.place,
        MakeMessage("'{0}' is expected at the end of the run, and an endless program has none: add "
                    "an instant, as in '@ 100ms', or remove 'endless'",
                    "“{0}”是对运行结束时的期望，而标为“endless”的程序不结束：请加上时刻，如“@ "
                    "100ms”，或去掉“endless”",
                    expectation.text()));
  }
  return clashes;
}

void AddRequirements(const std::vector<Requirement>& requirements, Scenario* scenario) {
  for (const Requirement& requirement : requirements) {
    const ScopeKey& key = KeyOf(requirement.scope);
    if (key.texts == nullptr) {
      scenario->within.push_back({requirement.text, requirement.then, requirement.within_us,
                                  requirement.place, requirement.then_place,
                                  requirement.time_place});
      continue;
    }
    std::vector<std::string>& texts = scenario->*key.texts;
    std::vector<TextPlace>& places = scenario->text_places[std::string(key.name)];
    places.resize(texts.size());
    places.push_back(requirement.place);
    texts.push_back(requirement.Expression());
  }
}

void ClearRequirements(Scenario* scenario) {
  for (const ScopeKey& key : kScopes) {
    if (key.texts != nullptr) (scenario->*key.texts).clear();
  }
  scenario->within.clear();
}

}  // namespace oncard::runtime
