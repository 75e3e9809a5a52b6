#include "session/rewindable_run.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

#include "base/milliseconds.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "runtime/scenario/world/world_events.h"

namespace oncard::session {
namespace {

/// Inserts an event of the scenario behind those of the same time.
template <typename Event>
void InsertInTime(Event event, std::vector<Event>* events) {
  const auto later = [](int64_t at, const Event& other) { return at < other.at_us; };
  events->insert(std::upper_bound(events->begin(), events->end(), event.at_us, later),
                 std::move(event));
}

/// True if nobody who looks at a thread in two states sees a difference.
bool LooksSame(const RewindableRun::Span& span, const vm::ThreadState& now, bool waits) {
  const vm::ThreadState& was = span.state;
  if (was.run != now.run || was.function != now.function || span.waits != waits) return false;
  // A thread that has executed something waits anew.
  return !waits || was.executed == now.executed;
}

}  // namespace

// --- What the card reports -----------------------------------------------------------------------

void RewindableRun::RefusalLog::Write(const runtime::LoggedCall& call) {
  if (call.caller < 0 || call.caller >= vm::kThreadCount) return;
  ++run_.place_.refused;
  const auto say = [&](Language language) {
    return runtime::FormatCallAndCode(call.command, call.arguments, call.code, call.reason,
                                      language);
  };
  auto refusal = std::make_shared<const Refusal>(
      Refusal{call.caller, call.code, {say(Language::kEnglish), say(Language::kChinese)}});
  run_.report_.refusal = refusal;
  run_.place_.refusals[static_cast<size_t>(call.caller)] = std::move(refusal);
}

// --- Start ---------------------------------------------------------------------------------------

RewindableRun::RewindableRun(runtime::Scenario scenario)
    : scenario_(std::move(scenario)),
      log_(this),
      controller_(runtime::CardOptions(scenario_)),
      supervisor_(&controller_) {}

Result<std::unique_ptr<RewindableRun>> RewindableRun::Create(
    runtime::Scenario scenario, vm::Object object, std::shared_ptr<const vm::Schedule> schedule) {
  std::unique_ptr<RewindableRun> run(new RewindableRun(std::move(scenario)));
  auto started = run->Start(std::move(object), std::move(schedule));
  if (!started.ok()) return started.error();
  return run;
}

Result<void> RewindableRun::Start(vm::Object object, std::shared_ptr<const vm::Schedule> schedule) {
  controller_.LogRefusals(&log_, 0);
  runtime::ScenarioErrors errors;
  auto started = runtime::StartScenario(scenario_, std::move(object), &controller_, &errors);
  if (!started.ok()) return started;
  course_.Read(scenario_, &controller_, &errors);
  if (!scenario_.schedule.starts_with(runtime::kReplayPrefix)) {
    auto policy = vm::ParsePolicy(scenario_.schedule);
    if (policy.ok()) {
      own_policy_ = std::move(policy).value();
    } else {
      errors.Add(runtime::PlaceOfText(scenario_, "schedule"), policy.error().message);
    }
  } else if (schedule == nullptr) {
    errors.Add(runtime::PlaceOfText(scenario_, "schedule"),
               {"the schedule file must be given with the scenario", "调度文件必须随场景一起给出"});
  }
  if (auto failure = errors.Failure()) return *std::move(failure);
  controller_.machine().SetPolicy(own_policy_);
  if (schedule != nullptr) {
    const auto replay = runtime::FollowSchedule(std::move(schedule), image());
    if (!replay.ok()) return replay.error();
    controller_.machine().SetPolicy(replay.value());
  }
  UpdateWorld();
  Keep();
  return {};
}

std::unique_ptr<RewindableRun> RewindableRun::CreateFromCalls(
    runtime::Scenario scenario, std::unique_ptr<const runtime::HostCalls> calls) {
  std::unique_ptr<RewindableRun> run(new RewindableRun(std::move(scenario)));
  run->controller_.LogRefusals(&run->log_, 0);
  if (!calls->bare()) runtime::ApplyWorld(run->scenario_, &run->controller_);
  run->calls_ = std::move(calls);
  run->lookup_ = std::make_unique<runtime::Controller>(runtime::CardOptions(run->scenario_));
  run->UpdateWorld();
  run->Keep();
  return run;
}

runtime::Scenario RewindableRun::ScenarioWithWrites(int64_t last) const {
  runtime::Scenario scenario = scenario_;
  for (const Change& change : changes_) {
    if (change.write && change.moment <= last) InsertInTime(*change.write, &scenario.host);
    if (change.input) InsertInTime(*change.input, &scenario.world.inputs);
    if (change.voltage) InsertInTime(*change.voltage, &scenario.world.voltages);
    if (change.move) InsertInTime(*change.move, &scenario.world.moves);
  }
  return scenario;
}

// --- The present ---------------------------------------------------------------------------------

const vm::Image& RewindableRun::image() const {
  static const vm::Image none;
  const vm::Image* image = machine().image();
  return image == nullptr ? none : *image;
}

const runtime::Controller& RewindableRun::CardWith(
    const std::shared_ptr<const vm::Image>& program) const {
  lookup_->Load(program);
  return *lookup_;
}

bool RewindableRun::CallIsDue() const {
  return CallIsLeft() && clock().LastEnded(calls_->TimeUs(place_.calls) *
                                           runtime::CardClock::kNsPerUs) <= controller_.cycle();
}

StepKind RewindableRun::NextStep() const {
  if (HostActsWithin()) return StepKind::kHost;
  if (place_.statements_left > 0) return StepKind::kStatement;
  const bool host_acts = course_.agenda().NextCycle() <= controller_.cycle() || CallIsDue();
  return host_acts ? StepKind::kHost : StepKind::kCycle;
}

bool RewindableRun::HostActsWithin() const {
  return place_.statements_left > 0 &&
         course_.agenda().NextWithin(controller_.cycle()) <= place_.statements_done;
}

int RewindableRun::NextThread() const {
  if (NextStep() != StepKind::kStatement) return -1;
  if (const auto chosen = ChosenNow()) return *chosen;
  const int thread = machine().NextThread();
  return thread >= 0 ? thread : std::countr_zero(machine().RunnableThreads());
}

std::optional<runtime::RunOver> RewindableRun::Over() const {
  if (NextStep() != StepKind::kCycle) return std::nullopt;
  if (calls_ != nullptr) {
    return CallIsLeft() ? std::nullopt : std::optional(runtime::RunOver::kHostEnd);
  }
  return course_.Over(controller_);
}

bool RewindableRun::follows_schedule() const {
  return machine().state().scheduler.policy.kind == vm::PolicyKind::kReplay;
}

const Refusal* RewindableRun::LastRefusal(int thread) const {
  const auto& refusal = place_.refusals[static_cast<size_t>(thread)];
  return refusal != nullptr && refusal->code == machine().thread(thread).error ? refusal.get()
                                                                               : nullptr;
}

std::optional<int> RewindableRun::ChosenNow() const {
  const auto choice = std::ranges::lower_bound(choices_, moment(), {}, &Choice::moment);
  if (choice == choices_.end() || choice->moment != moment()) return std::nullopt;
  return choice->thread;
}

int64_t RewindableRun::NextRecorded() const {
  const auto next = [this](const auto& recorded) {
    using Recorded = std::decay_t<decltype(recorded.front())>;
    const auto found = std::ranges::upper_bound(recorded, moment(), {}, &Recorded::moment);
    return found == recorded.end() ? INT64_MAX : found->moment;
  };
  return std::min(next(choices_), next(changes_));
}

// --- Forward -------------------------------------------------------------------------------------

const StepReport& RewindableRun::Step() {
  report_ = {};
  report_.kind = NextStep();
  switch (report_.kind) {
    case StepKind::kHost:
      StepHost();
      break;
    case StepKind::kCycle:
      BeginCycle();
      break;
    case StepKind::kStatement:
      StepStatement();
      break;
  }
  Arrive();
  return report_;
}

void RewindableRun::Advance(int64_t last) {
  const StepKind next = NextStep();
  if (next == StepKind::kHost || ChosenNow()) {
    Step();
    return;
  }
  const int64_t end = std::min({last, NextRecorded(), moment() + keep_interval_});
  if (next == StepKind::kCycle) BeginCycle();
  ExecuteTo(end);
  Arrive();
}

void RewindableRun::AdvanceTo(int64_t last) {
  while (moment() < last && !EndIsWanted()) Advance(last);
}

Result<void> RewindableRun::CheckThread(int thread) {
  if (thread >= 0 && thread < vm::kThreadCount) return {};
  return MakeError(7, "there is no thread {0}: threads are 0 to {1}",
                   "没有线程 {0}：线程编号为 0 至 {1}", thread, vm::kThreadCount - 1);
}

Result<void> RewindableRun::StepThread(int thread) {
  if (auto valid = CheckThread(thread); !valid.ok()) return valid;
  const int64_t from = moment();
  const auto can_run = [&] { return (machine().RunnableThreads() >> thread & 1) != 0; };
  while (can_run() && NextStep() != StepKind::kStatement) Step();
  if (!can_run()) {
    GoTo(from);
    return MakeError(1,
                     "thread {0} cannot execute a statement now: it has ended, or it waits; run "
                     "on until it is ready",
                     "线程 {0} 此刻不能执行语句：它已结束或正在等待；请继续运行到它就绪", thread);
  }
  if (NextThread() != thread) {
    Cut();
    choices_.push_back({moment(), thread});
  }
  Step();
  return {};
}

void RewindableRun::StepHost() {
  ++place_.moment;
  if (HostActsWithin()) return StepHostWithin();
  if (CallIsDue()) return StepCall();
  const auto judge = [this](const runtime::Agenda::Check& check) {
    if (check.condition.Holds(controller_)) return;
    ++place_.failed;
    const Message why = runtime::DescribeFailure(check.condition, controller_);
    report_.failed.push_back(
        {fmt::format("{}: {}", check.text, why.en), fmt::format("{}：{}", check.text, why.zh)});
  };
  course_.Act(&controller_, judge, [](const runtime::Agenda::Write&) {});
}

void RewindableRun::StepCall() {
  const size_t number = place_.calls++;
  controller_.PlaceInCycle(calls_->TimeUs(number));
  const vm::Image* const before = machine().image();
  runtime::HostCalls::Done done = calls_->Execute(number, &controller_);
  if (world_clock_ != clock()) UpdateWorld();
  if (machine().image() != before) place_.refusals = {};
  report_.call = true;
  place_.last_call = std::make_shared<const Message>(done.text);
  if (done.code != vm::kOk) {
    ++place_.refused;
    report_.refusal = std::make_shared<const Refusal>(Refusal{-1, done.code, done.text});
  }
  if (!done.deviation || HasBeenChanged()) return;
  ++place_.deviations;
  report_.deviation = std::move(done.deviation);
}

bool RewindableRun::HasBeenChanged() const {
  const auto made_before = [this](const auto& recorded) {
    return !recorded.empty() && recorded.front().moment < moment();
  };
  return made_before(choices_) || made_before(changes_);
}

void RewindableRun::StepHostWithin() {
  course_.ActWithin(&controller_, place_.statements_done, [](const runtime::Agenda::Write&) {});
  NoteState();
}

void RewindableRun::BeginCycle() {
  controller_.PlaceAtTick();
  place_.statements_left = controller_.BeginCycle();
  place_.statements_done = 0;
  // Threads that wake up at the end of their function finish.
  controller_.machine().Execute(0);
  NoteState();
  ++place_.moment;
}

void RewindableRun::StepStatement() {
  vm::Machine& machine = controller_.machine();
  const auto chosen = ChosenNow();
  if (follows_schedule() && (chosen || machine.NextThread() < 0)) LeaveSchedule();
  report_.thread = chosen ? *chosen : machine.NextThread();
  if (races_) report_.race = races_->BeforeStatement(controller_, report_.thread);
  if (chosen) {
    machine.ExecuteOne(*chosen);
    machine.Execute(0);
  } else {
    machine.Execute(1);
  }
  if (races_) races_->AfterStatement(controller_, report_.thread);
  NoteState();
  --place_.statements_left;
  ++place_.statements_done;
  ++place_.moment;
}

void RewindableRun::ExecuteTo(int64_t last) {
  vm::Machine& machine = controller_.machine();
  while (place_.statements_left > 0 && moment() < last && machine.RunnableThreads() != 0) {
    const int64_t until_host =
        course_.agenda().NextWithin(controller_.cycle()) - place_.statements_done;
    if (until_host <= 0) return;
    if (races_ || Awaits()) {
      StepStatement();
      continue;
    }
    const int64_t executed =
        machine.Execute(std::min({place_.statements_left, last - moment(), until_host}));
    place_.statements_left -= executed;
    place_.statements_done += executed;
    place_.moment += executed;
    if (executed == 0) LeaveSchedule();
  }
}

void RewindableRun::LeaveSchedule() { controller_.machine().SetPolicy(own_policy_); }

void RewindableRun::Arrive() {
  NoteFindings();
  LoseStatements();
  auto change = std::ranges::lower_bound(changes_, moment(), {}, &Change::moment);
  for (; change != changes_.end() && change->moment == moment(); ++change) Apply(*change);
  NoteEnd();
  head_ = std::max(head_, moment());
  const auto after = FirstKeptAfter(moment());
  if (moment() - std::prev(after)->place.moment >= keep_interval_) Keep();
}

void RewindableRun::LoseStatements() {
  if (machine().RunnableThreads() == 0 && !HostActsWithin()) place_.statements_left = 0;
}

void RewindableRun::NoteEnd() {
  if (!Over()) return;
  if (place_.over_cycle < 0) place_.over_cycle = controller_.cycle();
  if (place_.end_judged) return;
  place_.end_judged = true;
  supervisor_.JudgeEnd();
  NoteFindings();
}

void RewindableRun::ForgetEnd() {
  place_.end_judged = false;
  supervisor_.ForgetEnd();
  place_.findings = findings().size();
}

void RewindableRun::NoteFindings() {
  for (; place_.findings < findings().size(); ++place_.findings) {
    const runtime::CardFinding& finding = findings()[place_.findings];
    if (IsSilent(finding)) continue;
    ++place_.warned;
    if (!report_.warning) report_.warning = DescribeFindingPlace(finding, ProgramPath(scenario_));
  }
}

// --- Kept states ---------------------------------------------------------------------------------

void RewindableRun::Keep() {
  const auto at = std::ranges::lower_bound(kept_, moment(), {},
                                           [](const Kept& kept) { return kept.place.moment; });
  Kept present = {place_,
                  course_.position(),
                  machine().shared_image(),
                  vm::PackedState(machine().state()),
                  controller_.Body(),
                  supervisor_.history(),
                  supervisor_.found(),
                  races_};
  if (at != kept_.end() && at->place.moment == moment()) {
    *at = std::move(present);
  } else {
    kept_.insert(at, std::move(present));
  }
  if (kept_.size() > kKeptMax) ThinOut();
}

// Drops the state that is missed least: the one whose neighbours are close to each other, in
// proportion to their distance from the present.
void RewindableRun::ThinOut() {
  const auto moment_of = [this](size_t i) { return kept_[i].place.moment; };
  size_t least = 1;
  double least_gap = 0;
  for (size_t i = 1; i + 1 < kept_.size(); ++i) {
    const auto distance = static_cast<double>(std::abs(moment() - moment_of(i)) + kKeptInterval);
    const double gap = static_cast<double>(moment_of(i + 1) - moment_of(i - 1)) / distance;
    if (i > 1 && gap >= least_gap) continue;
    least = i;
    least_gap = gap;
  }
  kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(least));
}

