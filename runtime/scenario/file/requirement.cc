#include "runtime/scenario/file/requirement.h"

#include <fmt/core.h>

#include <array>

namespace oncard::runtime {
namespace {

struct ScopeKey {
  Scope scope;
  std::string_view name;
  std::vector<std::string> Scenario::*texts;
};

/// In the order in which a scenario's requirements are checked and reported.
constexpr std::array<ScopeKey, 4> kScopes = {{
    {Scope::kFinal, "final", &Scenario::final},
    {Scope::kAlways, "always", &Scenario::always},
    {Scope::kNever, "never", &Scenario::never},
    {Scope::kEventually, "eventually", &Scenario::eventually},
}};

const ScopeKey& KeyOf(Scope scope) { return kScopes[static_cast<size_t>(scope)]; }

}  // namespace

std::string_view ScopeName(Scope scope) { return KeyOf(scope).name; }

std::optional<Scope> ScopeNamed(std::string_view name) {
  for (const ScopeKey& key : kScopes) {
    if (key.name == name) return key.scope;
  }
  return std::nullopt;
}

std::string Requirement::Title() const { return fmt::format("{}: {}", ScopeName(scope), text); }

std::vector<Requirement> RequirementsOf(const Scenario& scenario) {
  std::vector<Requirement> requirements;
  for (const ScopeKey& key : kScopes) {
    const std::vector<std::string>& texts = scenario.*key.texts;
    for (size_t i = 0; i < texts.size(); ++i) {
      requirements.push_back({key.scope, texts[i], PlaceOfText(scenario, key.name, i)});
    }
  }
  return requirements;
}

void AddRequirements(const std::vector<Requirement>& requirements, Scenario* scenario) {
  for (const Requirement& requirement : requirements) {
    const ScopeKey& key = KeyOf(requirement.scope);
    std::vector<std::string>& texts = scenario->*key.texts;
    std::vector<TextPlace>& places = scenario->text_places[std::string(key.name)];
    places.resize(texts.size());
    places.push_back(requirement.place);
    texts.push_back(requirement.text);
  }
}

}  // namespace oncard::runtime
