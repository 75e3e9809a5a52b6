// The schema of the protocol against the session: it takes the arguments that the schema describes,
// refuses all others, and answers what it says. All other tests of sessions compare answers, too
// (asking_test.h).
#include "session/protocol_schema.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>

#include "base/files.h"
#include "session/editor_requests.h"
#include "session/recorded_host.h"
#include "tests/session/asking_test.h"

namespace oncard::session {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class ProtocolSchemaTest : public AskingTest {
 protected:
  ProtocolSchemaTest() : AskingTest(SessionHost(ReadSample, {}, OpenRecordedHost)) {}

  static oncard::Result<std::string> ReadSample(const std::string& path) {
    return ReadFile(std::string(ONCARD_SOURCE_DIR) + "/samples/" + path);
  }
  static const Json& Part(const std::string& name) { return TheProtocolCheck().Part(name); }
};

/// The objects that a type can be.
std::vector<Json> ObjectsOf(const Json& type) {
  if (type.contains("$ref")) {
    const std::string part = type["$ref"];
    return ObjectsOf(TheProtocolCheck().Part(part.substr(part.rfind('/') + 1)));
  }
  if (!type.contains("anyOf")) return {type};
  return {type["anyOf"].begin(), type["anyOf"].end()};
}

/// Words between blanks, without commas.
std::set<std::string> WordsIn(const std::string& text) {
  std::set<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) {
    if (word.ends_with(',')) word.pop_back();
    words.insert(word);
  }
  return words;
}

bool IsRequired(const Json& object, const std::string& name) {
  return std::ranges::count(object.value("required", Json::array()), Json(name)) == 1;
}

// --- Arguments -----------------------------------------------------------------------------------

TEST_F(ProtocolSchemaTest, HasTheRequestsOfTheSession) {
  std::vector<std::string> in_session;
  for (const RequestText& text : SessionHost::RequestTexts()) {
    in_session.emplace_back(text.name);
    std::set<std::string> in_schema;
    const std::vector<Json> objects =
        ObjectsOf(TheProtocolCheck().Form(std::string(text.name))["arguments"]);
    for (const Json& object : objects) {
      const Json members = object.value("properties", Json::object());
      for (const auto& [name, _] : members.items()) {
        const bool always = std::ranges::all_of(
            objects, [&name = name](const Json& each) { return IsRequired(each, name); });
        in_schema.insert(always ? name : '[' + name + ']');
      }
    }
    EXPECT_EQ(in_schema, WordsIn(std::string(text.arguments))) << text.name;
  }
  std::vector<std::string> in_schema;
  for (const auto& [name, _] : Part("Requests")["properties"].items()) in_schema.push_back(name);
  EXPECT_EQ(in_schema, in_session);
}

/// A value of a type, as far as requests need one to get on to the next argument.
Json ExampleOf(const Json& type) {
  if (type.contains("allOf")) return ExampleOf(type["allOf"][0]);
  if (type.contains("const")) return type["const"];
  if (type.contains("enum")) return type["enum"][0];
  if (type.contains("$ref")) return ExampleOf(ObjectsOf(type)[0]);
  if (type["type"] == "string") return "x";
  if (type["type"] == "boolean") return true;
  if (type["type"] == "array") return Json::array();
  if (type["type"] == "object") return Json::object();
  return 1;
}

/// Gives a request an object with every mistake that it can have; `ask` says what the session
/// answers, which calls a member `prefix` and its name.
void MakeMistakes(const Json& object, const std::string& prefix,
                  const std::function<std::string(const Json&)>& ask) {
  Json all = Json::object();
  const Json members = object.value("properties", Json::object());
  for (const auto& [name, type] : members.items()) all[name] = ExampleOf(type);
  const auto no_mistake = AllOf(Not(HasSubstr("' is wrong")), Not(HasSubstr("' is missing")),
                                Not(HasSubstr("is not an argument")));
  EXPECT_THAT(ask(all), no_mistake) << all;
  for (const auto& [name, _] : members.items()) {
    Json changed = all;
    changed[name] = {{"x", 1}};
    EXPECT_THAT(ask(changed), HasSubstr('\'' + prefix + name + "' is wrong")) << changed;
    changed.erase(name);
    if (IsRequired(object, name)) {
      EXPECT_THAT(ask(changed), HasSubstr("' is missing")) << changed;
    } else {
      EXPECT_THAT(ask(changed), no_mistake) << changed;
    }
  }
  all["unheard"] = 1;
  EXPECT_THAT(ask(all), HasSubstr('\'' + prefix + "unheard' is not an argument")) << all;
}

TEST_F(ProtocolSchemaTest, DescribesTheArgumentsThatTheSessionTakes) {
  for (const auto& [name, _] : Part("Requests")["properties"].items()) {
    for (const Json& object : ObjectsOf(TheProtocolCheck().Form(name)["arguments"])) {
      MakeMistakes(object, "", [this, &name = name](const Json& arguments) {
        return Ask(name, arguments).value("error", "");
      });
    }
  }
  for (const Json& object : ObjectsOf(Part("LineStop"))) {
    MakeMistakes(object, "lines[0].", [this](const Json& line) {
      return ErrorOf("set_stops", {{"lines", Json::array({line})}});
    });
  }
}

