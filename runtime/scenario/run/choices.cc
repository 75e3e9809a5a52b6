#include "runtime/scenario/run/choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/milliseconds.h"
#include "base/random.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_errors.h"

namespace oncard::runtime {
namespace {

using ChoiceKind = Choice::Kind;

/// `gpi[1]`; without an index all pins: `gpi`.
std::string NameOf(const InputEvent& event) {
  const std::string_view word = InputWordName(event.type);
  return event.index == 0 ? std::string(word) : fmt::format("{}[{}]", word, event.index);
}

/// `axis2.stall`, `switch1.cut_switch`.
std::string NameOf(const WorldFault& fault) {
  return fmt::format("{}{}.{}", fault.kind == FaultKind::kCutSwitch ? "switch" : "axis",
                     fault.number, kFaultNames[static_cast<size_t>(fault.kind)]);
}

/// True if one of the names is the other one, or an element of it.
bool Overlap(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return b.starts_with(a) && (b.size() == a.size() || b[a.size()] == '[');
}

class ChoiceFinder {
 public:
  ChoiceFinder(const Scenario& scenario, const CardClock& clock)
      : scenario_(scenario), clock_(clock) {}

  Result<std::vector<Choice>> Find() {
    const World& world = scenario_.world;
    for (size_t i = 0; i < world.inputs.size(); ++i) AddInput(world.inputs[i], i);
    for (size_t i = 0; i < world.faults.size(); ++i) {
      AddInstant(world.faults[i], {.kind = ChoiceKind::kFault,
                                   .index = i,
                                   .place = PlaceOfText(scenario_, kFaultPlaces, i)});
    }
    AddValues(scenario_.globals, {.kind = ChoiceKind::kGlobal});
    for (size_t i = 0; i < scenario_.threads.size(); ++i) {
      AddValues(scenario_.threads[i].values, {.kind = ChoiceKind::kLocal, .index = i});
    }
    if (choices_.size() > Choices::kChoicesMax) {
      ScenarioErrors too_many;
      too_many.Add(
          choices_[Choices::kChoicesMax].place,
          MakeMessage("there are {0} choices, and there can be {1}: give some a fixed value",
                      "共有 {0} 项选择，至多 {1} 项：应为其中一些给出确定的值", choices_.size(),
                      Choices::kChoicesMax));
      return *too_many.Failure();
    }
    CheckOthers(scenario_.globals);
    for (const ThreadStart& thread : scenario_.threads) CheckOthers(thread.values);
    NameLocals();
    CheckProduct();
    if (auto failure = errors_.Failure()) return *std::move(failure);
    return std::move(choices_);
  }

 private:
  void AddInput(const InputEvent& event, size_t index) {
    const TextPlace place = PlaceOfText(scenario_, kInputPlaces, index);
    Choice instant = {.kind = ChoiceKind::kInput, .index = index, .place = place};
    if (!event.any_level) instant.level = event.value;
    AddInstant(event, instant);
    if (!event.any_level) return;
    Choice level = {.kind = ChoiceKind::kLevel,
                    .index = index,
                    .name = NameOf(event),
                    .count = 2,
                    .place = place};
    if (!event.last_us) level.at_us = event.at_us;
    choices_.push_back(std::move(level));
  }

  /// The cycles of an event, if they are open.
  template <typename Event>
  void AddInstant(const Event& event, Choice choice) {
    if (!event.last_us) return;
    constexpr int64_t kNsPerUs = CardClock::kNsPerUs;
    choice.name = NameOf(event);
    choice.first = clock_.CycleAt(event.at_us);
    choice.count = clock_.LastEnded(*event.last_us * kNsPerUs) - choice.first + 1;
    CheckInstants(event.at_us, *event.last_us, choice);
    choices_.push_back(std::move(choice));
  }

  void CheckInstants(int64_t at_us, int64_t last_us, const Choice& choice) {
    const double first = ToMs(at_us);
    const double last = ToMs(last_us);
    if (choice.count < 1) {
      return errors_.Add(
          choice.place,
          MakeMessage("no cycle begins in the time of {0} from {1} to {2} ms, a cycle takes {3} "
                      "ms: make 'between_ms' longer, or use 'at_ms'",
                      "{0} 的时间段 {1} 至 {2} ms 内没有周期开始，周期为 {3} ms："
                      "应加长“between_ms”，或使用“at_ms”",
                      choice.name, first, last, ToMs(clock_.cycle_us())));
    }
    const int64_t limit_us = scenario_.limit_ms * 1000;
    const bool has_end = scenario_.until_us && *scenario_.until_us <= limit_us;
    const int64_t end_us = has_end ? *scenario_.until_us : limit_us;
    if (last_us <= end_us) return;
    errors_.Add(
        choice.place,
        MakeMessage("{0} comes from {1} to {2} ms, and the run ends at {3} ms ('{4}'): "
                    "end 'between_ms' there, or change '{4}'",
                    "{0} 的时间段为 {1} 至 {2} ms，而运行在 {3} ms 结束（“{4}”）："
                    "“between_ms”应止于此，或修改“{4}”",
                    choice.name, first, last, ToMs(end_us), has_end ? "until_ms" : "limit_ms"));
  }

