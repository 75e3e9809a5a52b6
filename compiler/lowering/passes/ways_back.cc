// The comparisons that lead from a shared body back to its calls (shared_bodies.cc). Only a call
// that a path reaches can be the one to go back to; the last of them needs no comparison. A call in
// a loop that is never entered must not keep itself alive through the body, so a way back is
// followed only when its call has been reached.
#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

// The shared bodies of a function, by the variables that say which call it is.
class Bodies {
 public:
  explicit Bodies(const LoweredFunction& function) {
    for (const SharedCalls& calls : function.calls) bodies_.emplace(calls.number, bodies_.size());
  }

  // The body with whose number an instruction compares.
  std::optional<size_t> Compared(const Instruction& instruction) const {
    if (instruction.kind != Instruction::Kind::kBinary ||
        instruction.binary != vm::BinaryOperator::kEqual || !instruction.b.IsConstant()) {
      return std::nullopt;
    }
    return Find(instruction.a);
  }

  // The body whose number an instruction sets. A recursive call that ends gives the number back
  // what another statement has assigned.
  std::optional<size_t> Assigned(const Instruction& instruction) const {
    return instruction.a.IsConstant() ? Find(instruction.target) : std::nullopt;
  }

 private:
  std::optional<size_t> Find(const Operand& number) const {
    if (!number.IsVariable()) return std::nullopt;
    const auto found = bodies_.find(number.variable);
    return found != bodies_.end() ? std::optional(found->second) : std::nullopt;
  }

  std::unordered_map<int, size_t> bodies_;
};

// The calls of each shared body that a path reaches, by their numbers.
class ReachedCalls {
 public:
  ReachedCalls(const Bodies& by_number, const LoweredFunction& function)
      : by_number_(by_number),
        code_(function.code),
        positions_(LabelPositions(function)),
        reached_(code_.size()),
        bodies_(function.calls.size()) {
    FindTests();
    open_.push_back(0);
    while (!open_.empty()) {
      const size_t next = open_.back();
      open_.pop_back();
      Follow(next);
    }
  }

  const std::set<int64_t>& Of(size_t body) const { return bodies_[body].reached; }

 private:
  // `t = number == value; if (t) goto ...;`, the jump.
  struct Test {
    int64_t value;
    size_t jump;
    bool seen = false;
  };
  struct Body {
    std::vector<Test> tests;  // in their order
    std::set<int64_t> reached;
    size_t last = 0;  // tests before this one can be passed
  };

  void FindTests() {
    for (size_t i = 0; i + 1 < code_.size(); ++i) {
      const auto body = by_number_.Compared(code_[i]);
      const Instruction& jump = code_[i + 1];
      if (!body || jump.kind != Instruction::Kind::kIf || jump.a != code_[i].target) continue;
      test_at_.emplace(i + 1, std::pair(*body, bodies_[*body].tests.size()));
      bodies_[*body].tests.push_back({code_[i].b.value, i + 1});
    }
  }

  void Follow(size_t i) {
    for (; i < code_.size() && !reached_[i]; ++i) {
      reached_[i] = true;
      const Instruction& instruction = code_[i];
      if (const auto body = by_number_.Assigned(instruction)) {
        Reach(bodies_[*body], instruction.a.value);
      }
      const auto test = test_at_.find(i);
      if (test != test_at_.end()) {
        Body& body = bodies_[test->second.first];
        body.tests[test->second.second].seen = true;
        Leave(body, test->second.second);
        return;
      }
      if (instruction.Jumps()) Jump(i);
      if (!instruction.GoesOn()) return;
    }
  }

  void Jump(size_t i) {
    open_.push_back(static_cast<size_t>(positions_[static_cast<size_t>(code_[i].label)]));
  }

  void Reach(Body& body, int64_t value) {
    if (!body.reached.insert(value).second) return;
    const auto test = std::find_if(body.tests.begin(), body.tests.end(),
                                   [value](const Test& one) { return one.value == value; });
    body.last = std::max(body.last, static_cast<size_t>(test - body.tests.begin()));
    for (size_t t = 0; t < body.tests.size(); ++t) {
      if (body.tests[t].seen) Leave(body, t);
    }
  }

  // Goes on after a test, as far as the calls that have been reached lead.
  void Leave(const Body& body, size_t t) {
    const Test& test = body.tests[t];
    if (body.reached.contains(test.value)) Jump(test.jump);
    if (t < body.last) open_.push_back(test.jump + 1);
  }

  const Bodies& by_number_;
  const std::vector<Instruction>& code_;
  const std::vector<int> positions_;
  std::vector<bool> reached_;
  std::vector<Body> bodies_;
  std::unordered_map<size_t, std::pair<size_t, size_t>> test_at_;  // body and test by the jump
  std::vector<size_t> open_;
};

}  // namespace

bool DecideWaysBack(LoweredFunction& function) {
  if (function.calls.empty()) return false;
  const Bodies bodies(function);
  const ReachedCalls reached(bodies, function);
  std::vector<std::set<int64_t>> rest;
  for (size_t body = 0; body < function.calls.size(); ++body) rest.push_back(reached.Of(body));
  bool changed = false;
  for (Instruction& instruction : function.code) {
    const auto body = bodies.Compared(instruction);
    if (!body) continue;
    const bool here = rest[*body].erase(instruction.b.value) > 0;
    if (here && !rest[*body].empty()) continue;
    MakeCopy(instruction, IntOperand(here ? 1 : 0));
    changed = true;
  }
  return changed;
}

bool ShortenWaysBack(LoweredFunction& function) {
  const Bodies bodies(function);
  std::vector<std::set<int64_t>> rest(function.calls.size());
  for (const Instruction& instruction : function.code) {
    if (const auto body = bodies.Assigned(instruction)) rest[*body].insert(instruction.a.value);
  }
  bool changed = false;
  for (Instruction& instruction : function.code) {
    const auto body = bodies.Compared(instruction);
    if (!body) continue;
    std::set<int64_t>& others = rest[*body];
    others.erase(instruction.b.value);
    if (others.size() != 1 || *others.begin() != 0) continue;
    MakeCopy(instruction, instruction.a);
    changed = true;
  }
  return changed;
}

}  // namespace oncard::compiler::lowering
