#include "session/host.h"

#include <atomic>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/json_reader.h"
#include "base/json_text.h"
#include "base/limits.h"
#include "base/milliseconds.h"
#include "base/nearest.h"
#include "compiler/diagnostic_printer.h"
#include "runtime/scenario/run/requirement_watch.h"
#include "runtime/scenario/run/result_json.h"
#include "session/arguments.h"
#include "session/editor_requests.h"
#include "session/line_writes.h"
#include "session/project.h"
#include "session/recorded_host.h"
#include "session/session.h"
#include "session/views.h"

namespace oncard::session {
namespace {

constexpr int64_t kMomentMax = int64_t{1} << 53;  // integers of JSON are exact up to here
constexpr int64_t kStepsMax = 1'000'000'000;
constexpr auto kMsMax = static_cast<double>(runtime::kTimeMsMax);
constexpr int kCardMax = 15;
constexpr int kOpeningMax = 1'000'000;
constexpr int kPointsMax = 100'000;
constexpr int kSwitchesMax = 7 * 16;  // one for each input
constexpr int64_t kTurnsMax = 100'000;
constexpr int64_t kTurnsDefault = 1000;
constexpr int64_t kWrittenMax = 100'000;
constexpr int64_t kWrittenDefault = 1000;

const std::vector<std::string_view> kGoals = {"step", "statement", "line",   "cycle", "time",
                                              "stop", "rest",      "change", "call",  "end"};

Error NoSession() {
  return MakeError(1, "no program is loaded: 'load' one first", "尚未加载程序：请先使用“load”");
}

/// The supervisor's warnings that are left out.
runtime::CardWarnings ReadSilent(Arguments* arguments) {
  std::vector<std::string_view> names;
  for (const runtime::CardWarningInfo& info : runtime::CardWarningTable()) {
    names.push_back(info.name);
  }
  runtime::CardWarnings silent;
  for (const size_t index : arguments->Words("silent", names)) {
    silent.Add(runtime::CardWarningTable()[index].warning);
  }
  return silent;
}

Walk ReadWalk(Arguments* arguments) {
  Walk walk;
  walk.goal = static_cast<Goal>(arguments->Word("goal", kGoals));
  const bool of_thread = walk.goal == Goal::kStatement || walk.goal == Goal::kLine;
  if (of_thread) {
    walk.thread = static_cast<int>(arguments->Whole("thread", 0, vm::kThreadCount - 1));
  }
  if (walk.goal == Goal::kTime) walk.time_us = FromMs(arguments->Number("ms", 0, kMsMax));
  if (walk.goal == Goal::kEnd) {
    walk.time_us = FromMs(arguments->Has("ms") ? arguments->Number("ms", 0, kMsMax) : kMsMax);
  }
  if (walk.goal == Goal::kChange) walk.name = arguments->Text("name");
  walk.budget = arguments->Whole("budget", 1, kStepsMax, walk.budget);
  return walk;
}

/// `races` is what a missing member means.
StopWishes ReadWishes(Arguments* arguments, bool races) {
  StopWishes wishes;
  for (Arguments& item : arguments->Objects("lines")) {
    LineStop line;
    constexpr int64_t kPlaceMax = std::numeric_limits<uint16_t>::max();
    if (item.Has("function")) {
      line.function = item.Text("function");
      line.position = static_cast<int>(item.Whole("position", 0, kPlaceMax, 0));
    } else {
      line.file = item.Text("file", {});
      line.line = static_cast<int>(item.Whole("line", 1, kPlaceMax));
    }
    if (item.Has("thread")) {
      line.thread = static_cast<int>(item.Whole("thread", 0, vm::kThreadCount - 1));
    }
    line.condition = item.Text("condition", {});
    line.hits = item.Whole("hits", 0, kMomentMax, 0);
    line.log = item.Text("log", {});
    arguments->Join(std::move(item));
    wishes.lines.push_back(std::move(line));
  }
  wishes.changes = arguments->Texts("changes", {});
  wishes.conditions = arguments->Texts("conditions", {});
  wishes.faults = arguments->Flag("faults", true);
  wishes.refusals = arguments->Flag("refusals", true);
  wishes.requirements = arguments->Flag("requirements", true);
  wishes.races = arguments->Flag("races", races);
  wishes.warnings = arguments->Flag("warnings", false);
  return wishes;
}

}  // namespace

// One function for each request. They read all arguments before they act, and return the result.
class SessionHost::Requests {
 public:
  Requests(compiler::FileReader reader, CommentReader comments, CallReader calls)
      : reader_(std::move(reader)), comments_(std::move(comments)), calls_(calls) {}

