#include "runtime/scenario/run/vacuity.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/milliseconds.h"
#include "base/trim.h"

namespace oncard::runtime {
namespace {

constexpr size_t kNowhere = std::string_view::npos;

/// The position of the last operator of two characters outside parentheses.
size_t LastOutside(std::string_view text, std::string_view op) {
  int depth = 0;
  size_t last = kNowhere;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (depth == 0 && text.substr(i, op.size()) == op) last = i;
  }
  return last;
}

std::optional<Guard> GuardWith(std::string_view left, bool negated) {
  const std::string text(Trim(left));
  auto condition = ParseCondition(negated ? "!(" + text + ")" : text);
  if (!condition.ok()) return std::nullopt;
  return Guard{std::move(condition).value(), text, negated};
}

/// The instants later than `end_us`, as in `500, 600`, in ascending order.
template <typename Events>
std::string InstantsAfter(const Events& events, int64_t end_us) {
  std::vector<int64_t> late;
  for (const auto& event : events) {
    if (event.at_us > end_us) late.push_back(event.at_us);
  }
  std::ranges::sort(late);
  std::string text;
  for (const int64_t at_us : late) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", ToMs(at_us));
  }
  return text;
}

}  // namespace

std::optional<Guard> GuardOf(const Requirement& requirement) {
  const std::string_view text = requirement.text;
  if (requirement.IsResponse()) return GuardWith(text, false);
  const size_t last_or = LastOutside(text, "||");
  if (requirement.scope == Scope::kNever) {
    const size_t last_and = LastOutside(text, "&&");
    if (last_or != kNowhere || last_and == kNowhere) return std::nullopt;
    return GuardWith(text.substr(0, last_and), false);
  }
  if (requirement.scope == Scope::kEventually || last_or == kNowhere) return std::nullopt;
  const std::string_view left = Trim(text.substr(0, last_or));
  const bool one = LastOutside(left, "||") == kNowhere && LastOutside(left, "&&") == kNowhere;
  if (!left.starts_with('!') || !one) return std::nullopt;
  return GuardWith(left, true);
}

Message DescribeVacuous(const Requirement& requirement, const Guard& guard) {
  if (guard.negated) {
    return MakeMessage("'{0}' was met by its left side alone: '{1}' always held",
                       "“{0}”仅凭左侧即已满足：“{1}”始终成立", requirement.Title(), guard.left);
  }
  return MakeMessage("'{0}' was met by its left side alone: '{1}' never held",
                     "“{0}”仅凭左侧即已满足：“{1}”从未成立", requirement.Title(), guard.left);
}

std::vector<Message> DescribeLateEvents(const World& world, int64_t end_us, bool of_all) {
  std::vector<Message> texts;
  const auto add = [&](std::string_view kind, const std::string& instants) {
    if (instants.empty()) return;
    const double end_ms = ToMs(end_us);
    texts.push_back(
        of_all ? MakeMessage("no run lasts until [[world.{0}]] at {1} ms: the last one ends at {2} "
                             "ms ('until_ms' makes it last longer)",
                             "没有运行持续到 {1} ms 的 [[world.{0}]]：最后的运行在 {2} ms "
                             "结束（可用“until_ms”使运行继续）",
                             kind, instants, end_ms)
               : MakeMessage("the run ended at {2} ms, before [[world.{0}]] at {1} ms: 'until_ms' "
                             "makes it last longer",
                             "运行在 {2} ms 结束，早于 {1} ms 的 "
                             "[[world.{0}]]：可用“until_ms”使运行继续",
                             kind, instants, end_ms));
  };
  add("input", InstantsAfter(world.inputs, end_us));
  add("move", InstantsAfter(world.moves, end_us));
  add("fault", InstantsAfter(world.faults, end_us));
  add("hand", InstantsAfter(world.hands, end_us));
  add("analog", InstantsAfter(world.voltages, end_us));
  add("module", InstantsAfter(world.modules, end_us));
  return texts;
}

std::vector<Message> DescribeIdleReactions(const World& world, uint64_t started, bool in_any) {
  std::vector<Message> texts;
  for (size_t i = 0; i < world.reactions.size(); ++i) {
    if ((started >> i & 1) != 0) continue;
    const std::string& when = world.reactions[i].when;
    texts.push_back(in_any
                        ? MakeMessage("no run starts the [[world.react]] of '{0}': it held at no "
                                      "boundary of profile cycles",
                                      "没有运行触发 [[world.react]]：“{0}”在任何规划周期"
                                      "边界上都未成立",
                                      when)
                        : MakeMessage("nothing started the [[world.react]] of '{0}': it held at "
                                      "no boundary of profile cycles",
                                      "[[world.react]] 未被触发：“{0}”在任何规划周期"
                                      "边界上都未成立",
                                      when));
  }
  return texts;
}

}  // namespace oncard::runtime
