// Sessions of the record of a host: its calls forward and back, across the programs that it
// downloads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "session/host.h"
#include "session/recorded_host.h"
#include "tests/runtime/recording_host.h"
#include "tests/session/asking_test.h"

namespace oncard::session {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

constexpr const char* kFirst = "int a;\nint f()\n{\n  a = 1;\n  a = 2;\n}\n";
constexpr const char* kSecond = "int b;\nint g()\n{\n  b = 10;\n  b = 20;\n  b = 30;\n}\n";

/// Both programs, one after the other.
std::string TwoPrograms() {
  runtime::RecordingHost host;
  host.Download("first", kFirst);
  host.Start();
  host.Wait(1000);
  host.Download("second", kSecond);
  host.Start();
  host.Wait(1000);
  host.Close();
  return host.text();
}

class HostCallsTest : public AskingTest {
 protected:
  HostCallsTest() : AskingTest(SessionHost({}, {}, OpenRecordedHost)) {}

  Json Load(const std::string& record) {
    return Result("load", {{"main", "h.calls"}, {"files", {{"h.calls", record}}}});
  }
  Json Forward(const std::string& goal) { return Result("forward", {{"goal", goal}}); }
  Json Back(const std::string& goal) { return Result("back", {{"goal", goal}}); }
  /// The names of the global variables.
  std::vector<std::string> Globals() {
    std::vector<std::string> names;
    for (const Json& variable : Result("variables")) names.push_back(variable["name"]);
    return names;
  }
};

// --- Calls ---------------------------------------------------------------------------------------

TEST_F(HostCallsTest, BeginsWithoutAProgram) {
  const Json loaded = Load(TwoPrograms());
  EXPECT_EQ(loaded["state"]["threads"], Json::array());
  EXPECT_EQ(loaded["state"]["host"]["next"], "GT_Download(\"first.bin\")");
  EXPECT_EQ(loaded["files"][0]["path"], "/programs/first.c");
  EXPECT_EQ(loaded["files"][1]["text"], kSecond);
  EXPECT_EQ(loaded["cards"], Json::parse(R"([{"card": 0, "opening": 1, "calls": 6}])"));
  EXPECT_EQ(Result("listing"), Json::array());
  EXPECT_THAT(Globals(), ElementsAre());
}

TEST_F(HostCallsTest, AreStepsThatSayWhatTheyDid) {
  Load(TwoPrograms());
  Forward("call");
  const Json second = Forward("call");
  EXPECT_EQ(second["stop"]["reason"], "goal");
  EXPECT_EQ(second["stop"]["text"], "GT_Bind(0, 1, 0) = 0");
  EXPECT_EQ(second["state"]["host"]["last"], "GT_Bind(0, 1, 0) = 0");
  EXPECT_EQ(second["state"]["host"]["next"], "GT_RunThread(0)");
  EXPECT_EQ(second["state"]["host"]["made"], 2);
  EXPECT_EQ(Back("call")["state"]["host"]["next"], "GT_Bind(0, 1, 0)");
}

TEST_F(HostCallsTest, EndWhereTheHostEnded) {
  Load(TwoPrograms());
  const Json end = Forward("stop");
  EXPECT_EQ(end["stop"], Json::parse(R"({"reason": "end", "failed": []})"));
  EXPECT_EQ(end["state"]["over"], "host-end");
  EXPECT_EQ(end["state"]["host"]["last"], "GT_Close() = 0");
  EXPECT_EQ(Result("evaluate", {{"text", "b"}})["value"], 30);
}

TEST_F(HostCallsTest, AreWhatTheSupervisorWarnsOf) {
  runtime::RecordingHost host;
  host.Call("GT_PrfJog", {1});
  host.Call("GT_SetVel", {1, 10});
  host.Call("GT_Update", {1});
  host.Wait(1000);
  host.Close();
  Load(host.text());
  const Json warnings = Forward("stop")["state"]["warnings"];
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0]["name"], "drive-off");
  EXPECT_EQ(warnings[0]["call"], "GT_Update(0x1)");
  EXPECT_FALSE(warnings[0].contains("thread"));
  EXPECT_FALSE(warnings[0].contains("line"));
  EXPECT_EQ(warnings[1]["name"], "work-left");
}

