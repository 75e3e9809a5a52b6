// Calls of functions that call themselves (recursion.cc). The statements of such a function stand
// once, as those of shared_bodies.cc do, and its variables are those of the call that runs. A call
// within the group keeps what its caller needs afterwards in arrays, one element for each call that
// waits, and takes it back behind the call:
//
//     fib_depth = 0;
//     fib_n = 10;
//     fib_call = 0;
//   lbl_fib:
//     ...
//     fib_back[fib_depth] = fib_call;     // keeps the way back
//     fib_n_kept[fib_depth] = fib_n;      // and what is needed
//     fib_depth = fib_depth + 1;
//     fib_n = tmp1;
//     fib_call = 1;
//     goto lbl_fib;
//   lbl_fib_4_back:
//     fib_depth = fib_depth - 1;
//     fib_call = fib_back[fib_depth];
//     fib_n = fib_n_kept[fib_depth];
//     tmp1 = fib_result;
//
// The last of N frames waits for nobody, so the arrays have N - 1 elements. The first statement of
// a call that has no frame left faults, at the line of the call, before anything is overwritten; no
// pass removes it. What a call needs is what its own statements may have written before, and may
// read afterwards before they write it: the calls within the group are jumped over to find out. All
// of this belongs to the page of the thread.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/lowering/lowerer.h"
#include "compiler/lowering/passes/passes.h"

