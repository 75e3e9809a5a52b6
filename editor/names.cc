#include "editor/names.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "editor/name_scanner.h"

namespace oncard::editor {
namespace {

std::tuple<int, uint32_t, int> OrderOf(const Reference& reference) {
  return {reference.range.file, reference.range.begin, reference.symbol};
}

}  // namespace

Names::Names(const ProgramText& text) {
  NameScanner(text, *this).Run();
  std::ranges::stable_sort(references_, {}, OrderOf);
}

const Reference* Names::At(int file, uint32_t offset) const {
  const auto after = std::ranges::upper_bound(
      references_, std::pair(file, offset), {},
      [](const Reference& each) { return std::pair(each.range.file, each.range.begin); });
  const Reference* found = nullptr;
  for (auto each = after; each != references_.begin();) {
    --each;
    const bool touches = each->range.file == file && each->range.end >= offset;
    if (!touches || (found != nullptr && found->range.begin != each->range.begin)) break;
    found = &*each;
  }
  return found;
}

std::span<const Reference> Names::Meanings(const Reference& reference) const {
  const Reference* const end = references_.data() + references_.size();
  const Reference* last = &reference;
  while (last != end && last->range == reference.range) ++last;
  return {&reference, last};
}

int Names::ScopeAt(size_t order) const {
  const auto after = std::ranges::upper_bound(scopes_, order, {}, &Scope::begin);
  int scope = static_cast<int>(after - scopes_.begin()) - 1;
  while (scope > 0 && scopes_[static_cast<size_t>(scope)].end <= order) {
    scope = scopes_[static_cast<size_t>(scope)].parent;
  }
  return std::max(scope, 0);
}

int Names::FunctionScope(int scope) const {
  while (scope > 0 && !scopes_[static_cast<size_t>(scope)].of_function) {
    scope = scopes_[static_cast<size_t>(scope)].parent;
  }
  return std::max(scope, 0);
}

int Names::FindMacro(std::string_view name, size_t order) const {
  const auto events = macro_events_.find(name);
  if (events == macro_events_.end()) return -1;
  const auto after = std::ranges::upper_bound(events->second, order, {}, &MacroEvent::order);
  const bool defined = after != events->second.begin() && (after - 1)->defined;
  return defined ? macros_.at(name) : -1;
}

int Names::Find(std::string_view name, int scope, size_t order) const {
  if (const int macro = FindMacro(name, order); macro >= 0) return macro;
  for (; scope >= 0; scope = scopes_[static_cast<size_t>(scope)].parent) {
    const auto found = by_name_.find({scope, name});
    if (found == by_name_.end()) continue;
    if (scope == 0 || symbol(found->second).declarations.front().order <= order) {
      return found->second;
    }
  }
  return -1;
}

int Names::FindStructure(std::string_view name, int scope, size_t order) const {
  for (; scope >= 0; scope = scopes_[static_cast<size_t>(scope)].parent) {
    const auto found = structures_.find({scope, name});
    if (found == structures_.end()) continue;
    if (symbol(found->second).declarations.front().order <= order) return found->second;
  }
  return -1;
}

int Names::FindMember(std::string_view name, int members) const {
  const auto found = by_name_.find({members, name});
  return members <= 0 || found == by_name_.end() ? -1 : found->second;
}

int Names::FindLabel(std::string_view name, int scope) const {
  const auto found = labels_.find({FunctionScope(scope), name});
  return found == labels_.end() ? -1 : found->second;
}

std::vector<int> Names::VisibleAt(size_t order) const {
  std::vector<int> visible;
  std::set<std::string_view> taken;
  const auto add = [&](int index) {
    if (taken.insert(symbol(index).name).second) visible.push_back(index);
  };
  for (const auto& [name, events] : macro_events_) {
    if (const int macro = FindMacro(name, order); macro >= 0) add(macro);
  }
  for (int scope = ScopeAt(order); scope >= 0; scope = scopes_[static_cast<size_t>(scope)].parent) {
    for (auto each = by_name_.lower_bound({scope, {}});
         each != by_name_.end() && each->first.first == scope; ++each) {
      if (symbol(each->second).declarations.front().order < order) add(each->second);
    }
  }
  return visible;
}

}  // namespace oncard::editor
