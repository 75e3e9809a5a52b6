// The order of events in a profile cycle:
//
//   1. Reactions::Act(): what the surroundings do because of what the card has done before; then
//      MotionCore::Tick(): the inputs are sampled, outputs and the clock advance; then
//      Family::after_tick: variables are written whose buffered commands the paths reached;
//   2. Machine::BeginCycle(): delays that end with this cycle end, periodic threads start;
//   3. Family::before_threads: the PLC blocks read inputs, write variables and outputs;
//   4. the scheduler policy distributes this cycle's statements to the threads; a GT command in a
//      program is executed at once, between two statements.
//
// A host call is executed between two cycles, after the cycles within the time that the call takes.
//
// A cycle's budget is rate * cycle length; the fraction of a statement that remains is carried to
// the next cycle, so that the rate is exact in the long run. Statements that the threads do not use
// are lost: an idle card does not save them.
// Tested by tests/runtime/controller_test.cc.
#include "runtime/sim/controller.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "base/milliseconds.h"
#include "motion/common/state_hash.h"
#include "runtime/sim/card_event_text.h"
#include "vm/object_reader.h"

namespace oncard::runtime {
namespace {

/// rate [statements/ms] times cycle [us] gives thousandths of a statement.
constexpr int64_t kStatementParts = 1000;
/// The threads get at most this many cycles before motion gets them, too.
constexpr int64_t kMotionLateMax = 1024;

}  // namespace

Controller::Controller(const ControllerOptions& options)
    : options_(options),
      motion_(options.family->Configured(options.motion, options.type)),
      clock_(motion_.config().cycle_us, options.family->CycleNs(options.motion)),
      family_state_(options.family->new_state()),
      commands_(&card_),
      machine_(&commands_),
      card_{*options.family, machine_, motion_, family_state_} {
  commands_.PrepareWith([this] { CatchUp(); });
  card_.set_cycle_ns = [this](int64_t cycle_ns) { SetCycle(cycle_ns); };
  card_.interrupt_host = [this](const Message& what) {
    interrupts_host_ = true;
    TellListeners(what);
  };
}

void Controller::LogRefusals(CardLog* log, int card) {
  ObserveRefusals([this, log, card](const gtcalls::Call& call, int16_t code) {
    log->Write({NowUs(), card, call.caller, call.command, call.arguments, code, call.reason});
  });
}

void Controller::LogEvents(CardLog* log, int card) {
  ListenToEvents(
      [log, card](int64_t time_us, const Message& what) { log->Write(time_us, card, what); });
}

void Controller::ListenToEvents(EventListener listener) {
  event_listeners_.push_back(std::move(listener));
  PassEventsOn();
}

void Controller::PassEventsOn() {
  motion_.Observe([this](const motion::CardEvent& event) {
    if (observer_ != nullptr) observer_->Happened(event);
    if (!event_listeners_.empty()) TellListeners(DescribeCardEvent(event, family().advised));
  });
}

void Controller::TellListeners(const Message& what) const {
  for (const EventListener& each : event_listeners_) each(clock_.UsOf(cycle()), what);
}

void Controller::ObserveWith(CardObserver* observer) {
  observer_ = observer;
  commands_.ObserveCommands(observer);
  machine_.ObserveOverruns(observer == nullptr
                               ? std::function<void(int)>()
                               : [observer](int thread) { observer->Overran(thread); });
  PassEventsOn();
}

void Controller::CollectRefusals(RefusedCommands* refused) {
  ObserveRefusals([this, refused](const gtcalls::Call& call, int16_t code) {
    refused->Add(call, code, NowUs());
  });
}

void Controller::ObserveRefusals(gtcalls::RefusalObserver observer) {
  refusal_observers_.push_back(std::move(observer));
  commands_.ObserveRefusals([this](const gtcalls::Call& call, int16_t code) {
    for (const gtcalls::RefusalObserver& each : refusal_observers_) each(call, code);
  });
}

Result<void> Controller::Download(const std::string& bin_path, vm::ObjectFiles* content) {
  auto object = vm::ReadObjectPair(bin_path, content);
  if (!object.ok()) return object.error();
  return Load(std::move(object).value());
}

Result<void> Controller::Load(vm::Object object) {
  auto image = vm::LinkObject(std::move(object), commands_);
  if (!image.ok()) return image.error();
  Load(std::move(image).value());
  return {};
}

void Controller::Load(std::shared_ptr<const vm::Image> image) {
  family().forget_program(family_state_);
  machine_.Load(std::move(image));
}

bool Controller::ProgramActs() const {
  return family().writes_variables(view()) ||
         std::ranges::any_of(machine_.state().threads, [](const vm::ThreadState& thread) {
           return thread.started || vm::IsAwake(thread);
         });
}

int16_t Controller::Call(const gtcalls::Command& command, std::span<vm::CommandArgument> arguments,
                         Message* reason) {
  AdvanceUs(family().cost_us(command));
  return Execute(command, arguments, reason);
}

int16_t Controller::Execute(const gtcalls::Command& command,
                            std::span<vm::CommandArgument> arguments, Message* reason,
                            const TickPasser& pass) {
  gtcalls::Call call{command, card_, vm::kHostCaller, arguments, {}};
  int16_t code = commands_.Execute(call);
  while (call.waits) {
    if (pass) {
      pass();
    } else {
      AdvanceUs(UsToNextTick());
    }
    code = commands_.Resume(call);
  }
  // Most commands have nothing to say.
  if (reason != nullptr && !call.reason.en.empty()) *reason = std::move(call.reason);
  return code;
}

void Controller::AdvanceUs(int64_t microseconds) {
  pending_ns_ += microseconds * CardClock::kNsPerUs;
  const int64_t now_ns = NowNs();
  const int64_t last = clock_.LastEnded(now_ns);
  if (last <= cycle()) return;
  pending_ns_ = now_ns - clock_.NsOf(last);
  RunCycles(last - cycle());
}

int64_t Controller::UsToTick(int64_t cycles) const {
  return (clock_.NsOf(cycle() + cycles) - NowNs() + CardClock::kNsPerUs - 1) / CardClock::kNsPerUs;
}

int64_t Controller::CyclesBeforeInterrupt() const {
  const auto before = family().cycles_before_interrupt;
  return before == nullptr ? gtcalls::kNeverActs : before(view());
}

bool Controller::GoesOn() const {
  const motion::WorldProgress& world = motion_.state().world;
  if (reactions_ && !reactions_->state().pending.empty()) return true;
  if (motion_.PathRuns() || (world.events && world.next < world.events->size())) return true;
  for (size_t axis = 0; axis < motion_.axis_count(); ++axis) {
    if ((motion_.Conditions(axis) & motion::kMovingBit) != 0) return true;
  }
  return false;
}

// A cycle that has begun keeps its length.
void Controller::SetCycle(int64_t cycle_ns) {
  if (cycle_ns == clock_.cycle_ns()) return;
  clock_.ChangeAfter(pending_ns_ == 0 ? cycle() : cycle() + 1, cycle_ns);
  if (clock_listener_) clock_listener_();
}

void Controller::RunCycle() {
  const int64_t budget = BeginCycle();
  if (state_observer_ || cycle_host_) {
    ExecuteInParts(budget);
  } else {
    machine_.Execute(budget);
  }
}

void Controller::RunCycles(int64_t cycles) {
  while (cycles > 0) cycles -= RunSome(cycles);
  CatchUp();
}

int64_t Controller::RunSome(int64_t limit) {
  const int64_t before_act = family().cycles_before_act(view()) - motion_late_;
  if (state_observer_ || cycle_host_ || reactions_ || before_act <= 0) {
    CatchUp();
    RunCycle();
    return 1;
  }
  if (const int64_t idle = std::min({limit, before_act, IdleCycles()}); idle > 0) {
    RunIdle(idle);
    return idle;
  }
  if (motion_.PathRuns()) {
    CatchUp();
    RunCycle();
    return 1;
  }
  // Statements between two commands and motion do not see each other.
  ++motion_late_;
  machine_.BeginCycle(cycle() + motion_late_);
  machine_.Execute(TakeBudget(1));
  if (motion_late_ == kMotionLateMax) CatchUp();
  return 1;
}

int64_t Controller::IdleCycles() const {
  // A path may write a variable for which a thread waits.
  if (motion_.PathRuns() && !machine_.Quiet()) return 0;
  return machine_.IdleCycles();
}

void Controller::RunIdle(int64_t cycles) {
  CatchUp();
  for (int64_t left = cycles; left > 0;) {
    left -= motion_.Advance(left);
    family().after_tick(card_);
  }
  machine_.BeginCycle(cycle());
  machine_.Execute(TakeBudget(cycles));
}

void Controller::CatchUp() {
  while (motion_late_ > 0) motion_late_ -= motion_.Advance(motion_late_);
}

int64_t Controller::TakeBudget(int64_t cycles) {
  pending_statements_ += cycles * options_.rate * clock_.cycle_us();
  const int64_t budget = pending_statements_ / kStatementParts;
  pending_statements_ %= kStatementParts;
  return budget;
}

void Controller::ExecuteInParts(int64_t budget) {
  // Threads that wake up at the end of their function finish.
  machine_.Execute(0);
  ShowState();
  for (int64_t executed = 0; executed < budget;) {
    const int64_t part = std::min(budget - executed, StatementsUntilHost(executed));
    const int64_t done = machine_.Execute(shows_states() ? 1 : part);
    if (done == 0) break;
    ShowState();
    if (machine_.last_stop() != vm::Stop::kBudget) break;
    executed += done;
  }
}

int64_t Controller::StatementsUntilHost(int64_t executed) {
  if (!cycle_host_) return INT64_MAX;
  if (executed >= host_acts_after_) host_acts_after_ = cycle_host_(executed);
  return host_acts_after_ - executed;
}

int64_t Controller::BeginCycle() {
  if (reactions_) reactions_->Act(clock_.NsOf(cycle()), &motion_);
  motion_.Tick();
  family().after_tick(card_);
  machine_.BeginCycle(cycle());
  family().before_threads(card_);
  host_acts_after_ = 0;
  return TakeBudget(1);
}

RunEnd Controller::RunUntilQuiet(int64_t limit_cycles) {
  const RunEnd end = RunSomeUntilQuiet(limit_cycles);
  CatchUp();
  return end;
}

RunEnd Controller::RunSomeUntilQuiet(int64_t limit_cycles) {
  for (int64_t ran = 0; !machine_.Quiet();) {
    if (Deadlocked()) return RunEnd::kDeadlock;
    if (ran >= limit_cycles) return RunEnd::kTimeLimit;
    ran += RunSome(limit_cycles - ran);
    if (machine_.Quiet()) break;
    if (machine_.last_stop() == vm::Stop::kScheduleEnd) return RunEnd::kScheduleEnd;
    if (machine_.last_stop() == vm::Stop::kScheduleDiverged) return RunEnd::kScheduleDiverged;
  }
  return RunEnd::kQuiet;
}

bool Controller::Deadlocked() const {
  if (machine_.RunnableThreads() != 0) return false;
  bool any_waits = false;
  for (const vm::ThreadState& thread : machine_.state().threads) {
    if (thread.period_cycles != 0) return false;
    if (thread.run != vm::ThreadRun::kRunning) continue;
    if (thread.wake_cycle > machine_.state().cycle) return false;
    any_waits = any_waits || thread.waiting;
  }
  return any_waits && !family().writes_variables(view());
}

double Controller::NowMs() const { return ToMs(clock_.UsOf(cycle())); }

int64_t Controller::NowUs() const { return NowNs() / CardClock::kNsPerUs; }

void Controller::Reset() {
  motion_.Reset();
  family().reset(family_state_);
  machine_.Load(nullptr);
  SetCycle(family().CycleNs(options_.motion));
  if (observer_ != nullptr) observer_->Reset();
}

ControllerSnapshot Controller::Snapshot() const { return {machine_.state(), Body()}; }

CardBody Controller::Body() const {
  CardBody body = {motion_.state(), family_state_, pending_ns_, pending_statements_};
  if (const auto change = clock_.changed()) body.clock.Emplace(*change);
  if (reactions_) body.reactions.Emplace(reactions_->state());
  return body;
}

void Controller::Restore(const ControllerSnapshot& snapshot) {
  machine_.Restore(snapshot.machine);
  RestoreBody(snapshot.body);
}

void Controller::RestoreBody(const CardBody& body) {
  motion_.Restore(body.motion);
  family_state_ = body.family;
  pending_ns_ = body.pending_ns;
  clock_.Restore(body.clock ? std::optional(*body.clock) : std::nullopt);
  pending_statements_ = body.pending_statements;
  if (body.reactions) reactions_->Restore(*body.reactions);
}

uint64_t Controller::WithRareParts(uint64_t hash) const {
  const auto change = clock_.changed();
  const int64_t part_ns = pending_ns_ % CardClock::kNsPerUs;
  if (change || part_ns != 0) {
    hash = motion::StateHash().Add(hash).Add(part_ns).Add(change).value();
  }
  return reactions_ ? motion::StateHash().Add(hash).Add(reactions_->state()).value() : hash;
}

uint64_t Controller::BodyHash() const {
  const std::array<uint64_t, 4> parts = {motion_.Hash(), gtcalls::HashOf(family_state_),
                                         static_cast<uint64_t>(pending_ns_ / CardClock::kNsPerUs),
                                         static_cast<uint64_t>(pending_statements_)};
  return WithRareParts(XXH64(parts.data(), sizeof parts, 0));
}

uint64_t Controller::Hash() const {
  const std::array<uint64_t, 5> parts = {machine_.Hash(), motion_.Hash(),
                                         gtcalls::HashOf(family_state_),
                                         static_cast<uint64_t>(pending_ns_ / CardClock::kNsPerUs),
                                         static_cast<uint64_t>(pending_statements_)};
  return WithRareParts(XXH64(parts.data(), sizeof parts, 0));
}

}  // namespace oncard::runtime
