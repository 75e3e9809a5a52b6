// The names of a program.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/nearest.h"
#include "compiler/syntax.h"
#include "gtcalls/catalogue.h"
#include "vm/object.h"

namespace oncard::compiler {

/// The meaning of a name of the program.
struct Entity {
  enum class Kind : uint8_t { kVariable, kMacro, kFunction };
  Kind kind = Kind::kVariable;
  std::string_view name;
  SourceRange range;  ///< of the name where it is defined
  /// The declaration was wrong: uses are accepted without a report.
  bool invalid = false;
  bool is_const = false;

  // kVariable
  std::string_view words;  ///< of its type, as written
  bool late = false;       ///< declared after the first statement; a fix-it moves it
  bool hides = false;      ///< another variable, until its block ends; it cannot move before that
  vm::DataType type = vm::DataType::kInt;
  vm::Storage storage = vm::Storage::kLocal;
  uint16_t id = 0;          ///< first slot
  uint16_t array_size = 0;  ///< 0: not an array
  const gtcalls::Structure* structure = nullptr;
  /// Dimensions of an array that was declared with several; it is treated as one-dimensional.
  std::vector<int64_t> dimensions;

  // kMacro
  Literal value;
};

/// Names in order of definition, found by hash.
class Scope {
 public:
  const Entity* Find(std::string_view name) const;
  Entity* Find(std::string_view name);
  /// Adds a name, which hides an entity that has it already. References to entities stay valid.
  Entity& Add(Entity entity);
  /// Ends the last entity with a name that is there; the one that it hides is found again.
  void End(std::string_view name) { by_name_.find(name)->second.pop_back(); }
  const std::deque<Entity>& entities() const { return entities_; }

 private:
  std::deque<Entity> entities_;
  std::unordered_map<std::string_view, std::vector<size_t>> by_name_;  // the last one is found
};

/// Generates names that the program does not use.
class FreshNames {
 public:
  /// All names that occur in the program.
  void Reserve(std::string_view name) { used_.emplace(name); }
  /// Returns `base`, or `base1`, `base2`, ...; a different name at each call.
  std::string Make(std::string_view base);

 private:
  std::unordered_set<std::string> used_;
  std::unordered_map<std::string, int> next_;
};

}  // namespace oncard::compiler