TEST_F(ProtocolSchemaTest, HasTheGoalsOfWalks) {
  std::set<std::string> goals;
  for (const char* walk : {"ForwardWalk", "BackWalk"}) {
    for (const Json& object : ObjectsOf(Part(walk))) {
      const Json& goal = object["properties"]["goal"];
      for (const Json& word : goal.value("enum", Json::array({goal.value("const", Json())}))) {
        goals.insert(word);
      }
    }
  }
  const std::string error = ErrorOf("forward", {{"goal", ""}});
  const size_t list = error.find("one of ");
  ASSERT_NE(list, std::string::npos) << error;
  EXPECT_EQ(goals, WordsIn(error.substr(list + std::string_view("one of ").size())));
}

// --- Answers -------------------------------------------------------------------------------------

/// Paths of scenarios, as ReadSample() takes them, in order.
std::vector<std::string> Scenarios() {
  const std::string samples = std::string(ONCARD_SOURCE_DIR) + "/samples/";
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(samples)) {
    if (entry.path().extension() != ".toml") continue;
    paths.push_back(entry.path().string().substr(samples.size()));
  }
  std::ranges::sort(paths);
  return paths;
}

TEST_F(ProtocolSchemaTest, DescribesSessionsOfTheSamples) {
  int loaded = 0;
  for (const std::string& path : Scenarios()) {
    Ask("run", {{"main", path}});
    loaded += Ask("load", {{"main", path}})["ok"] ? 1 : 0;
    Ask("forward", {{"goal", "time"}, {"ms", 20}, {"budget", 5000}});
    Ask("forward", {{"goal", "stop"}, {"budget", 20'000}});
    for (const char* look : {"variables", "card", "spans", "written", "listing", "record"})
      Ask(look);
    Ask("turns", {{"from", 0}, {"to", 1000}});
    Ask("trace", {{"names", {"axis1.prfPos"}}, {"from_ms", 0}, {"to_ms", 10}, {"points", 20}});
    Ask("back", {{"goal", "cycle"}});
  }
  EXPECT_GT(loaded, 20);
}

/// True if a request has an argument with this name.
bool HasArgument(const RequestText& request, const std::string& name) {
  return WordsIn(std::string(request.arguments)).contains(name);
}

TEST_F(ProtocolSchemaTest, DescribesQuestionsAboutTheSamples) {
  for (const std::string& path : Scenarios()) {
    for (const EditorRequest& request : EditorRequests()) {
      if (!HasArgument(request.text, "line")) Ask(std::string(request.text.name), {{"main", path}});
    }
  }
}

TEST_F(ProtocolSchemaTest, DescribesQuestionsAboutPlacesOfAProgram) {
  const std::string program =
      "#define DOUBLE(a) ((a) * 2)\n"
      "int n;  // counts\n"
      "int f(int k)\n"
      "{\n"
      "  TTrapPrm trap;\n"
      "  double d;\n"
      "  long clock;\n"
      "  trap.acc = 0.5;\n"
      "  GT_SetTrapPrm(1, &trap);\n"
      "  GT_GetPrfPos(1, &d, 1, &clock);\n"
      "  GT_Delay(5);\n"
      "  if (n < 7) n = DOUBLE(k);\n"
      "  return n;\n"
      "}\n";
  for (const EditorRequest& request : EditorRequests()) {
    if (!HasArgument(request.text, "line")) continue;
    Json arguments = {{"main", "p.c"}, {"files", {{"p.c", program}}}, {"structured", true}};
    if (HasArgument(request.text, "name")) arguments["name"] = "renamed";
    for (int line = 1; line <= 14; ++line) {
      for (int column = 1; column < 30; column += 2) {
        arguments["line"] = line;
        arguments["column"] = column;
        Ask(std::string(request.text.name), arguments);
      }
    }
  }
}

TEST_F(ProtocolSchemaTest, DescribesMessagesWithTheirNotesAndFixIts) {
  const char* const program = "int f()\n{\n  int count;\n  cuont = 1;\n  return 0;\n}\n";
  const Json checked = Result("check", {{"main", "p.c"}, {"files", {{"p.c", program}}}});
  EXPECT_EQ(checked["diagnostics"][0]["notes"][0]["line"], 3);
  EXPECT_EQ(checked["diagnostics"][0]["fixits"][0]["text"], "count");
}

TEST_F(ProtocolSchemaTest, DescribesPeriodicThreads) {
  const Json files = {
      {"p.c", "int n;\nint f()\n{\n  n = 1;\n}\n"},
      {"s.toml", "program = \"p.c\"\n[[thread]]\nfunction = \"f\"\nperiod_ms = 5\n"}};
  const Json loaded = Result("load", {{"main", "s.toml"}, {"files", files}});
  EXPECT_EQ(loaded["state"]["threads"][0]["next_start_ms"], 5.0);
}

/// After all tests: a member that no answer has had is in the schema for nothing.
class EveryMemberIsUsed : public testing::Environment {
  void TearDown() override {
    if (GTEST_FLAG_GET(filter) != "*") return;  // only some of the tests
    EXPECT_EQ(TheProtocolCheck().UnusedMembers(), std::set<std::string>());
  }
};

const testing::Environment* const kEveryMemberIsUsed =
    testing::AddGlobalTestEnvironment(new EveryMemberIsUsed);

}  // namespace
}  // namespace oncard::session
