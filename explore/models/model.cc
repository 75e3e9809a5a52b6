#include "explore/models/model.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "vm/arithmetic.h"
#include "vm/fixed_point.h"
#include "vm/symbol_names.h"

namespace oncard::explore {
namespace {

using vm::DataType;
using vm::IntOf;
using vm::Opcode;

constexpr uint32_t kNoCell = ~uint32_t{0};
constexpr uint32_t kCellMax = 1u << 24;

/// The number of slots of the variables.
uint32_t SlotCount(const std::vector<vm::Symbol>& symbols) {
  uint32_t count = 0;
  for (const vm::Symbol& symbol : symbols) {
    count = std::max(count, static_cast<uint32_t>(symbol.id + symbol.slots()));
  }
  return count;
}

const vm::Symbol* SymbolOfSlot(const std::vector<vm::Symbol>& symbols, uint32_t id) {
  for (const vm::Symbol& symbol : symbols) {
    if (id >= symbol.id && id < uint32_t{symbol.id} + symbol.slots()) return &symbol;
  }
  return nullptr;
}

}  // namespace

std::vector<ThreadSetup> BoundThreads(const vm::Machine& machine) {
  std::vector<ThreadSetup> bound;
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const vm::ThreadState& thread = machine.thread(number);
    if (thread.run == vm::ThreadRun::kUnbound) continue;
    bound.push_back({number, thread.function, thread.page});
  }
  return bound;
}

std::string NameOfSlot(const std::vector<vm::Symbol>& symbols, uint32_t id) {
  const vm::Symbol* symbol = SymbolOfSlot(symbols, id);
  return symbol == nullptr ? std::string()
                           : vm::NameOfElement(*symbol, static_cast<int>(id) - symbol->id);
}

Result<Model> Model::Create(const vm::Machine& machine) {
  Model model;
  model.image_ = machine.shared_image();
  const vm::Object& object = model.image_->object;
  model.wrap_shift_ = vm::WrapShift(object.double_format);
  model.global_count_ = SlotCount(object.globals);
  model.cells_.assign(
      machine.state().globals.begin(),
      machine.state().globals.begin() + static_cast<std::ptrdiff_t>(model.global_count_));
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const vm::ThreadState& state = machine.thread(number);
    if (state.run != vm::ThreadRun::kRunning) continue;
    if (auto added = model.AddThread(number, state, machine); !added.ok()) return added.error();
  }
  if (model.threads_.empty()) {
    return MakeError(1, "no thread runs: there is nothing to explore",
                     "没有运行的线程：没有可探索的内容");
  }
  model.TrackKey(true);
  return model;
}

Result<void> Model::AddThread(int number, const vm::ThreadState& state,
                              const vm::Machine& machine) {
  const vm::Function& function = image_->object.functions[state.function];
  Thread thread;
  thread.setup = {number, state.function, state.page};
  thread.first_local = static_cast<uint32_t>(cells_.size());
  thread.local_count = SlotCount(function.variables);
  thread.position_cell = thread.first_local + thread.local_count;
  thread.end_cell = thread.position_cell + 1;
  thread.result_cell = thread.position_cell + 2;
  const auto& page = machine.state().pages[state.page];
  cells_.insert(cells_.end(), page.begin(),
                page.begin() + static_cast<std::ptrdiff_t>(thread.local_count));
  cells_.resize(size_t{thread.position_cell} + 3);
  if (cells_.size() > kCellMax) {
    return MakeError(1, "the program has too many variables to explore",
                     "程序的变量过多，无法进行交错探索");
  }
  for (const vm::Instruction& instruction : function.instructions) {
    if (instruction.opcode == Opcode::kCommand) {
      return MakeError(1,
                       "function {0} calls a GT command; only programs without GT commands can be "
                       "explored without a card",
                       "函数 {0} 调用了 GT 指令；不带控制卡时只能探索纯变量程序", function.name);
    }
    thread.statements.push_back(Translate(instruction, thread));
  }
  runnable_ |= 1u << threads_.size();
  threads_.push_back(std::move(thread));
  return {};
}