void RewindableRun::Restore(const Kept& kept) {
  place_ = kept.place;
  course_.GoTo(kept.course);
  kept.machine.Unpack(scratch_.get());
  if (machine().shared_image() != kept.program) controller_.machine().Load(kept.program);
  controller_.machine().Restore(*scratch_);
  controller_.RestoreBody(kept.body);
  supervisor_.PutBack(kept.history);
  supervisor_.PutBack(kept.found);
  races_ = kept.races;
  ShareWorld();
}

void RewindableRun::ShareWorld() {
  if (world_clock_ != clock()) return UpdateWorld();
  controller_.motion().SetEvents(world_events_);
}

std::vector<RewindableRun::Kept>::iterator RewindableRun::FirstKeptAfter(int64_t moment) {
  return std::upper_bound(kept_.begin(), kept_.end(), moment,
                          [](int64_t at, const Kept& kept) { return at < kept.place.moment; });
}

int64_t RewindableRun::KeptBefore(int64_t moment) const {
  const auto at = std::ranges::lower_bound(kept_, moment, {},
                                           [](const Kept& kept) { return kept.place.moment; });
  return at == kept_.begin() ? 0 : std::prev(at)->place.moment;
}

void RewindableRun::GoTo(int64_t target) {
  target = std::clamp<int64_t>(target, 0, head_);
  const auto after = FirstKeptAfter(target);
  const Kept& nearest = *std::prev(after);
  if (target < moment() || nearest.place.moment > moment()) Restore(nearest);
  // Further steps back from there are shorter.
  constexpr int64_t kPartOfWay = 8;
  keep_interval_ = std::clamp((target - moment()) / kPartOfWay, int64_t{64}, kKeptInterval);
  AdvanceTo(target);
  keep_interval_ = kKeptInterval;
}

