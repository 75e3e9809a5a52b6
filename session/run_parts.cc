#include <iterator>

#include "runtime/observe/thread_status.h"
#include "runtime/scenario/file/view_setup.h"
#include "session/host.h"
#include "session/protocol_parts.h"
#include "session/views.h"

namespace oncard::session::schema {
namespace {

Members CompiledMembers() {
  return {Has("compiled", Flag()), Has("diagnostics", ListOf(The("Diagnostic")))};
}

/// The goals of a walk: some alone, those of a thread, and some with a member of their own.
Json WalkTo(const std::vector<std::string_view>& alone,
            const std::vector<std::pair<std::string_view, Member>>& others) {
  const Member budget = MayHave("budget", Whole(), "So many steps at most; 1000000 without it.");
  std::vector<Json> walks{
      Object({Has("goal", Words(alone)), budget}),
      Object({Has("goal", Words({"statement", "line"})), Has("thread", Whole()), budget})};
  for (const auto& [goal, its] : others) {
    walks.push_back(Object({Has("goal", Always(goal)), its, budget}));
  }
  return OneOf(std::move(walks));
}

/// A place at which a walk is to stop, by these members, with the options of all such places.
Json StopAt(const Members& place) {
  return Object(place + Members{MayHave("thread", Whole(), "Only this one."),
                                MayHave("condition", Text()),
                                MayHave("hits", Whole(), "Only from this arrival on."),
                                MayHave("log", Text(), "Is logged instead of a stop.")});
}

std::vector<Part> ProgramParts() {
  const Json diagnostics = ListOf(The("Diagnostic"));
  return {
      {"Language", "The language of texts for people.", Words({"en", "zh"})},
      {"Hello", "Who answers.",
       Object({Has("protocol", Always(kProtocolVersion)),
               Has("requests", ByName(Text()), "All requests with their arguments.")})},
      {"Project", "A program that is to be compiled.", Object(ProgramMembers())},
      {"SourceFile", "A file with its text.", Object({Has("path", Text()), Has("text", Text())})},
      {"Compiled", "What the compiler says.", Object(CompiledMembers())},
      {"Loaded", "What `load` answers; no more than messages if the program does not compile.",
       OneOf({Object({Has("compiled", Always(false)), Has("diagnostics", diagnostics)}),
              Object({Has("compiled", Always(true)), Has("diagnostics", diagnostics),
                      Has("files", ListOf(The("SourceFile"))),
                      MayHave("cards", ListOf(The("RecordedCard")), "Of the record of a host."),
                      MayHave("choice", Text(), "As of a whole run: the first case is loaded."),
                      Has("state", The("State"))})})},
      {"RecordedCard", "One of the records in the file of a host.",
       Object({Has("card", Whole()), Has("opening", Whole()), Has("calls", Whole())})},
      {"RunAnswer", "What `run` answers.",
       Object(CompiledMembers() +
              Members{MayHave("run", The("Run"), "Missing if the program does not compile.")})},
      {"Run", "The result of a whole run, as `oncard run --format=json` writes it.",
       Object(
           {MayHave("choice", Text(), "What was chosen, if the scenario leaves something open."),
            Has("passed", Flag()),
            Has("end", Words({"quiet", "until", "time-limit", "deadlock", "schedule-end",
                              "diverged", "interrupted"})),
            Has("time_ms", Number()), Has("statements", Whole()), Has("program_hash", Text()),
            Has("state_hash", Text()), Has("threads", ListOf(The("ThreadResult"))),
            Has("values", ByName(The("Value"))),
            Has("failures", ListOf(Object({Has("expectation", Text()), Has("message", Text())}))),
            Has("warnings", ListOf(Text()))})},
      {"ThreadResult", "How a thread has ended.",
       Object({Has("thread", Whole()), Has("function", Text()), Has("page", Whole()),
               Has("state", The("ThreadState")), Has("result", OrNull(Number())),
               Has("error", Whole()), Has("place", Text()), Has("statements", Whole()),
               Has("status", Text(), "In words.")})},
  };
}

std::vector<Part> StateParts() {
  return {
      {"State", "The present of a session.",
       Object({Has("moment", Whole()),
               Has("head", Whole(), "The last moment that the session can go to."),
               Has("cycle", Whole()), Has("time_ms", Number()), Has("statements", Whole()),
               Has("statements_left", Whole(), "That the threads may still execute in this cycle."),
               Has("next", Words(Names(StepKind::kHost, StepKind::kStatement, StepName))),
               MayHave("next_thread", Whole()),
               MayHave("over",
                       Words(Names(runtime::RunOver::kQuiet, runtime::RunOver::kHostEnd, OverName)),
                       "Why the run of the scenario is over."),
               Has("follows_schedule", Flag()), MayHave("host", The("HostState")),
               Has("hash", Text()), Has("threads", ListOf(The("Thread"))),
               Has("warnings", ListOf(The("CardWarning")), "Up to this moment.")})},
      {"HostState", "The calls of a recorded host.",
       Object({Has("calls", Whole(), "With the end."), Has("made", Whole()),
               MayHave("program", Text(), "The hash of the card's program."),
               MayHave("last", Text()), MayHave("next", Text()), MayHave("next_ms", Number())})},
      {"ThreadState", "What a thread does.",
       Words(Names(vm::ThreadRun::kStopped, vm::ThreadRun::kFaulted, runtime::ThreadStateName))},
      {"Thread", "A bound thread.",
       Object(
           {Has("thread", Whole()), Has("function", Text()), Has("page", Whole()),
            Has("state", The("ThreadState")), Has("file", Text()), Has("line", Whole()),
            Has("position", Whole(), "Of its statement in the function."),
            Has("statements", Whole()), Has("error", Whole()), Has("status", Text(), "In words."),
            Has("ready", Flag(), "It can execute a statement now."), MayHave("waits", The("Wait")),
            MayHave("next_start_ms", Number()), MayHave("result", Number()),
            MayHave("refused", Text(), "Its last command, if that was refused.")})},
      {"Wait", "Until a time, or until a variable has a value.",
       Object(
           {MayHave("until_ms", Number()), MayHave("name", Text()), MayHave("value", Number())})},
      {"CardWarning",
       "What the card's supervisor warns of; its place in the program, or the call of the host.",
       Object({Has("name", Text()), Has("text", Text()),
               Has("time_ms", Number(), "Of its first occurrence."), MayHave("thread", Whole()),
               MayHave("file", Text()), MayHave("line", Whole()), MayHave("call", Text())})},
      {"LogEvent", "A line that a stop logs.",
       Object({Has("event", Always("log")), Has("moment", Whole()), Has("thread", Whole()),
               Has("text", Text())})},
  };
}

std::vector<Part> WalkParts() {
  return {
      {"ForwardWalk", "How far a walk goes forward.",
       WalkTo(
           {"step", "cycle", "stop", "rest", "call"},
           {{"time", Has("ms", Number())}, {"end", MayHave("ms", Number(), "So long at most.")}})},
      {"BackWalk", "How far a walk goes back.",
       WalkTo({"step", "cycle", "stop", "call"}, {{"change", Has("name", Text())}})},
      {"WalkResult", "Where a walk has ended.",
       Object({Has("stop", The("Stop")), Has("state", The("State"))})},
      {"StopReason", "Why a walk has ended.",
       Words(Names(StopReason::kGoal, StopReason::kBudget, ReasonName))},
      {"Stop", "The end of a walk.",
       Object({Has("reason", The("StopReason")), MayHave("thread", Whole()),
               MayHave("number", Whole(), "Which of the wishes, from 0."), MayHave("text", Text()),
               MayHave("failed", ListOf(Text()),
                       "At the end: expectations and final requirements that do not hold.")})},
      {"StopWishes", "Where walks are to stop.",
       Object({MayHave("lines", ListOf(The("LineStop"))),
               MayHave("changes", ListOf(Text()), "Names of values."),
               MayHave("conditions", ListOf(Text())), MayHave("faults", Flag()),
               MayHave("refusals", Flag()), MayHave("requirements", Flag()),
               MayHave("races", Flag()), MayHave("warnings", Flag())})},
      {"LineStop", "A line, or a card statement of a function.",
       OneOf({StopAt({Has("line", Whole()),
                      MayHave("file", Text(), "As the threads of the state name it.")}),
              StopAt({Has("function", Text()), MayHave("position", Whole())})})},
  };
}

std::vector<Part> ValueParts() {
  return {
      {"Value", "Of a variable; a list of an array's.", OneOf({Number(), ListOf(Number())})},
      {"Variable", "A variable with its value.",
       Object({Has("name", Text()), Has("path", Text(), "Its name for `evaluate` and `write`."),
               Has("type", Text()), Has("slot", Whole()), Has("value", The("Value"))})},
      {"Card", "The card with its surroundings.",
       Object({Has("parts", ListOf(The("CardPart"))), Has("words", ListOf(The("CardWord"))),
               Has("switches", ListOf(The("CardSwitch"))), Has("paths", ListOf(The("CardPath"))),
               Has("view", The("MachineLook"))})},
      {"CardPart", "An axis, a profile, an encoder, ...",
       Object(
           {Has("part", Text()), Has("number", Whole()),
            Has("values", ListOf(Object({Has("name", Text()), Has("path", Text()),
                                         Has("value", Number()), MayHave("unit", Text()),
                                         MayHave("flag", Flag(), "It can only be 0 or 1.")})))})},
      {"CardWord", "Inputs or outputs.",
       Object({Has("name", Text()), Has("kind", Words({"input", "output"})), Has("value", Number()),
               Has("pins", Whole(), "How many there are, from bit 0.")})},
      {"CardSwitch", "A switch as `[[world.switch]]` describes it.",
       Object({Has("axis", Whole()), Has("type", Text()), Has("index", Whole()),
               MayHave("from", Number()), MayHave("to", Number()), Has("active_low", Flag()),
               Has("connected", Flag())})},
      {"CardPath", "A coordinate system that is set up, with the path that lies ahead of it.",
       Object(
           {Has("crd", Whole()), Has("axes", ListOf(Whole()), "By their coordinates X, Y, Z, A."),
            Has("points", ListOf(ListOf(Number())),
                "Positions of `axes` in their units, from where they are; empty if nothing waits."),
            Has("whole", Flag(), "`false`: the path goes on after the last point.")})},
      {"MachineLook", "How the machine looks, as `[view]` of the scenario describes it.",
       Object({Has("title", Text(), "In the language of the session; may be empty."),
               Has("kind",
                   Words({std::begin(runtime::kMachineKinds), std::end(runtime::kMachineKinds)})),
               Has("x", Whole(), "An axis, as all three."), Has("y", Whole()),
               Has("z", Whole(), "0: none."), Has("turn", Number()),
               Has("pins", ListOf(Object({Has("type", Text(), "The name of a word."),
                                          Has("index", Whole()), Has("name", Text())})))})},
      {"Evaluation", "The value of a name, or whether a condition holds.",
       OneOf({Object({Has("value", The("Value")), Has("path", Text(), "The whole name.")}),
              Object({Has("holds", Flag())})})},
      {"Channel", "A value over time: its extremes in each part of the time.",
       Object({Has("name", Text()), Has("least", ListOf(Number())),
               Has("largest", ListOf(Number()))})},
      {"Turn", "Statements of one thread in a row.",
       Object({Has("moment", Whole()), Has("time_ms", Number()), Has("thread", Whole()),
               Has("statements", Whole())})},
      {"LineWrites", "What a thread wrote in a line when it executed the line last.",
       Object({Has("thread", Whole()), Has("file", Text()), Has("line", Whole()),
               Has("moment", Whole(), "Before the last of its statements."),
               Has("values", ListOf(Object({Has("name", Text(), "Of a local: without its page."),
                                            Has("value", Number())}))),
               MayHave("result", Number(), "Of the thread, if it has returned one here.")})},
      {"ThreadSpan", "A time in which a thread was in one state.",
       Object({Has("thread", Whole()), Has("state", The("ThreadState")), Has("line", Whole()),
               Has("from", Whole(), "A moment."), Has("to", Whole()), Has("from_ms", Number()),
               Has("to_ms", Number()), MayHave("waits", The("Wait")),
               MayHave("text", Text(), "Why the thread has faulted.")})},
      {"ListedFunction", "The card statements of a function.",
       Object({Has("name", Text()), Has("file", Text()),
               Has("statements",
                   ListOf(Object({Has("line", Whole()), Has("text", Text()),
                                  Has("words", ListOf(Whole()), "Of the object file.")})))})},
  };
}

}  // namespace

Members ProgramMembers() {
  return {Has("main", Text(), "A scenario, a recording or a program."),
          MayHave("files", ByName(Text()), "The text of each file by its path."),
          MayHave("structured", Flag(), "The program is structured C.")};
}

std::vector<Part> RunParts() {
  std::vector<Part> parts;
  for (const auto& some : {ProgramParts(), StateParts(), WalkParts(), ValueParts()}) {
    parts.insert(parts.end(), some.begin(), some.end());
  }
  return parts;
}

}  // namespace oncard::session::schema
