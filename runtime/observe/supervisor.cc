#include "runtime/observe/supervisor.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <optional>

#include "base/milliseconds.h"
#include "runtime/observe/moving_axes.h"
#include "runtime/sim/card_event_text.h"

namespace oncard::runtime {

using gtcalls::MotionRole;
using motion::ProfileMode;

struct Supervisor::CallSite {
  static constexpr int16_t kNone = -2;

  uint64_t program = 0;
  int16_t caller = kNone;  ///< thread, or vm::kHostCaller
  // Of a thread.
  uint16_t function = 0;
  uint16_t instruction = 0;
  // Of the host.
  uint16_t command = 0;
  std::array<double, 2> values{};  ///< the first arguments, if they are values

  bool known() const { return caller != kNone; }
};

struct Supervisor::History {
  struct Profile {
    CallSite set_up;    ///< sets values that no start has taken over
    CallSite left_out;  ///< a later start of the same caller, without this profile
    CallSite started;   ///< the last start
    /// What has stopped the axis of the same number; nobody has taken note of it yet.
    std::optional<motion::CardEvent> stop;
    int64_t stopped_us = 0;
  };
  /// Of a periodic thread.
  struct Overruns {
    int64_t last_start = 0;  ///< the last one that was missed, in cycles
    int64_t missed = 0;      ///< starts that the same run has missed
  };