void RewindableRun::GoToCycle(int64_t cycle) {
  const auto reached = std::ranges::lower_bound(
      kept_, cycle, {}, [](const Kept& kept) { return kept.body.motion.cycle; });
  Restore(reached == kept_.begin() ? kept_.front() : *std::prev(reached));
  const auto at_end = [&] {
    return controller_.cycle() >= cycle && NextStep() == StepKind::kCycle;
  };
  while (moment() < head_ && !at_end() && !EndIsWanted()) Advance(head_);
}

// --- Data races ----------------------------------------------------------------------------------

Result<void> RewindableRun::WatchRaces(bool on) {
  if (on == races_.has_value()) return {};
  if (on && calls_ != nullptr) {
    return MakeError(1, "data races are not looked for where a host makes calls",
                     "有主机调用时不查找数据竞争");
  }
  if (!on) {
    races_.reset();
    for (Kept& kept : kept_) kept.races.reset();
    return {};
  }
  auto watch = RaceWatch::Create(scenario_, controller_);
  if (!watch.ok()) return watch.error();
  const int64_t present = moment();
  kept_.erase(kept_.begin() + 1, kept_.end());
  kept_.front().races = std::move(watch).value();
  Restore(kept_.front());
  AdvanceTo(present);
  return {};
}

// --- What must hold at some time -----------------------------------------------------------------

