#include "session/host.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "base/limits.h"
#include "tests/session/asking_test.h"
#include "tests/session/session_support.h"
#include "vm/record.h"

namespace oncard::session {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

constexpr const char* kAxis =
    "int n;\ndouble d;\nint a[3];\nint f(int k)\n{\n  n = k;\n  d = 2.5;\n  a[1] = 7;\n"
    "  GT_AxisOn(9);\n  GT_Delay(100);\n  return n;\n}\n";

class HostTest : public AskingTest {
 protected:
  void Load(const std::string& program, const std::string& scenario = "") {
    const Json result = Result(
        "load", {{"main", "s.toml"},
                 {"files", {{"p.c", program}, {"s.toml", "program = \"p.c\"\n" + scenario}}}});
    EXPECT_TRUE(result["compiled"]) << result;
  }
};

// --- Requests ------------------------------------------------------------------------------------

TEST_F(HostTest, RefusesWhatIsNoRequest) {
  for (const std::string_view text : {"", "x", "[]", "1", "{\"id\":", "\xff\xfe", "null"}) {
    const Json response = Json::parse(host_.Handle(text));
    EXPECT_FALSE(response["ok"]) << text;
    EXPECT_TRUE(response["id"].is_null()) << text;
    EXPECT_THAT(response["error"].get<std::string>(), HasSubstr("JSON object")) << text;
  }
  EXPECT_THAT(host_.Handle(std::string(100'000, '[')), HasSubstr("JSON object"));
  std::string many = R"({"id": 1, "request": "state", "arguments": {"0": 0)";
  for (int i = 1; i <= 1000; ++i) many += ", \"" + std::to_string(i) + "\": 0";
  EXPECT_THAT(host_.Handle(many + "}}"), HasSubstr("at most 1000 keys"));
  EXPECT_THAT(host_.Handle("{\"id\": {}, \"request\": \"state\"}"), HasSubstr("'id' must be"));
  EXPECT_THAT(host_.Handle("{\"id\": 1}"), HasSubstr("'request' is missing"));
  EXPECT_THAT(host_.Handle("{\"id\": 1, \"request\": \"state\", \"argument\": {}}"),
              HasSubstr("did you mean 'arguments'?"));
  EXPECT_THAT(host_.Handle(std::string(kRequestKind.bytes_max + 1, ' ')),
              HasSubstr("at most 67108864 bytes"));
}

TEST_F(HostTest, SuggestsSimilarRequests) {
  EXPECT_EQ(ErrorOf("foward"), "there is no request 'foward'; did you mean 'forward'?");
  EXPECT_THAT(ErrorOf("xyz"), HasSubstr("'hello' lists them"));
}

TEST_F(HostTest, ReportsAllMistakesOfTheArguments) {
  EXPECT_EQ(
      ErrorOf("forward", {{"goal", "sideways"}, {"budget", 0}, {"bugdet", 1}}),
      "'goal' is wrong: one of step, statement, line, cycle, time, stop, rest, change, call, end\n"
      "'budget' is wrong: an integer from 1 to 1000000000\n"
      "'bugdet' is not an argument of this request; did you mean 'budget'?");
  EXPECT_EQ(ErrorOf("trace", {{"from_ms", 0}, {"to_ms", 1}, {"points", 1}}),
            "'names' is missing: a list of texts");
  EXPECT_EQ(ErrorOf("go_to"), "'moment' is missing: an integer from 0 to 9007199254740992");
  EXPECT_THAT(ErrorOf("go_to", {{"moment", 1}, {"ms", 1}}),
              HasSubstr("'moment' is not an argument"));
  EXPECT_THAT(ErrorOf("go_to", {{"moment", 1.5}}), StartsWith("'moment' is wrong"));
  EXPECT_THAT(ErrorOf("write", {{"name", 1}, {"value", "x"}}),
              HasSubstr("'name' is wrong: a text\n'value' is wrong: a number"));
  EXPECT_THAT(ErrorOf("set_stops", {{"lines", {{{"lin", 3}}}}}),
              AllOf(HasSubstr("'lines[0].line' is missing"), HasSubstr("'lines[0].lin'")));
  EXPECT_THAT(ErrorOf("state", Json::array()), HasSubstr("must be an object"));
}

TEST_F(HostTest, NeedsAProgramFirst) {
  for (const char* request : {"state", "card", "listing", "record", "variables"}) {
    EXPECT_THAT(ErrorOf(request), HasSubstr("'load' one first")) << request;
  }
}

TEST_F(HostTest, SaysWhichProtocolItSpeaks) {
  const Json hello = Result("hello", {{"protocol", 1}});
  EXPECT_EQ(hello["protocol"], 1);
  EXPECT_EQ(hello["requests"]["go_to"], "[moment] [ms]");
  EXPECT_THAT(ErrorOf("hello", {{"protocol", 2}}), HasSubstr("protocol 2 is not spoken here"));
  Result("hello", {{"language", "zh"}});
  EXPECT_THAT(ErrorOf("state"), HasSubstr("尚未加载程序"));
}

// --- Programs ------------------------------------------------------------------------------------

TEST_F(HostTest, LoadsScenariosProgramsAndRecordings) {
  Load(kRace, kTwoThreads);
  EXPECT_THAT(Result("state")["threads"], SizeIs(2));
  Result("forward", {{"goal", "stop"}});
  const std::string hash = Result("state")["hash"];
  const std::string schedule = Result("record")["schedule"];

  Result("load", {{"main", "p.c"}, {"files", {{"p.c", kRace}}}});
  EXPECT_THAT(Result("state")["threads"], SizeIs(1));

  const Json loaded = Result(
      "load", {{"main", "r.schedule"}, {"files", {{"p.c", kRace}, {"r.schedule", schedule}}}});
  EXPECT_TRUE(loaded["state"]["follows_schedule"]);
  Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(Result("state")["hash"], hash);
}

TEST_F(HostTest, ReadsStructuredCAndItsIncludes) {
  const Json result = Result(
      "load", {{"main", "p.c"},
               {"structured", true},
               {"files",
                {{"p.c",
                  "#include \"k.h\"\nint s;\nint f(void)\n{\n  for (int i = 0; i < K; i++) s "
                  "+= i;\n  return s;\n}\n"},
                 {"k.h", "#define K 5\n"}}}});
  EXPECT_TRUE(result["compiled"]) << result;
  EXPECT_THAT(result["files"], SizeIs(2));
  Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(Result("evaluate", {{"text", "s"}})["value"], 10);
  // A recording says so itself.
  EXPECT_THAT(Result("record")["scenario"].get<std::string>(), HasSubstr("structured = true"));
}

// Values and changes have the names of C.
TEST_F(HostTest, NamesVariablesAsStructuredCDoes) {
  Load(
      "//@ structured\nstruct axis { int target; double gains[2]; } axis[2];\nint m[2][3];\n"
      "struct { TJogPrm jog; } moves[2];\n"
      "void f() {\n  struct axis old = {2, {0.5}};\n  axis[1] = old;\n  m[1][2] = old.target;\n"
      "  moves[1].jog.dec = 1.5;\n}\n");
  Result("forward", {{"goal", "stop"}});
  std::vector<std::string> globals;
  for (const Json& variable : Result("variables")) {
    globals.push_back(variable["path"].get<std::string>() + " " + variable["value"].dump());
  }
  EXPECT_EQ(globals,
            (std::vector<std::string>{
                "axis[0].target 0", "axis[0].gains [0.0,0.0]", "axis[1].target 2",
                "axis[1].gains [0.5,0.0]", "m[0] [0,0,0]", "m[1] [0,0,2]", "moves[0].jog.acc 0.0",
                "moves[0].jog.dec 0.0", "moves[0].jog.smooth 0.0", "moves[1].jog.acc 0.0",
                "moves[1].jog.dec 1.5", "moves[1].jog.smooth 0.0"}));
  const Json local = Result("variables", {{"page", 0}})[0];
  EXPECT_EQ(local["name"], "old.gains");
  EXPECT_EQ(local["path"], "page0.old.gains");
  EXPECT_EQ(Result("evaluate", {{"text", "axis[1].target"}})["value"], 2);
  EXPECT_EQ(Result("evaluate", {{"text", "axis_target[1]"}})["value"], 2);
  EXPECT_EQ(Result("evaluate", {{"text", "axis[1].gains"}})["value"], Json({0.5, 0.0}));
  EXPECT_EQ(Result("evaluate", {{"text", "moves[1].jog.dec"}})["value"], 1.5);
  EXPECT_EQ(Result("evaluate", {{"text", "m[1][2] == 2 && axis[1].target == 2"}})["holds"], true);
}

TEST_F(HostTest, AProgramWithErrorsIsNotLoaded) {
  Load(kRace);
  const Json result =
      Result("load", {{"main", "p.c"}, {"files", {{"p.c", "int f() { x = 1; }\n"}}}});
  EXPECT_FALSE(result["compiled"]);
  EXPECT_EQ(result["diagnostics"][0]["code"], "MP027");
  EXPECT_EQ(result["diagnostics"][0]["line"], 1);
  EXPECT_FALSE(result.contains("state"));
  // The session that was there goes on.
  EXPECT_EQ(Result("state")["threads"][0]["function"], "f");
}

TEST_F(HostTest, SaysWhichFileIsMissingOrWrong) {
  EXPECT_THAT(ErrorOf("load", {{"main", "p.c"}}), HasSubstr("there is no file 'p.c'"));
  EXPECT_THAT(ErrorOf("load", {{"main", "s.toml"}, {"files", {{"s.toml", "program = \"q.c\"\n"}}}}),
              HasSubstr("there is no file 'q.c'"));
  EXPECT_THAT(ErrorOf("load", {{"main", "s.toml"}, {"files", {{"s.toml", "progam = \"q.c\"\n"}}}}),
              HasSubstr("s.toml:1:1: unknown key 'progam'"));
  EXPECT_THAT(ErrorOf("load", {{"main", "r.schedule"}, {"files", {{"r.schedule", "x"}}}}),
              StartsWith("r.schedule: "));
  EXPECT_THAT(
      ErrorOf("load", {{"main", "s.toml"},
                       {"files",
                        {{"p.c", kRace}, {"s.toml", "program = \"p.c\"\nexpect = [\"y == 1\"]"}}}}),
      HasSubstr("s.toml:2:11: nothing is named 'y'"));
}

TEST_F(HostTest, ListsFilesThatAreMissing) {
  const auto missing = [this](const std::string& main, const Json& files) {
    return Ask("check", {{"main", main}, {"files", files}}).value("missing", Json());
  };
  EXPECT_EQ(missing("p.c", Json::object()), Json({"p.c"}));
  EXPECT_EQ(missing("a/s.toml", {{"a/s.toml", "program = \"../p.c\"\n"}}), Json({"p.c"}));
  const std::string including = "#include \"h.h\"\n#include \"h.h\"\nint f() {\n}\n";
  const std::string scenario = "program = \"p.c\"\ninclude = [\"sub\"]\n";
  EXPECT_EQ(missing("s.toml", {{"s.toml", scenario}, {"p.c", including}}),
            Json({"h.h", "sub/h.h"}));
  EXPECT_EQ(missing("p.c", {{"p.c", kRace}}), Json());
  // The next request does not repeat them.
  EXPECT_FALSE(Ask("hello").contains("missing"));
}

TEST_F(HostTest, ReadsFilesIfItHasAReader) {
  SessionHost host([](const std::string& path) -> oncard::Result<std::string> {
    if (path == "p.c") return std::string(kRace);
    return MakeError(1, "no {0}", "没有 {0}", path);
  });
  const std::string load = R"({"id":1,"request":"load","arguments":{"main":"p.c"}})";
  EXPECT_TRUE(Json::parse(host.Handle(load))["result"]["compiled"]);
}

TEST_F(HostTest, ChecksAndRunsWithoutASession) {
  const Json files = {{"p.c", kRace}};
  EXPECT_TRUE(Result("check", {{"main", "p.c"}, {"files", files}})["compiled"]);
  const Json result = Result("run", {{"main", "p.c"}, {"files", files}, {"show", {"x"}}});
  EXPECT_TRUE(result["run"]["passed"]);
  EXPECT_EQ(result["run"]["values"]["x"], 1);
  EXPECT_THAT(ErrorOf("state"), HasSubstr("'load' one first"));
}

// --- Looks ---------------------------------------------------------------------------------------

TEST_F(HostTest, ShowsTheState) {
  Load(kAxis, "[[thread]]\nthread = 2\nfunction = \"f\"\ninit = { k = 4 }\n");
  Result("set_stops", {{"refusals", false}});
  Result("forward", {{"goal", "cycle"}});
  const Json state = Result("state");
  EXPECT_EQ(state["time_ms"], 0.25);
  EXPECT_EQ(state["statements"], 5);
  EXPECT_EQ(state["next"], "cycle");
  EXPECT_FALSE(state.contains("next_thread"));
  const Json thread = state["threads"][0];
  EXPECT_EQ(thread["thread"], 2);
  EXPECT_EQ(thread["line"], 10);
  EXPECT_EQ(thread["state"], "running");
  EXPECT_FALSE(thread["ready"]);
  EXPECT_EQ(thread["waits"]["until_ms"], 100.25);
  EXPECT_EQ(thread["status"], "running at p.c:11");
}

TEST_F(HostTest, ShowsWhyACommandWasRefused) {
  Load(kAxis);
  const Json stopped = Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(stopped["stop"]["reason"], "refusal");
  EXPECT_THAT(stopped["stop"]["text"].get<std::string>(), HasSubstr("GT_AxisOn(9) = 7"));
  const Json thread = stopped["state"]["threads"][0];
  EXPECT_EQ(thread["error"], 7);
  EXPECT_EQ(thread["refused"], stopped["stop"]["text"]);
}

TEST_F(HostTest, ShowsWhatTheSupervisorWarnsOf) {
  Load(kUnpowered);
  EXPECT_EQ(Result("state")["warnings"], Json::array());
  Result("set_stops", {{"warnings", true}});
  const Json stop = Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(stop["stop"]["reason"], "warning");
  EXPECT_THAT(stop["stop"]["text"].get<std::string>(), HasSubstr("[drive-off]"));
  EXPECT_EQ(stop["state"]["warnings"],
            Json({{{"name", "drive-off"},
                   {"text", "axis 1 moves while its drive is off, call GT_AxisOn first"},
                   {"time_ms", 0.25},
                   {"thread", 0},
                   {"file", "p.c"},
                   {"line", 6}}}));
  Result("hello", {{"language", "zh"}});
  EXPECT_EQ(Result("state")["warnings"][0]["text"],
            "轴 1 在伺服使能关闭时运动，请先调用 GT_AxisOn");
  Result("set_stops");
  EXPECT_THAT(Result("forward", {{"goal", "stop"}})["state"]["warnings"], SizeIs(2));
}

TEST_F(HostTest, LeavesOutWarningsThatAreSilenced) {
  const Json project = {
      {"main", "p.c"}, {"files", {{"p.c", kUnpowered}}}, {"silent", {"drive-off"}}};
  Result("load", project);
  Result("set_stops", {{"warnings", true}});
  const Json stop = Result("forward", {{"goal", "stop"}});
  EXPECT_THAT(stop["stop"]["text"].get<std::string>(), HasSubstr("[work-left]"));
  ASSERT_THAT(stop["state"]["warnings"], SizeIs(1));
  EXPECT_EQ(stop["state"]["warnings"][0]["name"], "work-left");
  EXPECT_THAT(Result("run", project)["run"]["warnings"], SizeIs(1));
  EXPECT_THAT(ErrorOf("load", {{"main", "p.c"}, {"silent", {"drive-on"}}}),
              AllOf(HasSubstr("'silent' is wrong: a list of drive-off, update-mask, "),
                    HasSubstr("; there is no 'drive-on'")));
}

TEST_F(HostTest, ShowsVariables) {
  Load(kAxis, "[[thread]]\nfunction = \"f\"\npage = 5\ninit = { k = 4 }\n");
  Result("forward", {{"goal", "cycle"}});
  const Json globals = Result("variables");
  ASSERT_THAT(globals, SizeIs(3));
  EXPECT_EQ(globals[1]["name"], "d");
  EXPECT_EQ(globals[1]["type"], "double");
  EXPECT_EQ(globals[1]["value"], 2.5);
  EXPECT_EQ(globals[2]["value"], Json({0, 7, 0}));
  const Json locals = Result("variables", {{"page", 5}});
  EXPECT_EQ(locals[0]["name"], "k");
  EXPECT_EQ(locals[0]["path"], "page5.k");
  EXPECT_EQ(locals[0]["value"], 4);
  EXPECT_THAT(Result("variables", {{"page", 6}}), SizeIs(0));
  EXPECT_EQ(Result("slots", {{"page", 5}})[0], 4);
  EXPECT_THAT(Result("slots", {{"page", 5}}), SizeIs(1024));
}

TEST_F(HostTest, ShowsTheCard) {
  Load(kMove, "until_ms = 100\n");
  Result("forward", {{"goal", "stop"}});
  const Json card = Result("card");
  EXPECT_EQ(card["parts"][0]["part"], "axis");
  EXPECT_EQ(card["parts"][0]["number"], 1);
  const Json value = card["parts"][0]["values"][0];
  EXPECT_EQ(value["path"], "axis1." + value["name"].get<std::string>());
  const auto named = [](const Json& each) { return each["name"].get<std::string>(); };
  const auto moving = std::ranges::find(card["parts"][0]["values"], "moving", named);
  ASSERT_NE(moving, card["parts"][0]["values"].end());
  EXPECT_EQ((*moving)["flag"], true);
  EXPECT_FALSE(value.contains("flag"));
  const auto gpi = std::ranges::find(card["words"], "gpi", named);
  ASSERT_NE(gpi, card["words"].end());
  EXPECT_EQ((*gpi)["kind"], "input");
  EXPECT_EQ((*gpi)["pins"], 16);
  const auto enable = std::ranges::find(card["words"], "enable", named);
  ASSERT_NE(enable, card["words"].end());
  EXPECT_EQ((*enable)["kind"], "output");
  EXPECT_EQ((*enable)["pins"], 8);
}

TEST_F(HostTest, EvaluatesNamesAndConditions) {
  Load(kAxis);
  Result("forward", {{"goal", "cycle"}});
  EXPECT_EQ(Result("evaluate", {{"text", "a[1]"}})["value"], 7);
  EXPECT_EQ(Result("evaluate", {{"text", "a"}})["value"], Json({0, 7, 0}));
  EXPECT_EQ(Result("evaluate", {{"text", "a[1] > 5 && d == 2.5"}})["holds"], true);
  EXPECT_THAT(ErrorOf("evaluate", {{"text", "b"}}), HasSubstr("nothing is named 'b'"));
  EXPECT_THAT(ErrorOf("evaluate", {{"text", "a[1] >"}}), HasSubstr("a[1] >"));
}

TEST_F(HostTest, ListsTheStatements) {
  Load(kRace);
  const Json listing = Result("listing");
  EXPECT_EQ(listing[0]["name"], "f");
  EXPECT_EQ(listing[0]["statements"][1]["line"], 6);
  EXPECT_EQ(listing[0]["statements"][1]["text"], "a := a + 1");
  const auto record =
      vm::DecodeRecord(listing[0]["statements"][1]["words"].get<std::vector<uint16_t>>());
  ASSERT_TRUE(record.ok());
  EXPECT_EQ(record.value().instruction.opcode, vm::Opcode::kBinary);
}

TEST_F(HostTest, ShowsValuesOverTimeAndTurns) {
  Load(kRace, kTwoThreads);
  Result("forward", {{"goal", "stop"}});
  const Json trace =
      Result("trace", {{"names", {"x"}}, {"from_ms", 0}, {"to_ms", 1}, {"points", 2}});
  EXPECT_EQ(trace[0]["name"], "x");
  EXPECT_EQ(trace[0]["largest"].back(), 1);
  const Json turns = Result("turns", {{"from", 0}, {"to", 100}});
  ASSERT_THAT(turns, SizeIs(6));
  EXPECT_EQ(turns[1]["thread"], 1);
  EXPECT_EQ(turns[1]["moment"], 2);
  const Json written = Result("written");
  ASSERT_THAT(written, SizeIs(6));
  EXPECT_EQ(written[5]["thread"], 1);
  EXPECT_EQ(written[5]["line"], 7);
  EXPECT_EQ(written[5]["values"], Json::array({{{"name", "x"}, {"value", 1}}}));
  EXPECT_THAT(Result("written", {{"statements", 1}}), SizeIs(1));
  EXPECT_THAT(ErrorOf("trace", {{"names", {"x"}}, {"from_ms", 2}, {"to_ms", 1}, {"points", 2}}),
              HasSubstr("must not be later than 'to_ms'"));
}

TEST_F(HostTest, ShowsWaitsAndFaultsOverTime) {
  Load(
      "int go;\nint a[3];\nint i;\n"
      "int f()\n{\n  GT_WaitForVarEq(&go, 1);\n  i = 7;\n  a[i] = 1;\n}\n"
      "int g()\n{\n  GT_Delay(2);\n  go = 1;\n}\n",
      "cycle_us = 1000\n"
      "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"g\"\n");
  Result("set_stops", {{"faults", false}});
  Result("forward", {{"goal", "stop"}});
  const Json spans = Result("spans");
  ASSERT_THAT(spans, SizeIs(8));
  EXPECT_EQ(spans[2], Json({{"thread", 0},
                            {"state", "running"},
                            {"line", 6},
                            {"from", 2},
                            {"to", 6},
                            {"from_ms", 1.0},
                            {"to_ms", 3.0},
                            {"waits", {{"name", "go"}, {"value", 1.0}}}}));
  EXPECT_EQ(spans[3]["waits"], Json({{"until_ms", 3.0}}));
  EXPECT_EQ(spans[7]["state"], "faulted");
  EXPECT_EQ(spans[7]["text"], "index 7 is out of bounds: the array has elements 0 to 2");
  EXPECT_THAT(Result("spans", {{"from", 4}, {"to", 4}}), SizeIs(2));
  EXPECT_THAT(Result("spans", {{"most", 3}}), SizeIs(3));
}

// --- Walks ---------------------------------------------------------------------------------------

TEST_F(HostTest, WalksForwardAndBack) {
  Load(kRace, kTwoThreads);
  EXPECT_EQ(Result("forward", {{"goal", "step"}})["state"]["moment"], 1);
  EXPECT_EQ(Result("step_thread", {{"thread", 1}})["stop"]["thread"], 1);
  EXPECT_EQ(Result("forward", {{"goal", "statement"}, {"thread", 0}})["stop"]["reason"], "goal");
  const Json end = Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(end["stop"]["reason"], "end");
  EXPECT_EQ(end["state"]["over"], "quiet");
  Result("back", {{"goal", "change"}, {"name", "x"}});
  // Both threads wrote 1.
  EXPECT_EQ(Result("evaluate", {{"text", "x"}})["value"], 0);
  EXPECT_EQ(Result("go_to", {{"moment", 0}})["moment"], 0);
  EXPECT_THAT(ErrorOf("go_to", {{"moment", 99}}), HasSubstr("has reached moment 7, not 99"));
  EXPECT_THAT(ErrorOf("forward", {{"goal", "time"}, {"ms", -1}}), HasSubstr("'ms'"));
}

TEST_F(HostTest, StopsAndLogs) {
  Load(kRace, kTwoThreads);
  const Json set =
      Result("set_stops",
             {{"lines", {{{"line", 7}, {"log", "a is {page0.a}"}}, {{"line", 6}, {"thread", 1}}}}});
  EXPECT_EQ(set["lines"], Json({7, 6}));
  const Json first = Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(first["stop"]["reason"], "line");
  EXPECT_EQ(first["stop"]["number"], 1);
  Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(events_,
            "{\"event\":\"log\",\"moment\":4,\"thread\":0,\"text\":\"a is 1\"}\n"
            "{\"event\":\"log\",\"moment\":5,\"thread\":1,\"text\":\"a is 1\"}\n");
  EXPECT_THAT(ErrorOf("set_stops", {{"conditions", {"y > 1"}}}), HasSubstr("nothing is named 'y'"));
}

TEST_F(HostTest, StopsAtStatements) {
  Load(kRace, kTwoThreads);
  // Each line has one statement. Without a position it is the first one.
  const Json set = Result("set_stops", {{"lines",
                                         {{{"function", "f"}, {"position", 2}, {"thread", 1}},
                                          {{"function", "f"}, {"thread", 0}}}}});
  EXPECT_EQ(set["lines"], Json({7, 5}));
  EXPECT_EQ(Result("forward", {{"goal", "stop"}})["stop"],
            Json({{"reason", "line"}, {"thread", 0}, {"number", 1}}));
  const Json second = Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(second["stop"], Json({{"reason", "line"}, {"thread", 1}, {"number", 0}}));
  EXPECT_EQ(second["state"]["threads"][1]["position"], 2);
  EXPECT_THAT(ErrorOf("set_stops", {{"lines", {{{"function", "f"}, {"line", 5}}}}}),
              HasSubstr("'lines[0].line' is not an argument"));
  EXPECT_EQ(ErrorOf("set_stops", {{"lines", {{{"function", "f"}, {"position", 3}}}}}),
            "f has no statement at position 3: it has 3 statements, from 0 on");
}

// --- Changes -------------------------------------------------------------------------------------

TEST_F(HostTest, ChangesVariablesAndInputs) {
  Load(kMove, "until_ms = 20\n");
  Result("forward", {{"goal", "cycle"}});
  Result("write", {{"name", "n"}, {"value", 500}});
  Result("set_input", {{"type", "gpi"}, {"index", 2}, {"level", 1}});
  Result("set_voltage", {{"channel", 1}, {"volts", 2.5}});
  EXPECT_EQ(Result("evaluate", {{"text", "n"}})["value"], 500);
  Result("forward", {{"goal", "stop"}});
  EXPECT_EQ(Result("evaluate", {{"text", "gpi[2]"}})["value"], 1);
  EXPECT_EQ(Result("go_to", {{"ms", 1.1}})["time_ms"], 1.25);
  Result("forward", {{"goal", "stop"}});
  const Json recorded = Result("record");
  EXPECT_THAT(recorded["schedule"].get<std::string>(), HasSubstr("[[host]]"));
  EXPECT_THAT(recorded["scenario"].get<std::string>(), HasSubstr("[[world.input]]"));
  EXPECT_THAT(ErrorOf("set_input", {{"type", "gpo"}, {"index", 2}, {"level", 1}}),
              HasSubstr("no type of input"));
  EXPECT_THAT(ErrorOf("write", {{"name", "n"}, {"value", 1e12}}), HasSubstr("does not fit"));
}

TEST_F(HostTest, EvaluatesNamesAsAThreadMeansThem) {
  Load(
      "int k;\nint f()\n{\n  int i;\n  int b[3];\n  i = 7;\n  b[2] = 5;\n}\nint g()\n{\n  k = "
      "1;\n}\n",
      "[[thread]]\nthread = 3\npage = 9\nfunction = \"f\"\n"
      "[[thread]]\nthread = 4\nfunction = \"g\"\n");
  Result("forward", {{"goal", "stop"}});
  const auto in_f = [this](const char* text) {
    return Result("evaluate", {{"text", text}, {"thread", 3}});
  };
  EXPECT_EQ(in_f("i"), Json::parse(R"({"value":7,"path":"page9.i"})"));
  EXPECT_EQ(in_f("k"), Json::parse(R"({"value":1,"path":"k"})"));
  EXPECT_EQ(in_f("b[2]"), Json::parse(R"({"value":5,"path":"page9.b[2]"})"));
  EXPECT_EQ(in_f("b")["value"], Json({0, 0, 5}));
  EXPECT_EQ(in_f("i + b[2] == 12 && k == 1 && thread4.run == 0")["holds"], true);
  EXPECT_THAT(ErrorOf("evaluate", {{"text", "b[2] == 5"}, {"thread", 4}}), HasSubstr("'b"));
  EXPECT_THAT(ErrorOf("evaluate", {{"text", "i"}}), HasSubstr("nothing is named 'i'"));
  EXPECT_THAT(ErrorOf("evaluate", {{"text", "k"}, {"thread", 32}}), HasSubstr("thread"));
}

TEST_F(HostTest, RecordsForAFileInAnotherFolder) {
  Load(kMove, "until_ms = 1\n");
  Result("forward", {{"goal", "stop"}});
  const Json beside = Result("record");
  EXPECT_THAT(beside["scenario"].get<std::string>(), HasSubstr("program = \"p.c\"\n"));
  const Json apart = Result("record", {{"path", "runs/today/a.schedule"}});
  EXPECT_THAT(apart["scenario"].get<std::string>(), HasSubstr("program = \"../../p.c\"\n"));
  EXPECT_THAT(apart["schedule"].get<std::string>(), HasSubstr("| program = \"../../p.c\"\n"));
}

TEST_F(HostTest, MovesSwitches) {
  Load(kMove, "until_ms = 20\n[[world.switch]]\naxis = 2\nfrom = 50\nactive_low = true\n");
  EXPECT_EQ(Result("card")["switches"],
            Json::parse(R"([{"axis":2,"type":"home","index":2,"from":50.0,"active_low":true,)"
                        R"("connected":true}])"));
  Result("move_switch", {{"switch", 1}, {"from", -10}, {"to", 10.5}});
  Result("forward", {{"goal", "cycle"}});
  Result("forward", {{"goal", "cycle"}});
  const Json moved = Result("card")["switches"][0];
  EXPECT_EQ(moved["from"], -10);
  EXPECT_EQ(moved["to"], 10.5);
  EXPECT_THAT(Result("record")["scenario"].get<std::string>(), HasSubstr("[[world.move]]"));
  EXPECT_THAT(ErrorOf("move_switch", {{"switch", 1}}), HasSubstr("'from' or 'to' is missing"));
  EXPECT_THAT(ErrorOf("move_switch", {{"switch", 2}, {"to", 0}}), HasSubstr("no switch 2"));
}

TEST_F(HostTest, SaysHowTheMachineLooks) {
  const std::string scenario =
      "[view]\ntitle = \"Plotter\"\ntitle_zh = \"绘图仪\"\nkind = \"xy\"\nz = 3\n"
      "[[view.pin]]\ntype = \"gpo\"\nindex = 2\nname = \"Pen\"\n";
  Load(kMove, scenario);
  EXPECT_EQ(Result("card")["view"],
            Json::parse(R"({"title":"Plotter","kind":"xy","x":1,"y":2,"z":3,"turn":10000.0,)"
                        R"("pins":[{"type":"gpo","index":2,"name":"Pen"}]})"));
  Result("hello", {{"protocol", 1}, {"language", "zh"}});
  Load(kMove, scenario);
  const Json view = Result("card")["view"];
  EXPECT_EQ(view["title"], "绘图仪");
  EXPECT_EQ(view["pins"][0]["name"], "Pen");
}

TEST_F(HostTest, TakesTheFirstCaseOfChoicesAndSaysIt) {
  const Json arguments = {
      {"main", "s.toml"},
      {"files",
       {{"p.c", kAxis},
        {"s.toml",
         "program = \"p.c\"\n[[thread]]\nfunction = \"f\"\ninit = { k = { any = [2, 5] } }\n"}}}};
  const Json loaded = Result("load", arguments);
  EXPECT_EQ(loaded["choice"], "k = 2");
  EXPECT_EQ(Result("evaluate", {{"text", "page0.k"}})["value"], 2);
  EXPECT_THAT(Result("record")["scenario"].get<std::string>(), HasSubstr("\"k\" = 2"));
  EXPECT_EQ(Result("run", arguments)["run"]["choice"], "k = 2");
}

// --- The same requests give the same bytes -------------------------------------------------------

TEST_F(HostTest, AnswersTheSameRequestsWithTheSameBytes) {
  const std::vector<std::string> requests = {
      R"({"id":1,"request":"load","arguments":{"main":"p.c","files":{"p.c":"int x;\nint f()\n{\nl:\n  x = x + 1;\n  goto l;\n}\n"}}})",
      R"({"id":2,"request":"forward","arguments":{"goal":"time","ms":50}})",
      R"({"id":3,"request":"back","arguments":{"goal":"change","name":"x"}})",
      R"({"id":4,"request":"go_to","arguments":{"moment":1234}})",
      R"({"id":5,"request":"trace","arguments":{"names":["x","clock"],"from_ms":0,"to_ms":50,"points":7}})",
      R"({"id":6,"request":"record"})"};
  const auto all = [&] {
    SessionHost host;
    std::string answers;
    for (const std::string& request : requests) answers += host.Handle(request);
    return answers;
  };
  EXPECT_EQ(all(), all());
}

}  // namespace
}  // namespace oncard::session
