// How many calls of a group of functions (recursion.cc) run at the same time, found without a
// comment `//@ depth`: from the thread functions on, calls are followed with the values of their
// int arguments that are known, as in `factorial(7)`. A branch whose condition is known with them
// not to hold is not gone. What else decides, such as a global, is not known, so that both branches
// are. Each different call is followed once; where one leads to itself again, there is no proof.
#include <algorithm>
#include <map>
#include <utility>

#include "compiler/lowering/lowerer.h"
#include "compiler/tree_walk.h"

namespace oncard::compiler::lowering {
namespace {

/// So many different calls of a function are followed; further ones as one of which nothing is
/// known.
constexpr size_t kCallsMax = 2048;

// Ints alone: doubles would be computed as real numbers.
bool HasInts(const Expression& expression) {
  bool ints = true;
  ForEachExpression(expression, [&ints](const Expression& part) {
    const bool fixed =
        part.kind == Expression::Kind::kLiteral && part.literal.kind == Literal::Kind::kFixed;
    ints &=
        !fixed && part.kind != Expression::Kind::kCast && part.kind != Expression::Kind::kSizeof;
  });
  return ints;
}

bool HasJumps(const Function& function) {
  bool jumps = false;
  for (const StatementPtr& item : function.body) {
    ForEachStatement(*item, [&jumps](const Statement& statement) {
      jumps |= statement.kind == Statement::Kind::kGoto;
    });
  }
  return jumps;
}

}  // namespace

class Lowerer::DepthProof {
 public:
  explicit DepthProof(Lowerer& lowerer) : lowerer_(lowerer) {}

  void FollowAll() {
    for (FunctionInfo& info : lowerer_.functions_) {
      const bool starts = !info.called && !info.is_static && !info.syntax->prototype;
      if (starts) Number({&info, Values(info.syntax->parameters.size())});
    }
    for (size_t i = 0; i < calls_.size(); ++i) Follow(i);
  }

  // 0: not known.
  int DepthOf(int group) const {
    // Of the longest chain from a call on; 0: not known yet.
    std::vector<int> length(calls_.size());
    std::vector<bool> open(calls_.size());
    std::vector<std::pair<size_t, size_t>> path;  // with how many of its calls are done
    int longest = 1;
    for (size_t start = 0; start < calls_.size(); ++start) {
      if (calls_[start].function->group == group && length[start] == 0) path.emplace_back(start, 0);
      while (!path.empty()) {
        auto& [call, done] = path.back();
        open[call] = true;
        if (done < made_[call].size()) {
          const size_t next = made_[call][done++];
          if (open[next]) return 0;
          const bool inside = calls_[next].function->group == group;
          if (inside && length[next] == 0) path.emplace_back(next, 0);
          continue;
        }
        longest = std::max(longest, CloseChain(call, length));
        open[call] = false;
        path.pop_back();
      }
    }
    return longest <= kFramesMax ? longest : 0;
  }

 private:
  // Those of the int parameters, as far as they are known.
  using Values = std::vector<std::optional<int32_t>>;
  struct Call {
    FunctionInfo* function = nullptr;
    Values values;
  };

  // Finds the calls that a call may make.
  void Follow(size_t number) {
    from_ = number;
    const Call call = calls_[number];
    const Function& syntax = *call.function->syntax;
    Frame frame;
    frame.info = call.function;
    frame.scope_base = lowerer_.scopes_.size();
    Frame* const outer = std::exchange(lowerer_.frame_, &frame);
    lowerer_.scopes_.push_back(ScopeOf(call));
    any_order_ = HasJumps(syntax);
    WalkItems(syntax.body);
    lowerer_.scopes_.pop_back();
    lowerer_.frame_ = outer;
  }

  // The names of a function: parameters that it does not change are constants.
  static Scope ScopeOf(const Call& call) {
    const Function& syntax = *call.function->syntax;
    NameTable names;
    names.Add(syntax.body);
    Scope scope;
    for (size_t i = 0; i < syntax.parameters.size(); ++i) {
      const std::string_view name = syntax.parameters[i].declarator.name;
      if (name.empty()) continue;
      const std::optional<int32_t> value = call.values[i];
      Symbol& symbol = scope[name];
      if (!value || names.Find(name).first_write != nullptr) continue;
      symbol.kind = Symbol::Kind::kConstant;
      symbol.constant.value.integer = *value;
    }
    for (const StatementPtr& item : syntax.body) {
      ForEachStatement(*item, [&scope](const Statement& statement) {
        for (const Declarator& declarator : statement.declarators) scope[declarator.name] = {};
        if (statement.specifiers.enumeration == nullptr) return;
        for (const Enumerator& own : statement.specifiers.enumeration->enumerators) {
          scope[own.name] = {};
        }
      });
    }
    return scope;
  }

  // True where the statements behind are reached.
  bool WalkItems(const std::vector<StatementPtr>& items) {
    for (const StatementPtr& item : items) {
      if (!Walk(*item) && !any_order_) return false;
    }
    return true;
  }