/// How many parts of a kind the view of a card has.
size_t CountParts(const Json& card, std::string_view kind) {
  return static_cast<size_t>(
      std::ranges::count_if(card["parts"], [&](const Json& part) { return part["part"] == kind; }));
}

// 10 pulse/ms are reached after 10 ms, and kept.
TEST_F(HostCallsTest, ShowACardForPointToPointMotion) {
  runtime::RecordingHost host("GE-400-PG");
  host.Call("GT_AxisOn", {2});
  host.Call("GT_PrflV", {2});
  host.Call("GT_SetVel", {2, 10});
  host.Call("GT_SetAcc", {2, 1});
  host.Call("GT_Update", {2});
  host.Call("GT_ExOpt", {0xFFFE});
  host.Wait(50000);
  host.Close();
  Load(host.text());
  EXPECT_EQ(Forward("stop")["state"]["over"], "host-end");
  const Json card = Result("card");
  EXPECT_EQ(CountParts(card, "axis"), 4u);
  EXPECT_EQ(Result("evaluate", {{"text", "axis2.prfVel"}})["value"], 10);
  EXPECT_EQ(Result("evaluate", {{"text", "axis1.prfVel"}})["value"], 0);
  EXPECT_EQ(Result("evaluate", {{"text", "gpo"}})["value"], 0xFFFE);
}

// 2 pulse/ST are reached after 200 sample times of 0.2 ms, and kept. The request of a time
// interrupt, which nobody answers, is part of the state that is compared.
TEST_F(HostCallsTest, ShowACardThatCountsSampleTimes) {
  runtime::RecordingHost host("GT-400-SG");
  host.Call("GT_Axis", {2});
  host.Call("GT_AxisOn", {});
  host.Call("GT_PrflV", {});
  host.Call("GT_SetVel", {2});
  host.Call("GT_SetAcc", {0.01});
  host.Call("GT_Update", {});
  host.Call("GT_SetIntrTm", {100});
  host.Call("GT_TmrIntr", {});
  host.Wait(50000);
  host.Close();
  Load(host.text());
  EXPECT_EQ(Forward("stop")["state"]["over"], "host-end");
  EXPECT_EQ(CountParts(Result("card"), "axis"), 4u);
  EXPECT_EQ(Result("evaluate", {{"text", "axis2.prfVel"}})["value"], 2);
  EXPECT_EQ(Result("evaluate", {{"text", "axis1.prfVel"}})["value"], 0);
}

// The line of 500 pulses has not come to its end after 30 ms at 10 pulse/ms.
TEST_F(HostCallsTest, ShowAPathCard) {
  runtime::RecordingHost host("GE-300-SG");
  host.Call("GT_AxisOn", {1});
  host.Call("GT_AxisOn", {2});
  host.Call("GT_SetSynVel", {10});
  host.Call("GT_SetSynAcc", {1});
  host.Call("GT_LnXY", {300, 400});
  host.Wait(30000);
  host.Close();
  Load(host.text());
  EXPECT_EQ(Forward("stop")["state"]["over"], "host-end");
  EXPECT_EQ(CountParts(Result("card"), "axis"), 3u);
  EXPECT_EQ(Result("evaluate", {{"text", "crd1.run"}})["value"], 1);
  EXPECT_EQ(Result("evaluate", {{"text", "crd1.vel"}})["value"], 10);
  EXPECT_NEAR(Result("evaluate", {{"text", "axis2.prfVel"}})["value"], 8, 1e-9);
}

