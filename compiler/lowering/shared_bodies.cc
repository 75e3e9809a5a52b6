// Functions whose statements stand once in a thread function, for several calls. A call gives the
// parameters their values, says which call it is, and jumps; after the body a chain of comparisons
// leads back. The body stands where the first call is:
//
//     square_x = a;
//     square_call = 0;
//   lbl_square:
//     square_result = square_x * square_x;
//     if (square_call) goto lbl_square_5_back;
//     ...
//     square_x = b;
//     square_call = 1;
//     goto lbl_square;
//   lbl_square_5_back:
//
// All of these variables belong to the page of the thread, so that no access to a global is added.
// A function can have several bodies, one for each choice of arrays that it is called with.
#include <fmt/core.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "compiler/lowering/costs.h"
#include "compiler/lowering/lowerer.h"
#include "compiler/lowering/passes/passes.h"
#include "vm/limits.h"

namespace oncard::compiler::lowering {
namespace {

// Copies that are not longer are not worth jumps.
constexpr size_t kWorthSharing = 3;

// What a call by a jump takes beside its arguments: two statements to come, two to come back.
constexpr size_t kJumpCost = 4;

// So many statements are translated to find out, by leaving out one function after the other, which
// calls of a thread function become jumps. If it takes more, it is found by their sizes.
constexpr size_t kTriedMax = 5'000;

}  // namespace

// The body for the arrays of a call, nullptr if there is none yet.
Lowerer::SharedBody* Lowerer::FindBody(const FunctionInfo& info, const Scope& scope) {
  for (SharedBody& body : bodies_) {
    if (body.function != &info) continue;
    const bool same = std::all_of(scope.begin(), scope.end(), [&body](const auto& parameter) {
      const Symbol& symbol = parameter.second;
      const Symbol& other = body.scope.at(parameter.first);
      return symbol.variable == other.variable && symbol.offset == other.offset &&
             symbol.dimensions == other.dimensions && symbol.type.is_const == other.type.is_const;
    });
    if (same) return &body;
  }
  return nullptr;
}

// An array that begins at a computed element is another one in each call. What calls itself cannot
// be inlined, and has the place of such an array in a variable.
bool Lowerer::CanShare(const FunctionInfo& info, const Scope& scope) const {
  if (info.group != 0) return true;
  return info.shared && std::all_of(scope.begin(), scope.end(), [](const auto& parameter) {
           return parameter.second.offset.IsConstant();
         });
}

Value Lowerer::LowerSharedCall(const Expression& call, FunctionInfo& info, Scope scope) {
  const BasicType type = info.type.basic;
  const std::string_view name = info.syntax->name;
  SharedBody* body = FindBody(info, scope);
  const bool recursive = IsRecursive(info);
  const size_t number = recursive_calls_.size() - 1;  // of a recursive call, which has begun
  const int back = NewLabel(name, call.range, body != nullptr ? "back" : "first");
  if (body != nullptr) {
    EmitCopy(body->number, IntOperand(static_cast<int64_t>(body->back.size())), call.range);
    body->back.push_back(back);
    EmitGoto(body->begin, call.range);
    if (recursive) recursive_calls_[number].jump = out_->code.size() - 1;
    EmitLabel(back, call.range);
  } else {
    body = &bodies_.emplace_back();
    body->function = &info;
    body->scope = scope;
    body->id = static_cast<int>(bodies_.size());
    body->back.push_back(back);
    const auto make = [this, name, &call](std::string_view what, const Type& of) {
      return VariableOperand(NewVariable(Variable::Role::kLocal, fmt::format("{}_{}", name, what),
                                         of, {}, call.range));
    };
    body->number = make("call", Type{});
    OwnByFrames(body->number.variable, Type{}, 0);
    if (type != BasicType::kVoid) {
      body->result = make("result", info.type);
      OwnByFrames(body->result.variable, info.type, 0);
    }
    body->begin = NewLabel(fmt::format("lbl_{}", name));
    body->end = NewLabel(name, call.range, "end");
    body->instance = static_cast<int>(out_->instances.size());
    out_->instances.push_back({-1, 0, body->id});
    EmitCopy(body->number, IntOperand(0), call.range);
    if (recursive) recursive_calls_[number].jump = out_->code.size() - 1;
    // All calls lead there: for each of them it is outside of the block that calls.
    const int outside = std::exchange(instance_, body->instance);
    EmitLabel(body->begin, call.range);
    LowerBodyOf(call, info, std::move(scope), {body->id, body->end, body->result});
    instance_ = outside;
  }
  if (recursive) EndFrame(recursive_calls_[number], call.range);
  if (type == BasicType::kVoid) return {Operand(), type, type};
  // Another call may follow before the result is used.
  const Operand result = NewResult(call, info);
  if (info.type.own != nullptr) {
    CopyStructure(StructureAt(result.variable, info.type),
                  StructureAt(body->result.variable, info.type), call.range);
  } else {
    EmitCopy(result, body->result, call.range);
  }
  return {result, type, type};
}

// After each body the ways back to its calls. The first one goes on where the body ends.
void Lowerer::EmitWaysBack() {
  CompareBodies();
  const int function = instance_;
  std::vector<Instruction> code = std::exchange(out_->code, {});
  for (Instruction& instruction : code) {
    const int label = instruction.kind == Instruction::Kind::kLabel ? instruction.label : -1;
    out_->code.push_back(std::move(instruction));
    const auto body = std::find_if(bodies_.begin(), bodies_.end(),
                                   [label](const SharedBody& one) { return one.end == label; });
    if (body == bodies_.end()) continue;
    const SourceRange range = body->function->syntax->close_brace;
    BeginFullExpression(range);
    frame_->body = body->id;
    instance_ = body->instance;
    for (size_t i = body->back.size(); i-- > 0;) {
      const Value here = Compute(vm::BinaryOperator::kEqual, body->number,
                                 IntOperand(static_cast<int64_t>(i)), BasicType::kInt, range);
      EmitIf(here.operand, body->back[i], range);
    }
    EmitLabel(body->back[0], range);
    instance_ = function;
    out_->calls.push_back({std::string(body->function->syntax->name), body->number.variable});
  }
  frame_->body = 0;
}

// What becomes of a thread function with the calls as jumps that are marked.
Lowerer::Size Lowerer::TrySize(FunctionInfo& info) {
  const size_t variables = program_.variables.size();
  const size_t statements = program_.statements.size();
  const size_t globals = program_.globals.size();
  const size_t assertions = program_.assertions.size();
  LoweredFunction function = LowerFunction(info);
  Size size;
  size.stopped = stopped_;
  size.translated = function.code.size();
  program_.tried_statements += static_cast<int64_t>(function.code.size());
  if (!stopped_) {
    RemoveUnusedLabels(function);
    Optimize(program_, function, options_.double_format);
    const FunctionCost cost = CostOf(program_, function);
    size.statements = cost.statements;
    size.labels = std::max(cost.labels, vm::kLabelMax);
  }
  program_.assertions.resize(assertions);
  // The first time, static locals become globals, which stay.
  if (program_.globals.size() == globals) {
    program_.variables.resize(variables);
    program_.statements.resize(statements);
  }
  return size;
}

// Marks the functions whose calls become jumps, because that makes a thread function shorter, or
// makes it fit the card at all: first all that are worth it, then all but those without which it is
// no longer.
void Lowerer::ChooseShared(FunctionInfo& info) {
  // The marks of others mean nothing to a function without calls.
  if (!lowering_options_.optimize || info.calls.empty()) return;
  for (FunctionInfo& other : functions_) {
    other.shared = false;
    other.copies = 0;
    other.copied = 0;
  }
  const Size inlined = TrySize(info);
  if (reporter_.HasErrors()) return;
  std::vector<FunctionInfo*> candidates;
  for (FunctionInfo& other : functions_) {
    // Of a function that is too long as far as it goes, nothing is known.
    const bool worth = other.copies > 1 && other.copied > kWorthSharing;
    if (worth || (inlined.stopped && other.called)) candidates.push_back(&other);
  }
  if (candidates.empty()) return;
  const auto mark = [&candidates](bool shared) {
    for (FunctionInfo* candidate : candidates) candidate->shared = shared;
  };
  const auto shorter = [](const Size& a, const Size& b) {
    return std::tie(a.stopped, a.labels, a.statements) <
           std::tie(b.stopped, b.labels, b.statements);
  };
  mark(true);
  Size best = TrySize(info);
  if (candidates.size() * best.translated <= kTriedMax) {
    for (FunctionInfo* candidate : candidates) {
      candidate->shared = false;
      const Size size = TrySize(info);
      candidate->shared = shorter(best, size);
      if (!candidate->shared) best = size;
    }
  } else {
    for (FunctionInfo* candidate : candidates) {
      candidate->shared = candidate->as_jumps < candidate->as_copies;
    }
    const Size size = TrySize(info);
    if (shorter(best, size)) {
      mark(true);
    } else {
      best = size;
    }
  }
  if (!shorter(best, inlined)) mark(false);
}

// Compares what the statements of the bodies take once, with the jumps, and once for each call.
// Those of bodies within a body are not its own.
void Lowerer::CompareBodies() {
  std::unordered_map<int, SharedBody*> begins;
  std::unordered_set<int> ends;
  for (SharedBody& body : bodies_) {
    FunctionInfo& info = *body.function;
    info.as_jumps = info.as_copies = 0;
    begins.emplace(body.begin, &body);
    ends.insert(body.end);
  }
  std::vector<std::pair<SharedBody*, size_t>> open;  // with their own statements
  for (const Instruction& instruction : out_->code) {
    if (instruction.kind != Instruction::Kind::kLabel) {
      if (!open.empty() && instruction.IsStatement()) ++open.back().second;
      continue;
    }
    if (const auto begun = begins.find(instruction.label); begun != begins.end()) {
      open.emplace_back(begun->second, 0);
    }
    if (!ends.contains(instruction.label)) continue;
    const auto [body, own] = open.back();
    open.pop_back();
    body->function->as_jumps += own + kJumpCost * body->back.size();
    body->function->as_copies += own * body->back.size();
  }
}

void Lowerer::LowerThreadFunction(FunctionInfo& info) {
  CheckNameLength(info.syntax->name, info.syntax->name_range);
  ChooseShared(info);
  program_.functions.push_back(LowerFunction(info));
  if (stopped_) Report(Code::kLoweredTooLong, info.syntax->name_range, info.syntax->name);
}

}  // namespace oncard::compiler::lowering
