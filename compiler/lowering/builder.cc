// The smallest steps of the translation: statements, temporaries, labels and names.
#include <fmt/core.h>

#include <algorithm>

#include "compiler/lowering/lowerer.h"
#include "vm/limits.h"

namespace oncard::compiler::lowering {

std::string NameMaker::Make(std::string_view wish) {
  std::string name(wish.substr(0, vm::kNameLengthMax));
  if (Take(name)) return name;
  int& number = next_.try_emplace(name, 2).first->second;
  for (;;) {
    const std::string suffix = fmt::format("_{}", number++);
    std::string candidate(wish.substr(0, vm::kNameLengthMax - suffix.size()));
    candidate += suffix;
    if (Take(candidate)) return candidate;
  }
}

bool NameMaker::Take(const std::string& name) {
  if (base_ != nullptr) {
    const auto other = base_->used_.find(name);
    if (other != base_->used_.end() && other->second < base_count_) return false;
  }
  return used_.try_emplace(name, used_.size()).second;
}

const Expression& WithoutParens(const Expression& expression) {
  const Expression* inner = &expression;
  while (inner->kind == Expression::Kind::kParen) inner = inner->operands[0].get();
  return *inner;
}

Instruction& Lowerer::Emit(Instruction instruction, SourceRange range) {
  instruction.range = range;
  instruction.statement = statement_;
  instruction.instance = instance_;
  // The passes may still shorten the function, but not by this much.
  if (out_->code.size() > size_t{2} * vm::kInstructionMax) stopped_ = true;
  out_->code.push_back(std::move(instruction));
  return out_->code.back();
}

void Lowerer::EmitCopy(const Operand& target, const Operand& value, SourceRange range) {
  Instruction copy;
  copy.target = target;
  copy.a = value;
  Emit(std::move(copy), range);
}

void Lowerer::EmitGoto(int label, SourceRange range) {
  if (EndsInJump()) return;
  Instruction jump;
  jump.kind = Instruction::Kind::kGoto;
  jump.label = label;
  Emit(std::move(jump), range);
}

void Lowerer::EmitIf(const Operand& condition, int label, SourceRange range) {
  Instruction jump;
  jump.kind = Instruction::Kind::kIf;
  jump.a = condition;
  jump.label = label;
  Emit(std::move(jump), range);
}

void Lowerer::EmitLabel(int label, SourceRange range) {
  Instruction instruction;
  instruction.kind = Instruction::Kind::kLabel;
  instruction.label = label;
  Emit(std::move(instruction), range);
}

Operand Lowerer::NewTemporary(vm::DataType type, SourceRange range) {
  Variable variable;
  variable.role = Variable::Role::kTemporary;
  variable.type = type;
  variable.body = frame_ != nullptr ? frame_->body : 0;
  variable.group = frame_ != nullptr ? frame_->group : 0;
  variable.range = range;
  program_.variables.push_back(std::move(variable));
  return VariableOperand(static_cast<int>(program_.variables.size()) - 1);
}

// A number, or that of a member of a structure of the card.
Operand Lowerer::VariableOperand(int variable) const {
  const Variable& named = program_.variables[static_cast<size_t>(variable)];
  Operand operand;
  operand.kind = Operand::Kind::kVariable;
  operand.type = named.type;
  operand.variable = variable;
  if (named.structure == nullptr) return operand;
  operand.kind = Operand::Kind::kMember;
  operand.member = named.member;
  operand.variable -= named.member;
  return operand;
}

int Lowerer::NewLabel(std::string_view wish) {
  out_->labels.push_back(label_names_.Make(wish));
  return static_cast<int>(out_->labels.size()) - 1;
}

int Lowerer::NewLabel(std::string_view construct, SourceRange keyword, std::string_view part) {
  return NewLabel(
      fmt::format("lbl_{}_{}{}{}", construct, LineOf(keyword), part.empty() ? "" : "_", part));
}

// A jump after another one is never reached.
bool Lowerer::EndsInJump() const { return !out_->code.empty() && !out_->code.back().GoesOn(); }

void Lowerer::BeginFullExpression(SourceRange range) {
  statement_ = static_cast<int>(program_.statements.size());
  program_.statements.push_back(range);
}

// Begins a block with names of its own, and an instance of it.
void Lowerer::OpenBlock(const void* block, Scope names) {
  scopes_.push_back(std::move(names));
  BlockInstance instance;
  instance.parent = instance_;
  instance.body = frame_->body;
  instance.block = blocks_.try_emplace(block, static_cast<int>(blocks_.size()) + 1).first->second;
  instance_ = static_cast<int>(out_->instances.size());
  out_->instances.push_back(instance);
}

void Lowerer::CloseBlock() {
  scopes_.pop_back();
  instance_ = out_->instances[static_cast<size_t>(instance_)].parent;
}

bool Lowerer::IsShared(const Operand& operand) const {
  return operand.variable >= 0 &&
         program_.variables[static_cast<size_t>(operand.variable)].role == Variable::Role::kGlobal;
}

std::string_view Lowerer::Source(SourceRange range) const {
  return std::string_view(files_[static_cast<size_t>(range.file)].text())
      .substr(range.begin, range.end - range.begin);
}

int Lowerer::LineOf(SourceRange range) const {
  return files_[static_cast<size_t>(range.file)].LineOf(range.begin);
}

}  // namespace oncard::compiler::lowering