void RewindableRun::Await(std::vector<runtime::CardCondition> conditions,
                          std::vector<Response> responses) {
  awaited_ = std::move(conditions);
  responses_ = std::move(responses);
  place_.held.assign(awaited_.size(), false);
  place_.owed.assign(responses_.size(), {});
  NoteState();
  Keep();
}

bool RewindableRun::Awaits() const {
  const std::vector<bool>& held = place_.held;
  const bool waits = std::find(held.begin(), held.end(), false) != held.end();
  return place_.over_cycle < 0 && (waits || !responses_.empty());
}

void RewindableRun::NoteState() {
  if (!Awaits()) return;
  for (size_t i = 0; i < awaited_.size(); ++i) {
    if (!place_.held[i]) place_.held[i] = awaited_[i].Holds(controller_);
  }
  for (size_t i = 0; i < responses_.size(); ++i) {
    const Response& response = responses_[i];
    place_.owed[i].Observe(response.requirement, response.left.Holds(controller_),
                           response.right.Holds(controller_), clock().NsOf(controller_.cycle()),
                           machine().state().executed);
  }
}

// --- Changes -------------------------------------------------------------------------------------

void RewindableRun::Cut() {
  head_ = moment();
  std::erase_if(choices_, [this](const Choice& choice) { return choice.moment >= moment(); });
  std::erase_if(kept_, [this](const Kept& kept) { return kept.place.moment > moment(); });
  const auto cut =
      std::erase_if(changes_, [this](const Change& change) { return change.moment > moment(); });
  if (cut > 0) UpdateWorld();
}

