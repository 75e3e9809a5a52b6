#include "explore/reports/culprit.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace oncard::explore {
namespace {

using runtime::LoggedStep;
using runtime::SlotChange;
using runtime::SlotValue;
using vm::SlotAddress;

/// A global that a thread has read, and the step in which it did: a source of a local's value or of
/// a decision.
struct Source {
  SlotValue value;
  size_t step = 0;
};
using Sources = std::vector<Source>;

/// A longer list of sources would not be readable.
constexpr size_t kSourceMax = 64;

void Add(const Sources& more, Sources* sources) {
  for (const Source& source : more) {
    const auto same = [&](const Source& each) {
      return each.step == source.step && runtime::SameSlot(each.value.slot, source.value.slot);
    };
    if (sources->size() < kSourceMax && std::ranges::none_of(*sources, same)) {
      sources->push_back(source);
    }
  }
}

/// A thread has used at `use` the value that it read at `read`, although another thread changed it
/// at `write`.
struct StaleUse {
  using Kind = StaleValue::Kind;
  Kind kind = Kind::kOverwrites;
  SlotValue value;
  size_t read = 0;
  size_t write = 0;
  size_t use = 0;
};

/// Which of two uses is reported: the higher one, and of equal ones the later one.
struct UseRank {
  bool agrees = false;  ///< it is between the threads of the racing pair, about its variable or
                        ///< one of its statements
  bool synchronises = false;  ///< its variable is there to order the threads
  int kind = 0;               ///< overwriting ranks over deciding, and that over computing
  bool fatal = false;         ///< it involves the statement after which every end is bad

  bool operator>=(const UseRank& other) const {
    const auto ordered = [](const UseRank& rank) {
      return std::tuple(rank.agrees, !rank.synchronises, rank.kind, rank.fatal);
    };
    return ordered(*this) >= ordered(other);
  }
};

/// Ranks uses by what is known of the failure.
class UseJudge {
 public:
  UseJudge(const Subject& subject, const Trail& trail, int64_t last_escape)
      : subject_(subject), trail_(trail), last_escape_(last_escape) {}

  UseRank Of(const StaleUse& use) const {
    return {Agrees(use), Synchronises(use), KindRank(use.kind),
            last_escape_ >= 0 && Involves(use, static_cast<size_t>(last_escape_))};
  }
  bool Agrees(const StaleUse& use) const {
    if (!trail_.pair) return true;
    const RacingPair& pair = *trail_.pair;
    const auto thread = [&](size_t step) { return trail_.steps[step].thread; };
    const std::set<int> of_pair = {thread(pair.first.step), thread(pair.second.step)};
    if (of_pair != std::set<int>{thread(use.use), thread(use.write)}) return false;
    return NameOf(use) == pair.what || Involves(use, pair.first.step) ||
           Involves(use, pair.second.step);
  }

 private:
  static int KindRank(StaleUse::Kind kind) {
    switch (kind) {
      case StaleUse::Kind::kOverwrites:
        return 2;
      case StaleUse::Kind::kDecides:
        return 1;
      case StaleUse::Kind::kComputes:
        break;
    }
    return 0;
  }
  static bool Involves(const StaleUse& use, size_t step) {
    return use.write == step || use.use == step || use.read == step;
  }
  std::string NameOf(const StaleUse& use) const {
    return runtime::NameOf(trail_.steps[use.read].log, use.value.slot, subject_.image->object);
  }
  bool Synchronises(const StaleUse& use) const {
    const std::string name = NameOf(use);
    const std::string variable = name.substr(0, name.find('['));
    return std::ranges::find(subject_.sync, variable) != subject_.sync.end();
  }

  const Subject& subject_;
  const Trail& trail_;
  int64_t last_escape_;
};

/// Follows values from globals through locals and decisions, and keeps the use to be reported.
class Flow {
 public:
  Flow(const Trail& trail, const UseJudge& judge) : judge_(judge) {
    for (now_ = 0; now_ < trail.steps.size(); ++now_) {
      Take(trail.steps[now_], trail.matters[now_]);
    }
  }
  const std::optional<StaleUse>& use() const { return use_; }