namespace oncard::compiler::lowering {

// Whether a call in the statements that are being translated is one within its group.
bool Lowerer::IsRecursive(const FunctionInfo& info) const {
  return info.group != 0 && frame_->info->group == info.group;
}

Lowerer::Frames& Lowerer::FramesOf(const FunctionInfo& info, SourceRange range) {
  Frames& frames = frames_[info.group];
  if (frames.back >= 0) return frames;
  const std::string_view name = GroupOf(info).members[0]->syntax->name;
  frames.range = range;
  const int depth =
      NewVariable(Variable::Role::kLocal, fmt::format("{}_depth", name), Type{}, {}, range);
  OwnByFrames(depth, Type{}, 0);
  frames.depth = VariableOperand(depth);
  frames.back = NewArray(frames, fmt::format("{}_back", name), vm::DataType::kInt, 1);
  program_.variables[static_cast<size_t>(frames.back)].checks = true;
  return frames;
}

// A variable of the page that no frame has.
int Lowerer::NewArray(const Frames& frames, std::string_view wish, vm::DataType type, int size) {
  Type element;
  if (type == vm::DataType::kDouble) element.basic = BasicType::kDouble;
  const int array =
      NewVariable(Variable::Role::kLocal, wish, element, {int64_t{size}}, frames.range);
  OwnByFrames(array, element, 0);
  return array;
}

// Says which calls have a variable of their own: those of a group.
void Lowerer::OwnByFrames(int variable, const Type& type, int group) {
  for (int leaf = 0; leaf < LeavesOf(type); ++leaf) {
    program_.variables[static_cast<size_t>(variable) + static_cast<size_t>(leaf)].group = group;
  }
}

// Before the parameters get their values: a call from elsewhere begins with the first frame, one
// within the group keeps the frame that calls.
void Lowerer::BeginFrame(const FunctionInfo& info, SourceRange range) {
  const Frames& frames = FramesOf(info, range);
  if (!IsRecursive(info)) {
    // With one frame there is no element to keep another one.
    EmitCopy(frames.depth, IntOperand(GroupOf(info).depth == 1 ? 1 : 0), range);
    return;
  }
  RecursiveCall& call = recursive_calls_.emplace_back();
  call.group = info.group;
  call.body = frame_->body;
  call.save = out_->code.size();
  EmitCopy(BackOf(frames), bodies_[static_cast<size_t>(call.body) - 1].number, range);
  ChangeDepth(frames, vm::BinaryOperator::kAdd, range);
}

void Lowerer::EndFrame(RecursiveCall& call, SourceRange range) {
  const Frames& frames = frames_.at(call.group);
  call.restore = out_->code.size();
  ChangeDepth(frames, vm::BinaryOperator::kSubtract, range);
  EmitCopy(bodies_[static_cast<size_t>(call.body) - 1].number, BackOf(frames), range);
}

// The way back of the call that waits at the present depth.
Operand Lowerer::BackOf(const Frames& frames) const {
  Operand back = VariableOperand(frames.back);
  back.kind = Operand::Kind::kElement;
  back.index = frames.depth.variable;
  return back;
}

void Lowerer::ChangeDepth(const Frames& frames, vm::BinaryOperator by_one, SourceRange range) {
  Instruction step;
  step.kind = Instruction::Kind::kBinary;
  step.binary = by_one;
  step.target = step.a = frames.depth;
  step.b = IntOperand(1);
  Emit(std::move(step), range);
}

// The statements before each statement, on the ways that one call of a function takes. They lead
// over the calls within a group, from where the frame is kept: what the parameters get is not the
// frame's any more. They lead over other calls, too, and to the body of these, but not beyond the
// end of a body.
std::vector<std::vector<size_t>> Lowerer::WaysTo() const {
  const std::vector<Instruction>& code = out_->code;
  std::vector<std::vector<size_t>> before(code.size() + 1);
  const std::vector<int> positions = LabelPositions(*out_);
  std::set<size_t> jumps;
  for (const RecursiveCall& call : recursive_calls_) {
    before[call.restore].push_back(call.save);
    jumps.insert(call.jump);
  }
  std::set<int> begins;
  std::set<int> ends;
  for (const SharedBody& body : bodies_) {
    begins.insert(body.begin);
    ends.insert(body.end);
    const auto begin = static_cast<size_t>(positions[static_cast<size_t>(body.begin)]);
    const auto end = static_cast<size_t>(positions[static_cast<size_t>(body.end)]);
    if (!jumps.contains(begin - 1)) before[end + 1].push_back(begin - 1);
  }
  for (size_t i = 0; i < code.size(); ++i) {
    const Instruction& instruction = code[i];
    if (jumps.contains(i)) continue;
    const bool label = instruction.kind == Instruction::Kind::kLabel;
    if (label && ends.contains(instruction.label)) continue;
    if (instruction.Jumps()) {
      before[static_cast<size_t>(positions[static_cast<size_t>(instruction.label)])].push_back(i);
    }
    const bool leaves =
        instruction.kind == Instruction::Kind::kReturn ||
        (instruction.kind == Instruction::Kind::kGoto && !begins.contains(instruction.label));
    if (!leaves) before[i + 1].push_back(i);
  }
  return before;
}

// What an operand reads or writes: one variable, or those of all members of a structure of the
// card.
Lowerer::VariableRange Lowerer::VariablesOf(const Operand& operand) const {
  const int first = operand.variable + operand.member;
  if (operand.kind != Operand::Kind::kVariable) return {first, first + 1};
  const gtcalls::Structure* const structure =
      program_.variables[static_cast<size_t>(first)].structure;
  return {first, first + (structure != nullptr ? static_cast<int>(structure->members.size()) : 1)};
}

// The variables that may have a value when a call within a group begins: parameters, and what the
// statements before it write.
std::set<int> Lowerer::WrittenBefore(const RecursiveCall& call,
                                     const std::vector<std::vector<size_t>>& before) const {
  std::set<int> written;
  for (const auto& [name, symbol] : bodies_[static_cast<size_t>(call.body) - 1].scope) {
    for (int leaf = 0; leaf < LeavesOf(symbol.type); ++leaf) {
      written.insert(symbol.variable + leaf);
    }
    written.insert(symbol.offset.variable);
  }
  std::vector<bool> seen(before.size());
  std::vector<size_t> open = {call.save};
  while (!open.empty()) {
    const size_t i = open.back();
    open.pop_back();
    if (seen[i]) continue;
    seen[i] = true;
    ForEachOperand(out_->code[i], [&](const Operand& operand, bool writes) {
      const VariableRange changed = VariablesOf(operand);
      for (int variable = changed.begin; writes && variable < changed.end; ++variable) {
        written.insert(variable);
      }
    });
    open.insert(open.end(), before[i].begin(), before[i].end());
  }
  return written;
}

// Finds the variables of a group that its calls need when they go on.
void Lowerer::FindKept(int group) {
  const std::vector<Instruction>& code = out_->code;
  const std::vector<std::vector<size_t>> before = WaysTo();
  std::map<int, std::vector<size_t>> reads;
  const auto read = [&](int variable, size_t i) {
    if (variable < 0) return;
    if (program_.variables[static_cast<size_t>(variable)].group == group) {
      reads[variable].push_back(i);
    }
  };
  for (size_t i = 0; i < code.size(); ++i) {
    ForEachOperand(code[i], [&](const Operand& operand, bool written) {
      read(operand.index, i);
      const VariableRange used = VariablesOf(operand);
      for (int variable = used.begin; variable < used.end; ++variable) {
        if (!written || operand.address) read(variable, i);
      }
    });
  }
  std::vector<std::set<int>> written;  // by call
  for (const RecursiveCall& call : recursive_calls_) {
    written.push_back(call.group == group ? WrittenBefore(call, before) : std::set<int>());
  }
  std::vector<int> needed(code.size() + 1, -1);  // the last variable that is needed before it
  for (auto& [variable, open] : reads) {
    for (const size_t i : open) needed[i] = variable;
    while (!open.empty()) {
      const size_t i = open.back();
      open.pop_back();
      for (const size_t from : before[i]) {
        const Operand& target = code[from].target;
        const bool whole = target.IsVariable() || target.kind == Operand::Kind::kMember;
        const bool writes = whole && VariablesOf(target).begin == variable;
        if (writes || needed[from] == variable) continue;
        needed[from] = variable;
        open.push_back(from);
      }
    }
    for (size_t i = 0; i < recursive_calls_.size(); ++i) {
      RecursiveCall& call = recursive_calls_[i];
      const bool has_value = written[i].contains(variable);
      if (has_value && needed[call.restore] == variable) call.kept.push_back(variable);
    }
  }
}

// What the array of a variable is called.
std::string Lowerer::KeptName(int number) const {
  const Variable& variable = program_.variables[static_cast<size_t>(number)];
  if (variable.structure == nullptr) return fmt::format("{}_kept", variable.name);
  const std::string& whole = program_.variables[static_cast<size_t>(number - variable.member)].name;
  return fmt::format("{}_{}_kept", whole,
                     variable.structure->members[static_cast<size_t>(variable.member)].name);
}

// Gives each variable that is kept an array. Temporaries have no names, so they share arrays, each
// call beginning with the first.
void Lowerer::MakeArrays(int group, const Group& sizes) {
  Frames& frames = frames_.at(group);
  frames.rows = static_cast<size_t>(std::max(sizes.depth - 1, 1));
  const auto set_size = [&](int array, int elements) {
    program_.variables[static_cast<size_t>(array)].size = static_cast<int>(frames.rows) * elements;
    frames.slots += static_cast<size_t>(elements);
  };
  set_size(frames.back, 1);
  const std::string_view name = sizes.members[0]->syntax->name;
  std::map<int, int> arrays;  // by variable
  std::map<vm::DataType, std::vector<int>> of_temporaries;
  for (RecursiveCall& call : recursive_calls_) {
    if (call.group != group) continue;
    std::map<vm::DataType, size_t> used;
    for (const int number : call.kept) {
      const Variable variable = program_.variables[static_cast<size_t>(number)];
      const bool temporary = variable.role == Variable::Role::kTemporary;
      int* array = nullptr;
      if (temporary) {
        std::vector<int>& known = of_temporaries[variable.type];
        const size_t place = used[variable.type]++;
        if (place == known.size()) known.push_back(-1);
        array = &known[place];
      } else {
        array = &arrays.try_emplace(number, -1).first->second;
      }
      if (*array < 0) {
        *array = NewArray(frames, temporary ? fmt::format("{}_kept", name) : KeptName(number),
                          variable.type, 1);
        set_size(*array, std::max(variable.size, 1));
      }
      call.arrays.push_back(*array);
    }
  }
}

// Keeps what a call needs, or gives it back.
void Lowerer::CopyKept(const RecursiveCall& call, bool save) {
  const Operand depth = frames_.at(call.group).depth;
  for (size_t i = 0; i < call.kept.size(); ++i) {
    const Variable& variable = program_.variables[static_cast<size_t>(call.kept[i])];
    const SourceRange range = out_->code.back().range;
    Type type;
    type.basic = variable.type == vm::DataType::kDouble ? BasicType::kDouble : BasicType::kInt;
    ArrayPlace own = {call.kept[i], IntOperand(0), {}, type, variable.name};
    ArrayPlace kept = {call.arrays[i], depth, {}, type, variable.name};
    if (variable.size > 0) {
      own.dimensions = kept.dimensions = {variable.size};
      kept.offset = Compute(vm::BinaryOperator::kMultiply, depth, IntOperand(variable.size),
                            BasicType::kInt, range)
                        .operand;
    }
    CopyLeaf(save ? kept : own, save ? own : kept, range);
  }
}

// Completes the calls within groups when all statements of a thread function are there.
void Lowerer::EmitFrames() {
  if (stopped_ || reporter_.HasErrors() || frames_.empty()) return;
  for (const auto& [group, frames] : frames_) {
    FindKept(group);
    MakeArrays(group, groups_[static_cast<size_t>(group) - 1]);
  }
  if (reporter_.HasErrors()) return;
  for (const auto& [group, frames] : frames_) {
    const FunctionInfo& first = *groups_[static_cast<size_t>(group) - 1].members[0];
    out_->frames.push_back({std::string(first.syntax->name), frames.back,
                            static_cast<int>(frames.rows), static_cast<int>(frames.slots),
                            groups_[static_cast<size_t>(group) - 1].depth});
  }
  std::map<size_t, std::pair<const RecursiveCall*, bool>> behind;  // statements
  for (const RecursiveCall& call : recursive_calls_) {
    behind[call.save] = {&call, true};
    behind[call.restore + 1] = {&call, false};
  }
  const int function = std::exchange(instance_, -1);
  std::vector<Instruction> code = std::exchange(out_->code, {});
  for (size_t i = 0; i < code.size(); ++i) {
    statement_ = code[i].statement;
    out_->code.push_back(std::move(code[i]));
    const auto found = behind.find(i);
    if (found == behind.end()) continue;
    frame_->body = found->second.first->body;
    CopyKept(*found->second.first, found->second.second);
  }
  frame_->body = 0;
  instance_ = function;
}

}  // namespace oncard::compiler::lowering
