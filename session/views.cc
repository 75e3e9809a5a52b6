#include "session/views.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/milliseconds.h"
#include "runtime/observe/axis_path.h"
#include "runtime/observe/quantity.h"
#include "runtime/observe/step_log.h"
#include "runtime/observe/thread_status.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/sim/program.h"
#include "vm/disassembler.h"
#include "vm/record.h"

namespace oncard::session {

std::string_view StepName(StepKind kind) {
  switch (kind) {
    case StepKind::kHost:
      return "host";
    case StepKind::kCycle:
      return "cycle";
    case StepKind::kStatement:
      break;
  }
  return "statement";
}

std::string_view OverName(runtime::RunOver over) {
  switch (over) {
    case runtime::RunOver::kQuiet:
      return "quiet";
    case runtime::RunOver::kUntil:
      return "until";
    case runtime::RunOver::kLimit:
      return "time-limit";
    case runtime::RunOver::kHostEnd:
      return "host-end";
    case runtime::RunOver::kDeadlock:
      break;
  }
  return "deadlock";
}

std::string_view ReasonName(StopReason reason) {
  switch (reason) {
    case StopReason::kGoal:
      return "goal";
    case StopReason::kLine:
      return "line";
    case StopReason::kChange:
      return "change";
    case StopReason::kCondition:
      return "condition";
    case StopReason::kFault:
      return "fault";
    case StopReason::kRace:
      return "race";
    case StopReason::kWarning:
      return "warning";
    case StopReason::kRefusal:
      return "refusal";
    case StopReason::kRequirement:
      return "requirement";
    case StopReason::kDeviation:
      return "deviation";
    case StopReason::kScheduleEnd:
      return "schedule-end";
    case StopReason::kEnd:
      return "end";
    case StopReason::kStart:
      return "start";
    case StopReason::kBudget:
      break;
  }
  return "budget";
}

namespace {

using Json = nlohmann::ordered_json;
using runtime::Quantity;

/// What a thread waits for in a cycle.
Json WaitView(const RewindableRun& run, const vm::ThreadState& thread, const vm::Image& program,
              int64_t cycle) {
  if (thread.wake_cycle > cycle) {
    return {{"until_ms", ToMs(run.controller().clock().UsOf(thread.wake_cycle))}};
  }
  const vm::SlotAddress& slot = thread.wait_slot;
  Json json = Json::object();
  const std::string name = runtime::NameOfSlot(slot, thread.function, program.object);
  if (!name.empty()) json["name"] = name;
  json["value"] = slot.type == vm::DataType::kDouble ? vm::DoubleFromFixed(thread.wait_value)
                                                     : static_cast<double>(thread.wait_value);
  return json;
}

Json WarningView(const runtime::CardFinding& finding, Language language) {
  const runtime::CommandPlace& place = finding.place;
  Json json = {{"name", runtime::InfoOf(finding.warning).name},
               {"text", finding.text.In(language)},
               {"time_ms", ToMs(finding.first_us)}};
  if (place.thread >= 0) json["thread"] = place.thread;
  if (place.line > 0) {
    json["file"] = place.file;
    json["line"] = place.line;
  }
  if (!place.call.empty()) json["call"] = place.call;
  return json;
}

Json ThreadView(const RewindableRun& run, int number, Language language) {
  const vm::ThreadState& thread = run.machine().thread(number);
  const vm::Function& function = run.image().object.functions[thread.function];
  const std::string program = ProgramPath(run.scenario());
  const int line = run.machine().Line(number);
  const std::string place = runtime::SourcePlace(program, function, thread.pc);
  Json json = {{"thread", number},
               {"function", function.name},
               {"page", thread.page},
               {"state", runtime::ThreadStateName(thread.run)},
               {"file", function.file},
               {"line", line},
               {"position", thread.pc},
               {"statements", thread.executed},
               {"error", thread.error},
               {"status", runtime::DescribeStatus(thread, run.image(), place).In(language)}};
  const bool runs = thread.run == vm::ThreadRun::kRunning;
  const bool ready = (run.machine().RunnableThreads() >> number & 1) != 0;
  json["ready"] = ready;
  if (runs && !ready)
    json["waits"] = WaitView(run, thread, run.image(), run.machine().state().cycle);
  if (thread.period_cycles != 0) {
    json["next_start_ms"] = ToMs(run.controller().clock().UsOf(thread.next_start));
  }
  if (!runs && thread.started && thread.result_type != vm::DataType::kVoid) {
    json["result"] = Json::parse(runtime::ResultText(thread), nullptr, false);
  }
  if (const Refusal* refusal = run.LastRefusal(number)) {
    json["refused"] = refusal->call.In(language);
  }
  return json;
}

/// The value as JSON has it.
Json ValueView(const Quantity& quantity, const RewindableRun& run) {
  const std::string text = runtime::FormatQuantity(quantity, run.controller());
  return Json::parse(text, nullptr, false);
}

Json ValuesView(const std::vector<Quantity>& quantities, const RewindableRun& run) {
  Json values = Json::array();
  for (const Quantity& quantity : quantities) values.push_back(ValueView(quantity, run));
  return values;
}

/// Variables: each number of a structure by itself, an array or a row of one as a list.
Json VariablesView(const std::vector<Quantity>& quantities, const std::string& prefix,
                   const RewindableRun& run) {
  Json variables = Json::array();
  for (const Quantity& quantity : quantities) {
    const bool element = quantity.is_part && quantity.name.ends_with(']');
    const std::string path =
        quantity.name.substr(0, element ? quantity.name.rfind('[') : quantity.name.size());
    Json value = ValueView(quantity, run);
    if (element && !variables.empty() && variables.back()["path"] == path) {
      variables.back()["value"].push_back(std::move(value));
      continue;
    }
    variables.push_back({{"name", path.substr(prefix.size())},
                         {"path", path},
                         {"type", vm::TypeName(quantity.slot.type)},
                         {"slot", quantity.slot.id},
                         {"value", element ? Json::array({std::move(value)}) : std::move(value)}});
  }
  return variables;
}

Json PartView(const runtime::MotionPart& part, size_t index, const RewindableRun& run) {
  const int number = part.first + static_cast<int>(index);
  Json values = Json::array();
  for (const runtime::MotionValue& value : part.values) {
    const std::string name = runtime::MotionValueName(part, number, value.name);
    const auto found = runtime::ResolveQuantity(name, run.controller());
    if (!found.ok()) continue;
    Json json = {
        {"name", value.name}, {"path", name}, {"value", ValueView(found.value().front(), run)}};
    if (value.unit != runtime::Unit::kNone) {
      json["unit"] = found.value().front().UnitText(run.controller().family().cycle_ns != 0);
    }
    if (value.form == runtime::NumberForm::kFlag) json["flag"] = true;
    values.push_back(std::move(json));
  }
  return {{"part", part.name}, {"number", number}, {"values", std::move(values)}};
}

Json SwitchView(const motion::PositionSwitch& contact, const runtime::AxisUnit& unit) {
  const auto position = [&](double pulses) {
    return unit.FromPulses(pulses, runtime::AxisMeasure::kPosition);
  };
  Json json = {{"axis", contact.axis + 1},
               {"type", runtime::InputWordName(contact.type)},
               {"index", contact.bit + 1}};
  if (std::isfinite(contact.first)) json["from"] = position(contact.first);
  if (std::isfinite(contact.last)) json["to"] = position(contact.last);
  json["active_low"] = contact.active_low;
  json["connected"] = contact.connected;
  return json;
}

/// A coordinate system with the path that lies ahead.
Json PathView(size_t crd, const RewindableRun& run) {
  const runtime::AxisPath path = runtime::PathAhead(run.controller(), crd, kPathPointsMax);
  return {{"crd", crd + 1}, {"axes", path.axes}, {"points", path.points}, {"whole", path.whole}};
}

/// The Chinese text if there is one and it is asked for.
const std::string& TextIn(Language language, const std::string& en, const std::string& zh) {
  return language == Language::kChinese && !zh.empty() ? zh : en;
}

/// How the scenario wants the machine to look.
Json MachineView(const runtime::ViewSetup& view, Language language) {
  Json pins = Json::array();
  for (const runtime::ViewPin& pin : view.pins) {
    pins.push_back({{"type", pin.type},
                    {"index", pin.index},
                    {"name", TextIn(language, pin.name, pin.name_zh)}});
  }
  return {{"title", TextIn(language, view.title, view.title_zh)},
          {"kind", view.kind},
          {"x", view.x},
          {"y", view.y},
          {"z", view.z},
          {"turn", view.turn},
          {"pins", std::move(pins)}};
}

}  // namespace

nlohmann::ordered_json StateView(const RewindableRun& run, Language language) {
  const runtime::Controller& controller = run.controller();
  Json json = {{"moment", run.moment()},
               {"head", run.head()},
               {"cycle", controller.cycle()},
               {"time_ms", controller.NowMs()},
               {"statements", run.machine().state().executed},
               {"statements_left", run.statements_left()},
               {"next", StepName(run.NextStep())}};
  if (const int thread = run.NextThread(); thread >= 0) json["next_thread"] = thread;
  if (const auto over = run.Over()) json["over"] = OverName(*over);
  json["follows_schedule"] = run.follows_schedule();
  if (const runtime::HostCalls* calls = run.calls()) {
    json["host"] = {{"calls", calls->size()}, {"made", run.calls_made()}};
    const vm::Image* program = run.machine().image();
    if (program != nullptr) json["host"]["program"] = fmt::format("{:016x}", program->hash);
    if (run.last_call() != nullptr) json["host"]["last"] = run.last_call()->In(language);
    if (run.calls_made() < calls->size()) {
      json["host"]["next"] = calls->Describe(run.calls_made());
      json["host"]["next_ms"] = ToMs(calls->TimeUs(run.calls_made()));
    }
  }
  json["hash"] = fmt::format("{:016x}", controller.Hash());
  json["threads"] = Json::array();
  for (int number = 0; number < vm::kThreadCount; ++number) {
    if (run.machine().thread(number).run == vm::ThreadRun::kUnbound) continue;
    json["threads"].push_back(ThreadView(run, number, language));
  }
  json["warnings"] = Json::array();
  for (const runtime::CardFinding& finding : run.findings()) {
    if (!run.IsSilent(finding)) json["warnings"].push_back(WarningView(finding, language));
  }
  return json;
}

nlohmann::ordered_json StopView(const Stop& stop, Language language) {
  Json json = {{"reason", ReasonName(stop.reason)}};
  if (stop.thread >= 0) json["thread"] = stop.thread;
  if (stop.number >= 0) json["number"] = stop.number;
  const std::string& text = stop.text.In(language);
  if (!text.empty()) json["text"] = text;
  if (stop.reason == StopReason::kEnd) {
    json["failed"] = Json::array();
    for (const Message& failed : stop.failed) json["failed"].push_back(failed.In(language));
  }
  return json;
}

nlohmann::ordered_json GlobalsView(const RewindableRun& run) {
  return VariablesView(runtime::GlobalQuantities(run.controller()), {}, run);
}

nlohmann::ordered_json PageView(const RewindableRun& run, int page) {
  for (const vm::ThreadState& thread : run.machine().state().threads) {
    if (thread.run == vm::ThreadRun::kUnbound || thread.page != page) continue;
    return VariablesView(runtime::LocalQuantities(thread.function, page, run.controller()),
                         fmt::format("page{}.", page), run);
  }
  return Json::array();
}

nlohmann::ordered_json SlotsView(const RewindableRun& run, int page) {
  return run.machine().state().pages[static_cast<size_t>(page)];
}

nlohmann::ordered_json CardView(const RewindableRun& run, Language language) {
  const motion::MotionCore& core = run.controller().motion();
  Json parts = Json::array();
  for (const runtime::MotionPart& part : runtime::MotionParts()) {
    for (size_t index = 0; index < part.count(core); ++index) {
      if (part.has != nullptr && !part.has(core, index)) continue;
      parts.push_back(PartView(part, index, run));
    }
  }
  Json words = Json::array();
  for (const std::string_view name : runtime::WordNames()) {
    const auto found = runtime::ResolveQuantity(name, run.controller());
    if (!found.ok()) continue;
    words.push_back({{"name", name},
                     {"kind", runtime::FindInputWord(name) ? "input" : "output"},
                     {"value", ValueView(found.value().front(), run)},
                     {"pins", runtime::WordWidth(name)}});
  }
  Json switches = Json::array();
  for (const motion::PositionSwitch& contact : core.state().switches) {
    switches.push_back(SwitchView(contact, run.controller().options().units[contact.axis]));
  }
  Json paths = Json::array();
  for (size_t crd = 0; crd < core.state().crds.size(); ++crd) {
    if (core.state().crds[crd].exists()) paths.push_back(PathView(crd, run));
  }
  return {{"parts", std::move(parts)},
          {"words", std::move(words)},
          {"switches", std::move(switches)},
          {"paths", std::move(paths)},
          {"view", MachineView(run.scenario().view, language)}};
}

Result<nlohmann::ordered_json> Evaluate(const std::string& text, std::optional<int> thread,
                                        const RewindableRun& run) {
  using runtime::CardCondition;
  const runtime::Controller& controller = run.controller();
  const std::string name = thread ? runtime::NameInThread(text, *thread, controller) : text;
  auto found = runtime::ResolveQuantity(name, controller);
  if (found.ok()) {
    const bool array = found.value().size() != 1 || found.value().front().is_part;
    Json values = ValuesView(found.value(), run);
    return Json{{"value", array ? values : values.front()}, {"path", name}};
  }
  const auto bound = thread ? CardCondition::ReadInThread(text, *thread, controller)
                            : CardCondition::Read(text, controller);
  // A lone name that does not exist: the first error suggests a similar one.
  if (!bound.ok()) return bound.error();
  return Json{{"holds", bound.value().Holds(run.controller())}};
}

nlohmann::ordered_json ListingView(const RewindableRun& run) {
  Json functions = Json::array();
  const vm::Object& object = run.image().object;
  for (const vm::Function& function : object.functions) {
    Json statements = Json::array();
    for (size_t i = 0; i < function.instructions.size(); ++i) {
      statements.push_back(
          {{"line", function.lines[i]},
           {"text", vm::DescribeInstruction(object, function, i, run.controller().commands())},
           {"words", vm::EncodeRecord(function.instructions[i])}});
    }
    functions.push_back(
        {{"name", function.name}, {"file", function.file}, {"statements", std::move(statements)}});
  }
  return functions;
}

nlohmann::ordered_json ChannelsView(const std::vector<Session::Channel>& channels) {
  Json json = Json::array();
  for (const Session::Channel& channel : channels) {
    json.push_back(
        {{"name", channel.name}, {"least", channel.least}, {"largest", channel.largest}});
  }
  return json;
}

nlohmann::ordered_json SpansView(const std::vector<RewindableRun::Span>& spans,
                                 const RewindableRun& run, Language language) {
  const runtime::CardClock& clock = run.controller().clock();
  Json json = Json::array();
  for (const RewindableRun::Span& span : spans) {
    Json item = {{"thread", span.thread},
                 {"state", runtime::ThreadStateName(span.state.run)},
                 {"line", span.line},
                 {"from", span.from},
                 {"to", span.to},
                 {"from_ms", ToMs(clock.UsOf(span.from_cycle))},
                 {"to_ms", ToMs(clock.UsOf(span.to_cycle))}};
    if (span.waits) item["waits"] = WaitView(run, span.state, *span.program, span.from_cycle);
    if (span.state.run == vm::ThreadRun::kFaulted) {
      item["text"] = runtime::DescribeFault(span.state, *span.program).In(language);
    }
    json.push_back(std::move(item));
  }
  return json;
}

nlohmann::ordered_json LineWritesView(const std::vector<LineWrites>& lines) {
  Json json = Json::array();
  for (const LineWrites& line : lines) {
    Json values = Json::array();
    for (const LineWrites::Value& value : line.values) {
      values.push_back({{"name", value.name}, {"value", Json::parse(value.text, nullptr, false)}});
    }
    json.push_back({{"thread", line.thread},
                    {"file", line.file},
                    {"line", line.line},
                    {"moment", line.moment},
                    {"values", std::move(values)}});
    if (!line.result.empty()) json.back()["result"] = Json::parse(line.result, nullptr, false);
  }
  return json;
}

nlohmann::ordered_json TurnsView(const std::vector<RewindableRun::Turn>& turns,
                                 const RewindableRun& run) {
  Json json = Json::array();
  for (const RewindableRun::Turn& turn : turns) {
    json.push_back({{"moment", turn.moment},
                    {"time_ms", ToMs(run.controller().clock().UsOf(turn.cycle))},
                    {"thread", turn.thread},
                    {"statements", turn.statements}});
  }
  return json;
}

}  // namespace oncard::session