void Model::TrackKey(bool on) {
  track_key_ = on;
  key_ = {};
  for (uint32_t cell = 0; on && cell < cells_.size(); ++cell) AddToKey(cell, cells_[cell], &key_);
}

Model::Operand Model::Translate(const vm::Operand& operand, const Thread& thread,
                                DataType type) const {
  Operand result;
  const auto cell_of = [&](vm::Storage storage, uint16_t id) {
    return storage == vm::Storage::kGlobal ? uint32_t{id} : thread.first_local + id;
  };
  if (const auto* immediate = std::get_if<vm::Immediate>(&operand)) {
    result.constant = type == DataType::kInt ? vm::IntFromFixed(immediate->raw)
                                             : vm::WrapFixed(immediate->raw, wrap_shift_);
  } else if (const auto* variable = std::get_if<vm::Variable>(&operand)) {
    result.place = Place::kCell;
    result.shared = variable->storage == vm::Storage::kGlobal;
    result.cell = cell_of(variable->storage, variable->id);
  } else {
    const auto& element = std::get<vm::Element>(operand);
    result.place = Place::kElement;
    result.shared = element.storage == vm::Storage::kGlobal;
    result.cell = cell_of(element.storage, element.base);
    result.size = element.size;
    result.index_shared = element.index.storage == vm::Storage::kGlobal;
    result.index_cell = cell_of(element.index.storage, element.index.id);
  }
  return result;
}

Model::Statement Model::Translate(const vm::Instruction& instruction, const Thread& thread) const {
  Statement statement;
  statement.opcode = instruction.opcode;
  statement.op = instruction.op;
  statement.type = instruction.type;
  statement.displacement = instruction.displacement;
  const auto& operands = instruction.operands;
  switch (instruction.opcode) {
    case Opcode::kUnary:
      statement.a = Translate(operands[0], thread, instruction.type);
      statement.target = Translate(operands[1], thread, instruction.type);
      break;
    case Opcode::kBinary:
      statement.a = Translate(operands[0], thread, instruction.type);
      statement.b = Translate(operands[1], thread, instruction.type);
      statement.target = Translate(operands[2], thread, instruction.type);
      break;
    case Opcode::kReturn:
      statement.a = Translate(operands[0], thread, DataType::kInt);
      statement.b = Translate(operands[1], thread,
                              image_->object.functions[Index(thread.setup.function)].return_type);
      break;
    case Opcode::kJump:
      statement.a = Translate(operands[0], thread, DataType::kInt);
      break;
    case Opcode::kCommand:
      break;
  }
  for (const Operand* operand : {&statement.a, &statement.b, &statement.target}) {
    statement.shared = statement.shared || operand->shared || operand->index_shared;
  }
  return statement;
}

// --- Checks --------------------------------------------------------------------------------------

void Model::CheckBefore(int thread, size_t position, StatementCheck check) {
  Statement& statement = threads_[Index(thread)].statements[position];
  checks_are_local_ = checks_are_local_ && !check.sees_others;
  checks_.push_back(std::move(check));
  AddCheck(static_cast<uint32_t>(checks_.size() - 1), &statement, &statement.before);
}

void Model::CheckAfterWrites(const StatementCheck& check) {
  checks_are_local_ = checks_are_local_ && !check.sees_others && check.locals.empty();
  checks_.push_back(check);
  const auto number = static_cast<uint32_t>(checks_.size() - 1);
  for (Thread& thread : threads_) {
    for (Statement& statement : thread.statements) {
      const Operand& target = statement.target;
      const uint32_t end = target.cell + (target.place == Place::kElement ? target.size : 1);
      const bool writes = target.shared && std::ranges::any_of(check.globals, [&](uint32_t cell) {
                            return cell >= target.cell && cell < end;
                          });
      if (writes) AddCheck(number, &statement, &statement.after);
    }
  }
}

