// The comparisons that lead from a shared body back to its calls (shared_bodies.cc). Only a call
// that a path reaches can be the one to go back to; the last of them needs no comparison. A call in
// a loop that is never entered must not keep itself alive through the body, so a way back is
// followed only when its call has been reached.
#include <algorithm>
#include <set>
#include <unordered_map>

#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {
namespace {

bool Compares(const Instruction& instruction, int number) {
  return instruction.kind == Instruction::Kind::kBinary &&
         instruction.binary == vm::BinaryOperator::kEqual && instruction.a.IsVariable() &&
         instruction.a.variable == number && instruction.b.IsConstant();
}

// A recursive call that ends gives the number back what another statement has assigned.
bool Assigns(const Instruction& instruction, int number) {
  return instruction.target.IsVariable() && instruction.target.variable == number &&
         instruction.a.IsConstant();
}

// The calls of each shared body that a path reaches, by their numbers.
class ReachedCalls {
 public:
  explicit ReachedCalls(const LoweredFunction& function)
      : code_(function.code), positions_(LabelPositions(function)), reached_(code_.size()) {
    for (const SharedCalls& calls : function.calls) FindTests(calls.number);
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
    int number = -1;
    std::vector<Test> tests;  // in their order
    std::set<int64_t> reached;
    size_t last = 0;  // tests before this one can be passed
  };

  void FindTests(int number) {
    Body& body = bodies_.emplace_back();
    body.number = number;
    for (size_t i = 0; i + 1 < code_.size(); ++i) {
      const Instruction& jump = code_[i + 1];
      if (!Compares(code_[i], number) || jump.kind != Instruction::Kind::kIf ||
          jump.a != code_[i].target) {
        continue;
      }
      test_at_.emplace(i + 1, std::pair(bodies_.size() - 1, body.tests.size()));
      body.tests.push_back({code_[i].b.value, i + 1});
    }
  }

  void Follow(size_t i) {
    for (; i < code_.size() && !reached_[i]; ++i) {
      reached_[i] = true;
      const Instruction& instruction = code_[i];
      if (instruction.kind == Instruction::Kind::kReturn) return;
      for (Body& body : bodies_) {
        if (Assigns(instruction, body.number)) Reach(body, instruction.a.value);
      }
      const auto test = test_at_.find(i);
      if (test != test_at_.end()) {
        Body& body = bodies_[test->second.first];
        body.tests[test->second.second].seen = true;
        Leave(body, test->second.second);
        return;
      }
      if (instruction.label >= 0 && instruction.kind != Instruction::Kind::kLabel) Jump(i);
      if (instruction.kind == Instruction::Kind::kGoto) return;
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
  const ReachedCalls reached(function);
  bool changed = false;
  for (size_t body = 0; body < function.calls.size(); ++body) {
    const int number = function.calls[body].number;
    std::set<int64_t> rest = reached.Of(body);
    for (Instruction& instruction : function.code) {
      if (!Compares(instruction, number)) continue;
      const bool here = rest.erase(instruction.b.value) > 0;
      if (here && !rest.empty()) continue;
      MakeCopy(instruction, IntOperand(here ? 1 : 0));
      changed = true;
    }
  }
  return changed;
}

bool ShortenWaysBack(LoweredFunction& function) {
  bool changed = false;
  for (const SharedCalls& calls : function.calls) {
    std::set<int64_t> rest;
    for (const Instruction& instruction : function.code) {
      if (Assigns(instruction, calls.number)) rest.insert(instruction.a.value);
    }
    for (Instruction& instruction : function.code) {
      if (!Compares(instruction, calls.number)) continue;
      rest.erase(instruction.b.value);
      if (rest.size() != 1 || *rest.begin() != 0) continue;
      MakeCopy(instruction, instruction.a);
      changed = true;
    }
  }
  return changed;
}

}  // namespace oncard::compiler::lowering
