#include "session/protocol_schema.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/json_text.h"
#include "session/host.h"
#include "session/protocol_parts.h"

namespace oncard::session {
namespace schema {
namespace {

struct Request {
  std::string_view name;
  Json arguments;
  Json result;
};

/// As SessionHost::RequestTexts() names them, in the same order.
std::vector<Request> RequestsOfProtocol() {
  const Json none = Object({});
  const Json program = The("Project");
  const Json file = The("SourceProject");
  const Json place = The("SourcePlace");
  const Members place_members = SourcePlaceMembers();
  const Json state = The("State");
  const Json walked = The("WalkResult");
  const Member silent =
      MayHave("silent", ListOf(Text()), "Names of the supervisor's warnings that are left out.");
  const Member most = MayHave("most", Whole(), "So many at most.");
  return {
      {"hello",
       Object({MayHave("protocol", Always(kProtocolVersion)),
               MayHave("language", The("Language"), "Of all texts from now on.")}),
       The("Hello")},
      {"check", program, The("Compiled")},
      {"run",
       Object(ProgramMembers() +
              Members{MayHave("show", ListOf(Text()), "Names of values for the result."), silent}),
       The("RunAnswer")},
      {"load",
       Object(ProgramMembers() +
              Members{MayHave("card", Whole(), "Which card of the record of a host."),
                      MayHave("opening", Whole(), "Which of its openings, from 1."), silent}),
       The("Loaded")},
      {"state", none, state},
      {"forward", The("ForwardWalk"), walked},
      {"back", The("BackWalk"), walked},
      {"step_thread", Object({Has("thread", Whole())}), walked},
      {"go_to", OneOf({Object({Has("moment", Whole())}), Object({Has("ms", Number())})}), state},
      {"set_stops", The("StopWishes"),
       Object({Has("lines", ListOf(Whole()), "Where the stops at lines are.")})},
      {"variables", Object({MayHave("page", Whole(), "Without it the global variables.")}),
       ListOf(The("Variable"))},
      {"slots", Object({Has("page", Whole())}), ListOf(Whole())},
      {"card", none, The("Card")},
      {"evaluate",
       Object(
           {Has("text", Text()),
            MayHave("thread", Whole(), "Names are meant as in its function: its locals first.")}),
       The("Evaluation")},
      {"write", Object({Has("name", Text()), Has("value", Number())}), state},
      {"set_input",
       Object({Has("type", Text()), Has("index", Whole()), Has("level", Whole(), "0 or 1.")}),
       state},
      {"set_voltage", Object({Has("channel", Whole()), Has("volts", Number())}), state},
      {"move_switch",
       Object({Has("switch", Whole(), "From 1."),
               MayHave("from", Number(), "In pulses, or in the unit of its axis."),
               MayHave("to", Number())}),
       state},
      {"trace",
       Object({Has("names", ListOf(Text())), Has("from_ms", Number()), Has("to_ms", Number()),
               Has("points", Whole())}),
       ListOf(The("Channel"))},
      {"turns", Object({Has("from", Whole(), "A moment."), Has("to", Whole()), most}),
       ListOf(The("Turn"))},
      {"spans", Object({MayHave("from", Whole(), "A moment."), MayHave("to", Whole()), most}),
       ListOf(The("ThreadSpan"))},
      {"written", Object({MayHave("statements", Whole(), "1000 without it.")}),
       ListOf(The("LineWrites"))},
      {"listing", none, ListOf(The("ListedFunction"))},
      {"record", Object({MayHave("path", Text(), "The file in which a client keeps one of them.")}),
       Object({Has("schedule", Text(), "The text of a schedule file."),
               Has("scenario", Text(), "That of its scenario, with the changes.")})},
      {"describe", place, OrNull(The("Description"))},
      {"signature", place, OrNull(The("Signature"))},
      {"complete", place, The("Completion")},
      {"outline", file, ListOf(The("OutlineEntry"))},
      {"definition", place, ListOf(The("FileRange"))},
      {"references",
       Object(place_members +
              Members{MayHave("declaration", Flag(), "False: without declarations.")}),
       ListOf(The("Reference"))},
      {"rename", Object(place_members + Members{Has("name", Text())}), ListOf(The("Edit"))},
      {"tokens", file, ListOf(The("Word"))},
      {"folds", file, ListOf(The("Fold"))},
      {"hints", file, ListOf(The("Hint"))},
      {"fixes", program, The("Fixes")},
      {"lower", program, The("Lowered")},
      {"two_columns", program, The("TwoColumns")},
  };
}

Json RequestsObject() {
  Members requests;
  for (Request& request : RequestsOfProtocol()) {
    requests.push_back(Has(request.name, Object({Has("arguments", std::move(request.arguments)),
                                                 Has("result", std::move(request.result))})));
  }
  return Object(requests);
}

Json AnswerType() {
  const Member id = Has("id", OneOf({Whole(), Text(), {{"type", "null"}}}), "Of the request.");
  const Member missing =
      MayHave("missing", ListOf(Text()), "Files that the request needs and that do not exist.");
  return OneOf(
      {Object({id, Has("ok", Always(true)), Has("result", Anything()), missing}),
       Object({id, Has("ok", Always(false)), Has("error", Text(), "What was wrong."), missing})});
}

}  // namespace
}  // namespace schema

std::string ProtocolSchema() {
  using schema::Json;
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "Protocol"},
                 {"description", "The session protocol; docs/session-protocol.md explains it."}};
  schema.update(schema::Object({schema::Has("requests", schema::The("Requests")),
                                schema::Has("answer", schema::The("Answer")),
                                schema::Has("event", schema::The("LogEvent"))}));
  std::vector<schema::Part> parts = {
      {"Requests", "What each request takes and answers.", schema::RequestsObject()},
      {"Answer", "The last line of an answer.", schema::AnswerType()}};
  std::ranges::move(schema::RunParts(), std::back_inserter(parts));
  std::ranges::move(schema::SourceParts(), std::back_inserter(parts));
  for (schema::Part& part : parts) {
    Json& type = schema["$defs"][std::string(part.name)];
    type["description"] = part.meaning;
    type.update(part.type);
  }
  return JsonText(schema, 2) + '\n';
}

}  // namespace oncard::session
