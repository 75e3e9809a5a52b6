// The initial values of globals. A download sets the card's storage to 0, so the thread functions
// have to write them, and no thread may use a global before all of them are written. Every thread
// function begins with
//
//     if (oncard_ready) goto lbl_start;
//     oncard_entered = oncard_entered + 1;
//     if (oncard_written) goto lbl_start_written;
//     speed = 5;                                       // all initial values
//     oncard_written = 1;
//   lbl_start_written:
//     oncard_left = oncard_left + 1;
//   lbl_start_wait:
//     t = oncard_entered != oncard_left;
//     if (t) goto lbl_start_wait;
//     oncard_ready = 1;
//   lbl_start:
//
// The card has no statement that elects one of several threads, but the values are constants, so
// several threads may write them, as long as none goes on while another one still may. A thread
// writes only between its two counts, and it goes on when both counts are equal in one statement,
// when no thread is between them. A thread that counts later finds oncard_written set.
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

void Lowerer::EmitStart(LoweredFunction& function) {
  if (initial_values_.empty()) return;
  if (start_.ready < 0) {
    const Type type;
    const auto make = [this, &type](std::string_view name) {
      return NewGlobal(NewGlobalName(name), type, {}, SourceRange());
    };
    start_.ready = make("oncard_ready");
    start_.entered = make("oncard_entered");
    start_.written = make("oncard_written");
    start_.left = make("oncard_left");
  }
  LoweredFunction* const outer = out_;
  out_ = &function;
  std::vector<Instruction> body = std::move(function.code);
  function.code.clear();
  label_names_ = NameMaker();
  for (const std::string& name : function.labels) label_names_.Reserve(name);
  const SourceRange range = function.header;
  BeginFullExpression(range);
  const Operand one = IntOperand(1);
  const auto add_one = [this, &one, range](int variable) {
    Instruction step;
    step.kind = Instruction::Kind::kBinary;
    step.target = step.a = VariableOperand(variable);
    step.b = one;
    Emit(std::move(step), range);
  };
  const int start = NewLabel("lbl_start");
  const int written = NewLabel("lbl_start_written");
  const int wait = NewLabel("lbl_start_wait");
  EmitIf(VariableOperand(start_.ready), start, range);
  add_one(start_.entered);
  EmitIf(VariableOperand(start_.written), written, range);
  for (const InitialValue& initial : initial_values_) {
    BeginFullExpression(initial.range);
    EmitCopy(initial.target, initial.value, initial.range);
  }
  BeginFullExpression(range);
  EmitCopy(VariableOperand(start_.written), one, range);
  EmitLabel(written, range);
  add_one(start_.left);
  EmitLabel(wait, range);
  const Value waiting = Compute(vm::BinaryOperator::kNotEqual, VariableOperand(start_.entered),
                                VariableOperand(start_.left), BasicType::kInt, range);
  EmitIf(waiting.operand, wait, range);
  EmitCopy(VariableOperand(start_.ready), one, range);
  EmitLabel(start, range);
  function.code.insert(function.code.end(), std::make_move_iterator(body.begin()),
                       std::make_move_iterator(body.end()));
  out_ = outer;
}

}  // namespace oncard::compiler::lowering
