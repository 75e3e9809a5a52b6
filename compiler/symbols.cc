#include "compiler/symbols.h"

namespace oncard::compiler {

const Entity* Scope::Find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() || found->second.empty() ? nullptr
                                                          : &entities_[found->second.back()];
}

Entity* Scope::Find(std::string_view name) {
  const auto found = by_name_.find(name);
  return found == by_name_.end() || found->second.empty() ? nullptr
                                                          : &entities_[found->second.back()];
}

Entity& Scope::Add(Entity entity) {
  by_name_[entity.name].push_back(entities_.size());
  return entities_.emplace_back(std::move(entity));
}

std::string FreshNames::Make(std::string_view base) {
  std::string name(base);
  int& number = next_[name];
  while (number > 0 || !used_.insert(name).second) {
    name = std::string(base) + std::to_string(++number);
    if (used_.insert(name).second) break;
  }
  return name;
}

}  // namespace oncard::compiler
