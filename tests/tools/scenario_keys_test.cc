// Every key of a scenario with every command that reads the file: the key has an effect, or the
// command refuses it, or there is nothing that it could change.
#include "runtime/scenario/file/scenario_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using runtime::KeyUse;
using runtime::ScenarioUse;

/// The text of a scenario without the key and with it. If a scenario does not name `program` it is
/// `p.c`; `explore` is added where all schedules are required.
struct KeyCase {
  const char* key;
  const char* program;
  const char* without;
  const char* with;
};

constexpr const char* kSpin = "int n;\nint f()\n{\nlbl:\n  n = n + 1;\n  goto lbl;\n}\n";
constexpr const char* kAdd = "int n;\nint f(int k)\n{\n  n = n + k;\n  return n;\n}\n";
constexpr const char* kTwo =
    "int n;\nint f(int k)\n{\n  n = 1;\n  n = 2;\n  return n;\n}\nint g()\n{\n  n = 7;\n  return "
    "n;\n}\n";
constexpr const char* kDelay =
    "int n, t;\nint f()\n{\n  GT_Delay(10);\n  n = n + 1;\n  return n;\n}\n";
constexpr const char* kInput =
    "int n;\nint f()\n{\n  GT_Delay(10);\n  GT_GetDi(4, &n);\n  return n;\n}\n";
constexpr const char* kDouble =
    "int n;\nint f()\n{\n  double d;\n  d = 30000;\n  d = d + d;\n"
    "  n = d > 0;\n  return n;\n}\n";
constexpr const char* kInclude = "#include \"v.h\"\nint f()\n{\n  n = 1;\n  return n;\n}\n";
constexpr const char* kNested = "int n;\nint f()\n{\n  n = 1 + 2 * 3;\n  return n;\n}\n";
constexpr const char* kLoop = "int n;\nint f()\n{\nlbl:\n  goto lbl;\n}\n";
constexpr const char* kWait = "int n;\nint f()\n{\n  GT_WaitForVarEq(&n, 1);\n  return n;\n}\n";
constexpr const char* kAxis = "int n;\nint f()\n{\n  GT_AxisOn(10);\n  return n;\n}\n";

const KeyCase kCases[] = {
    {"program", kAdd, "final = [\"n == 0\"]\n", "program = \"other.c\"\nfinal = [\"n == 0\"]\n"},
    {"title", kDelay, "", "title = \"A name\"\n"},
    {"include", kInclude, "", "include = [\"sub\"]\n"},
    {"structured", kNested, "", "structured = true\n"},
    {"double", kDouble, "final = [\"n == 1\"]\n", "final = [\"n == 1\"]\ndouble = \"16.16\"\n"},
    {"schedule", kTwo,
     "final = [\"n == 2\"]\n[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = "
     "\"g\"\n",
     "schedule = \"rr:9\"\nfinal = [\"n == 2\"]\n[[thread]]\nfunction = \"f\"\n[[thread]]\nthread "
     "= 1\nfunction = "
     "\"g\"\n"},
    {"rate", kSpin, "until_ms = 2\nnever = [\"n > 30\"]\n",
     "until_ms = 2\nnever = [\"n > 30\"]\nrate = 20\n"},
    {"card", kAxis, "", "card = \"GTS-1200\"\n"},
    {"axes", kAxis, "", "axes = 12\n"},
    {"cycle_us", kDelay, "expect = [\"clock < 10.5\"]\n",
     "expect = [\"clock < 10.5\"]\ncycle_us = 4000\n"},
    {"limit_ms", kDelay, "", "limit_ms = 5\n"},
    {"until_ms", kDelay, "", "until_ms = 5\n"},
    {"trace", kAdd, "", "trace = [\"nothing\"]\n"},
    {"keys", kAdd, "", "keys = [{ at_ms = 1, text = \"q\" }]\n"},
    {"mram", kAdd, "", "mram = \"m.mram\"\n"},
    {"expect", kAdd, "", "expect = [\"n == 1\"]\n"},
    {"final", kAdd, "", "final = [\"n == 1\"]\n"},
    {"always", kTwo, "", "always = [\"n != 1\"]\n"},
    {"never", kTwo, "", "never = [\"n == 1\"]\n"},
    {"eventually", kTwo, "", "eventually = [\"n == 3\"]\n"},
    {"endless", kLoop, "limit_ms = 2\n", "limit_ms = 2\nendless = true\n"},
    {"livelock", kLoop, "limit_ms = 2\n", "limit_ms = 2\nlivelock = \"any\"\n"},
    {"deadlock", kWait, "", "deadlock = \"any\"\n"},
    {"leads", kTwo, "", "leads = [\"n == 2 -> n == 1\"]\n"},
    {"within", kDelay, "", "within = [{ after = \"n == 0\", then = \"n == 1\", ms = 2 }]\n"},
    {"races", kTwo, "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"g\"\n",
     "races = \"none\"\n[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"g\"\n"},
    {"sync", kTwo, "", "sync = [\"nothing\"]\n"},
    {"explore", kAdd, "", "explore = { verdict = \"FAILED\" }\n"},
    {"globals", kAdd, "final = [\"n == 0\"]\n", "final = [\"n == 0\"]\n[globals]\nn = 3\n"},
    {"thread", kTwo, "final = [\"n == 2\"]\n",
     "final = [\"n == 2\"]\n[[thread]]\nfunction = \"g\"\n"},
    {"world", kInput, "expect = [\"n == 0\"]\n",
     "expect = [\"n == 0\"]\n[[world.input]]\nvalue = 5\nat_ms = 1\n"},
    {"ethercat", kDelay, "final = [\"drive1.state == 0\"]\n",
     "final = [\"drive1.state == 0\"]\n[[ethercat.slave]]\n"},
    {"view", kDelay, "", "[view]\ntitle = \"Drill\"\n"},
    {"host", kDelay, "final = [\"n == 1\"]\n",
     "final = [\"n == 1\"]\n[[host]]\nat_ms = 1\nset = { n = 4 }\n"},
};