  std::string Handle(std::string_view text);
  void End() { ended_ = true; }

 private:
  friend class SessionHost;
  using Handler = Result<Json> (Requests::*)(Arguments&);
  struct Request {
    RequestText text;
    Handler handler;
  };
  static const std::vector<Request>& All();

  Result<Json> Hello(Arguments& arguments);
  Result<Json> Check(Arguments& arguments);
  Result<Json> RunWhole(Arguments& arguments);
  Result<Json> Load(Arguments& arguments);
  Result<Json> State(Arguments& arguments);
  Result<Json> Forward(Arguments& arguments);
  Result<Json> Back(Arguments& arguments);
  Result<Json> StepThread(Arguments& arguments);
  Result<Json> GoTo(Arguments& arguments);
  Result<Json> SetStops(Arguments& arguments);
  Result<Json> Variables(Arguments& arguments);
  Result<Json> Slots(Arguments& arguments);
  Result<Json> Card(Arguments& arguments);
  Result<Json> Evaluate(Arguments& arguments);
  Result<Json> Write(Arguments& arguments);
  Result<Json> SetInput(Arguments& arguments);
  Result<Json> SetVoltage(Arguments& arguments);
  Result<Json> MoveSwitch(Arguments& arguments);
  Result<Json> Trace(Arguments& arguments);
  Result<Json> Turns(Arguments& arguments);
  Result<Json> Spans(Arguments& arguments);
  Result<Json> Written(Arguments& arguments);
  Result<Json> Listing(Arguments& arguments);
  Result<Json> Record(Arguments& arguments);

  Result<Json> LoadCalls(const std::string& text, const std::string& path, std::optional<int> card,
                         int opening, runtime::CardWarnings silent);
  void Begin(Session session, runtime::CardWarnings silent);
  Result<Json> Answer(std::string_view text);
  /// Reads the files that a request brings.
  Result<Project> ReadFiles(Arguments& arguments,
                            runtime::ScenarioUse use = runtime::ScenarioUse::kSession);
  /// For a request that needs a session and has no further arguments.
  std::optional<Error> Missing(Arguments& arguments) const;
  Json StateNow() const { return StateView(session_->run(), language_); }
  /// The answer to a walk.
  Json WalkAnswer(const Stop& stop) const;

