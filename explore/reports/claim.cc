#include "explore/reports/claim.h"

#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/milliseconds.h"

namespace oncard::explore {
namespace {

// --- What was asked ------------------------------------------------------------------------------

/// True for engines that also look at runs without an end.
bool SeesEndlessRuns(EngineKind engine) {
  switch (engine) {
    case EngineKind::kAuto:
    case EngineKind::kDpor:
    case EngineKind::kStateful:
      return true;
    case EngineKind::kBounded:
    case EngineKind::kRandom:
    case EngineKind::kPct:
    case EngineKind::kPos:
    case EngineKind::kFollow:
      break;
  }
  return false;
}

/// Which faults an exploration can find without a requirement.
struct BuiltIn {
  bool deadlock = false;
  bool livelock = false;
  bool limit = false;  ///< threads that are still running at the scenario's limit_ms
};

BuiltIn BuiltInOf(const Findings& findings) {
  const Subject& subject = findings.subject;
  const bool deadlock = !subject.may_deadlock;
  if (const auto& card = subject.card) {
    const bool limit = card->until_us ? *card->until_us > card->limit_ms * 1000 : !subject.may_last;
    return {deadlock, false, limit};
  }
  const bool livelock = !subject.may_last && SeesEndlessRuns(findings.exploration.engine);
  return {deadlock, livelock, false};
}

std::string_view RaceRuleText(RaceRule rule) {
  switch (rule) {
    case RaceRule::kAny:
      return "any";
    case RaceRule::kBenign:
      return "benign";
    case RaceRule::kNone:
      break;
  }
  return "none";
}

std::string Joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<Message> BuiltInAsked(const Findings& findings) {
  const Subject& subject = findings.subject;
  std::vector<Message> lines;
  Message built_in = {"no thread fault", "无线程故障"};
  const BuiltIn looked_for = BuiltInOf(findings);
  if (looked_for.deadlock) {
    built_in.en += ", no deadlock";
    built_in.zh += "，无死锁";
  }
  if (looked_for.livelock) {
    built_in.en += ", no livelock";
    built_in.zh += "，无活锁";
  }
  if (looked_for.limit) {
    const char* since = subject.host != nullptr ? " after the host's end" : "";
    const char* since_zh = subject.host != nullptr ? "主机结束后 " : " ";
    built_in.en += fmt::format(", all threads end before {} ms{}", subject.card->limit_ms, since);
    built_in.zh += fmt::format("，所有线程在{}{} ms 前结束", since_zh, subject.card->limit_ms);
  }
  lines.push_back(std::move(built_in));
  if (subject.host != nullptr) {
    lines.push_back({"every call of the host is answered with its recorded code",
                     "主机每次调用的返回值与记录相同"});
  }
  if (subject.races != RaceRule::kAny && subject.card) {
    lines.push_back({"axes, coordinate systems and outputs have one owner at a time",
                     "每个轴、坐标系和输出在同一时间只有一个归属线程"});
  }
  if (subject.races != RaceRule::kAny) {
    Message races =
        subject.races == RaceRule::kNone
            ? Message{"no data race", "无数据竞争"}
            : Message{"no data race that changes a final value", "无改变最终值的数据竞争"};
    if (!subject.sync.empty()) {
      races.en += fmt::format("; synchronising: {}", Joined(subject.sync));
      races.zh += fmt::format("；同步变量：{}", Joined(subject.sync));
    }
    if (subject.card) {
      races.en += "; variables for which statements wait synchronise, too";
      races.zh += "；语句所等待的变量也作为同步变量";
    }
    lines.push_back(std::move(races));
  }
  return lines;
}

std::vector<Message> NotAsked(const Findings& findings) {
  Message line;
  const auto add = [&](const Message& what) {
    line.en += (line.en.empty() ? "" : ", ") + what.en;
    line.zh += (line.zh.empty() ? "" : "、") + what.zh;
  };
  const Subject& subject = findings.subject;
  const BuiltIn looked_for = BuiltInOf(findings);
  if (subject.requirements.empty()) add({"the results", "运行结果"});
  if (subject.endless) add({"that runs end (endless)", "运行会结束（endless）"});
  if (!looked_for.livelock) add({"livelock", "活锁"});
  const auto is_eventually = [](const Requirement& each) {
    return each.scope == Scope::kEventually;
  };
  if (subject.may_last && std::ranges::any_of(subject.requirements, is_eventually)) {
    add({"'eventually' in runs that never end", "不结束的运行中的“eventually”"});
  }
  if (!looked_for.deadlock) add({"deadlock", "死锁"});
  if (subject.races == RaceRule::kAny) add({"data races", "数据竞争"});
  if (line.en.empty()) return {};
  return {std::move(line)};
}

// --- Of what, under which assumptions ------------------------------------------------------------

std::vector<Message> Program(const Subject& subject) {
  std::vector<Message> lines;
  lines.push_back(MakeMessage("{0}, object {1:016x}", "{0}，目标文件 {1:016x}", subject.program,
                              subject.image->hash));
  if (subject.host != nullptr) {
    lines.push_back(MakeMessage("host of {0}: {1} calls, {2:016x}",
                                "{0} 的主机：{1} 次调用，{2:016x}", subject.record,
                                subject.host->size(), subject.scenario_hash));
  } else if (!subject.scenario.empty()) {
    lines.push_back(MakeMessage("scenario {0}, {1:016x}", "场景 {0}，{1:016x}", subject.scenario,
                                subject.scenario_hash));
  }
  std::string threads;
  for (const ThreadSetup& setup : subject.threads) {
    threads +=
        fmt::format("{}{} {}", threads.empty() ? "" : ", ", setup.thread,
                    subject.image->object.functions[static_cast<size_t>(setup.function)].name);
  }
  lines.push_back({"threads " + threads, "线程 " + threads});
  return lines;
}

/// What was chosen from, and how far.
std::vector<Message> Cases(const Findings& findings) {
  std::vector<Message> lines;
  if (!findings.cases) return lines;
  const CaseSearch& search = *findings.cases;
  Message choices;
  for (const Message& choice : search.choices) {
    choices.en += (choices.en.empty() ? "" : ", ") + choice.en;
    choices.zh += (choices.zh.empty() ? "" : "，") + choice.zh;
  }
  lines.push_back(MakeMessage("for every choice of: {0}: {1} cases",
                              "对以下各项的每种选择：{2}：共 {1} 种情形", choices.en, search.cases,
                              choices.zh));
  if (search.searched == 1) {
    lines.push_back({"one case was searched", "已搜索 1 种情形"});
  } else if (search.in_order || search.searched == search.cases) {
    lines.push_back(MakeMessage("the counts are sums over the first {0} cases",
                                "计数为前 {0} 种情形之和", search.searched));
  } else {
    lines.push_back(MakeMessage("{0} cases were searched; the counts are sums",
                                "已搜索 {0} 种情形；计数为总和", search.searched));
  }
  return lines;
}

uint64_t HashOfWorld(const CardConditions& card) {
  const std::string text = runtime::FormatWorld(card.world, card.axis_count);
  return XXH64(text.data(), text.size(), 0);
}

/// True if `leads` is asked of a program that can run for ever.
bool AsksForResponses(const Subject& subject) {
  return !subject.card &&
         std::ranges::any_of(subject.requirements, [](const Requirement& requirement) {
           return requirement.scope == Scope::kLeads;
         });
}

std::vector<Message> Assumptions(const Findings& findings) {
  const Subject& subject = findings.subject;
  std::vector<Message> lines;
  if (!subject.card) {
    lines.push_back({"any thread may execute the next statement; no time passes",
                     "任一线程都可能执行下一条语句；不计时间"});
    if (AsksForResponses(subject) && SeesEndlessRuns(findings.exploration.engine)) {
      lines.push_back({"leads: no thread that can run waits for ever for its next statement",
                       "leads：任一可运行的线程都不会永远得不到执行"});
    }
    return lines;
  }
  const CardConditions& card = *subject.card;
  lines.push_back(
      {"any thread may execute the next statement, and each executes at least one in every cycle",
       "任一线程都可能执行下一条语句，且每个线程在每个周期内至少执行一条"});
  lines.push_back(MakeMessage("rate {0} statements per ms, cycle {1} us, {2} axes",
                              "速率每 ms {0} 条语句，周期 {1} us，{2} 轴", card.rate, card.cycle_us,
                              card.axis_count));
  if (subject.host != nullptr) {
    lines.push_back(
        {"the host makes its recorded calls, each in the cycle of the record, whatever it reads",
         "无论读到什么，主机都在记录的周期内发出所记录的调用"});
  }
  lines.push_back(card.world == runtime::World{}
                      ? Message{"world: ideal drives, inputs off, no events",
                                "外部世界：理想驱动器，输入全关，无事件"}
                      : MakeMessage("world: as in the scenario, {0:016x}",
                                    "外部世界：如场景所述，{0:016x}", HashOfWorld(card)));
  return lines;
}

std::vector<Message> Bounds(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  std::vector<Message> lines;
  const auto add = [&](Message message) { lines.push_back(std::move(message)); };
  if (const auto& card = findings.subject.card; card && !BuiltInOf(findings).limit) {
    if (card->until_us) {
      add(MakeMessage("the first {0} ms", "前 {0} ms", ToMs(*card->until_us)));
    } else if (findings.subject.host != nullptr) {
      add(MakeMessage("until {0} ms after the host's end", "到主机结束后 {0} ms 为止",
                      card->limit_ms));
    } else {
      add(MakeMessage("the first {0} ms", "前 {0} ms", card->limit_ms));
    }
  } else if (exploration.horizon) {
    add({"until the threads have ended", "到线程结束为止"});
  }
  if (exploration.bounded) {
    add(MakeMessage("preemptions: at most {0}", "抢占：最多 {0} 次",
                    std::max(exploration.bounded->preemptions, 0)));
  }
  if (const auto& samples = exploration.samples) {
    add(MakeMessage("{0} random schedules of the engine {1}, seed {2}",
                    "{1} 引擎的 {0} 个随机调度，种子 {2}", samples->runs,
                    EngineName(exploration.engine), samples->seed));
    if (findings.subject.may_last && samples->cut > 0) {
      add(MakeMessage("the first {0} statements of those that do not end: {1}",
                      "其中不结束的 {1} 个：前 {0} 条语句", samples->longest, samples->cut));
    }
  }
  if (exploration.engine == EngineKind::kFollow) add({"one schedule", "一个调度"});
  if (AsksForResponses(findings.subject) && !SeesEndlessRuns(exploration.engine)) {
    add({"leads: only runs that end", "leads：仅限会结束的运行"});
  }
  if (const auto& islands = exploration.islands) {
    std::string threads;
    for (const std::vector<int>& island : islands->threads) {
      threads += fmt::format("{}{{{}}}", threads.empty() ? "" : ", ", fmt::join(island, ", "));
    }
    add(MakeMessage("every schedule, by islands: threads {0}, each with any timing of the others",
                    "所有调度，按互不相关的线程组证明：线程 {0}，其余线程的时序任意", threads));
    if (!islands->sums.empty()) {
      add(MakeMessage("at the end {0}: the sum of what they add, in every combination",
                      "结束时 {0}：各组增量之和，涵盖所有组合", fmt::join(islands->sums, ", ")));
    }
  }
  if (exploration.reduced && IsGood(exploration.verdict)) {
    add({"every schedule; orders of statements in a cycle that nobody notices were searched once",
         "所有调度；周期内不影响任何线程和要求的语句次序只搜索一次"});
  }
  if (lines.empty() && exploration.verdict == Verdict::kProved) {
    add({"none: every schedule was searched", "无：已搜索所有调度"});
  }
  return lines;
}

// --- Results that nobody has asked for -----------------------------------------------------------

/// The results to be shown, and a requirement that the user could add for them.
struct Results {
  int64_t count = 0;  ///< number of different results found
  /// For each known result: the globals written and the return values of threads, if they are not
  /// the same in all results.
  std::vector<std::vector<NamedValue>> shown;
  std::string
      requirement;  ///< a requirement that one of the results meets; empty if none can be offered
};

int64_t CountEnds(const Exploration& exploration) {
  int64_t count = 0;
  if (exploration.traces) count = std::max(count, exploration.traces->final_full);
  if (exploration.states) count = std::max(count, exploration.states->final_full);
  if (exploration.bounded) count = std::max(count, exploration.bounded->different_ends);
  if (exploration.samples) {
    count = std::max(count, static_cast<int64_t>(exploration.samples->ends.size()));
  }
  return count;
}

/// Maximum number of elements of an offered requirement; a longer one is hard to read.
constexpr size_t kOfferedMax = 4;

/// Empty if there are requirements on the results, or a failure, and for an endless program.
std::optional<Results> ResultsOf(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  const Subject& subject = findings.subject;
  if (!subject.requirements.empty() || exploration.failure || subject.endless) {
    return std::nullopt;
  }
  // The result of running the threads one after the other is probably the intended one: it comes
  // last in the list.
  std::vector<End> ends = exploration.ends;
  if (findings.serial_end) ends.push_back(*findings.serial_end);
  Results results;
  results.count = CountEnds(exploration);
  if (ends.empty()) return results;
  const auto named = NameEnds(ends, subject.image->object, subject.threads);
  const size_t returns = named[0].size() - subject.threads.size();
  std::vector<size_t> interesting;
  for (size_t i = 0; i < ends[0].size(); ++i) {
    const int64_t usual = i < returns ? findings.start[i] : ends[0][i];
    if (std::ranges::any_of(ends, [&](const End& end) { return end[i] != usual; })) {
      interesting.push_back(i);
    }
  }
  for (size_t end = 0; end < exploration.ends.size(); ++end) {
    auto& shown = results.shown.emplace_back();
    for (const size_t i : interesting) shown.push_back(named[end][i]);
  }
  // The globals; if there are none, the return value of the first thread.
  const auto& meant = named.back();
  if (interesting.empty()) interesting.push_back(returns);
  for (size_t n = 0; n < std::min(interesting.size(), kOfferedMax); ++n) {
    const NamedValue& value = meant[interesting[n]];
    if (n > 0 && interesting[n] >= returns) break;
    results.requirement += fmt::format("{}{} == {}", results.requirement.empty() ? "" : " && ",
                                       value.name, value.value);
  }
  return results;
}

/// The line to be pasted.
std::string PasteLine(const Subject& subject, const std::string& requirement) {
  return subject.scenario.empty() ? "//@ final: " + requirement
                                  : fmt::format("final = [\"{}\"]", requirement);
}

std::string EndText(const std::vector<NamedValue>& end) {
  std::string text;
  for (const NamedValue& value : end) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", value.name, value.value);
  }
  return text;
}

Message ResultsHead(const Results& results) {
  Message head = {"there is no requirement on the results", "未对结果提出要求"};
  const auto add = [&](const Message& more) {
    head.en += "; " + more.en;
    head.zh += "；" + more.zh;
  };
  const auto shown = static_cast<int64_t>(results.shown.size());
  if (results.count == 1) {
    add({"one was found", "发现 1 种结果"});
  } else if (results.count > 1) {
    add(MakeMessage("{0} different ones were found", "发现 {0} 种不同结果", results.count));
  }
  if (shown > 0 && shown < results.count) {
    add(MakeMessage("{0} of them", "其中 {0} 种", shown));
  }
  if (shown == 0) return head;
  return {head.en + ':', head.zh + "："};
}

Message AskHead(const Subject& subject) {
  return subject.scenario.empty()
             ? Message{"require the intended one with a line in the source, for example",
                       "请在源程序中用一行写出期望的结果，例如"}
             : Message{"require the intended one with a line in the scenario, for example",
                       "请在场景中用一行写出期望的结果，例如"};
}

}  // namespace