  bool Walk(const Statement& statement) {
    switch (statement.kind) {
      case Statement::Kind::kBlock:
        return WalkItems(statement.items);
      case Statement::Kind::kIf: {
        Walk(*statement.value);
        const std::optional<bool> holds = Truth(*statement.value);
        const bool then_goes_on = holds != false && Walk(*statement.body);
        const bool has_else = statement.else_body != nullptr;
        const bool else_goes_on = holds != true && (!has_else || Walk(*statement.else_body));
        return then_goes_on || else_goes_on;
      }
      case Statement::Kind::kWhile:
      case Statement::Kind::kFor:
        if (statement.initial != nullptr) Walk(*statement.initial);
        if (statement.value != nullptr) {
          Walk(*statement.value);
          if (Truth(*statement.value) == false) return true;
        }
        Walk(*statement.body);
        if (statement.step != nullptr) Walk(*statement.step);
        return true;
      case Statement::Kind::kSwitch: {
        Walk(*statement.value);
        const bool outer = std::exchange(any_order_, true);
        Walk(*statement.body);
        any_order_ = outer;
        return true;
      }
      default:
        break;
    }
    ForEachWholeExpression(statement, [this](const Expression& whole) { Walk(whole); });
    if (statement.body != nullptr) Walk(*statement.body);
    return statement.kind != Statement::Kind::kReturn &&
           statement.kind != Statement::Kind::kBreak &&
           statement.kind != Statement::Kind::kContinue;
  }

  void Walk(const Expression& expression) {
    if (expression.kind == Expression::Kind::kSizeof) return;
    const bool both = expression.op == "&&" || expression.op == "||";
    if (expression.kind == Expression::Kind::kBinary && both) {
      Walk(*expression.operands[0]);
      const std::optional<bool> left = Truth(*expression.operands[0]);
      if (!left || *left == (expression.op == "&&")) Walk(*expression.operands[1]);
      return;
    }
    if (expression.kind == Expression::Kind::kConditional) {
      Walk(*expression.operands[0]);
      const std::optional<bool> holds = Truth(*expression.operands[0]);
      if (holds != false) Walk(*expression.operands[1]);
      if (holds != true) Walk(*expression.operands[2]);
      return;
    }
    for (const ExpressionPtr& operand : expression.operands) Walk(*operand);
    if (expression.kind == Expression::Kind::kCall) Enter(expression);
  }

  // Whether a condition holds, where that is known.
  std::optional<bool> Truth(const Expression& condition) {
    if (any_order_) return std::nullopt;
    const Expression& inner = WithoutParens(condition);
    if (inner.kind == Expression::Kind::kUnary && inner.op == "!") {
      const std::optional<bool> holds = Truth(*inner.operands[0]);
      return holds ? std::optional(!*holds) : std::nullopt;
    }
    const bool conjunction = inner.op == "&&";
    if (inner.kind == Expression::Kind::kBinary && (conjunction || inner.op == "||")) {
      const std::optional<bool> left = Truth(*inner.operands[0]);
      const std::optional<bool> right = Truth(*inner.operands[1]);
      if (left == !conjunction || right == !conjunction) return !conjunction;
      return left && right ? std::optional(conjunction) : std::nullopt;
    }
    const std::optional<int32_t> value = ValueOf(inner);
    return value ? std::optional(*value != 0) : std::nullopt;
  }

  std::optional<int32_t> ValueOf(const Expression& expression) {
    if (!HasInts(expression)) return std::nullopt;
    const std::optional<TypedConstant> value = lowerer_.Evaluate(expression);
    if (!value || !IsInteger(value->type)) return std::nullopt;
    return static_cast<int32_t>(value->value.integer);
  }

  void Enter(const Expression& expression) {
    const Expression& callee = WithoutParens(*expression.operands[0]);
    if (callee.kind != Expression::Kind::kName) return;
    const auto found = lowerer_.scopes_[0].find(callee.text);
    if (found == lowerer_.scopes_[0].end() || found->second.function == nullptr) return;
    FunctionInfo& function = *found->second.function;
    const std::vector<ParameterDeclaration>& parameters = function.syntax->parameters;
    Call call = {&function, Values(parameters.size())};
    for (size_t i = 0; i < parameters.size() && i + 1 < expression.operands.size(); ++i) {
      const Type type = lowerer_.ResolveGlobalType(parameters[i].specifiers);
      if (type.basic != BasicType::kInt || IsReference(parameters[i].declarator, type)) continue;
      call.values[i] = ValueOf(*expression.operands[i + 1]);
    }
    if (different_[function.order] >= kCallsMax) call.values.assign(parameters.size(), {});
    const size_t number = Number(std::move(call));
    made_[from_].push_back(number);
  }

  size_t Number(Call call) {
    const auto [known, is_new] =
        numbers_.try_emplace({call.function->order, call.values}, calls_.size());
    if (is_new) {
      ++different_[call.function->order];
      calls_.push_back(std::move(call));
      made_.emplace_back();
    }
    return known->second;
  }

  // When all its calls are known: how many calls wait for each other, those that it makes included.
  int CloseChain(size_t call, std::vector<int>& length) const {
    for (const size_t next : made_[call]) length[call] = std::max(length[call], length[next]);
    return ++length[call];
  }

  Lowerer& lowerer_;
  bool any_order_ = false;  // statements may be reached by jumps
  std::vector<Call> calls_;
  std::vector<std::vector<size_t>> made_;  // by each of them
  std::map<std::pair<int, Values>, size_t> numbers_;
  std::map<int, size_t> different_;  // how many calls, by their functions' order
  size_t from_ = 0;                  // the call that is followed
};

void Lowerer::ProveDepths() {
  if (std::ranges::none_of(groups_, [](const Group& group) { return group.depth == 0; })) return;
  DepthProof proof(*this);
  proof.FollowAll();
  for (Group& group : groups_) {
    if (group.depth == 0) group.depth = proof.DepthOf(group.members[0]->group);
  }
}

}  // namespace oncard::compiler::lowering