void Model::AddCheck(uint32_t check, Statement* statement, std::vector<uint32_t>* list) {
  list->push_back(check);
  statement->shared = statement->shared || !checks_[check].globals.empty();
  std::vector<uint32_t> cells;
  for (const std::vector<uint32_t>* each : {&statement->before, &statement->after}) {
    for (const uint32_t other : *each) {
      cells.insert(cells.end(), checks_[other].globals.begin(), checks_[other].globals.end());
    }
  }
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  if (cells.size() > AccessSet::kCheckedMax) checks_are_local_ = false;
}

std::optional<int64_t> Model::FailedOf(const std::vector<uint32_t>& checks) const {
  for (const uint32_t check : checks) {
    if (!checks_[check].holds(*this)) return kFirstCheck + checks_[check].requirement;
  }
  return std::nullopt;
}

void Model::NoteIn(StatementCoverage* coverage) {
  if (coverage->empty()) *coverage = StatementCoverage(image_->object);
  for (Thread& thread : threads_) thread.noted = coverage->BitsOf(Index(thread.setup.function));
}

bool Model::Alike(int thread, int other) const {
  const Thread& one = threads_[Index(thread)];
  const Thread& two = threads_[Index(other)];
  const auto same = [&](const Operand& a, const Operand& b) {
    const auto same_cell = [&](bool shared, uint32_t cell, uint32_t of_other) {
      return shared ? cell == of_other : cell - one.first_local == of_other - two.first_local;
    };
    if (a.place != b.place || a.shared != b.shared || a.constant != b.constant) return false;
    if (a.place == Place::kConstant) return true;
    if (!same_cell(a.shared, a.cell, b.cell)) return false;
    return a.place == Place::kCell || (a.size == b.size && a.index_shared == b.index_shared &&
                                       same_cell(a.index_shared, a.index_cell, b.index_cell));
  };
  const auto alike = [&](const Statement& a, const Statement& b) {
    const bool checked =
        !a.before.empty() || !a.after.empty() || !b.before.empty() || !b.after.empty();
    return !checked && a.opcode == b.opcode && a.op == b.op && a.type == b.type &&
           a.displacement == b.displacement && same(a.a, b.a) && same(a.b, b.b) &&
           same(a.target, b.target);
  };
  return one.local_count == two.local_count && one.dead == two.dead &&
         std::ranges::equal(one.statements, two.statements, alike) &&
         std::ranges::equal(ThreadCells(thread), ThreadCells(other));
}

bool Model::HasLoops() const {
  return std::ranges::any_of(threads_, [](const Thread& thread) {
    return std::ranges::any_of(thread.statements, [](const Statement& statement) {
      return statement.opcode == Opcode::kJump && statement.displacement <= 0;
    });
  });
}

// --- Accesses ----------------------------------------------------------------------------------

uint32_t Model::CellOf(const Operand& operand) const {
  if (operand.place == Place::kCell) return operand.cell;
  const uint32_t index = vm::ToUnsigned(IntOf(cells_[operand.index_cell]));
  return index < operand.size ? operand.cell + index : kNoCell;
}

void Model::Note(const Operand& operand, bool written, AccessSet* set) const {
  if (operand.place == Place::kConstant) return;
  if (operand.place == Place::kElement && operand.index_shared) set->Read(operand.index_cell);
  if (!operand.shared) return;
  const uint32_t cell = CellOf(operand);
  if (cell == kNoCell) return;  // the statement faults before it accesses the array
  if (written) {
    set->write = cell;
  } else {
    set->Read(cell);
  }
}

AccessSet Model::NextAccess(int thread) const {
  AccessSet set = NextOwnAccess(thread);
  const Statement& statement = NextStatement(threads_[Index(thread)]);
  for (const std::vector<uint32_t>* list : {&statement.before, &statement.after}) {
    for (const uint32_t check : *list) {
      for (const uint32_t cell : checks_[check].globals) set.ReadToCheck(cell);
    }
  }
  return set;
}