void RewindableRun::AddChange(Change change) {
  Cut();
  change.moment = moment();
  changes_.push_back(std::move(change));
  Apply(changes_.back());
  UpdateWorld();
  place_.over_cycle = -1;
  NoteEnd();
  Keep();
}

void RewindableRun::Apply(const Change& change) {
  ForgetEnd();
  if (!change.write) return;
  vm::Machine& machine = controller_.machine();
  for (size_t i = 0; i < change.variables.size(); ++i) {
    machine.Write(change.variables[i].slot, change.write->values.front().values[i]);
  }
  if (!change.write->after_statements) return;
  // In the middle of a cycle threads that waited for the value at the end of their function finish.
  machine.Execute(0);
  NoteState();
  LoseStatements();
}

Result<void> RewindableRun::WriteVariable(const std::string& name, double value) {
  const runtime::ControllerSnapshot before = controller_.Snapshot();
  const runtime::InitialValue initial = {name, {value}};
  auto variables = runtime::SetVariable(initial, name, &controller_);
  controller_.Restore(before);
  if (!variables.ok()) return variables.error();
  if (NextStep() == StepKind::kHost) Step();
  Change change;
  change.variables.push_back(std::move(variables).value().front());
  change.write = runtime::HostEvent{clock().UsOf(controller_.cycle()), {initial}};
  if (place_.statements_left > 0) change.write->after_statements = place_.statements_done;
  AddChange(std::move(change));
  return {};
}