  void AddValues(const std::vector<InitialValue>& values, Choice choice) {
    for (size_t i = 0; i < values.size(); ++i) {
      const InitialValue& value = values[i];
      if (!value.last) continue;
      (choice.kind == ChoiceKind::kGlobal ? choice.index : choice.local) = i;
      choice.name = value.name;
      choice.place = value.place;
      choice.first = static_cast<int64_t>(value.values.front());
      choice.count = *value.last - choice.first + 1;
      choices_.push_back(choice);
    }
  }

  /// A variable with a choice has no other value.
  void CheckOthers(const std::vector<InitialValue>& values) {
    for (size_t i = 0; i < values.size(); ++i) {
      for (size_t other = 0; values[i].last && other < values.size(); ++other) {
        // Of two choices the second one is too many.
        const bool told = values[other].last && other > i;
        if (other == i || told || !Overlap(values[i].name, values[other].name)) continue;
        errors_.Add(values[i].place,
                    MakeMessage("'{0}' has a choice, and another value too: remove one of them",
                                "“{0}”既有选择，又有另一个值：应去掉其一", values[i].name));
        break;
      }
    }
  }

  /// Names of locals with the page, where another choice has the same name.
  void NameLocals() {
    const auto all = choices_;
    for (Choice& choice : choices_) {
      if (choice.kind != ChoiceKind::kLocal ||
          std::ranges::count(all, choice.name, &Choice::name) == 1) {
        continue;
      }
      choice.name = fmt::format("page{}.{}", scenario_.threads[choice.index].page, choice.name);
    }
  }

  void CheckProduct() {
    double product = 1;
    std::string factors;
    for (const Choice& choice : choices_) {
      product *= static_cast<double>(std::max<int64_t>(choice.count, 0));
      factors += fmt::format("{}{}: {}", factors.empty() ? "" : ", ", choice.name, choice.count);
    }
    if (product <= static_cast<double>(Choices::kCasesMax)) return;
    const auto most = std::ranges::max_element(choices_, {}, &Choice::count);
    errors_.Add(most->place,
                MakeMessage("the choices have {0:.15g} cases together, and there can be {1}; {2}: "
                            "make ranges smaller, or divide one among several scenarios",
                            "各选择共有 {0:.15g} 种情形，至多 {1} 种；{2}："
                            "应缩小范围，或将其分到几个场景中",
                            product, Choices::kCasesMax, factors));
  }