AccessSet Model::NextOwnAccess(int thread) const {
  const Statement& statement = NextStatement(threads_[Index(thread)]);
  AccessSet set;
  Note(statement.a, false, &set);
  Note(statement.b, false, &set);
  Note(statement.target, true, &set);
  return set;
}

int Model::Line(int thread) const {
  const ThreadSetup& place = setup(thread);
  const auto& lines = image_->object.functions[static_cast<size_t>(place.function)].lines;
  const auto position = static_cast<size_t>(Position(thread));
  return position < lines.size() ? lines[position] : 0;
}

int64_t Model::Read(const vm::SlotAddress& slot) const {
  if (slot.global) return slot.id < global_count_ ? cells_[slot.id] : 0;
  for (const Thread& thread : threads_) {
    if (thread.setup.page == slot.page && slot.id < thread.local_count) {
      return cells_[thread.first_local + slot.id];
    }
  }
  return 0;
}

StateKey Model::GlobalsKey() const {
  StateKey key;
  for (uint32_t cell = 0; cell < global_count_; ++cell) AddToKey(cell, cells_[cell], &key);
  return key;
}

StateKey Model::FinalKey() const {
  StateKey key = GlobalsKey();
  for (const Thread& thread : threads_) {
    AddToKey(thread.end_cell, cells_[thread.end_cell], &key);
    AddToKey(thread.result_cell, cells_[thread.result_cell], &key);
  }
  return key;
}

// --- Parts of the state ------------------------------------------------------------------------

bool Model::AccessesAreLocal() const {
  return checks_are_local_ && std::ranges::none_of(threads_, [](const Thread& thread) {
           return std::ranges::any_of(thread.statements, [](const Statement& statement) {
             return statement.a.index_shared || statement.b.index_shared ||
                    statement.target.index_shared;
           });
         });
}

std::span<const int64_t> Model::ThreadCells(int thread) const {
  const Thread& owner = threads_[Index(thread)];
  return std::span(cells_).subspan(owner.first_local, owner.result_cell + 1 - owner.first_local);
}

void Model::SetThreadCells(int thread, std::span<const int64_t> cells) {
  std::ranges::copy(cells, &cells_[threads_[Index(thread)].first_local]);
  runnable_ &= ~(1u << thread);
  if (Running(thread)) runnable_ |= 1u << thread;
}

void Model::ForgetSteps() {
  journal_.clear();
  marks_.clear();
}

// --- Steps -------------------------------------------------------------------------------------

bool Model::Load(const Operand& operand, int64_t* value) const {
  if (operand.place == Place::kConstant) {
    *value = operand.constant;
    return true;
  }
  const uint32_t cell = CellOf(operand);
  if (cell == kNoCell) return false;
  *value = cells_[cell];
  return true;
}

void Model::Write(uint32_t cell, int64_t value) {
  if (cells_[cell] == value) return;
  journal_.push_back({cell, cells_[cell]});
  Replace(cell, value);
}

void Model::Replace(uint32_t cell, int64_t value) {
  if (track_key_) {
    AddToKey(cell, cells_[cell], &key_);
    AddToKey(cell, value, &key_);
  }
  cells_[cell] = value;
}

void Model::Finish(int thread, int64_t end) {
  Write(threads_[Index(thread)].end_cell, end);
  runnable_ &= ~(1u << thread);
}