class ScenarioKeyTest : public testing::TestWithParam<KeyCase> {
 protected:
  void SetUp() override {
    scratch_.Write("p.c", GetParam().program);
    scratch_.Write("other.c", kDelay);
    scratch_.Write("sub/v.h", "int n;\n");
  }

  /// The output of the command for a scenario; paths are the same in all.
  std::string Say(const std::vector<std::string>& command, const std::string& text) {
    const bool names_program = text.find("program =") != std::string::npos;
    scratch_.Write("s.toml", (names_program ? "" : "program = \"p.c\"\n") + text);
    std::vector<std::string> words = command;
    words.push_back("s.toml");
    const ProcessResult result = RunOncard(words, scratch_.path());
    const std::string said = std::to_string(result.exit_code) + '\n' + result.out + result.err +
                             scratch_.Read("t.gnuplot");
    // A verdict contains the hash of the file, which changes with its text.
    return std::regex_replace(said, std::regex("scenario s\\.toml, [0-9a-f]{16}"), "");
  }

  void Expect(KeyUse use, const std::vector<std::string>& command, const std::string& more) {
    const KeyCase& c = GetParam();
    const std::string without = Say(command, more + c.without);
    const std::string with = Say(command, more + c.with);
    const std::string what = command[0] + ' ' + c.key + "\n" + without + "----\n" + with;
    const bool refused = with.find(std::string("'") + c.key + "'") != std::string::npos ||
                         with.find(std::string("[[") + c.key + "]]") != std::string::npos;
    if (use == KeyUse::kMeansNothing) {
      EXPECT_EQ(with, without) << what;
    } else {
      EXPECT_NE(with, without) << what;
      EXPECT_EQ(use == KeyUse::kRefused, refused && with.find("s.toml:") != std::string::npos)
          << what;
    }
  }

  const runtime::KeyRule& Rule() const {
    return *std::ranges::find(runtime::ScenarioKeyRules(), std::string_view(GetParam().key),
                              &runtime::KeyRule::name);
  }
  ScratchFolder scratch_;
};

TEST_P(ScenarioKeyTest, InOneRun) {
  Expect(Rule().run, {"run", "--format=json", "--trace=t.gnuplot"}, "");
}

TEST_P(ScenarioKeyTest, InATest) {
  const std::string key = GetParam().key;
  KeyUse use = Rule().run;
  if (key == "title") use = KeyUse::kMeansNothing;  // a test draws no picture
  if (key == "explore") use = KeyUse::kUsed;        // it makes the test an exploration
  Expect(use, {"test", "--format=json"}, "");
}

TEST_P(ScenarioKeyTest, InAnExploration) {
  const std::string key = GetParam().key;
  // A single engine, because a verdict names the first one of two, which depends on timing.
  Expect(Rule().explore, {"test", "--format=json"},
         key == "explore" ? "" : "explore = { engine = \"stateful\", verdict = \"PROVED\" }\n");
}

INSTANTIATE_TEST_SUITE_P(Keys, ScenarioKeyTest, testing::ValuesIn(kCases),
                         [](const auto& param) { return std::string(param.param.key); });

TEST(ScenarioKeys, HaveACaseEach) {
  for (const runtime::KeyRule& rule : runtime::ScenarioKeyRules()) {
    EXPECT_TRUE(std::ranges::any_of(kCases, [&](const KeyCase& c) { return c.key == rule.name; }))
        << rule.name;
  }
}

}  // namespace
}  // namespace oncard::tools