 private:
  static int KeyOf(const SlotAddress& local) { return local.page * vm::kSlotCount + local.id; }

  void Take(const TrailStep& step, bool matters) {
    Sources sources;
    for (const SlotValue& read : step.log.reads) {
      if (read.slot.global) {
        Add({{read, now_}}, &sources);
      } else {
        Add(locals_[KeyOf(read.slot)], &sources);
      }
    }
    const bool acts = step.log.command || std::ranges::any_of(step.log.writes, [](const auto& w) {
                        return w.slot.global;
                      });
    if (acts && matters) {
      for (const Source& source : sources) Judge(source, KindOf(source, step), step.thread);
      for (const Source& source : decisions_[step.thread]) {
        Judge(source, StaleUse::Kind::kDecides, step.thread);
      }
    }
    if (step.log.decides) decisions_[step.thread] = sources;
    for (const SlotChange& write : step.log.writes) {
      if (!write.slot.global) {
        locals_[KeyOf(write.slot)] = sources;
        continue;
      }
      if (write.before == write.after) continue;
      Writers& writers = writers_[write.slot.id];
      if (writers.last && writers.last->thread != step.thread) writers.other = writers.last;
      writers.last = GlobalWrite{now_, step.thread, write.after};
    }
  }

  static StaleUse::Kind KindOf(const Source& source, const TrailStep& step) {
    const bool back = std::ranges::any_of(step.log.writes, [&](const SlotChange& write) {
      return runtime::SameSlot(write.slot, source.value.slot);
    });
    return back ? StaleUse::Kind::kOverwrites : StaleUse::Kind::kComputes;
  }

  /// Checks whether another thread has changed what the source read.
  void Judge(const Source& source, StaleUse::Kind kind, int thread) {
    const Writers& writers = writers_[source.value.slot.id];
    const auto& write =
        writers.last && writers.last->thread != thread ? writers.last : writers.other;
    if (!write || write->thread == thread || write->step <= source.step) return;
    if (write->value == source.value.raw) return;
    const StaleUse use = {kind, source.value, source.step, write->step, now_};
    if (!use_ || judge_.Of(use) >= judge_.Of(*use_)) use_ = use;
  }

  struct GlobalWrite {
    size_t step = 0;
    int thread = 0;
    int64_t value = 0;
  };
  /// The latest change of a global, and the latest write by another thread than that one.
  struct Writers {
    std::optional<GlobalWrite> last;
    std::optional<GlobalWrite> other;
  };

  const UseJudge& judge_;
  size_t now_ = 0;
  std::map<int, Sources> locals_;     ///< by page and slot
  std::map<int, Sources> decisions_;  ///< of each thread, the latest one
  std::map<int, Writers> writers_;    ///< by slot
  std::optional<StaleUse> use_;
};

/// Describes steps in words.
class CulpritDescriber {
 public:
  CulpritDescriber(const Subject& subject, const Trail& trail)
      : trail_(trail), object_(subject.image->object) {}

  Culprit Describe(const StaleUse& use) const {
    const LoggedStep& read = Log(use.read);
    const LoggedStep& write = Log(use.write);
    const LoggedStep& acts = Log(use.use);
    const std::string name = NameOf(read, use.value.slot, object_);
    const std::string old = ValueText(read, use.value.slot, use.value.raw, object_);
    const std::string there = WrittenTo(write, use.value.slot);
    Culprit culprit;
    culprit.steps = {use.read, use.write, use.use};
    culprit.stale = {use.kind, name, old, there, use.read, use.write, use.use};
    switch (use.kind) {
      case StaleUse::Kind::kOverwrites:
        culprit.sentence = MakeMessage(
            "thread {0} wrote {1} = {2} over thread {3}'s {4} at step {5}, because it had read "
            "{1} = {6} at step {7}, before thread {3} wrote it at step {8}",
            "线程 {0} 在第 {5} 步用 {1} = {2} 覆盖了线程 {3} 的 {4}，因为它在第 {7} 步读到 {1} = "
            "{6}，早于线程 {3} 在第 {8} 步的写入",
            acts.thread, name, WrittenTo(acts, use.value.slot), write.thread, there, use.use + 1,
            old, use.read + 1, use.write + 1);
        break;
      case StaleUse::Kind::kComputes:
        culprit.sentence = MakeMessage(
            "thread {0} used {1} = {2} at step {3}, which it had read at step {4}; thread {5} had "
            "set it to {6} at step {7}",
            "线程 {0} 在第 {3} 步使用了第 {4} 步读到的 {1} = {2}，而线程 {5} 已在第 {7} 步将其改为 "
            "{6}",
            acts.thread, name, old, use.use + 1, use.read + 1, write.thread, there, use.write + 1);
        break;
      case StaleUse::Kind::kDecides:
        culprit.sentence = MakeMessage(
            "thread {0} continued to step {1}, because it had read {2} = {3} at step {4}; thread "
            "{5} had set it to {6} at step {7}",
            "线程 {0} 执行到第 {1} 步，因为它在第 {4} 步读到 {2} = {3}，而线程 {5} 已在第 {7} "
            "步将其改为 {6}",
            acts.thread, use.use + 1, name, old, use.read + 1, write.thread, there, use.write + 1);
        break;
    }
    return culprit;
  }