ThreadEnd Model::Execute(const Statement& statement, const Thread& thread) {
  int64_t a = 0;
  int64_t b = 0;
  int64_t next = cells_[thread.position_cell] + 1;
  NoteNext(thread, StatementCoverage::kExecuted);
  if (!Load(statement.a, &a)) return ThreadEnd::kIndexOutOfBounds;
  switch (statement.opcode) {
    case Opcode::kUnary:
    case Opcode::kBinary: {
      if (!Load(statement.b, &b)) return ThreadEnd::kIndexOutOfBounds;
      const uint32_t target = CellOf(statement.target);
      if (target == kNoCell) return ThreadEnd::kIndexOutOfBounds;
      if (statement.opcode == Opcode::kUnary) {
        Write(target, vm::EvaluateUnary(static_cast<vm::UnaryOperator>(statement.op),
                                        statement.type, a, wrap_shift_));
        break;
      }
      const std::optional<int64_t> value = vm::EvaluateBinary(
          static_cast<vm::BinaryOperator>(statement.op), statement.type, a, b, wrap_shift_);
      if (!value) return ThreadEnd::kDivisionByZero;
      Write(target, *value);
      break;
    }
    case Opcode::kJump:
      NoteCondition(thread, IntOf(a) != 0);
      if (IntOf(a) != 0) next += statement.displacement - 1;
      break;
    case Opcode::kReturn:
      NoteCondition(thread, IntOf(a) != 0);
      if (IntOf(a) != 0) {
        if (!Load(statement.b, &b)) return ThreadEnd::kIndexOutOfBounds;
        Write(thread.result_cell, b);
        return ThreadEnd::kFinished;
      }
      break;
    case Opcode::kCommand:
      break;
  }
  // Reaching the end of the code is not a statement: the thread stays at its last one.
  if (next >= static_cast<int64_t>(thread.statements.size())) return ThreadEnd::kFinished;
  Replace(thread.position_cell, next);
  return ThreadEnd::kRunning;
}

void Model::Step(int thread) {
  const Thread& taking = threads_[Index(thread)];
  marks_.push_back({static_cast<uint32_t>(journal_.size()), runnable_,
                    static_cast<uint32_t>(cells_[taking.position_cell]),
                    static_cast<uint8_t>(thread), key_});
  const Statement& statement = NextStatement(taking);
  const bool checked = !statement.before.empty() || !statement.after.empty();
  const int64_t end = checked ? ExecuteChecked(statement, taking)
                              : static_cast<int64_t>(Execute(statement, taking));
  if (end != static_cast<int64_t>(ThreadEnd::kRunning)) Finish(thread, end);
}

int64_t Model::ExecuteChecked(const Statement& statement, const Thread& thread) {
  if (const auto failed = FailedOf(statement.before)) return *failed;
  const ThreadEnd end = Execute(statement, thread);
  if (Fails(end)) return static_cast<int64_t>(end);
  const auto failed = FailedOf(statement.after);
  // A statement that fails does so before it writes.
  if (failed) GoBackTo(marks_.back());
  return failed.value_or(static_cast<int64_t>(end));
}

int64_t Model::StepPrivate(int thread, int64_t limit) {
  int64_t steps = 0;
  for (; steps < limit && Running(thread); ++steps) {
    if (!NextIsPrivate(thread) && !NextAccess(thread).empty()) break;
    Step(thread);
  }
  return steps;
}

void Model::ForgetDeadLocals(int thread) {
  const Thread& owner = threads_[Index(thread)];
  if (owner.dead.empty()) return;
  if (Running(thread)) {
    for (const uint32_t slot : owner.dead[static_cast<size_t>(Position(thread))]) {
      Write(owner.first_local + slot, 0);
    }
  } else {
    for (uint32_t slot = 0; slot < owner.local_count; ++slot) Write(owner.first_local + slot, 0);
  }
}

void Model::Undo() {
  GoBackTo(marks_.back());
  marks_.pop_back();
}

void Model::GoBackTo(const Mark& mark) {
  while (journal_.size() > mark.journal) {
    const Change change = journal_.back();
    journal_.pop_back();
    cells_[change.cell] = change.old;
  }
  cells_[threads_[mark.thread].position_cell] = mark.position;
  runnable_ = mark.runnable;
  key_ = mark.key;
}

}  // namespace oncard::explore