  compiler::FileReader reader_;
  CommentReader comments_;
  CallReader calls_ = nullptr;
  Language language_ = Language::kEnglish;
  std::optional<Session> session_;
  std::atomic<bool> ended_ = false;
  std::string events_;
  /// Files that this request needed and that do not exist.
  std::vector<std::string> missing_;
  Json id_;
};

const std::vector<SessionHost::Requests::Request>& SessionHost::Requests::All() {
  static const std::vector<Request> all = {
      {{"hello", "[protocol] [language]"}, &Requests::Hello},
      {{"check", "main [files] [structured]"}, &Requests::Check},
      {{"run", "main [files] [structured] [show] [silent]"}, &Requests::RunWhole},
      {{"load", "main [files] [structured] [card] [opening] [silent]"}, &Requests::Load},
      {{"state", ""}, &Requests::State},
      {{"forward", "goal [thread] [ms] [budget]"}, &Requests::Forward},
      {{"back", "goal [thread] [name] [budget]"}, &Requests::Back},
      {{"step_thread", "thread"}, &Requests::StepThread},
      {{"go_to", "[moment] [ms]"}, &Requests::GoTo},
      {{"set_stops",
        "[lines] [changes] [conditions] [faults] [refusals] [requirements] [races] [warnings]"},
       &Requests::SetStops},
      {{"variables", "[page]"}, &Requests::Variables},
      {{"slots", "page"}, &Requests::Slots},
      {{"card", ""}, &Requests::Card},
      {{"evaluate", "text [thread]"}, &Requests::Evaluate},
      {{"write", "name value"}, &Requests::Write},
      {{"set_input", "type index level"}, &Requests::SetInput},
      {{"set_voltage", "channel volts"}, &Requests::SetVoltage},
      {{"move_switch", "switch [from] [to]"}, &Requests::MoveSwitch},
      {{"trace", "names from_ms to_ms points"}, &Requests::Trace},
      {{"turns", "from to [most]"}, &Requests::Turns},
      {{"spans", "[from] [to] [most]"}, &Requests::Spans},
      {{"written", "[statements]"}, &Requests::Written},
      {{"listing", ""}, &Requests::Listing},
      {{"record", "[path]"}, &Requests::Record},
  };
  return all;
}

std::span<const RequestText> SessionHost::RequestTexts() {
  static const std::vector<RequestText> texts = [] {
    std::vector<RequestText> list;
    for (const auto& request : Requests::All()) list.push_back(request.text);
    for (const EditorRequest& request : EditorRequests()) list.push_back(request.text);
    return list;
  }();
  return texts;
}

std::string SessionHost::Requests::Handle(std::string_view text) {
  events_.clear();
  missing_.clear();
  id_ = nullptr;
  auto answer = Answer(text);
  Json response = {{"id", id_}, {"ok", answer.ok()}};
  if (answer.ok()) {
    response["result"] = std::move(answer).value();
  } else {
    response["error"] = answer.error().message.In(language_);
  }
  if (!missing_.empty()) response["missing"] = missing_;
  return std::move(events_) + JsonText(response) + '\n';
}

Result<Json> SessionHost::Requests::Answer(std::string_view text) {
  if (text.size() > kRequestKind.bytes_max) {
    return MakeError(1, "a request has at most {0} bytes", "请求最多 {0} 字节",
                     kRequestKind.bytes_max);
  }
  const Json request = ReadJson(text);
  if (!request.is_object()) {
    return MakeError(1,
                     "a request is a JSON object in one line, with at most {0} keys in each object",
                     "请求应为一行 JSON 对象，其中每个对象最多 {0} 个键", kJsonKeysMax);
  }
  if (const auto id = request.find("id"); id != request.end()) {
    if (id->is_number_integer() || id->is_string()) id_ = *id;
  }
  Arguments head(request);
  const bool has_id = head.Has("id");
  const std::string name = head.Text("request");
  const Json none = Json::object();
  const bool has_arguments = head.Has("arguments");
  if (has_id && id_.is_null()) {
    return MakeError(1, "'id' must be an integer or a text", "“id”应为整数或文本");
  }
  if (auto mistakes = head.Mistakes()) return *std::move(mistakes);
  std::vector<std::string_view> names;
  for (const Request& each : All()) {
    names.push_back(each.text.name);
    if (each.text.name != name) continue;
    Arguments arguments(has_arguments ? request["arguments"] : none);
    return (this->*each.handler)(arguments);
  }
  for (const EditorRequest& each : EditorRequests()) {
    names.push_back(each.text.name);
    if (each.text.name != name) continue;
    Arguments arguments(has_arguments ? request["arguments"] : none);
    return each.answer(arguments, {reader_, language_, &missing_});
  }
  const std::string_view near = NearestName(name, names);
  if (!near.empty()) {
    return MakeError(1, "there is no request '{0}'; did you mean '{1}'?",
                     "没有请求“{0}”；是否为“{1}”？", name, near);
  }
  return MakeError(1, "there is no request '{0}': 'hello' lists them",
                   "没有请求“{0}”：“hello”会列出所有请求", name);
}

std::optional<Error> SessionHost::Requests::Missing(Arguments& arguments) const {
  if (auto mistakes = arguments.Mistakes()) return mistakes;
  if (!session_) return NoSession();
  return std::nullopt;
}

// --- Before a session ----------------------------------------------------------------------------

Result<Json> SessionHost::Requests::Hello(Arguments& arguments) {
  const int64_t protocol = arguments.Whole("protocol", 1, kMomentMax, kProtocolVersion);
  const bool chinese = arguments.Has("language") && arguments.Word("language", {"en", "zh"}) == 1;
  if (auto mistakes = arguments.Mistakes()) return *std::move(mistakes);
  if (protocol != kProtocolVersion) {
    return MakeError(1, "protocol {0} is not spoken here: this is {1}",
                     "此处不支持协议 {0}：当前版本为 {1}", protocol, kProtocolVersion);
  }
  language_ = chinese ? Language::kChinese : Language::kEnglish;
  Json requests = Json::object();
  for (const RequestText& each : RequestTexts()) requests[std::string(each.name)] = each.arguments;
  return Json{{"protocol", kProtocolVersion}, {"requests", std::move(requests)}};
}

Result<Project> SessionHost::Requests::ReadFiles(Arguments& arguments, runtime::ScenarioUse use) {
  const std::string main = arguments.Text("main");
  Files files(arguments.TextsByName("files"), reader_);
  const bool structured = arguments.Flag("structured", false);
  if (auto mistakes = arguments.Mistakes()) return *std::move(mistakes);
  auto project = ReadProject(main, files, structured, use);
  missing_ = files.missing();
  if (!project.ok() || !comments_) return project;
  auto& [scenario, compilation, schedule, calls] = project.value();
  // A scenario and a recording say everything themselves, and an object has no comments.
  if (scenario.program != main || compilation.files.empty() || !compilation.ok()) return project;
  auto read = comments_(main, compilation.files[0].text(), *compilation.object, &scenario);
  if (!read.ok()) return read.error();
  return project;
}

Result<Json> SessionHost::Requests::Check(Arguments& arguments) {
  const auto project = ReadFiles(arguments);
  if (!project.ok()) return project.error();
  const compiler::Compilation& compilation = project.value().compilation;
  return Json{{"compiled", compilation.ok() || project.value().calls.has_value()},
              {"diagnostics", compiler::DiagnosticsJson(compilation, language_)}};
}

Result<Json> SessionHost::Requests::RunWhole(Arguments& arguments) {
  runtime::RunOptions options;
  options.show = arguments.Texts("show", {});
  options.silent = ReadSilent(&arguments);
  auto project = ReadFiles(arguments, runtime::ScenarioUse::kRun);
  if (!project.ok()) return project.error();
  const compiler::Compilation& compilation = project.value().compilation;
  Json answer = {{"compiled", compilation.ok()},
                 {"diagnostics", compiler::DiagnosticsJson(compilation, language_)}};
  if (!compilation.ok()) return answer;
  options.replay = project.value().schedule;
  options.stop = &ended_;
  const auto result =
      runtime::RunWithRequirements(project.value().scenario, *compilation.object, options);
  if (!result.ok()) return result.error();
  answer["run"] = runtime::ResultJson(result.value(), language_);
  return answer;
}

Result<Json> SessionHost::Requests::Load(Arguments& arguments) {
  std::optional<int> card;
  if (arguments.Has("card")) card = static_cast<int>(arguments.Whole("card", 0, kCardMax));
  const auto opening = static_cast<int>(arguments.Whole("opening", 1, kOpeningMax, 1));
  const runtime::CardWarnings silent = ReadSilent(&arguments);
  const std::string main = arguments.Text("main");
  auto project = ReadFiles(arguments);
  if (!project.ok()) return project.error();
  if (project.value().calls) return LoadCalls(*project.value().calls, main, card, opening, silent);
  compiler::Compilation& compilation = project.value().compilation;
  Json answer = {{"compiled", compilation.ok()},
                 {"diagnostics", compiler::DiagnosticsJson(compilation, language_)}};
  if (!compilation.ok()) return answer;
  auto session =
      Session::Create(std::move(project.value().scenario), *std::move(compilation.object),
                      std::move(project.value().schedule));
  if (!session.ok()) return session.error();
  Begin(std::move(session).value(), silent);
  answer["files"] = Json::array();
  for (const compiler::SourceFile& file : compilation.files) {
    answer["files"].push_back({{"path", file.path()}, {"text", file.text()}});
  }
  if (const Message& choice = session_->choice(); !choice.en.empty()) {
    answer["choice"] = choice.In(language_);
  }
  answer["state"] = StateNow();
  return answer;
}

Result<Json> SessionHost::Requests::LoadCalls(const std::string& text, const std::string& path,
                                              std::optional<int> card, int opening,
                                              runtime::CardWarnings silent) {
  if (calls_ == nullptr) {
    return MakeError(1, "records of host calls are read by the 'oncard' command only",
                     "主机调用记录只能由“oncard”命令读取");
  }
  auto loaded = calls_(text, path, card, opening);
  if (!loaded.ok()) return loaded.error();
  Begin(std::move(loaded.value().session), silent);
  Json answer = std::move(loaded.value().answer);
  answer["state"] = StateNow();
  return answer;
}

void SessionHost::Requests::Begin(Session session, runtime::CardWarnings silent) {
  session_.emplace(std::move(session));
  session_->EndEarly(&ended_);
  session_->run().Silence(silent);
}

// --- Walks ---------------------------------------------------------------------------------------

Result<Json> SessionHost::Requests::State(Arguments& arguments) {
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return StateNow();
}

Json SessionHost::Requests::WalkAnswer(const Stop& stop) const {
  return {{"stop", StopView(stop, language_)}, {"state", StateNow()}};
}

Result<Json> SessionHost::Requests::Forward(Arguments& arguments) {
  const Walk walk = ReadWalk(&arguments);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  std::vector<LogLine> log;
  const auto stop = session_->Forward(walk, &log);
  for (const LogLine& line : log) {
    const Json event = {
        {"event", "log"}, {"moment", line.moment}, {"thread", line.thread}, {"text", line.text}};
    events_ += JsonText(event) + '\n';
  }
  if (!stop.ok()) return stop.error();
  return WalkAnswer(stop.value());
}

Result<Json> SessionHost::Requests::Back(Arguments& arguments) {
  const Walk walk = ReadWalk(&arguments);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  const auto stop = session_->Back(walk);
  if (!stop.ok()) return stop.error();
  return WalkAnswer(stop.value());
}

Result<Json> SessionHost::Requests::StepThread(Arguments& arguments) {
  const auto thread = static_cast<int>(arguments.Whole("thread", 0, vm::kThreadCount - 1));
  if (auto missing = Missing(arguments)) return *std::move(missing);
  const auto stop = session_->StepThread(thread);
  if (!stop.ok()) return stop.error();
  return WalkAnswer(stop.value());
}

Result<Json> SessionHost::Requests::GoTo(Arguments& arguments) {
  const bool to_time = arguments.Has("ms");
  const double ms = to_time ? arguments.Number("ms", 0, kMsMax) : 0;
  const int64_t moment = to_time ? 0 : arguments.Whole("moment", 0, kMomentMax);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  if (to_time) {
    session_->run().GoToCycle(session_->run().controller().clock().CycleAt(FromMs(ms)));
    return StateNow();
  }
  if (moment > session_->run().head()) {
    return MakeError(1, "the run has reached moment {0}, not {1}: go forward",
                     "运行只到达时刻 {0}，未到 {1}：请前进", session_->run().head(), moment);
  }
  session_->run().GoTo(moment);
  return StateNow();
}

Result<Json> SessionHost::Requests::SetStops(Arguments& arguments) {
  const StopWishes wishes = ReadWishes(&arguments, session_ && session_->ForbidsRaces());
  if (auto missing = Missing(arguments)) return *std::move(missing);
  if (auto set = session_->SetStops(wishes); !set.ok()) return set.error();
  return Json{{"lines", session_->stops().lines()}};
}

// --- Looks ---------------------------------------------------------------------------------------

Result<Json> SessionHost::Requests::Variables(Arguments& arguments) {
  const int64_t page = arguments.Whole("page", 0, vm::kPageCount - 1, -1);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return page < 0 ? GlobalsView(session_->run())
                  : PageView(session_->run(), static_cast<int>(page));
}

Result<Json> SessionHost::Requests::Slots(Arguments& arguments) {
  const auto page = static_cast<int>(arguments.Whole("page", 0, vm::kPageCount - 1));
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return SlotsView(session_->run(), page);
}

Result<Json> SessionHost::Requests::Card(Arguments& arguments) {
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return CardView(session_->run(), language_);
}

Result<Json> SessionHost::Requests::Evaluate(Arguments& arguments) {
  const std::string text = arguments.Text("text");
  std::optional<int> thread;
  if (arguments.Has("thread")) {
    thread = static_cast<int>(arguments.Whole("thread", 0, vm::kThreadCount - 1));
  }
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return session::Evaluate(text, thread, session_->run());
}

Result<Json> SessionHost::Requests::Trace(Arguments& arguments) {
  const std::vector<std::string> names = arguments.Texts("names");
  const double from_ms = arguments.Number("from_ms", 0, kMsMax);
  const double to_ms = arguments.Number("to_ms", 0, kMsMax);
  const auto points = static_cast<int>(arguments.Whole("points", 1, kPointsMax));
  if (auto missing = Missing(arguments)) return *std::move(missing);
  if (from_ms > to_ms) {
    return MakeError(1, "'from_ms' must not be later than 'to_ms'", "“from_ms”不得晚于“to_ms”");
  }
  const auto channels = session_->Trace(names, FromMs(from_ms), FromMs(to_ms), points);
  if (!channels.ok()) return channels.error();
  return ChannelsView(channels.value());
}

Result<Json> SessionHost::Requests::Turns(Arguments& arguments) {
  const int64_t from = arguments.Whole("from", 0, kMomentMax);
  const int64_t to = arguments.Whole("to", 0, kMomentMax);
  const int64_t most = arguments.Whole("most", 1, kTurnsMax, kTurnsDefault);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return TurnsView(session_->run().Turns(from, to, static_cast<size_t>(most)), session_->run());
}

Result<Json> SessionHost::Requests::Spans(Arguments& arguments) {
  const int64_t from = arguments.Whole("from", 0, kMomentMax, 0);
  const int64_t to = arguments.Whole("to", 0, kMomentMax, kMomentMax);
  const int64_t most = arguments.Whole("most", 1, kTurnsMax, kTurnsDefault);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  RewindableRun& run = session_->run();
  return SpansView(run.Spans(from, to, static_cast<size_t>(most)), run, language_);
}

Result<Json> SessionHost::Requests::Written(Arguments& arguments) {
  const int64_t statements = arguments.Whole("statements", 1, kWrittenMax, kWrittenDefault);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return LineWritesView(WritesOfLines(session_->run(), statements));
}

Result<Json> SessionHost::Requests::Listing(Arguments& arguments) {
  if (auto missing = Missing(arguments)) return *std::move(missing);
  return ListingView(session_->run());
}

// --- Changes and recordings ----------------------------------------------------------------------

Result<Json> SessionHost::Requests::Write(Arguments& arguments) {
  const std::string name = arguments.Text("name");
  const double value = arguments.Number("value");
  if (auto missing = Missing(arguments)) return *std::move(missing);
  if (auto done = session_->run().WriteVariable(name, value); !done.ok()) return done.error();
  return StateNow();
}

Result<Json> SessionHost::Requests::SetInput(Arguments& arguments) {
  const std::string type = arguments.Text("type");
  const auto index = static_cast<int>(arguments.Whole("index", 1, 16));
  const bool level = arguments.Whole("level", 0, 1) != 0;
  if (auto missing = Missing(arguments)) return *std::move(missing);
  const auto word = runtime::FindInputWord(type);
  if (!word) {
    return MakeError(1, "'{0}' is no type of input", "“{0}”不是输入类型", type);
  }
  if (auto done = session_->run().SetInput(*word, index, level); !done.ok()) return done.error();
  return StateNow();
}

Result<Json> SessionHost::Requests::SetVoltage(Arguments& arguments) {
  const auto channel = static_cast<int>(arguments.Whole("channel", 1, 8));
  const double volts = arguments.Number("volts");
  if (auto missing = Missing(arguments)) return *std::move(missing);
  if (auto done = session_->run().SetVoltage(channel, volts); !done.ok()) return done.error();
  return StateNow();
}

Result<Json> SessionHost::Requests::MoveSwitch(Arguments& arguments) {
  constexpr double kPositionMax = 2147483648.0;
  const auto number = static_cast<int>(arguments.Whole("switch", 1, kSwitchesMax));
  const bool has_from = arguments.Has("from");
  const bool has_to = arguments.Has("to");
  runtime::SwitchMove move;
  if (has_from) move.from = arguments.Number("from", -kPositionMax, kPositionMax);
  if (has_to) move.to = arguments.Number("to", -kPositionMax, kPositionMax);
  if (auto missing = Missing(arguments)) return *std::move(missing);
  if (!has_from && !has_to) {
    return MakeError(1, "'from' or 'to' is missing: the position of the switch",
                     "缺少“from”或“to”：开关的位置");
  }
  auto done = session_->run().MoveSwitch(number, move.from, move.to);
  if (!done.ok()) return done.error();
  return StateNow();
}

Result<Json> SessionHost::Requests::Record(Arguments& arguments) {
  const std::string path = arguments.Text("path", {});
  if (auto missing = Missing(arguments)) return *std::move(missing);
  if (session_->run().calls() != nullptr) {
    return MakeError(1, "the run of a host cannot be recorded as a schedule",
                     "主机程序的运行不能录制为调度");
  }
  const vm::Schedule schedule = session_->run().Record(path);
  return Json{{"schedule", vm::FormatSchedule(schedule)}, {"scenario", schedule.scenario}};
}

// --- The host ------------------------------------------------------------------------------------

SessionHost::SessionHost(compiler::FileReader reader, CommentReader comments, CallReader calls)
    : requests_(std::make_unique<Requests>(std::move(reader), std::move(comments), calls)) {}
SessionHost::SessionHost(SessionHost&&) noexcept = default;
SessionHost& SessionHost::operator=(SessionHost&&) noexcept = default;
SessionHost::~SessionHost() = default;

std::string SessionHost::Handle(std::string_view request) { return requests_->Handle(request); }

void SessionHost::End() { requests_->End(); }

}  // namespace oncard::session