Claim ClaimOf(const Findings& findings) {
  const Exploration& exploration = findings.exploration;
  const EngineKind engine = exploration.paired ? EngineKind::kAuto : exploration.engine;
  Claim claim;
  for (const Requirement& requirement : findings.subject.requirements) {
    const std::string title = requirement.Title();
    claim.requirements.push_back({title, title});
  }
  claim.built_in = BuiltInAsked(findings);
  claim.not_asked = NotAsked(findings);
  claim.program = Program(findings.subject);
  claim.cases = Cases(findings);
  if (findings.cases) {
    for (const runtime::CoveredChoice& choice : findings.cases->covered) {
      claim.covered.push_back(runtime::DescribeCovered(choice));
    }
  }
  claim.assumptions = Assumptions(findings);
  claim.bounds = Bounds(findings);
  claim.by = MakeMessage("oncard {0}, engine {1}", "oncard {0}，{1} 引擎", ONCARD_VERSION,
                         EngineName(engine));
  return claim;
}

std::optional<UnaskedResults> UnaskedResultsOf(const Findings& findings) {
  const auto results = ResultsOf(findings);
  if (!results) return std::nullopt;
  UnaskedResults unasked = {ResultsHead(*results), {}, AskHead(findings.subject), {}};
  for (const auto& end : results->shown) unasked.ends.push_back(EndText(end));
  if (!results->requirement.empty()) {
    unasked.requirement = PasteLine(findings.subject, results->requirement);
  }
  return unasked;
}