  std::array<Profile, motion::kAxisMax> profiles;
  std::array<Overruns, vm::kThreadCount> overruns{};
  uint32_t set_up = 0;        ///< profiles for which a target or a velocity has ever been set
  uint32_t velocity_set = 0;  ///< the same for a velocity
};

struct Supervisor::Found {
  std::vector<CardFinding> findings;
  std::map<Key, size_t> known;  ///< where they are
  /// Of each periodic thread, in periods: belongs to its finding, not to the history.
  std::array<int64_t, vm::kThreadCount> longest_runs{};
};

namespace {

/// A shared value, to be changed: others who have it keep it as it was.
template <typename Value>
Value& Own(std::shared_ptr<Value>* shared) {
  if (shared->use_count() > 1) *shared = std::make_shared<Value>(**shared);
  return **shared;
}

/// True if a command may start a motion: it writes axes or coordinate systems.
bool MayStartMotion(const gtcalls::Command& command) {
  using gtcalls::Resource;
  return std::ranges::any_of(command.accesses, [](const gtcalls::Access& access) {
    return access.write &&
           (access.resource == Resource::kAxis || access.resource == Resource::kCrd ||
            access.resource == Resource::kEverything);
  });
}

/// The profiles that a command of kCommit names.
uint32_t SelectedMask(const gtcalls::Call& call) {
  return static_cast<uint32_t>(static_cast<int64_t>(call.value(0)));
}

/// `1, 2`.
std::string ListOf(uint32_t mask) {
  std::vector<size_t> numbers;
  motion::ForEachBit(mask, motion::kAxisMax, [&](size_t axis) { numbers.push_back(axis + 1); });
  return fmt::format("{}", fmt::join(numbers, ", "));
}

/// True if a report of the card says why an axis that moved, or whose drive was on, has stopped.
bool StopsAxis(const motion::MotionCore& core, const motion::CardEvent& event) {
  using motion::CardEventKind;
  const motion::MotionState& state = core.state();
  const size_t item = event.item;
  switch (event.kind) {
    // An axis moves away from a limit freely; homing goes to limits.
    case CardEventKind::kPositiveLimitSwitch:
    case CardEventKind::kPositiveSoftLimit:
      return state.axes[item].profile.velocity > 0 && !state.homing[item].running;
    case CardEventKind::kNegativeLimitSwitch:
    case CardEventKind::kNegativeSoftLimit:
      return state.axes[item].profile.velocity < 0 && !state.homing[item].running;
    case CardEventKind::kSmoothStopInput:
    case CardEventKind::kAbruptStopInput:
      return core.AxisMoving(state.axes[item]);
    case CardEventKind::kAlarm:
      return state.axes[item].servo_on;
    case CardEventKind::kFollowingError:
    case CardEventKind::kEncoderSilent:
    case CardEventKind::kGantrySkew:
    case CardEventKind::kHeldAtLimit:
      return true;
    case CardEventKind::kBeyondErrorLimit:
    case CardEventKind::kMovedBySegment:
    case CardEventKind::kMovedByPath:
    case CardEventKind::kTooFast:
    case CardEventKind::kTooSteep:
    case CardEventKind::kStarved:
    case CardEventKind::kEndedMoving:
    case CardEventKind::kMoveStopped:
    case CardEventKind::kCornerLimited:
    case CardEventKind::kJunctionLimited:
      break;
  }
  return false;
}

/// True if another profile follows this one as its master.
bool IsMaster(const motion::MotionState& state, size_t profile) {
  return std::ranges::any_of(state.profiles, [&](const motion::Profile& slave) {
    const motion::Master* master = slave.SelectedMaster();
    return master != nullptr && master->chosen && master->index == profile &&
           master->type != motion::MasterType::kEncoder;
  });
}

}  // namespace

// --- Texts ---------------------------------------------------------------------------------------

namespace {

Message DescribeNamedFinding(const CardFinding& finding, const std::string& program_path,
                             const Message& when) {
  const Message place = DescribePlace(finding.place, program_path);
  const std::string_view name = InfoOf(finding.warning).name;
  return {fmt::format("{}{}{} [{}]", place.en, finding.text.en, when.en, name),
          fmt::format("{}{}{} [{}]", place.zh, finding.text.zh, when.zh, name)};
}

}  // namespace

Message DescribeFindingPlace(const CardFinding& finding, const std::string& program_path) {
  return DescribeNamedFinding(finding, program_path, {});
}

Message DescribeFinding(const CardFinding& finding, const std::string& program_path) {
  return DescribeNamedFinding(finding, program_path,
                              DescribeOccurrences(finding.first_us, finding.count));
}

// --- Beginning -----------------------------------------------------------------------------------

Supervisor::Supervisor(Controller* controller)
    : controller_(*controller),
      history_(std::make_shared<History>()),
      found_(std::make_shared<Found>()) {
  const gtcalls::Family& family = controller_.family();
  for (const gtcalls::Command& command : family.catalogue.commands()) {
    kinds_.push_back({family.motion_role(command), MayStartMotion(command)});
  }
  controller->ObserveWith(this);
}

Supervisor::~Supervisor() { controller_.ObserveWith(nullptr); }

Supervisor::History& Supervisor::Present() { return Own(&history_); }

Supervisor::Found& Supervisor::PresentFound() { return Own(&found_); }

void Supervisor::Reset() { history_ = std::make_shared<History>(); }

void Supervisor::AddTo(const HistoryPointer& history, std::vector<int64_t>* words) {
  const auto add_site = [&](const CallSite& site) {
    words->insert(words->end(), {static_cast<int64_t>(site.program), site.caller, site.function,
                                 site.instruction, site.command});
    for (const double value : site.values) words->push_back(std::bit_cast<int64_t>(value));
  };
  const auto& [profiles, overruns, set_up, velocity_set] = *history;
  for (const auto& [waiting, left_out, started, stop, stopped_us] : profiles) {
    add_site(waiting);
    add_site(left_out);
    add_site(started);
    words->push_back(stop.has_value());
    if (!stop) continue;
    const auto& [kind, item, value, bound] = *stop;
    words->insert(words->end(), {static_cast<int64_t>(kind), static_cast<int64_t>(item),
                                 std::bit_cast<int64_t>(value), std::bit_cast<int64_t>(bound)});
    words->push_back(stopped_us);
  }
  for (const auto& [last_start, missed] : overruns) {
    words->insert(words->end(), {last_start, missed});
  }
  words->insert(words->end(), {set_up, velocity_set});
}

uint32_t Supervisor::AwaitedProfiles(const HistoryPointer& history) {
  uint32_t awaited = 0;
  uint32_t bit = 1;
  for (const History::Profile& profile : history->profiles) {
    if (profile.set_up.known()) awaited |= bit;
    bit <<= 1;
  }
  return awaited;
}

// --- Places --------------------------------------------------------------------------------------

Supervisor::CallSite Supervisor::SiteOf(const gtcalls::Call& call) const {
  CallSite site;
  site.caller = static_cast<int16_t>(call.caller);
  if (call.caller == vm::kHostCaller) {
    site.command = call.command.number;
    for (size_t i = 0; i < std::min(site.values.size(), call.arguments.size()); ++i) {
      site.values[i] = call.value(i);
    }
    return site;
  }
  const vm::ThreadState& thread = controller_.machine().thread(call.caller);
  site.program = controller_.machine().image()->hash;
  site.function = thread.function;
  site.instruction = thread.pc;
  return site;
}

CommandPlace Supervisor::PlaceOfSite(const CallSite& site) const {
  const vm::Image* image = controller_.machine().image();
  if (site.caller != vm::kHostCaller) {
    if (image == nullptr || image->hash != site.program) return {};
    return PlaceOfInstruction(controller_.machine(), site.caller, site.function, site.instruction);
  }
  const gtcalls::Command& command = *controller_.family().catalogue.Find(site.command);
  CommandPlace place;
  place.call = command.name;
  const bool kept = command.parameters.size() <= site.values.size() &&
                    std::ranges::all_of(command.parameters, [](const gtcalls::Parameter& each) {
                      return each.passing == gtcalls::Passing::kValue;
                    });
  if (!kept) return place;
  std::vector<vm::CommandArgument> arguments(command.parameters.size());
  for (size_t i = 0; i < arguments.size(); ++i) arguments[i].value = site.values[i];
  place.call = FormatInputs(command, arguments);
  return place;
}

// --- Commands ------------------------------------------------------------------------------------

void Supervisor::BeforeCommand(const gtcalls::Call& call) {
  if (KindOf(call.command).moves) moving_before_ = Moving();
}

void Supervisor::AfterCommand(const gtcalls::Call& call, int16_t code) {
  const CommandKind kind = KindOf(call.command);
  if (code != vm::kOk || !kind.moves) return;
  switch (kind.role) {
    case MotionRole::kTarget:
    case MotionRole::kVelocity:
      NoteSetUp(call, kind.role);
      break;
    case MotionRole::kCommit:
      NoteCommit(call);
      break;
    case MotionRole::kAcknowledge:
      NoteAcknowledged(call);
      break;
    case MotionRole::kNone:
      break;
  }
  const uint32_t begun = Moving() & ~moving_before_;
  if (begun == 0) return;
  NoteStart(call, begun);
  motion::ForEachBit(begun, motion::kAxisMax, [&](size_t profile) { CheckDrive(call, profile); });
}

void Supervisor::NoteStart(const gtcalls::Call& call, uint32_t profiles) {
  motion::ForEachBit(profiles, core().axis_count(), [&](size_t profile) {
    Present().profiles[profile] = {
        .set_up = {}, .left_out = {}, .started = SiteOf(call), .stop = {}};
  });
}

void Supervisor::NoteAcknowledged(const gtcalls::Call& call) {
  const auto first = static_cast<size_t>(call.integer(0)) - 1;
  for (size_t i = first; i < first + static_cast<size_t>(call.integer(1)); ++i) {
    if (history_->profiles[i].stop) Present().profiles[i].stop.reset();
  }
}

uint32_t Supervisor::Moving() const {
  uint32_t moving = 0;
  for (size_t i = 0; i < core().axis_count(); ++i) {
    if (core().state().profiles[i].now.moving) moving |= uint32_t{1} << i;
  }
  return moving;
}

bool Supervisor::OfTwoThreads(const gtcalls::Call& call, const CallSite& earlier) const {
  if (call.caller == vm::kHostCaller || !earlier.known()) return false;
  if (earlier.caller == vm::kHostCaller || earlier.caller == call.caller) return false;
  return vm::IsActive(controller_.machine().thread(earlier.caller));
}

void Supervisor::CheckTarget(const gtcalls::Call& call, size_t index) {
  const CallSite& waiting = history_->profiles[index].set_up;
  if (!OfTwoThreads(call, waiting)) return;
  Add(CardWarning::kTwoThreads, call, index,
      MakeMessage("axis {0} gets a target while the one that thread {1} has set in line {2} is not "
                  "started yet; unless the threads wait for each other, either can be lost",
                  "轴 {0} 设置目标时，线程 {1} 在第 {2} 行设置的目标尚未启动；若两线程互不等待，"
                  "其中之一可能丢失",
                  index + 1, waiting.caller, PlaceOfSite(waiting).line));
}

void Supervisor::CheckChange(const gtcalls::Call& call, size_t index) {
  const motion::Profile& profile = core().profile(index);
  const History::Profile& known = history_->profiles[index];
  if (profile.mode != ProfileMode::kTrap || (moving_before_ >> index & 1) == 0) return;
  // A start by which another thread changes its own motion, or a velocity, is no new target.
  if (known.set_up.caller != call.caller || !OfTwoThreads(call, known.started)) return;
  Add(CardWarning::kTwoThreads, call, index,
      MakeMessage(
          "axis {0} gets a new target while it still moves for thread {1}, which started it "
          "in line {2}; unless the threads wait for each other, either can be lost",
          "轴 {0} 还在为线程 {1}（第 {2} 行启动）运动时改变目标；若两线程互不等待，其中之一"
          "可能丢失",
          index + 1, known.started.caller, PlaceOfSite(known.started).line));
}

void Supervisor::NoteSetUp(const gtcalls::Call& call, MotionRole role) {
  const auto index = static_cast<size_t>(call.integer(0)) - 1;
  History& history = Present();
  history.set_up |= uint32_t{1} << index;
  if (role == MotionRole::kVelocity) history.velocity_set |= uint32_t{1} << index;
  // In mode Trap a velocity alone leads nowhere.
  const ProfileMode mode = core().profile(index).mode;
  if (mode == ProfileMode::kTrap && role == MotionRole::kTarget) CheckTarget(call, index);
  const bool leads = role == MotionRole::kTarget || mode == ProfileMode::kJog;
  if (leads) history.profiles[index].set_up = SiteOf(call);
}

void Supervisor::NoteCommit(const gtcalls::Call& call) {
  const uint32_t mask = SelectedMask(call);
  CheckMask(call, mask);
  NoteLeftOut(call, mask);
  motion::ForEachBit(mask, core().axis_count(), [&](size_t profile) {
    CheckVelocity(call, profile);
    CheckChange(call, profile);
  });
  NoteStart(call, mask);
}

bool Supervisor::AwaitsStart(size_t index) const {
  const motion::Profile& profile = core().profile(index);
  if (!history_->profiles[index].set_up.known()) return false;
  switch (profile.mode) {
    case ProfileMode::kTrap:
      return profile.trap.target != profile.now.position;
    case ProfileMode::kJog:
      return profile.jog.velocity != 0;
    default:
      return false;
  }
}

void Supervisor::CheckMask(const gtcalls::Call& call, uint32_t mask) {
  if ((mask & history_->set_up) != 0) return;
  Message text = MakeMessage("the mask starts axis {0}, for which nothing has been set",
                             "掩码启动了未设置过运动参数的轴 {0}", ListOf(mask));
  uint32_t waiting = 0;
  for (size_t i = 0; i < core().axis_count(); ++i) {
    if (AwaitsStart(i)) waiting |= uint32_t{1} << i;
  }
  if (waiting != 0) {
    const Message hint = MakeMessage("; the mask of axis {0} is {1}", "；轴 {0} 的掩码为 {1}",
                                     ListOf(waiting), waiting);
    text = {text.en + hint.en, text.zh + hint.zh};
    // Enough has been said of them.
    motion::ForEachBit(waiting, motion::kAxisMax,
                       [&](size_t profile) { Present().profiles[profile].set_up = {}; });
  }
  Add(CardWarning::kUpdateMask, call, std::move(text));
}

void Supervisor::NoteLeftOut(const gtcalls::Call& call, uint32_t mask) {
  for (size_t i = 0; i < core().axis_count(); ++i) {
    const History::Profile& profile = history_->profiles[i];
    if ((mask >> i & 1) != 0 || profile.left_out.known() || !AwaitsStart(i)) continue;
    if (profile.set_up.caller == call.caller) Present().profiles[i].left_out = SiteOf(call);
  }
}

void Supervisor::CheckVelocity(const gtcalls::Call& call, size_t index) {
  const uint32_t bit = uint32_t{1} << index;
  // An axis that moves is stopped by a start with the velocity 0.
  if ((moving_before_ & bit) != 0) return;
  const motion::Profile& profile = core().profile(index);
  const bool set = (history_->velocity_set & bit) != 0;
  const bool in_place =
      profile.mode == ProfileMode::kTrap
          ? profile.trap.velocity == 0 && profile.trap.target != profile.now.position
          : profile.jog.velocity == 0 && !set;
  if (!in_place) return;
  Add(CardWarning::kNoVelocity, call, index,
      set ? MakeMessage("axis {0} is started with the velocity 0 and does not move",
                        "轴 {0} 以速度 0 启动，不会运动", index + 1)
          : MakeMessage("axis {0} is started without a velocity and does not move, call {1}",
                        "轴 {0} 启动时未设置速度，不会运动，请调用 {1}", index + 1,
                        controller_.family().advised.velocity));
}

Message Supervisor::DescribeDriveOff(size_t axis) const {
  return MakeMessage("axis {0} moves while its drive is off, call {1} first",
                     "轴 {0} 在伺服使能关闭时运动，请先调用 {1}", axis + 1,
                     controller_.family().advised.drive_on);
}

void Supervisor::CheckDrive(const gtcalls::Call& call, size_t index) {
  // A path says itself which of its members it moves.
  if (core().profile(index).mode == ProfileMode::kCrd) return;
  const std::optional<size_t> off = core().readings().AxisWithDriveOff(index);
  // A profile without an axis, or one that only leads others, needs no drive.
  if (!off || IsMaster(core().state(), index)) return;
  Add(CardWarning::kDriveOff, call, *off, DescribeDriveOff(*off));
}

// --- What the card does by itself ----------------------------------------------------------------

void Supervisor::NoteBeyondLimit(const motion::CardEvent& event) {
  const CallSite& site = history_->profiles[event.item].started;
  Key key = KeyOf(CardWarning::kAxisLimit, site, event.item);
  std::get<std::string>(key) +=
      event.kind == motion::CardEventKind::kTooFast ? " velocity" : " acceleration";
  Add(std::move(key), PlaceOfSite(site), DescribeCardEvent(event, controller_.family().advised),
      controller_.NowUs());
}

void Supervisor::NoteMovedByPath(const motion::CardEvent& event) {
  const motion::MotionState& state = core().state();
  bool leads = false;
  motion::ForEachBit(state.axes[event.item].profile_map, motion::kAxisMax,
                     [&](size_t profile) { leads = leads || IsMaster(state, profile); });
  if (leads) return;
  if (event.kind == motion::CardEventKind::kMovedBySegment) {
    const CallSite& site = history_->profiles[event.item].started;
    Add(KeyOf(CardWarning::kDriveOff, site, event.item), PlaceOfSite(site),
        DescribeDriveOff(event.item), controller_.NowUs());
    return;
  }
  Add({CardWarning::kDriveOff, 0, static_cast<int>(event.bound), static_cast<int>(event.item),
       "path"},
      {}, DescribeCardEvent(event, controller_.family().advised), controller_.NowUs());
}

void Supervisor::Happened(const motion::CardEvent& event) {
  if (event.kind == motion::CardEventKind::kMovedBySegment ||
      event.kind == motion::CardEventKind::kMovedByPath) {
    return NoteMovedByPath(event);
  }
  if (event.kind == motion::CardEventKind::kTooFast ||
      event.kind == motion::CardEventKind::kTooSteep) {
    return NoteBeyondLimit(event);
  }
  if (!StopsAxis(core(), event)) return;
  if (history_->profiles[event.item].stop) return;
  History::Profile& profile = Present().profiles[event.item];
  profile.stop = event;
  profile.stopped_us = controller_.clock().UsOf(controller_.cycle());
}

void Supervisor::Overran(int number) {
  const vm::Machine& machine = controller_.machine();
  const vm::ThreadState& thread = machine.thread(number);
  History::Overruns& overruns = Present().overruns[static_cast<size_t>(number)];
  // A run that misses the next start, too, is still the same.
  const bool same =
      overruns.missed > 0 && overruns.last_start + thread.period_cycles == thread.next_start;
  overruns.missed = same ? overruns.missed + 1 : 1;
  overruns.last_start = thread.next_start;
  int64_t& longest = PresentFound().longest_runs[static_cast<size_t>(number)];
  longest = std::max(longest, overruns.missed);
  const CardClock& clock = controller_.clock();
  const double period_ms = ToMs(clock.UsIn(thread.period_cycles));
  CardFinding& finding =
      Add({CardWarning::kPeriodOverrun, machine.image()->hash, thread.function, number, {}},
          PlaceOfInstruction(machine, number, thread.function, thread.pc), {},
          clock.UsOf(machine.state().cycle));
  finding.text = MakeMessage(
      "the thread overruns its period of {0} ms here, its longest run lasts more than {1} ms",
      "线程在此处超出其周期 {0} ms，最长一次运行超过 {1} ms", period_ms,
      period_ms * static_cast<double>(longest));
}

// --- The end of a run ----------------------------------------------------------------------------

void Supervisor::JudgeEnd() {
  const size_t before = findings().size();
  for (size_t i = 0; i < core().axis_count(); ++i) {
    JudgeStop(i);
    JudgeLeftOut(i);
  }
  JudgeWorkLeft();
  for (size_t i = before; i < findings().size(); ++i) PresentFound().findings[i].at_end = true;
}

void Supervisor::ForgetEnd() {
  if (std::ranges::none_of(findings(), &CardFinding::at_end)) return;
  Found& found = PresentFound();
  std::vector<size_t> indices;  // of those that stay
  size_t staying = 0;
  for (const CardFinding& finding : found.findings) {
    indices.push_back(staying);
    if (!finding.at_end) ++staying;
  }
  std::erase_if(found.known,
                [&](const auto& entry) { return found.findings[entry.second].at_end; });
  for (auto& [key, index] : found.known) index = indices[index];
  std::erase_if(found.findings, [](const CardFinding& finding) { return finding.at_end; });
}

void Supervisor::JudgeWorkLeft() {
  motion::ForEachBit(MovingAxes(controller_), motion::kAxisMax, [&](size_t axis) {
    const CallSite& site = history_->profiles[axis].started;
    Add(KeyOf(CardWarning::kWorkLeft, site, axis), PlaceOfSite(site),
        DescribeMovingAxis(controller_, axis), controller_.NowUs())
        .count = 0;
  });
  const motion::MotionState& state = core().state();
  for (size_t crd = 0; crd < state.crds.size(); ++crd) {
    for (size_t fifo = 0; fifo < state.crds[crd].fifos.size(); ++fifo) {
      const size_t left = state.crds[crd].fifos[fifo].Remaining();
      if (left == 0 || state.crds[crd].run.running) continue;
      Add({CardWarning::kWorkLeft, 0, static_cast<int>(crd), static_cast<int>(fifo), "fifo"}, {},
          MakeMessage("coordinate system {0} rests at the end of the run with segments left in its "
                      "FIFO {1}: {2}",
                      "运行结束时坐标系 {0} 静止，其 FIFO {1} 中还有 {2} 段未执行", crd + 1, fifo,
                      left),
          controller_.NowUs())
          .count = 0;
    }
  }
}

void Supervisor::JudgeStop(size_t index) {
  const History::Profile& profile = history_->profiles[index];
  if (!profile.stop) return;
  Add(KeyOf(CardWarning::kAxisStopped, profile.started, index), PlaceOfSite(profile.started),
      DescribeCardEvent(*profile.stop, controller_.family().advised), profile.stopped_us);
}

void Supervisor::JudgeLeftOut(size_t i) {
  const History::Profile& profile = history_->profiles[i];
  if (profile.left_out.known() && AwaitsStart(i)) {
    Add(KeyOf(CardWarning::kUpdateMask, profile.left_out, i), PlaceOfSite(profile.left_out),
        MakeMessage(
            "the mask leaves out axis {0}, which is set up and never started; its mask is {1}",
            "掩码未包括已设置的轴 {0}，此后也没有启动它；其掩码为 {1}", i + 1, uint32_t{1} << i),
        controller_.NowUs());
  }
}

// --- Findings ------------------------------------------------------------------------------------

const std::vector<CardFinding>& Supervisor::findings() const { return found_->findings; }

void Supervisor::Include(const Supervisor& other) {
  if (other.findings().empty()) return;
  Found& found = PresentFound();
  IncludeFound(other.found_->known, other.findings(), &found.known, &found.findings);
}

Supervisor::Key Supervisor::KeyOf(CardWarning warning, const CallSite& site, size_t axis) const {
  Key key = KeyOf(warning, site);
  std::get<std::string>(key) += fmt::format(" {}", axis);
  return key;
}

Supervisor::Key Supervisor::KeyOf(CardWarning warning, const CallSite& site) const {
  if (site.caller == vm::kHostCaller) return {warning, 0, 0, 0, PlaceOfSite(site).call};
  return {warning, site.program, site.function, site.instruction, {}};
}

void Supervisor::Add(CardWarning warning, const gtcalls::Call& call, Message text) {
  Add(KeyOf(warning, SiteOf(call)), PlaceOf(call), std::move(text), controller_.NowUs());
}

void Supervisor::Add(CardWarning warning, const gtcalls::Call& call, size_t axis, Message text) {
  Add(KeyOf(warning, SiteOf(call), axis), PlaceOf(call), std::move(text), controller_.NowUs());
}

CardFinding& Supervisor::Add(Key key, CommandPlace place, Message text, int64_t at_us) {
  Found& found = PresentFound();
  const auto [entry, added] = found.known.try_emplace(std::move(key), found.findings.size());
  if (added) {
    found.findings.push_back(
        {std::get<CardWarning>(entry->first), std::move(place), std::move(text), at_us, 0});
  }
  CardFinding& finding = found.findings[entry->second];
  ++finding.count;
  return finding;
}

}  // namespace oncard::runtime
