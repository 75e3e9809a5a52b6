#include "explore/models/card_steps.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "explore/models/word_key.h"
#include "gtcalls/gts/numbers.h"
#include "runtime/observe/lasting_access.h"
#include "runtime/observe/quantity.h"
#include "runtime/observe/statement_access.h"
#include "runtime/scenario/run/reaction_conditions.h"
#include "vm/operand_slots.h"

namespace oncard::explore {
namespace {

using gtcalls::Resource;
using runtime::BodyDivision;
using vm::ThreadState;

/// True for what only the thread itself, the clock and the operands of a command are.
bool IsOfStatement(Resource resource) {
  return resource == Resource::kNone || resource == Resource::kClock ||
         resource == Resource::kThread || resource == Resource::kVariable;
}

}  // namespace

CardSteps::CardSteps(CardModel* model, const std::shared_ptr<KnownSteps>& known)
    : CardRows(model, std::shared_ptr<CardRows::Tables>(known, &known->rows)),
      model_(*model),
      card_(*model->controller_),
      known_(*known) {
  for (const CardModel::BoundRequirement& bound : model->requirements_) {
    Names& names = names_.emplace_back();
    AddNames(bound.condition, &names);
    if (bound.then) AddNames(*bound.then, &names);
    if (bound.matters) AddNames(*bound.matters, &names);
    const Scope scope = bound.requirement.scope;
    if (scope == Scope::kFinal) continue;
    watches_time_ = watches_time_ || bound.then || scope == Scope::kEventually;
    AddNames(bound.condition, &watched_);
    if (bound.matters) AddNames(*bound.matters, &watched_);
  }
  for (const runtime::CardCondition& condition :
       runtime::ConditionsOfReactions(model->scenario_.world, card_)) {
    AddNames(condition, &reaction_names_);
  }
  PlanInstructions();
}

void CardSteps::AddNames(const runtime::CardCondition& condition, Names* names) {
  for (const runtime::Quantity& quantity : condition.quantities()) {
    if (!runtime::IsOfProgram(quantity.kind)) {
      names->body = true;
    } else if (quantity.kind == runtime::QuantityKind::kVariable && quantity.slot.global) {
      names->globals = true;
    } else {
      names->threads = true;
      names->globals = true;  // pages without a thread are among them
    }
  }
}

void CardSteps::AddToKey(const Row& row, const Names& names) {
  if (names.globals) key_.push_back(GlobalsNumber(row));
  if (names.body) key_.push_back(BodyOf(row).present);
  if (!names.threads) return;
  for (size_t place = 0; place < thread_count(); ++place) key_.push_back(ThreadNumber(row, place));
}

void CardSteps::PlanInstructions() {
  const auto add_operand = [](const vm::Operand& operand, Instruction* plan) {
    vm::ForEachNamedSlot(operand, vm::Storage::kGlobal, [&](uint32_t slot) {
      plan->globals.push_back(static_cast<uint16_t>(slot));
    });
  };
  const auto add_command = [&](uint16_t number, Instruction* plan) {
    plan->command = card_.family().catalogue.Find(number);
    // An argument can stand for the variables behind it, too.
    plan->all_globals = !plan->globals.empty();
    plan->alone = plan->command == nullptr;
    if (plan->alone) return;
    plan->looks_around = model_.supervisor_->LooksAround(*plan->command);
    for (const gtcalls::Access& access : plan->command->accesses) {
      const Resource resource = access.resource;
      if (resource == Resource::kProgram || resource == Resource::kEverything) plan->alone = true;
      if (IsOfStatement(resource)) continue;
      plan->reads_body = true;
      plan->changes_body = plan->changes_body || access.write;
    }
  };
  for (const vm::Function& function : model_.image_->object.functions) {
    std::vector<Instruction>& plans = instructions_.emplace_back();
    for (const vm::Instruction& instruction : function.instructions) {
      Instruction& plan = plans.emplace_back();
      for (const vm::Operand& operand : instruction.operands) add_operand(operand, &plan);
      if (instruction.opcode != vm::Opcode::kCommand) continue;
      add_command(instruction.op, &plan);
      PlanOutputs(instruction, &plan);
    }
    for (const vm::Assert& each : function.asserts) {
      if (each.position < plans.size()) plans[each.position].alone = true;
    }
  }
}

void CardSteps::PlanOutputs(const vm::Instruction& instruction, Instruction* plan) const {
  const vm::CommandShape* shape = card_.commands().Find(instruction.op);
  if (plan->command == nullptr || shape == nullptr || plan->changes_body) return;
  const auto& operands = instruction.operands;
  for (size_t i = 0; i < operands.size() && i < shape->parameters.size(); ++i) {
    const vm::ParameterShape& parameter = shape->parameters[i];
    const auto* variable = std::get_if<vm::Variable>(&operands[i]);
    if (!parameter.address || parameter.elements_on_card || variable == nullptr) continue;
    if (plan->command->parameters[i].passing != gtcalls::Passing::kOutput) continue;
    if (variable->storage != vm::Storage::kLocal) continue;
    int64_t elements = 1;
    if (parameter.count_parameter >= 0) {
      const auto* count =
          std::get_if<vm::Immediate>(&operands[static_cast<size_t>(parameter.count_parameter)]);
      if (count == nullptr) continue;
      elements = count->raw >> vm::kFractionBits;
    }
    const int64_t slots = elements * static_cast<int64_t>(parameter.slots.size());
    if (slots <= 0 || variable->id + slots > vm::kSlotCount) continue;
    plan->outputs.operands.push_back(i);
    for (int64_t slot = 0; slot < slots; ++slot) {
      plan->outputs.slots.push_back(static_cast<uint16_t>(variable->id + slot));
    }
  }
}

// --- Steps ---------------------------------------------------------------------------------------

CardSteps::Row CardSteps::Start() { return RowOfCard(model_.Start()); }

CardSteps::Row CardSteps::From(const CardModel::State& state) {
  model_.Load(state);
  return RowOfCard(state);
}

CardSteps::Row CardSteps::StepAlone(const Row& from, int thread) {
  Load(from);
  CardModel::State state = StateFor(from);
  model_.Execute(&state, thread);
  return RowOfCard(state);
}

CardSteps::Row CardSteps::Step(const Row& from, int thread) {
  const size_t place = PlaceOf(thread);
  const Statement& statement = StatementOf(from, place);
  if (statement.alone) return StepAlone(from, thread);
  Row row = from;
  SetThread(place, statement.thread, &row);
  if (statement.history) row.history = *statement.history;
  if (!statement.globals.empty()) WriteGlobals(statement.globals, &row);
  if (!statement.body.empty()) SetBodyParts(statement.body, &row);
  NoteStatement(place, &row);
  const bool judges = MayViolate(from, row);
  const bool goes_on = ProgressOf(row).left > 0 && Runnable(row) != 0;
  if (SomeoneFinishes(row)) return StepAlone(from, thread);
  if (!judges && goes_on) return row;
  Progress progress = ProgressOf(row);
  const bool known = (!judges || Judge(row, &progress)) && Settle(&row, &progress);
  if (!known) return StepAlone(from, thread);
  SetProgress(std::move(progress), &row);
  return row;
}

bool CardSteps::MayViolate(const Row& before, const Row& after) const {
  if (!model_.has_invariants_) return false;
  return watches_time_ || watched_.threads ||
         (watched_.globals && GlobalsNumber(before) != GlobalsNumber(after)) ||
         (watched_.body && BodyNumber(before) != BodyNumber(after));
}

CardSteps::Row CardSteps::EndCycle(const Row& from) {
  const Progress& before = ProgressOf(from);
  Progress progress = {.reached = before.reached, .owed = before.owed};
  Row row = from;
  const bool known = row.finished ? NextCycle(&row, &progress) : Settle(&row, &progress);
  if (known) {
    SetProgress(std::move(progress), &row);
    return row;
  }
  const CardModel::State whole = model_.EndCycle(Whole(from));
  return RowOfCard(whole);
}

bool CardSteps::Settle(Row* row, Progress* progress) {
  for (;;) {
    const int64_t cycle = CycleOf(*row);
    bool quiet = true;
    bool sleeps = false;
    for (size_t place = 0; place < thread_count(); ++place) {
      const Position& thread = PositionOf(*row, place);
      quiet = quiet && !thread.running;
      sleeps = sleeps || (thread.running && thread.wake_cycle > cycle);
    }
    if (quiet) {
      row->finished = model_.others_end_runs_;
      return model_.others_end_runs_;
    }
    const uint32_t runnable = Runnable(*row);
    if (progress->left > 0 && runnable != 0) return true;
    if (runnable == 0 && !sleeps) return false;
    if (cycle >= model_.bounds_.last() || !NextCycle(row, progress)) return false;
  }
}

bool CardSteps::NextCycle(Row* row, Progress* progress) {
  const int64_t cycle = CycleOf(*row);
  for (const CardModel::BoundRequirement& bound : model_.requirements_) {
    if (bound.cycle == cycle) return false;
  }
  const Cycle& next = CycleAfter(*row);
  SetBody(next.body, row);
  row->history = next.history;
  progress->left = next.statements;
  progress->served = 0;
  if (SomeoneFinishes(*row)) return false;
  return !model_.has_invariants_ || Judge(*row, progress);
}

const CardSteps::Cycle& CardSteps::CycleAfter(const Row& row) {
  const Body& body = BodyOf(row);
  const auto key_with = [&](uint32_t number) {
    key_.assign({number, row.history});
    // Commands that a path has reached, and reactions, look at more than the body.
    if (!body.apart) key_.push_back(GlobalsNumber(row));
    AddToKey(row, reaction_names_);
    return KeyOfWords(key_);
  };
  bool executed = false;
  const auto execute = [&] {
    executed = true;
    return ExecuteCycle(row);
  };
  const uint32_t number = known_.cycles.NumberOf(key_with(BodyNumber(row)), [&] {
    if (body.event_soon) return execute();
    const PresentCycle& next = known_.present_cycles.Of(key_with(body.present), [&] {
      const Cycle cycle = execute();
      return PresentCycle{BodyWith(cycle.body).parts, cycle.history, cycle.statements, cycle.tells};
    });
    std::vector<uint32_t> parts = next.parts;
    parts[BodyDivision::kWorld] = body.parts[BodyDivision::kWorld];
    return Cycle{NumberOfParts(std::move(parts)), next.history, next.statements, next.tells};
  });
  const Cycle& cycle = known_.cycles[number];
  if (cycle.tells && told_cycles_.insert(number).second && !executed) execute();
  return cycle;
}

CardSteps::Cycle CardSteps::ExecuteCycle(const Row& row) {
  Load(row);
  const gtcalls::Family& family = card_.family();
  const bool acts = family.cycles_before_act(card_.view()) != gtcalls::kNeverActs ||
                    family.writes_variables(card_.view());
  const int64_t told = Told();
  const int64_t statements = model_.BeginCycle();
  bool same = !acts && NumberOfGlobals() == GlobalsNumber(row);
  for (size_t place = 0; place < thread_count(); ++place) {
    same = same && NumberOfThread(place) == ThreadNumber(row, place);
  }
  exact_ = exact_ && same;
  return {NumberOfBody(), NumberOfHistory(), statements, Told() != told};
}

int64_t CardSteps::Told() const {
  int64_t told = 0;
  for (const runtime::RefusedCommand& refused : model_.refused()) told += refused.count;
  for (const runtime::CardFinding& finding : model_.found()) told += finding.count;
  return told;
}

bool CardSteps::Judge(const Row& row, Progress* progress) {
  uint32_t bit = 1;
  for (size_t i = 0; i < model_.requirements_.size(); ++i) {
    const CardModel::BoundRequirement& bound = model_.requirements_[i];
    const Scope scope = bound.requirement.scope;
    if (scope == Scope::kFinal) continue;
    const Judgement judgement = JudgementOf(row, i);
    if (bound.then) {
      runtime::Owed& owed = progress->owed[bound.response];
      owed.Observe(bound.requirement, judgement.holds, judgement.answers,
                   card_.clock().NsOf(CycleOf(row)), 0);
      if (owed.late) return false;
    } else if (scope == Scope::kEventually) {
      if (judgement.holds) progress->reached |= bit;
      bit <<= 1;
    } else if (!judgement.holds) {
      return false;
    }
  }
  return true;
}

const CardSteps::Judgement& CardSteps::JudgementOf(const Row& row, size_t requirement) {
  const CardModel::BoundRequirement& bound = model_.requirements_[requirement];
  key_.assign({static_cast<int64_t>(requirement)});
  AddToKey(row, names_[requirement]);
  const Judgement& judgement = known_.judgements.Of(KeyOfWords(key_), [&] {
    Load(row);
    return Judgement{.holds = model_.Holds(bound),
                     .answers = bound.then && bound.then->Holds(card_),
                     .mattered = bound.matters && bound.matters->Holds(card_)};
  });
  // It may be known from the search of another case.
  bound.judged = true;
  bound.mattered = bound.mattered || judgement.mattered;
  return judgement;
}

// --- Statements ----------------------------------------------------------------------------------

const CardSteps::Statement& CardSteps::StatementOf(const Row& row, size_t place) {
  static const Statement kAlone = {
      .alone = true, .thread = 0, .history = {}, .globals = {}, .body = {}};
  const Position& thread = PositionOf(row, place);
  const std::vector<Instruction>& function = instructions_[thread.function];
  if (thread.pc >= function.size()) return kAlone;
  const Instruction& instruction = function[thread.pc];
  if (instruction.alone) return kAlone;
  if (instruction.sees_others()) return FindStatement(row, place, instruction);
  const bool globals = instruction.all_globals || !instruction.globals.empty();
  return recent_statements_.Of(
      {static_cast<uint32_t>(place), ThreadNumber(row, place), globals ? GlobalsNumber(row) : 0,
       instruction.command != nullptr ? BodyNumber(row) : 0},
      [&]() -> const Statement& { return FindStatement(row, place, instruction); });
}

const CardSteps::Statement& CardSteps::FindStatement(const Row& row, size_t place,
                                                     const Instruction& instruction) {
  const BodyAccess* access = nullptr;
  if (instruction.reads_body) access = &AccessOf(row, place, instruction);
  key_.assign({static_cast<int64_t>(place), ThreadNumber(row, place)});
  AddToKey(row, instruction, access);
  bool executed = false;
  const auto execute = [&] {
    executed = true;
    const int64_t told = Told();
    Statement statement = Execute(row, place, instruction, access);
    statement.tells = Told() != told;
    return statement;
  };
  const uint32_t number = known_.statements.NumberOf(KeyOfWords(key_), execute);
  const Statement& statement = known_.statements[number];
  if (statement.tells && told_statements_.insert(number).second && !executed) execute();
  return statement;
}

void CardSteps::AddToKey(const Row& row, const Instruction& instruction, const BodyAccess* access) {
  if (instruction.all_globals) {
    key_.push_back(GlobalsNumber(row));
  } else {
    for (const uint16_t slot : instruction.globals) key_.push_back(ValueOf(row, slot));
  }
  const Body& body = BodyOf(row);
  if (instruction.command != nullptr) key_.push_back(body.parts[BodyDivision::kClock]);
  if (access != nullptr && access->whole) {
    key_.push_back(BodyNumber(row));
  } else if (access != nullptr) {
    key_.push_back(body.parts[BodyDivision::kIo]);
    key_.push_back(body.parts[BodyDivision::kRest]);
    for (const size_t part : access->parts) key_.push_back(body.parts[part]);
  }
  // The supervisor looks at a command that changes something.
  if (instruction.changes_body) {
    key_.push_back(row.history);
    for (size_t other = 0; other < thread_count(); ++other) {
      key_.push_back(vm::IsActive(ThreadOf(row, other).state));
    }
  }
  if (!instruction.looks_around) return;
  uint32_t awaited = runtime::Supervisor::AwaitedProfiles(HistoryOf(row));
  for (; awaited != 0; awaited &= awaited - 1) {
    const size_t part = BodyDivision::kFirstAxis + static_cast<size_t>(std::countr_zero(awaited));
    if (part < body.parts.size()) key_.push_back(body.parts[part]);
  }
}

CardSteps::Statement CardSteps::Execute(const Row& row, size_t place,
                                        const Instruction& instruction, const BodyAccess* access) {
  if (instruction.command == nullptr) {
    LoadMachine(row);
  } else {
    Load(row);
  }
  model_.NoteCoverage(NumberOnCard(place));
  card_.machine().ExecuteOne(NumberOnCard(place));
  Statement statement;
  statement.thread = NumberOfThread(place);
  statement.alone = ThreadWith(statement.thread).state.run == vm::ThreadRun::kFaulted;
  bool declared = true;
  for (size_t other = 0; other < thread_count(); ++other) {
    if (other != place) declared = declared && NumberOfThread(other) == ThreadNumber(row, other);
  }
  bool others = false;
  statement.globals = Differences(GlobalsNumber(row), NumberOfGlobals(), &others);
  declared = declared && !others;
  for (const GlobalWrite& write : statement.globals) {
    const bool named =
        std::ranges::find(instruction.globals, write.slot) != instruction.globals.end();
    declared = declared && (named || instruction.all_globals);
  }
  if (access != nullptr) {
    const std::vector<uint32_t>& before = BodyOf(row).parts;
    const std::vector<uint32_t>& after = BodyWith(NumberOfBody()).parts;
    for (size_t part = 0; part < before.size(); ++part) {
      if (before[part] == after[part]) continue;
      statement.body.emplace_back(part, after[part]);
      const bool written = std::ranges::find(access->written, part) != access->written.end();
      declared = declared && (written || access->whole);
    }
  }
  exact_ = exact_ && declared;
  if (model_.supervisor_->history() != HistoryOf(row)) {
    statement.history = NumberOfHistory();
    statement.alone = statement.alone || !instruction.changes_body;
  }
  if (watches_outputs_ && !instruction.outputs.slots.empty()) {
    statement.writes_outputs = WritesOutputs(row, place, instruction, ThreadWith(statement.thread));
  }
  return statement;
}

bool CardSteps::WritesOutputs(const Row& row, size_t place, const Instruction& instruction,
                              const Thread& after) {
  if (after.state.error != vm::kOk) return false;
  // What it does not write stays different when it is executed with other values.
  Load(row);
  const ThreadState& thread = ThreadOf(row, place).state;
  vm::Machine& machine = card_.machine();
  const auto slot_of = [&](uint16_t slot) {
    return vm::SlotAddress{false, thread.page, slot, vm::DataType::kDouble};
  };
  for (const uint16_t slot : instruction.outputs.slots) {
    machine.WriteRaw(slot_of(slot), machine.ReadRaw(slot_of(slot)) ^ 1);
  }
  machine.ExecuteOne(NumberOnCard(place));
  return std::ranges::all_of(instruction.outputs.slots, [&](uint16_t slot) {
    const int64_t value = slot < after.page.size() ? after.page[slot] : 0;
    return machine.ReadRaw(slot_of(slot)) == value;
  });
}

const CardSteps::BodyAccess& CardSteps::AccessOf(const Row& row, size_t place,
                                                 const Instruction& instruction) {
  static const BodyAccess kWhole = {.whole = true, .parts = {}, .written = {}};
  if (!BodyOf(row).apart) return kWhole;
  key_.assign({static_cast<int64_t>(place), ThreadNumber(row, place),
               BodyOf(row).parts[BodyDivision::kRest]});
  if (instruction.all_globals) key_.push_back(GlobalsNumber(row));
  return known_.accesses.Of(KeyOfWords(key_), [&] {
    Load(row);
    return NextBodyAccess(NumberOnCard(place));
  });
}

CardSteps::BodyAccess CardSteps::NextBodyAccess(int number) const {
  const runtime::StatementAccess touched = runtime::NextPreciseAccess(card_, number);
  const bool sets_axis = std::ranges::any_of(touched, [](const runtime::Touched& each) {
    return each.write && runtime::IsOfAxis(each.resource);
  });
  BodyAccess access;
  const auto add = [&](size_t part, bool write) {
    access.parts.push_back(part);
    if (write) access.written.push_back(part);
  };
  for (const runtime::Touched& each : touched) {
    const auto word = static_cast<int>(each.number);
    if (IsOfStatement(each.resource)) continue;
    if (runtime::IsOfAxis(each.resource) && each.number >= 1 &&
        each.number <= division().axis_count()) {
      add(BodyDivision::kFirstAxis + each.number - 1, each.write);
    } else if (each.resource == Resource::kDigitalInput && !each.write &&
               gtcalls::gts::DiTypeOf(word) == motion::DiType::kGpi) {
      add(BodyDivision::kIo, false);
    } else if (each.resource == Resource::kDigitalOutput &&
               (gtcalls::gts::DoTypeOf(word) == motion::DoType::kGpo ||
                (each.write && sets_axis))) {
      add(BodyDivision::kIo, each.write);
    } else {
      // Other inputs and outputs are those of axes.
      access.whole = true;
    }
  }
  return access;
}

runtime::StatementAccess CardSteps::NewLastingAccess(const Row& row, int thread) {
  const size_t place = PlaceOf(thread);
  key_.assign({static_cast<int64_t>(place), ThreadNumber(row, place), GlobalsNumber(row)});
  const Body& body = BodyOf(row);
  key_.push_back(body.apart ? body.parts[BodyDivision::kRest] : BodyNumber(row));
  key_.push_back(body.apart);
  if (!lasting_.Insert(KeyOfWords(key_))) return {};
  Load(row);
  return runtime::NextLastingAccess(card_, NumberOnCard(place));
}

}  // namespace oncard::explore