std::string ClaimText(const Findings& findings, Language language) {
  const bool chinese = language == Language::kChinese;
  // Columns of a terminal: a Chinese character takes two, but three bytes.
  const auto columns = [&](const Message& label) {
    return chinese ? label.zh.size() / 3 * 2 : label.en.size();
  };
  Claim claim = ClaimOf(findings);
  std::vector<Message> asked = std::move(claim.requirements);
  asked.insert(asked.end(), claim.built_in.begin(), claim.built_in.end());
  for (const Message& covered : claim.covered) {
    claim.cases.push_back(MakeMessage("covered: {0}", "已覆盖：{1}", covered.en, covered.zh));
  }
  const WayOut& way = findings.way_out;
  std::vector<std::pair<Message, std::vector<Message>>> entries = {
      {{"asked", "要求"}, asked},
      {{"not asked", "未要求"}, claim.not_asked},
      {{"program", "程序"}, claim.program},
      {{"cases", "情形"}, claim.cases},
      {{"assumes", "前提"}, claim.assumptions},
      {{"bounds", "范围"}, claim.bounds},
      {{"by", "工具"}, {claim.by}},
      {{"reached", "进度"}, way.reached},
      {{"spent on", "状态用于"}, way.spent},
      {{"try", "可尝试"}, way.next}};
  std::erase_if(entries, [](const auto& entry) { return entry.second.empty(); });
  size_t width = 0;
  for (const auto& [label, lines] : entries) width = std::max(width, columns(label));
  std::string text;
  for (const auto& [label, lines] : entries) {
    text += label.In(language) + std::string(width - columns(label), ' ');
    for (const Message& line : lines) {
      if (&line != &lines.front()) text += std::string(width, ' ');
      text += "  " + line.In(language) + '\n';
    }
  }
  const auto results = UnaskedResultsOf(findings);
  if (!results) return text;
  text += '\n' + results->head.In(language) + '\n';
  for (const std::string& end : results->ends) text += "  " + end + '\n';
  if (!results->requirement.empty()) {
    text += results->ask.In(language) + "\n  " + results->requirement + '\n';
  }
  return text + '\n';
}