// The path of a card of three axes: from where it is in the first line to the end of the second.
TEST_F(HostCallsTest, ShowThePathAhead) {
  runtime::RecordingHost host("GE-300-SG");
  host.Call("GT_AxisOn", {1});
  host.Call("GT_AxisOn", {2});
  host.Call("GT_StrtList", {});
  host.Call("GT_MvXY", {0, 0, 10, 1});
  host.Call("GT_LnXY", {300, 400});
  host.Call("GT_LnXY", {300, 0});
  host.Call("GT_EndList", {});
  host.Call("GT_StrtMtn", {});
  host.Wait(30000);
  host.Close();
  Load(host.text());
  Forward("stop");
  const Json paths = Result("card")["paths"];
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0]["crd"], 1);
  EXPECT_EQ(paths[0]["axes"], Json({1, 2, 3}));
  EXPECT_EQ(paths[0]["whole"], true);
  const Json points = paths[0]["points"];
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0][0], Result("evaluate", {{"text", "axis1.prfPos"}})["value"]);
  EXPECT_NEAR(points[0][1].get<double>() * 3, points[0][0].get<double>() * 4, 1e-9);
  EXPECT_EQ(points[1], Json({300, 400, 0}));
  EXPECT_EQ(points[2], Json({300, 0, 0}));
}

// --- Back ----------------------------------------------------------------------------------------

TEST_F(HostCallsTest, GoingBackBringsTheProgramBack) {
  Load(TwoPrograms());
  Forward("stop");
  EXPECT_THAT(Globals(), ElementsAre("b"));
  for (int call = 0; call < 4; ++call) Back("call");  // the end, two of the second program, it
  EXPECT_THAT(Globals(), ElementsAre("a"));
  EXPECT_EQ(Result("evaluate", {{"text", "a"}})["value"], 2);
  Result("go_to", {{"moment", 0}});
  EXPECT_THAT(Globals(), ElementsAre());
}

TEST_F(HostCallsTest, EveryMomentIsReachedAgainExactly) {
  Load(TwoPrograms());
  std::vector<std::string> hashes = {Result("state")["hash"]};
  while (!Result("state").contains("over")) hashes.push_back(Forward("step")["state"]["hash"]);
  // In an order in which no moment follows the one before it.
  for (size_t i = 0; i < hashes.size(); ++i) {
    const size_t moment = i * 7 % hashes.size();
    EXPECT_EQ(Result("go_to", {{"moment", moment}})["hash"], hashes[moment]) << moment;
  }
}

// --- Stops ---------------------------------------------------------------------------------------

TEST_F(HostCallsTest, ALineOfALaterProgramStops) {
  Load(TwoPrograms());
  const Json set = Result("set_stops", {{"lines", {{{"line", 6}, {"condition", "b == 20"}}}}});
  EXPECT_EQ(set["lines"], Json::parse("[6]"));
  const Json stop = Forward("stop");
  EXPECT_EQ(stop["stop"]["reason"], "line");
  EXPECT_EQ(stop["state"]["threads"][0]["function"], "g");
}

TEST_F(HostCallsTest, ThreadsThatACallStartsArriveAtTheirFirstLine) {
  Load(TwoPrograms());
  Result("set_stops", {{"lines", {{{"line", 4}}}}});
  for (const std::string function : {"f", "g"}) {
    const Json stop = Forward("stop");
    EXPECT_EQ(stop["stop"]["reason"], "line");
    EXPECT_EQ(stop["state"]["host"]["last"], "GT_RunThread(0) = 0");
    EXPECT_EQ(stop["state"]["threads"][0]["function"], function);
  }
}

TEST_F(HostCallsTest, ValuesOfALaterProgramStop) {
  Load(TwoPrograms());
  Result("set_stops", {{"changes", {"b"}}, {"conditions", {"a == 2"}}});
  EXPECT_EQ(Forward("stop")["stop"]["text"], "a == 2 has become true");
  EXPECT_EQ(Forward("stop")["stop"]["text"], "b has changed from 0 to 10");
}

TEST_F(HostCallsTest, ANameOfNoProgramIsRefused) {
  Load(TwoPrograms());
  EXPECT_NE(ErrorOf("set_stops", {{"changes", {"c"}}}), "");
  EXPECT_NE(ErrorOf("set_stops", {{"conditions", {"c > 1"}}}), "");
  EXPECT_NE(ErrorOf("set_stops", {{"lines", {{{"line", 99}}}}}), "");
}

