#include "explore/models/card_model.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <variant>

#include "base/milliseconds.h"
#include "explore/models/word_key.h"
#include "runtime/observe/lasting_access.h"
#include "runtime/observe/moving_axes.h"
#include "runtime/observe/statement_access.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "vm/thread_words.h"

namespace oncard::explore {

/// The state around the machine with its hash, by which states are distinguished.
struct CardModel::Body {
  /// The body after a number of cycles in which no command changes it.
  struct Later {
    int64_t cycles = 0;
    std::weak_ptr<const Body> body;
  };

  runtime::CardBody values;
  uint64_t hash = 0;
  mutable std::vector<Later> later = {};  ///< those that states still have
};

namespace {

using vm::ThreadState;

/// True for a statement that may change the card outside the machine.
bool ChangesBody(const vm::Instruction& instruction, const gtcalls::Catalogue& catalogue) {
  if (instruction.opcode != vm::Opcode::kCommand) return false;
  const gtcalls::Command* command = catalogue.Find(instruction.op);
  return command == nullptr ||
         std::ranges::any_of(command->accesses, [](const gtcalls::Access& access) {
           return access.write && access.resource != gtcalls::Resource::kThread &&
                  access.resource != gtcalls::Resource::kVariable;
         });
}

/// True if a condition names more than variables and threads.
bool NamesCard(const runtime::CardCondition& condition) {
  return !std::ranges::all_of(condition.quantities(), [](const runtime::Quantity& quantity) {
    return runtime::IsOfProgram(quantity.kind);
  });
}

/// True if a condition names how many statements were executed.
bool CountsStatements(const runtime::CardCondition& condition) {
  return std::ranges::any_of(condition.quantities(), [](const runtime::Quantity& quantity) {
    return quantity.kind == runtime::QuantityKind::kThreadStatements ||
           quantity.kind == runtime::QuantityKind::kStatements;
  });
}

/// What a condition is read from.
runtime::StatementAccess AccessOf(const runtime::CardCondition& condition,
                                  const runtime::Controller& controller) {
  runtime::StatementAccess access;
  for (const runtime::Quantity& quantity : condition.quantities()) {
    runtime::AddAccesses(runtime::LastingAccessOf(quantity, controller), &access);
  }
  return access;
}

/// The values of all globals.
std::vector<int64_t> GlobalsOf(const CardModel::State& state) {
  const std::span<const int64_t> packed = state.variables.Globals();
  std::vector<int64_t> globals(packed.begin(), packed.end());
  globals.resize(vm::kSlotCount);
  return globals;
}

}  // namespace

CardModel::CardModel(const runtime::Scenario& scenario)
    : scenario_(scenario),
      controller_(std::make_unique<runtime::Controller>(runtime::CardOptions(scenario))),
      supervisor_(std::make_unique<runtime::Supervisor>(controller_.get())),
      asserts_(runtime::ProgramPath(scenario)) {
  controller_->CollectRefusals(refused_.get());
}

Result<CardModel> CardModel::Create(const runtime::Scenario& scenario,
                                    const std::vector<Requirement>& requirements, vm::Object object,
                                    runtime::ScenarioErrors errors) {
  CardModel model(scenario);
  runtime::Controller& controller = *model.controller_;
  auto started = runtime::StartScenario(scenario, std::move(object), &controller, &errors);
  if (!started.ok()) return started.error();
  // A run of a failing schedule traces them.
  runtime::TraceQuantities(scenario, controller, &errors);
  runtime::CheckTimes(requirements, scenario, controller.machine().image()->object, &errors);
  model.KeepThreads(BoundThreads(controller.machine()));
  model.bounds_ = runtime::RunBounds::Of(scenario, model.controller_->clock());
  if (scenario.until_us && model.bounds_.kind_of_last() == runtime::RunOver::kUntil) {
    model.horizon_.at_ms = ToMs(*scenario.until_us);
  }
  model.BindRequirements(requirements, &errors);
  model.BindRaces(&errors);
  if (auto failure = errors.Failure()) return *std::move(failure);
  // If no thread runs, the card continues until then, as in a run.
  if (scenario.until_us) model.last_instant_ = model.bounds_.last();
  model.Save(&model.initial_);
  return model;
}

Result<CardModel> CardModel::CreateFromCalls(const runtime::Scenario& scenario,
                                             const std::vector<Requirement>& requirements,
                                             std::shared_ptr<const runtime::HostCalls> calls,
                                             runtime::ScenarioErrors errors) {
  auto host = HostEvents::Create(scenario, std::move(calls));
  if (!host.ok()) return host.error();
  CardModel model(scenario);
  model.host_ = std::make_shared<const HostEvents>(std::move(host).value());
  model.host_->Prepare(scenario, model.controller_.get());
  model.KeepThreads(model.host_->threads());
  const int64_t end = model.host_->end_cycle();
  model.bounds_.may_last = runtime::MayLastForEver(scenario);
  if (model.host_->cut()) {
    model.bounds_.until = end;
    model.horizon_.at_ms = ToMs(model.controller_->clock().UsOf(end));
  } else {
    model.bounds_.limit = end + model.controller_->clock().CyclesIn(scenario.limit_ms * 1000);
  }
  runtime::CheckTimes(requirements, true, model.controller_->clock().UsOf(model.bounds_.last()),
                      &errors);
  model.BindRequirements(requirements, &errors);
  model.BindRaces(&errors);
  if (auto failure = errors.Failure()) return *std::move(failure);
  model.Save(&model.initial_);
  return model;
}

void CardModel::KeepThreads(std::vector<ThreadSetup> threads) {
  const vm::Machine& machine = controller_->machine();
  image_ = machine.shared_image();
  scratch_ = std::make_unique<vm::MachineState>(machine.state());
  setups_ = std::move(threads);
  if (image_ != nullptr) coverage_ = StatementCoverage(image_->object);
}

void CardModel::BindRequirements(const std::vector<Requirement>& requirements,
                                 runtime::ScenarioErrors* errors) {
  asserts_.Begin(*controller_, errors);
  for (const runtime::Expectation& expectation : scenario_.expectations) {
    if (!errors->CanJudge(expectation.text())) continue;
    auto bound = runtime::CardCondition::Bind(expectation.condition, *controller_);
    if (!bound.ok()) {
      errors->AddText(expectation.place, expectation.text(), bound.error().message);
      continue;
    }
    for (const runtime::Quantity& quantity : bound.value().quantities()) {
      if (quantity.kind == runtime::QuantityKind::kThreadError) {
        fault_expected_ |= 1u << quantity.thread;
      }
    }
    BoundRequirement requirement = {{Scope::kFinal, expectation.text()}, std::move(bound).value()};
    if (expectation.at_us) {
      requirement.cycle = controller_->clock().CycleAt(*expectation.at_us);
      last_instant_ = std::max(last_instant_, requirement.cycle);
      if (requirement.cycle > bounds_.last()) {
        errors->Add(expectation.place,
                    MakeMessage("the expectation '{0}' is later than the end of the run",
                                "期望“{0}”的时刻在运行结束之后", expectation.text()));
      }
    }
    requirements_.push_back(std::move(requirement));
  }
  auto conditions =
      runtime::ReadRequirements<runtime::CardCondition>(requirements, *controller_, errors);
  if (conditions.size() < requirements.size()) return;
  for (size_t i = 0; i < requirements.size(); ++i) {
    const Scope scope = requirements[i].scope;
    has_invariants_ = has_invariants_ || scope != Scope::kFinal;
    auto& [condition, then] = conditions[i];
    const bool of_every_state = scope != Scope::kFinal && scope != Scope::kEventually;
    const bool names_card = NamesCard(condition) || (then && NamesCard(*then));
    watches_card_ = watches_card_ || (of_every_state && names_card);
    BoundRequirement& bound =
        requirements_.emplace_back(BoundRequirement{requirements[i], std::move(condition)});
    if (!then) continue;
    bound.then = std::move(then);
    bound.response = initial_.owed.size();
    initial_.owed.emplace_back();
  }
  BindGuards();
  counts_statements_ = AnyCountsStatements();
}

template <typename Look>
void CardModel::ForEachCondition(const Look& look) const {
  for (const BoundRequirement& bound : requirements_) {
    look(bound.condition);
    if (bound.then) look(*bound.then);
    if (bound.matters) look(*bound.matters);
  }
  for (const Requirement& assert : asserts_.asserts()) {
    for (const ThreadSetup& setup : setups_) {
      const auto read =
          runtime::CardCondition::ReadInThread(assert.text, setup.thread, *controller_);
      if (read.ok()) look(read.value());
    }
  }
  for (const runtime::InputReaction& reaction : scenario_.world.reactions) {
    const auto read = runtime::CardCondition::Read(reaction.when, *controller_);
    if (read.ok()) look(read.value());
  }
}

bool CardModel::AnyCountsStatements() const {
  bool any = false;
  ForEachCondition(
      [&](const runtime::CardCondition& condition) { any = any || CountsStatements(condition); });
  return any;
}

std::vector<vm::SlotAddress> CardModel::NamedLocals() const {
  std::vector<vm::SlotAddress> slots;
  ForEachCondition([&](const runtime::CardCondition& condition) {
    for (const runtime::Quantity& quantity : condition.quantities()) {
      const bool local = quantity.kind == runtime::QuantityKind::kVariable && !quantity.slot.global;
      if (local) slots.push_back(quantity.slot);
    }
  });
  return slots;
}

void CardModel::BindGuards() {
  for (BoundRequirement& bound : requirements_) {
    bound.guard = runtime::GuardOf(bound.requirement);
    if (!bound.guard) continue;
    auto matters = runtime::CardCondition::Bind(bound.guard->matters, *controller_);
    if (matters.ok()) bound.matters = std::move(matters).value();
  }
}

void CardModel::BindRaces(runtime::ScenarioErrors* errors) {
  const RaceRule rule = *RaceRuleNamed(scenario_.races);
  const runtime::TextPlace place = runtime::PlaceOfText(scenario_, "races");
  if (host_ != nullptr) {
    if (rule == RaceRule::kAny) return;
    return errors->Add(
        place, {"data races and owners of axes are not looked for where a recorded host starts the "
                "threads: explore a scenario that starts them",
                "主机记录中不查找数据竞争与轴的归属：请探索由场景启动线程的程序"});
  }
  std::vector<bool> ordering = runtime::OrderingGlobals(scenario_, *controller_, errors);
  if (rule == RaceRule::kBenign) {
    errors->Add(place,
                {"whether a race is benign is known only in programs without GT commands: "
                 "use races = \"none\" with the card, or explore the functions without GT "
                 "commands separately",
                 "仅对不含 GT 指令的程序能判断竞争是否无害：带控制卡时请使用 races = \"none\"，"
                 "或单独探索不含 GT 指令的函数"});
  }
  if (rule != RaceRule::kNone) return;
  std::vector<int> threads;
  for (const ThreadSetup& setup : setups_) threads.push_back(setup.thread);
  races_ = std::make_shared<const CardRaces>(std::move(ordering), std::move(threads));
}

std::vector<Message> CardModel::UntestedRequirements() const {
  std::vector<Message> texts;
  for (const BoundRequirement& bound : requirements_) {
    const Scope scope = bound.requirement.scope;
    if (!bound.judged && scope != Scope::kEventually) {
      texts.push_back(MakeMessage("no run came to where '{0}' is checked",
                                  "没有运行到达检查“{0}”的时刻", bound.requirement.Title()));
    } else if (bound.matters && !bound.mattered) {
      texts.push_back(runtime::DescribeVacuous(bound.requirement, *bound.guard));
    }
  }
  for (Message& untested : asserts_.DescribeUntested()) texts.push_back(std::move(untested));
  return texts;
}

std::vector<std::string> CardModel::HeldSoFar() const {
  std::vector<std::string> titles;
  for (const BoundRequirement& bound : requirements_) {
    if (!bound.judged || bound.requirement.scope == Scope::kEventually) continue;
    if (!bound.matters || bound.mattered) titles.push_back(bound.requirement.Title());
  }
  return titles;
}

std::vector<Message> CardModel::Untested() const {
  std::vector<Message> texts = UntestedRequirements();
  for (Message& late :
       runtime::DescribeLateEvents(scenario_.world, controller_->clock().UsOf(latest_end_), true)) {
    texts.push_back(std::move(late));
  }
  if (const runtime::Reactions* reactions = controller_->reactions()) {
    for (Message& idle :
         runtime::DescribeIdleReactions(scenario_.world, reactions->started(), true)) {
      texts.push_back(std::move(idle));
    }
  }
  return texts;
}

std::vector<Requirement> CardModel::Requirements() const {
  std::vector<Requirement> requirements;
  for (const BoundRequirement& bound : requirements_) requirements.push_back(bound.requirement);
  const std::vector<Requirement>& asserts = asserts_.asserts();
  requirements.insert(requirements.end(), asserts.begin(), asserts.end());
  return requirements;
}

// --- What must hold ------------------------------------------------------------------------------

const runtime::Owed& CardModel::OwedTo(const State& state, int requirement) const {
  return state.owed[requirements_[static_cast<size_t>(requirement)].response];
}

void CardModel::ObserveResponse(const BoundRequirement& bound, runtime::Owed* owed) const {
  const int64_t now_ns = controller_->clock().NsOf(controller_->cycle());
  owed->Observe(bound.requirement, Holds(bound), bound.then->Holds(*controller_), now_ns,
                controller_->machine().state().executed);
}

bool CardModel::Holds(const BoundRequirement& bound) const {
  bound.judged = true;
  bound.mattered = bound.mattered || (bound.matters && bound.matters->Holds(*controller_));
  return bound.condition.Holds(*controller_) != (bound.requirement.scope == Scope::kNever);
}

void CardModel::JudgeEnd(State* state) const {
  uint32_t bit = 1;
  for (size_t i = 0; i < requirements_.size() && !state->fault; ++i) {
    const BoundRequirement& bound = requirements_[i];
    bool holds = true;
    if (bound.requirement.scope == Scope::kEventually) {
      holds = (state->reached & bit) != 0;
      bit <<= 1;
    } else if (bound.requirement.scope == Scope::kLeads) {
      holds = !state->owed[bound.response].pending;
    } else if (bound.requirement.scope == Scope::kFinal && bound.cycle < 0) {
      holds = Holds(bound);
    }
    if (!holds) state->fault = {Fault::Kind::kRequirement, static_cast<int>(i), 0};
  }
}

void CardModel::JudgeState(State* state) const {
  uint32_t bit = 1;
  for (size_t i = 0; i < requirements_.size() && !state->fault; ++i) {
    const BoundRequirement& bound = requirements_[i];
    if (bound.requirement.scope == Scope::kFinal) continue;
    if (bound.then) {
      runtime::Owed& owed = state->owed[bound.response];
      ObserveResponse(bound, &owed);
      if (owed.late) state->fault = {Fault::Kind::kRequirement, static_cast<int>(i), 0};
      continue;
    }
    const bool holds = Holds(bound);
    if (bound.requirement.scope == Scope::kEventually) {
      if (holds) state->reached |= bit;
      bit <<= 1;
    } else if (!holds) {
      state->fault = {Fault::Kind::kRequirement, static_cast<int>(i), 0};
    }
  }
}

void CardModel::JudgeInstant(State* state) const {
  for (size_t i = 0; i < requirements_.size() && !state->fault; ++i) {
    const BoundRequirement& bound = requirements_[i];
    if (bound.cycle == controller_->cycle() && !Holds(bound)) {
      state->fault = {Fault::Kind::kRequirement, static_cast<int>(i), 0};
    }
  }
}

void CardModel::JudgeThreads(State* state) const {
  for (int i = 0; i < thread_count() && !state->fault; ++i) {
    const int number = setup(i).thread;
    if (controller_->machine().thread(number).run != vm::ThreadRun::kFaulted) continue;
    if ((fault_expected_ >> number & 1) == 0) state->fault = {Fault::Kind::kThread, 0, i};
  }
}

// --- Steps ---------------------------------------------------------------------------------------

CardModel::State CardModel::Start() {
  State state = Begin();
  Save(&state);
  return state;
}

CardModel::State CardModel::Begin() {
  Load(initial_);
  held_ = nullptr;
  State state;
  state.owed = initial_.owed;
  state.races = races_;
  if (has_invariants_) JudgeState(&state);
  Settle(&state);
  return state;
}

CardModel::State CardModel::Step(const State& from, int thread) {
  Load(from);
  const ThreadState& before = controller_->machine().thread(setup(thread).thread);
  const vm::Function& function = image_->object.functions[before.function];
  const bool changes =
      before.pc < function.instructions.size() &&
      ChangesBody(function.instructions[before.pc], controller_->family().catalogue);
  if (changes) held_ = nullptr;
  State state;
  state.left = from.left;
  state.served = from.served;
  state.reached = from.reached;
  state.owed = from.owed;
  state.races = from.races;
  Execute(&state, thread);
  Save(&state);
  return state;
}

void CardModel::Advance(State* state, int thread) {
  // From here on the card no longer agrees with a kept state.
  held_ = nullptr;
  Execute(state, thread);
}

Race CardModel::NoteRaces(State* state, int thread) const {
  if (state->races == nullptr) return {};
  auto noted = std::make_shared<CardRaces>(*state->races);
  const Race race = noted->BeforeStatement(*controller_, thread);
  if (*noted != *state->races) state->races = std::move(noted);
  return race;
}

void CardModel::NoteWait(State* state, int thread) const {
  const bool waits = controller_->machine().thread(setup(thread).thread).waiting;
  if (state->races == nullptr || !waits) return;
  auto noted = std::make_shared<CardRaces>(*state->races);
  noted->AfterStatement(*controller_, thread);
  state->races = std::move(noted);
}

Fault CardModel::JudgeAsserts(int thread) {
  auto failed = asserts_.BeforeStatement(*controller_, setup(thread).thread);
  if (!failed) return {};
  assert_values_ = std::move(failed->values);
  return {Fault::Kind::kRequirement, static_cast<int>(requirements_.size() + failed->number),
          thread};
}

void CardModel::NoteCoverage(int number) {
  const vm::Machine& machine = controller_->machine();
  const ThreadState& thread = machine.thread(number);
  if (machine.image() != image_.get()) return;  // a host has loaded another program
  const auto& instructions = image_->object.functions[thread.function].instructions;
  if (thread.pc >= instructions.size()) return;
  const vm::Instruction& next = instructions[thread.pc];
  uint8_t bits = StatementCoverage::kExecuted;
  if (HasTwoWays(next)) {
    const auto& condition = std::get<vm::Variable>(next.operands[0]);
    const bool global = condition.storage == vm::Storage::kGlobal;
    const int64_t value = machine.ReadRaw({global, thread.page, condition.id});
    bits |= value != 0 ? StatementCoverage::kHeld : StatementCoverage::kNotHeld;
  }
  coverage_.Note(thread.function, thread.pc, bits);
}

void CardModel::Execute(State* state, int thread) {
  vm::Machine& machine = controller_->machine();
  const int number = setup(thread).thread;
  const Race race = NoteRaces(state, thread);
  if (race) {
    const bool in_order = race.first.thread < race.second.thread;
    races_met_.insert(in_order ? race : Race{race.cell, race.second, race.first});
  }
  --state->left;
  state->served |= 1u << number;
  state->choices = 0;
  state->fault = JudgeAsserts(thread);
  NoteCoverage(number);
  machine.ExecuteOne(number);
  // Threads that wake up at the end of their code finish.
  machine.Execute(0);
  NoteWait(state, thread);
  JudgeThreads(state);
  if (has_invariants_ && !state->fault) JudgeState(state);
  if (race && !state->fault) {
    state->fault.kind = Fault::Kind::kRace;
    state->fault.race = race;
  }
  Settle(state);
}

int64_t CardModel::AdvanceAlone(State* state, int thread, int64_t most) {
  vm::Machine& machine = controller_->machine();
  const auto runs = [](const ThreadState& each) { return each.run == vm::ThreadRun::kRunning; };
  if (has_invariants_ || races_ != nullptr || !asserts_.empty() ||
      std::ranges::count_if(machine.state().threads, runs) != 1) {
    Advance(state, thread);
    return 1;
  }
  held_ = nullptr;
  const int64_t executed = machine.Execute(std::min(most, state->left));
  state->left -= executed;
  state->served |= 1u << setup(thread).thread;
  state->choices = 0;
  JudgeThreads(state);
  Settle(state);
  return executed;
}

CardModel::State CardModel::Whole(const State& state) {
  State whole = state;
  Save(&whole);
  return whole;
}

uint32_t CardModel::Candidates(const State& state) const {
  const uint32_t runnable = controller_->machine().RunnableThreads();
  const uint32_t unserved = runnable & ~state.served;
  return std::popcount(unserved) >= state.left ? unserved : runnable;
}

void CardModel::Settle(State* state) {
  const vm::Machine& machine = controller_->machine();
  while (!state->fault && !state->ended) {
    if (machine.Quiet() && !HostActs()) {
      state->finished = true;
      if (others_end_runs_) return;
      return End(state);
    }
    if (state->left > 0 && machine.RunnableThreads() != 0) break;
    JudgeInstant(state);
    const bool host_acts = HostActs();
    if (host_acts && !state->fault) ActAsHost(state);
    if (state->fault) break;
    if (!host_acts && controller_->Deadlocked()) {
      if (runtime::MayDeadlock(scenario_)) {
        state->finished = true;
        return End(state);
      }
      state->fault.kind = Fault::Kind::kDeadlock;
    } else if (controller_->cycle() >= bounds_.last()) {
      if (bounds_.kind_of_last() == runtime::RunOver::kLimit) {
        state->fault.kind = Fault::Kind::kTimeLimit;
      } else {
        End(state);
      }
    } else {
      NextCycle(state);
    }
  }
  if (state->fault) state->ended = true;
  if (state->ended) return;
  const uint32_t candidates = Candidates(*state);
  for (int i = 0; i < thread_count(); ++i) {
    if ((candidates >> setup(i).thread & 1) != 0) state->choices |= 1u << i;
  }
}

void CardModel::NextCycle(State* state) {
  state->left = BeginCycle();
  state->served = 0;
  controller_->machine().Execute(0);
  if (has_invariants_) JudgeState(state);
}

void CardModel::ActAsHost(State* state) {
  held_ = nullptr;
  host_acted_until_ = controller_->cycle() + 1;
  if (const auto deviation = host_->Act(controller_.get())) {
    state->fault.kind = Fault::Kind::kHostCall;
    state->fault.call = deviation->call;
    state->fault.code = deviation->code;
  } else if (has_invariants_) {
    JudgeState(state);
  }
}

void CardModel::End(State* state) {
  state->ended = true;
  // If no thread runs, the card continues until the last requested instant.
  for (;;) {
    JudgeInstant(state);
    if (state->fault || controller_->cycle() >= std::min(last_instant_, bounds_.last())) break;
    BeginCycle();
    if (has_invariants_) JudgeState(state);
  }
  // A failure has cut the run before its end.
  if (!state->fault) supervisor_->JudgeEnd();
  if (!bounds_.CutsAt(*controller_)) JudgeEnd(state);
  if (!state->fault) NoteHorizon();
}

void CardModel::NoteHorizon() {
  latest_end_ = std::max(latest_end_, controller_->cycle());
  if (bounds_.CutsAt(*controller_)) {
    horizon_.at_ms = ToMs(controller_->clock().UsOf(controller_->cycle()));
  }
  if (horizon_.at_ms || watches_card_) horizon_.axes |= runtime::MovingAxes(*controller_);
  // Threads in a deadlock never go on.
  if (controller_->Deadlocked()) return;
  const auto& threads = controller_->machine().state().threads;
  for (size_t number = 0; number < threads.size(); ++number) {
    if (vm::IsAwake(threads[number])) horizon_.threads |= 1u << number;
  }
}

int64_t CardModel::BeginCycle() {
  const gtcalls::Family& family = controller_->family();
  const gtcalls::CardView view = controller_->view();
  const bool acts = family.cycles_before_act(view) != gtcalls::kNeverActs;
  if (acts || family.writes_variables(view)) held_ = nullptr;
  ++cycles_since_held_;
  const uint64_t held = ConditionsOfReactions();
  const int64_t statements = controller_->BeginCycle();
  // Conditions also depend on the program. What is pending is part of the body.
  if (ConditionsOfReactions() != held) held_ = nullptr;
  return statements;
}

uint64_t CardModel::ConditionsOfReactions() const {
  const runtime::Reactions* reactions = controller_->reactions();
  return reactions == nullptr ? 0 : reactions->state().held;
}

// --- Islands -------------------------------------------------------------------------------------

void CardModel::RunBeside(const CardModel& whole) {
  others_end_runs_ = bounds_.kind_of_last() == runtime::RunOver::kLimit;
  // How long a run lasts, and whether it matters what still moves then, is asked of all threads.
  last_instant_ = whole.last_instant_;
  watches_card_ = whole.watches_card_;
}

bool CardModel::MayEndCycle(const State& state) const {
  for (int i = 0; i < thread_count(); ++i) {
    const bool can_run = (state.choices >> i & 1) != 0;
    if (can_run && (state.served >> setup(i).thread & 1) == 0) return false;
  }
  return true;
}

CardModel::State CardModel::EndCycle(const State& from) {
  Load(from);
  State state;
  state.reached = from.reached;
  state.owed = from.owed;
  state.races = from.races;
  state.finished = from.finished;
  if (state.finished) {
    JudgeInstant(&state);
    if (!state.fault) NextCycle(&state);
    state.ended = static_cast<bool>(state.fault);
  } else {
    Settle(&state);
  }
  Save(&state);
  return state;
}

Fault CardModel::EndRun(const State& from) {
  Load(from);
  State state = from;
  End(&state);
  return state.fault;
}

void CardModel::Include(const CardModel& island, const std::vector<size_t>& origins) {
  for (size_t i = 0; i < origins.size(); ++i) {
    const BoundRequirement& from = island.requirements_[i];
    const BoundRequirement& to = requirements_[origins[i]];
    to.judged = to.judged || from.judged;
    to.mattered = to.mattered || from.mattered;
  }
  coverage_.Include(island.coverage_);
  asserts_.Include(island.asserts_);
  refused_->Include(*island.refused_);
  supervisor_->Include(*island.supervisor_);
  horizon_.axes |= island.horizon_.axes;
  horizon_.threads |= island.horizon_.threads;
  latest_end_ = std::max(latest_end_, island.latest_end_);
}

// --- States --------------------------------------------------------------------------------------

void CardModel::Save(State* state) {
  const vm::MachineState& machine = controller_->machine().state();
  state->variables.Pack(machine);
  state->threads = machine.threads;
  state->executed = machine.executed;
  state->body = CurrentBody();
  state->history = supervisor_->history();
  held_ = state->body;
  cycles_since_held_ = 0;
}

std::shared_ptr<const CardModel::Body> CardModel::CurrentBody() const {
  if (held_ != nullptr) {
    if (cycles_since_held_ == 0) return held_;
    for (const Body::Later& later : held_->later) {
      if (later.cycles != cycles_since_held_) continue;
      if (auto body = later.body.lock()) return body;
    }
  }
  // Not std::make_shared(), which keeps the memory until nothing refers to the body weakly.
  std::shared_ptr<const Body> body =
      std::make_unique<const Body>(Body{controller_->Body(), controller_->BodyHash()});
  if (held_ != nullptr) {
    std::erase_if(held_->later, [](const Body::Later& later) { return later.body.expired(); });
    held_->later.push_back({cycles_since_held_, body});
  }
  return body;
}

void CardModel::Load(const State& state) {
  vm::MachineState& machine = *scratch_;
  state.variables.Unpack(&machine);
  machine.threads = state.threads;
  machine.executed = state.executed;
  machine.cycle = state.body->values.motion.cycle;
  controller_->machine().Restore(machine);
  if (held_ != state.body || cycles_since_held_ != 0) {
    controller_->RestoreBody(state.body->values);
  }
  supervisor_->PutBack(state.history);
  held_ = state.body;
  cycles_since_held_ = 0;
  host_acted_until_ = controller_->cycle();
}

void CardModel::CopyVariables(State* state) const {
  const vm::MachineState& machine = controller_->machine().state();
  state->variables.Pack(machine);
  state->threads = machine.threads;
}

bool CardModel::NextDependOnEachOther(int a, int b) const {
  return FindDependence(NextAccess(*controller_, setup(a).thread),
                        NextAccess(*controller_, setup(b).thread)) != nullptr;
}

runtime::StatementAccess CardModel::WatchedAccess() const {
  runtime::StatementAccess access;
  const auto add = [&](const std::optional<runtime::CardCondition>& condition) {
    if (condition) runtime::AddAccesses(AccessOf(*condition, *controller_), &access);
  };
  for (const BoundRequirement& bound : requirements_) {
    if (bound.requirement.scope == Scope::kFinal) continue;
    add(bound.condition);
    add(bound.then);
    add(bound.matters);
  }
  return access;
}

std::optional<runtime::StatementAccess> CardModel::AccessOfAssert(int thread,
                                                                  const vm::Assert& assert) const {
  const auto bound =
      runtime::CardCondition::ReadInThread(assert.condition, setup(thread).thread, *controller_);
  if (!bound.ok()) return std::nullopt;
  return AccessOf(bound.value(), *controller_);
}

int64_t CardModel::CycleOf(const State& state) { return state.body->values.motion.cycle; }

StateKey CardModel::KeyOf(const State& state) const {
  words_.assign(state.variables.slots.begin(), state.variables.slots.end());
  words_.push_back(state.variables.used_pages);
  for (size_t number = 0; number < state.threads.size(); ++number) {
    const ThreadState& thread = state.threads[number];
    if (thread.run == vm::ThreadRun::kUnbound) continue;
    words_.push_back(static_cast<int64_t>(number));
    const auto of_thread = vm::WordsOf(thread);
    words_.insert(words_.end(), of_thread.begin(),
                  of_thread.end() - (counts_statements_ ? 0 : vm::kCountWords));
  }
  if (counts_statements_) words_.push_back(state.executed);
  words_.insert(words_.end(), {static_cast<int64_t>(state.body->hash), state.left,
                               static_cast<int64_t>(state.served), state.ended, state.reached,
                               static_cast<int64_t>(state.fault.kind)});
  // The clock is a part of the body, so an instant says how much time is left.
  for (const runtime::Owed& owed : state.owed) {
    words_.push_back(owed.pending ? owed.due_ns : -1);
  }
  if (state.races != nullptr) state.races->AddTo(&words_);
  return KeyOfWords(words_);
}

StateKey CardModel::GlobalsKey(const State& state) const { return KeyOfWords(GlobalsOf(state)); }

StateKey CardModel::FinalKey(const State& state) const {
  std::vector<int64_t> words = GlobalsOf(state);
  for (const ThreadState& thread : state.threads) words.push_back(thread.result);
  return KeyOfWords(words);
}

}  // namespace oncard::explore