int64_t RewindableRun::InputInstant() const {
  // Events at 0 are those of power-on.
  return std::max<int64_t>(1, clock().UsOf(controller_.cycle()));
}

Result<void> RewindableRun::SetInput(motion::DiType type, int index, bool level) {
  if (index < 1 || index > motion::DiWidth(type)) {
    return MakeError(7, "there is no input {0}[{1}]: it has pins 1 to {2}",
                     "没有输入 {0}[{1}]：其引脚为 1 至 {2}", runtime::InputWordName(type), index,
                     motion::DiWidth(type));
  }
  const auto& switches = scenario_.world.switches;
  const auto wired = std::ranges::find_if(switches, [&](const runtime::SwitchSetup& contact) {
    return contact.type == type && contact.index == index;
  });
  if (wired != switches.end()) {
    return MakeError(1, "the input {0}[{1}] is wired to switch {2}: move the switch",
                     "输入 {0}[{1}] 接在开关 {2} 上：请移动该开关", runtime::InputWordName(type),
                     index, wired - switches.begin() + 1);
  }
  Change change;
  change.input = runtime::InputEvent{InputInstant(), type, index, level ? 1u : 0u};
  AddChange(std::move(change));
  return {};
}

Result<void> RewindableRun::SetVoltage(int channel, double volts) {
  if (channel < 1 || channel > static_cast<int>(motion::kAdcCount)) {
    return MakeError(7, "there is no analogue input {0}: they are 1 to {1}",
                     "没有模拟量输入 {0}：编号为 1 至 {1}", channel, motion::kAdcCount);
  }
  Change change;
  change.voltage = runtime::VoltageEvent{InputInstant(), channel, volts};
  AddChange(std::move(change));
  return {};
}

Result<void> RewindableRun::MoveSwitch(int number, double from, double to) {
  const size_t count = scenario_.world.switches.size();
  if (count == 0) {
    return MakeError(7, "the scenario has no switches: describe them under [[world.switch]]",
                     "场景中没有开关：应在 [[world.switch]] 中描述");
  }
  if (number < 1 || static_cast<size_t>(number) > count) {
    return MakeError(7, "there is no switch {0}: they are 1 to {1}",
                     "没有开关 {0}：编号为 1 至 {1}", number, count);
  }
  if (from > to) {
    return MakeError(7, "'from' is greater than 'to': exchange them", "“from”大于“to”：应对调");
  }
  Change change;
  change.move = runtime::SwitchMove{InputInstant(), number, from, to};
  AddChange(std::move(change));
  return {};
}