  /// Two statements whose order makes the difference.
  Culprit Describe(const RacingPair& pair) const {
    const LoggedStep& first = Log(pair.first.step);
    const LoggedStep& second = Log(pair.second.step);
    const auto does = [&](const LoggedStep& step, bool writes) -> Message {
      const auto is_what = [&](const auto& each) {
        return each.slot.global && NameOf(step, each.slot, object_) == pair.what;
      };
      const auto write = std::ranges::find_if(step.writes, is_what);
      if (writes && write != step.writes.end()) {
        const std::string value = ValueText(step, write->slot, write->after, object_);
        return MakeMessage("wrote {0} = {1}", "写入 {0} = {1}", pair.what, value);
      }
      const auto read = std::ranges::find_if(step.reads, is_what);
      if (!writes && read != step.reads.end()) {
        const std::string value = ValueText(step, read->slot, read->raw, object_);
        return MakeMessage("read {0} = {1}", "读到 {0} = {1}", pair.what, value);
      }
      return writes ? MakeMessage("acted on {0}", "操作了 {0}", pair.what)
                    : MakeMessage("looked at {0}", "查看了 {0}", pair.what);
    };
    const Message one = does(first, pair.first.writes);
    const Message two = does(second, pair.second.writes);
    Culprit culprit;
    culprit.steps = {pair.first.step, pair.second.step};
    culprit.sentence = {
        fmt::format("thread {} {} at step {}, before thread {} {} at step {}", first.thread, one.en,
                    pair.first.step + 1, second.thread, two.en, pair.second.step + 1),
        fmt::format("线程 {} 在第 {} 步{}，早于线程 {} 在第 {} 步{}", first.thread,
                    pair.first.step + 1, one.zh, second.thread, pair.second.step + 1, two.zh)};
    return culprit;
  }

 private:
  const LoggedStep& Log(size_t step) const { return trail_.steps[step].log; }
  std::string WrittenTo(const LoggedStep& step, const SlotAddress& slot) const {
    const auto is_slot = [&](const SlotChange& write) {
      return runtime::SameSlot(write.slot, slot);
    };
    const auto found = std::ranges::find_if(step.writes, is_slot);
    return found == step.writes.end() ? "" : ValueText(step, slot, found->after, object_);
  }

  const Trail& trail_;
  const vm::Object& object_;
};

}  // namespace

std::optional<Culprit> FindCulprit(const Subject& subject, const Failure& failure,
                                   const Trail& trail) {
  const bool told_already = failure.livelock || failure.fault.kind == Fault::Kind::kRace ||
                            failure.fault.kind == Fault::Kind::kDeadlock;
  if (told_already) return std::nullopt;
  const CulpritDescriber describer(subject, trail);
  const UseJudge judge(subject, trail, failure.last_escape - trail.skipped);
  const Flow flow(trail, judge);
  if (flow.use() && judge.Agrees(*flow.use())) return describer.Describe(*flow.use());
  if (trail.pair) return describer.Describe(*trail.pair);
  return std::nullopt;
}

}  // namespace oncard::explore