void AddClaim(const Findings& findings, nlohmann::ordered_json* json) {
  const Subject& subject = findings.subject;
  const BuiltIn built_in = BuiltInOf(findings);
  auto& asked = (*json)["asked"];
  asked["requirements"] = nlohmann::ordered_json::array();
  for (const Requirement& requirement : subject.requirements) {
    auto& each = asked["requirements"].emplace_back();
    each = {{"scope", ScopeName(requirement.scope)}, {"expression", requirement.Expression()}};
    if (requirement.scope == Scope::kWithin) each["ms"] = ToMs(requirement.within_us);
  }
  asked["faults"] = true;
  if (subject.endless) asked["endless"] = true;
  asked["deadlock"] = built_in.deadlock;
  asked["livelock"] = built_in.livelock;
  asked["limit"] = built_in.limit;
  asked["races"] = RaceRuleText(subject.races);
  if (subject.races != RaceRule::kAny && subject.card) asked["owners"] = true;
  if (!subject.sync.empty()) asked["sync"] = subject.sync;
  auto& program = (*json)["program"];
  program = {{"file", subject.program}, {"object", fmt::format("{:016x}", subject.image->hash)}};
  if (subject.host != nullptr) {
    program["host"] = {{"record", subject.record}, {"calls", subject.host->size()}};
  } else if (!subject.scenario.empty()) {
    program["scenario"] = subject.scenario;
  }
  program["scenario_hash"] = fmt::format("{:016x}", subject.scenario_hash);
  for (const ThreadSetup& setup : subject.threads) {
    const auto function = static_cast<size_t>(setup.function);
    program["threads"].push_back({{"thread", setup.thread},
                                  {"function", subject.image->object.functions[function].name},
                                  {"page", setup.page}});
  }
  if (const auto& search = findings.cases) {
    for (const Message& choice : search->choices) (*json)["choices"].push_back(choice.en);
    (*json)["cases"] = search->cases;
    (*json)["cases_searched"] = search->searched;
    for (const runtime::CoveredChoice& choice : search->covered) {
      auto& covered = (*json)["covered"].emplace_back();
      covered["name"] = choice.name;
      if (choice.instants) {
        covered["from_ms"] = choice.first;
        covered["to_ms"] = choice.last;
      } else {
        covered["from"] = static_cast<int64_t>(choice.first);
        covered["to"] = static_cast<int64_t>(choice.last);
      }
      covered["values"] = choice.values;
      covered["covered"] = choice.covered;
    }
  }
  auto& assumptions = (*json)["assumptions"];
  assumptions["card"] = subject.card.has_value();
  if (const auto& card = subject.card) {
    assumptions["rate"] = card->rate;
    assumptions["cycle_us"] = card->cycle_us;
    assumptions["axes"] = card->axis_count;
    assumptions["limit_ms"] = card->limit_ms;
    if (card->until_us) assumptions["until_ms"] = ToMs(*card->until_us);
    assumptions["world"] = card->world == runtime::World{}
                               ? std::string("nothing happens")
                               : fmt::format("{:016x}", HashOfWorld(*card));
  }
  auto& bounds = (*json)["bounds"] = nlohmann::ordered_json::array();
  for (const Message& line : Bounds(findings)) bounds.push_back(line.en);
  if (const Horizon& horizon = findings.exploration.horizon) {
    auto& json_horizon = (*json)["horizon"];
    if (horizon.at_ms) json_horizon["ms"] = *horizon.at_ms;
    json_horizon["moving_axes"] = NumbersOf(horizon.axes, 1);
    json_horizon["running_threads"] = NumbersOf(horizon.threads, 0);
  }
  const auto add_way = [&](const char* name, const std::vector<Message>& lines) {
    for (const Message& line : lines) (*json)[name].push_back(line.en);
  };
  add_way("reached", findings.way_out.reached);
  add_way("spent_on", findings.way_out.spent);
  add_way("try", findings.way_out.next);
  (*json)["oncard"] = ONCARD_VERSION;
  const auto results = ResultsOf(findings);
  if (!results) return;
  auto& shown = (*json)["results"] = nlohmann::ordered_json::array();
  for (const auto& end : results->shown) {
    auto& values = shown.emplace_back(nlohmann::ordered_json::object());
    for (const NamedValue& value : end) values[value.name] = nlohmann::json::parse(value.value);
  }
  if (!results->requirement.empty()) (*json)["ask"] = PasteLine(subject, results->requirement);
}

}  // namespace oncard::explore