TEST_F(HostCallsTest, ARefusedCallStops) {
  runtime::RecordingHost host;
  host.Call("GT_AxisOn", {9});
  host.Close();
  Load(host.text());
  const Json stop = Forward("stop")["stop"];
  EXPECT_EQ(stop["reason"], "refusal");
  EXPECT_EQ(stop["text"], "GT_AxisOn(9) = 7: parameter axis is 9; this card has 1 to 8");
  Result("go_to", {{"moment", 0}});
  Result("set_stops", {{"refusals", false}});
  EXPECT_EQ(Forward("stop")["stop"]["reason"], "end");
}

// --- Records that do not fit ---------------------------------------------------------------------

/// The text with `to` in place of the first `from`.
std::string Changed(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST_F(HostCallsTest, AnotherAnswerThanTheRecordedOneStops) {
  Load(Changed(TwoPrograms(), "\"in\":[0,1,0],\"code\":0", "\"in\":[0,1,0],\"code\":1"));
  Result("set_stops", {{"faults", false}, {"refusals", false}});
  const Json stop = Forward("stop");
  EXPECT_EQ(stop["stop"]["reason"], "deviation");
  EXPECT_THAT(stop["stop"]["text"], HasSubstr("GT_Bind(0, 1, 0) returns 0 instead of 1"));
  EXPECT_EQ(stop["state"]["host"]["made"], 2);
}

TEST_F(HostCallsTest, AfterAChangeOfTheUserAnswersAreNotCompared) {
  Load(TwoPrograms());
  Forward("call");
  Result("write", {{"name", "a"}, {"value", 5}});
  EXPECT_EQ(Forward("stop")["stop"]["reason"], "end");
}

TEST_F(HostCallsTest, ARecordWithoutAnEndSaysSo) {
  const std::string text = TwoPrograms();
  Load(text.substr(0, text.rfind("{\"close\"")));
  const Json stop = Forward("stop")["stop"];
  EXPECT_EQ(stop["reason"], "end");
  EXPECT_THAT(stop["failed"][0], HasSubstr("the record ends before the host closed the card"));
}

TEST_F(HostCallsTest, ADamagedRecordIsRefused) {
  const std::string text = TwoPrograms();
  const Json arguments = {{"main", "h.calls"},
                          {"files", {{"h.calls", text.substr(0, text.size() - 9) + "\n"}}}};
  EXPECT_THAT(ErrorOf("load", arguments), HasSubstr("h.calls:9: this is no line of a record"));
}

TEST_F(HostCallsTest, ACardThatWasNotOpenedIsRefused) {
  const Json arguments = {
      {"main", "h.calls"}, {"files", {{"h.calls", TwoPrograms()}}}, {"card", 1}};
  EXPECT_EQ(ErrorOf("load", arguments), "the host has not opened card 1");
}

TEST_F(HostCallsTest, AHostWithoutAReaderRefusesRecords) {
  host_ = SessionHost();
  const Json arguments = {{"main", "h.calls"}, {"files", {{"h.calls", TwoPrograms()}}}};
  EXPECT_THAT(ErrorOf("load", arguments), HasSubstr("read by the 'oncard' command only"));
}

TEST_F(HostCallsTest, WhatNeedsAProgramOfItsOwnIsRefused) {
  const Json arguments = {{"main", "h.calls"}, {"files", {{"h.calls", TwoPrograms()}}}};
  EXPECT_THAT(ErrorOf("run", arguments), HasSubstr("only for 'load'"));
  EXPECT_THAT(ErrorOf("outline", arguments), HasSubstr("only for 'load'"));
  Load(TwoPrograms());
  EXPECT_THAT(ErrorOf("record"), HasSubstr("cannot be recorded as a schedule"));
  EXPECT_THAT(ErrorOf("set_stops", {{"races", true}}), HasSubstr("data races are not looked for"));
}

}  // namespace
}  // namespace oncard::session