void RewindableRun::UpdateWorld() {
  const bool bare = calls_ != nullptr && calls_->bare() && changes_.empty();
  if (bare) {
    world_events_ = nullptr;
  } else {
    const runtime::Scenario changed = ScenarioWithChanges();
    world_events_ = std::make_shared<const motion::WorldEvents>(
        runtime::EventsOf(changed.world, changed.bus, clock()));
  }
  world_clock_ = clock();
  controller_.motion().SetEvents(world_events_);
}

// --- Recording -----------------------------------------------------------------------------------

vm::Schedule RewindableRun::Record(const std::string& path) {
  vm::Recording recording;
  recording.program_hash = image().hash;
  const int64_t present = moment();
  Restore(kept_.front());
  controller_.machine().Record(&recording);
  AdvanceTo(present);
  controller_.machine().EndRecording();
  const int64_t now_us = clock().UsOf(controller_.cycle());
  if (!Over()) recording.cut_us = now_us;
  runtime::Scenario scenario = ScenarioWithWrites(present);
  if (place_.over_cycle >= 0 && place_.over_cycle < controller_.cycle()) {
    constexpr int64_t kMs = 1000;
    scenario.until_us = now_us;
    scenario.limit_ms = std::max(scenario.limit_ms, (now_us + kMs - 1) / kMs);
  }
  if (!path.empty()) scenario = runtime::MoveScenario(scenario, path);
  recording.scenario = runtime::FormatScenario(runtime::ScenarioOfOneRun(scenario));
  return vm::ScheduleOf(recording);
}

std::vector<RewindableRun::Turn> RewindableRun::Turns(int64_t from, int64_t to, size_t most) {
  std::vector<Turn> turns;
  const int64_t present = moment();
  GoTo(from);
  while (moment() < std::min(to, head_) && !EndIsWanted()) {
    const int64_t at = moment();
    const StepReport& step = Step();
    if (step.kind != StepKind::kStatement) continue;
    const int64_t cycle = controller_.cycle();
    if (!turns.empty() && turns.back().thread == step.thread && turns.back().cycle == cycle) {
      ++turns.back().statements;
      continue;
    }
    if (turns.size() == most) break;
    turns.push_back({at, cycle, step.thread, 1});
  }
  GoTo(present);
  return turns;
}

std::vector<RewindableRun::Span> RewindableRun::Spans(int64_t from, int64_t to, size_t most) {
  std::vector<Span> spans;
  std::array<std::optional<size_t>, vm::kThreadCount> open;
  const auto close = [&](std::optional<size_t>& number) {
    if (!number) return;
    spans[*number].to = moment();
    spans[*number].to_cycle = controller_.cycle();
    number.reset();
  };
  const int64_t present = moment();
  GoTo(from);
  for (bool full = false;;) {
    const uint32_t runnable = machine().RunnableThreads();
    for (int number = 0; number < vm::kThreadCount; ++number) {
      const vm::ThreadState& thread = machine().thread(number);
      auto& span = open[static_cast<size_t>(number)];
      const bool waits = thread.run == vm::ThreadRun::kRunning && (runnable >> number & 1) == 0;
      if (span && LooksSame(spans[*span], thread, waits)) continue;
      close(span);
      if (thread.run == vm::ThreadRun::kUnbound) continue;
      full = full || spans.size() == most;
      if (full) continue;
      span = spans.size();
      const int64_t cycle = controller_.cycle();
      spans.push_back({number, waits, thread, machine().image(), machine().Line(number), moment(),
                       moment(), cycle, cycle});
    }
    if (full || moment() >= std::min(to, head_) || EndIsWanted()) break;
    Step();
  }
  for (auto& span : open) close(span);
  GoTo(present);
  return spans;
}

}  // namespace oncard::session