  const Scenario& scenario_;
  const CardClock& clock_;
  std::vector<Choice> choices_;
  ScenarioErrors errors_;
};

/// There are few, most of them in order: less code than a sort of the library.
void SortByTime(std::vector<InputEvent>* events) {
  for (size_t i = 1; i < events->size(); ++i) {
    for (size_t j = i; j > 0 && (*events)[j].at_us < (*events)[j - 1].at_us; --j) {
      std::swap((*events)[j], (*events)[j - 1]);
    }
  }
}

/// Puts a chosen instant into an event.
template <typename Event>
void Choose(int64_t at_us, Event* event) {
  event->at_us = at_us;
  event->last_us.reset();
}

void Choose(int64_t value, InitialValue* initial) {
  initial->values = {static_cast<double>(value)};
  initial->last.reset();
}

}  // namespace

Result<Choices> Choices::Of(const Scenario& scenario) {
  const ControllerOptions card = CardOptions(scenario);
  const CardClock clock(card.motion.cycle_us, card.family->CycleNs(card.motion));
  auto found = ChoiceFinder(scenario, clock).Find();
  if (!found.ok()) return found.error();
  return Choices(clock, std::move(found).value());
}

Choices::Choices(CardClock clock, std::vector<Choice> choices)
    : clock_(clock), choices_(std::move(choices)) {
  for (const Choice& choice : choices_) cases_ *= choice.count;
}

std::vector<int64_t> Choices::ValuesIn(int64_t number) const {
  std::vector<int64_t> values;
  for (const Choice& choice : choices_) {
    values.push_back(choice.first + number % choice.count);
    number /= choice.count;
  }
  return values;
}

Scenario Choices::CaseOf(const Scenario& scenario, int64_t number) const {
  Scenario chosen = scenario;
  World& world = chosen.world;
  const std::vector<int64_t> values = ValuesIn(number);
  for (size_t i = 0; i < choices_.size(); ++i) {
    const Choice& choice = choices_[i];
    switch (choice.kind) {
      case ChoiceKind::kInput:
        Choose(clock_.UsOf(values[i]), &world.inputs[choice.index]);
        break;
      case ChoiceKind::kLevel:
        world.inputs[choice.index].value = static_cast<uint32_t>(values[i]);
        world.inputs[choice.index].any_level = false;
        break;
      case ChoiceKind::kFault:
        Choose(clock_.UsOf(values[i]), &world.faults[choice.index]);
        break;
      case ChoiceKind::kGlobal:
        Choose(values[i], &chosen.globals[choice.index]);
        break;
      case ChoiceKind::kLocal:
        Choose(values[i], &chosen.threads[choice.index].values[choice.local]);
        break;
    }
  }
  SortByTime(&world.inputs);
  return chosen;
}

int64_t Choices::Draw(uint64_t seed) const {
  int64_t number = 0;
  int64_t weight = 1;
  for (const Choice& choice : choices_) {
    const auto count = static_cast<uint64_t>(choice.count);
    number += weight * static_cast<int64_t>(RandomBelow(seed, count));
    weight *= choice.count;
  }
  return number;
}

std::vector<Message> Choices::Describe() const {
  std::vector<Message> texts;
  for (const Choice& choice : choices_) {
    const int64_t last = choice.first + choice.count - 1;
    if (choice.kind == ChoiceKind::kInput || choice.kind == ChoiceKind::kFault) {
      texts.push_back(MakeMessage(
          "{0} at {1}..{2} ms ({3} instants)", "{0} 在 {1}..{2} ms（{3} 个时刻）", choice.name,
          ToMs(clock_.UsOf(choice.first)), ToMs(clock_.UsOf(last)), choice.count));
      continue;
    }
    Message& text = texts.emplace_back(
        MakeMessage("{0} in {1}..{2}", "{0} 取 {1}..{2}", choice.name, choice.first, last));
    if (!choice.at_us) continue;
    text.en += fmt::format(" at {} ms", ToMs(*choice.at_us));
    text.zh += fmt::format("（{} ms 时）", ToMs(*choice.at_us));
  }
  return texts;
}

Message Choices::DescribeCase(int64_t number) const {
  const std::vector<int64_t> values = ValuesIn(number);
  Message text;
  const auto add = [&](const std::string& what, std::optional<int64_t> at_us) {
    const std::string at = at_us ? FormatMs(*at_us) + " ms" : "";
    text.en += (text.en.empty() ? "" : "; ") + what + (at_us ? " at " + at : "");
    text.zh += (text.zh.empty() ? "" : "；") + what + (at_us ? "（" + at + "）" : "");
  };
  for (size_t i = 0; i < choices_.size(); ++i) {
    const Choice& choice = choices_[i];
    std::optional<int64_t> at_us = choice.at_us;
    std::optional<int64_t> value = values[i];
    if (choice.kind == ChoiceKind::kInput || choice.kind == ChoiceKind::kFault) {
      at_us = clock_.UsOf(values[i]);
      value = choice.level;
      // An open level is the next choice.
      if (choice.kind == ChoiceKind::kInput && !choice.level) value = values[++i];
    }
    add(value ? fmt::format("{} = {}", choice.name, *value) : choice.name, at_us);
  }
  return text;
}

std::vector<CoveredChoice> Choices::Covered(const std::vector<bool>& cases) const {
  std::vector<std::vector<bool>> covered;
  covered.reserve(choices_.size());
  for (const Choice& choice : choices_) covered.emplace_back(static_cast<size_t>(choice.count));
  for (size_t number = 0; number < cases.size(); ++number) {
    if (!cases[number]) continue;
    auto rest = static_cast<int64_t>(number);
    for (size_t i = 0; i < choices_.size(); ++i) {
      covered[i][static_cast<size_t>(rest % choices_[i].count)] = true;
      rest /= choices_[i].count;
    }
  }
  std::vector<CoveredChoice> result;
  for (size_t i = 0; i < choices_.size(); ++i) {
    const Choice& choice = choices_[i];
    const bool instants = choice.kind == ChoiceKind::kInput || choice.kind == ChoiceKind::kFault;
    const auto shown = [&](int64_t value) {
      return instants ? ToMs(clock_.UsOf(value)) : static_cast<double>(value);
    };
    result.push_back({choice.name, instants, shown(choice.first),
                      shown(choice.first + choice.count - 1), choice.count,
                      std::ranges::count(covered[i], true)});
  }
  return result;
}

Message DescribeCovered(const CoveredChoice& choice) {
  return choice.instants
             ? MakeMessage("{0} of {1} instants of {2}, {3} to {4} ms",
                           "{2} 在 {3} 至 {4} ms 的 {1} 个时刻中的 {0} 个", choice.covered,
                           choice.values, choice.name, choice.first, choice.last)
             : MakeMessage("{0} of {1} values of {2}, {3:.0f} to {4:.0f}",
                           "{2} 取 {3:.0f} 至 {4:.0f} 的 {1} 个值中的 {0} 个", choice.covered,
                           choice.values, choice.name, choice.first, choice.last);
}

Message DescribeChosen(const Message& chosen) {
  return MakeMessage("choice: {0}", "选择：{1}", chosen.en, chosen.zh);
}

}  // namespace oncard::runtime
