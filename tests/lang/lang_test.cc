// The language by example: every file `<rule>/<case>.c` here is a program whose comments say what
// the compiler, or running it, must yield. Files named bad_* are rejected.
//
//   // expect ok                    nothing is reported (the default; says so where it matters)
//   // expect error MP041           reported on this line; @N: on line N of the file instead
//   // expect warning MP120         the same for a warning
//   // expect: v=3, d[1]=2.5        values of globals after the run: functions t0, t1, ... on the
//                                   threads and pages of their numbers, otherwise the first
//                                   function on thread 0 and page 0
//   // options: double=16.16        options of the compilation: double, max-errors
//
// A program that begins with `//@ structured` is lowered first.
//
// What is reported and what is expected must be the same, code by code and line by line. Included
// files carry their own expectations.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "base/files.h"
#include "compiler/compiler.h"
#include "compiler/dialect.h"
#include "compiler/lowering/lowering.h"
#include "runtime/sim/controller.h"

namespace oncard {
namespace {

constexpr int64_t kCycleLimit = 4000;  // one second of 250 us cycles

std::string Root() { return std::string(ONCARD_SOURCE_DIR) + "/tests/lang"; }

std::vector<std::string> Programs() {
  std::vector<std::string> programs;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(Root())) {
    if (entry.path().extension() == ".c") {
      programs.push_back(std::filesystem::relative(entry.path(), Root()).string());
    }
  }
  std::sort(programs.begin(), programs.end());
  return programs;
}

struct Expectations {
  std::vector<std::string> diagnostics;  // "file:line: error MP041"
  std::vector<std::pair<std::string, double>> values;
  compiler::Options options;
};

std::string Describe(const std::string& path, int line, std::string_view severity,
                     const std::string& code) {
  return fmt::format("{}:{}: {} {}", std::filesystem::path(path).filename().string(), line,
                     severity, code);
}

void ReadExpectations(const std::string& path, const std::string& text, Expectations* out) {
  static const std::regex kDiagnostic("// expect (error|warning) (MP[0-9]{3})(?: @([0-9]+))?");
  static const std::regex kValues("// expect: (.*)");
  static const std::regex kValue(R"(([A-Za-z_][A-Za-z_0-9.\[\]]*)\s*=\s*(-?[0-9.]+))");
  static const std::regex kOption("// options:.*(double|max-errors)=([0-9.]+)");
  const compiler::SourceFile file(path, text);
  for (int number = 1; number <= file.line_count(); ++number) {
    const std::string line(file.Line(number));
    for (std::sregex_iterator i(line.begin(), line.end(), kDiagnostic), end; i != end; ++i) {
      const int at = (*i)[3].matched ? std::stoi((*i)[3].str()) : number;
      out->diagnostics.push_back(Describe(path, at, (*i)[1].str(), (*i)[2].str()));
    }
    std::smatch match;
    if (std::regex_search(line, match, kOption)) {
      if (match[1].str() == "double") {
        out->options.double_format =
            match[2].str() == "16.16" ? vm::DoubleFormat::k16_16 : vm::DoubleFormat::k32_16;
      } else {
        out->options.max_errors = std::stoi(match[2].str());
      }
    }
    if (!std::regex_search(line, match, kValues)) continue;
    const std::string values = match[1].str();
    for (std::sregex_iterator i(values.begin(), values.end(), kValue), end; i != end; ++i) {
      out->values.emplace_back((*i)[1].str(), std::stod((*i)[2].str()));
    }
  }
}

// Runs a program to its end and compares globals.
void CheckValues(const vm::Object& object,
                 const std::vector<std::pair<std::string, double>>& values) {
  runtime::Controller controller;
  const Result<void> loaded = controller.Load(object);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message.en;
  std::vector<std::pair<int, int>> bindings;  // thread, function id
  for (size_t i = 0; i < object.functions.size(); ++i) {
    const std::string& name = object.functions[i].name;
    if (name.size() > 1 && name[0] == 't' &&
        std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; })) {
      bindings.emplace_back(std::stoi(name.substr(1)), static_cast<int>(i) + 1);
    }
  }
  if (bindings.empty()) bindings.emplace_back(0, 1);
  for (const auto& [thread, function] : bindings) {
    ASSERT_EQ(controller.machine().Bind(thread, function, thread), 0);
    ASSERT_EQ(controller.machine().Run(thread), 0);
  }
  ASSERT_EQ(controller.RunUntilQuiet(kCycleLimit), runtime::RunEnd::kQuiet);
  for (const auto& [name, wanted] : values) {
    const size_t bracket = name.find('[');
    const std::string base = name.substr(0, bracket);
    const int index = bracket == std::string::npos ? 0 : std::stoi(name.substr(bracket + 1));
    const auto symbol =
        std::find_if(object.globals.begin(), object.globals.end(),
                     [&base](const vm::Symbol& candidate) { return candidate.name == base; });
    ASSERT_NE(symbol, object.globals.end()) << name;
    vm::SlotAddress slot;
    slot.global = true;
    slot.id = static_cast<uint16_t>(symbol->id + index);
    slot.type = symbol->type;
    EXPECT_EQ(controller.machine().Read(slot), wanted) << name;
  }
}

struct Outcome {
  std::deque<compiler::SourceFile> files;
  std::vector<compiler::Diagnostic> diagnostics;
  bool good = false;
  std::optional<vm::Object> object;
};

Outcome LowerProgram(const std::string& path, const std::string& text,
                     const compiler::Options& options) {
  compiler::Lowering lowering = compiler::LowerText(path, text, options, {}, compiler::ReadSource);
  Outcome outcome;
  outcome.files.assign(lowering.files.begin(), lowering.files.end());
  outcome.diagnostics = std::move(lowering.diagnostics);
  outcome.good = lowering.text.has_value();
  outcome.object = std::move(lowering.object);
  return outcome;
}

Outcome CompileProgram(const std::string& path, const compiler::Options& options) {
  compiler::Compilation compilation = compiler::Compile(path, options);
  Outcome outcome;
  outcome.files.assign(compilation.files.begin(), compilation.files.end());
  outcome.diagnostics = std::move(compilation.diagnostics);
  outcome.good = compilation.ok();
  outcome.object = std::move(compilation.object);
  return outcome;
}

class LangTest : public testing::TestWithParam<std::string> {};

TEST_P(LangTest, MeetsItsExpectations) {
  const std::string path = Root() + '/' + GetParam();
  Result<std::string> text = ReadFile(path);
  ASSERT_TRUE(text.ok());
  Expectations expected;
  ReadExpectations(path, text.value(), &expected);
  expected.options.include_folders = {Root() + "/include_folder"};
  const Outcome outcome = compiler::WantsStructured(text.value())
                              ? LowerProgram(path, text.value(), expected.options)
                              : CompileProgram(path, expected.options);
  for (size_t i = 1; i < outcome.files.size(); ++i) {
    ReadExpectations(outcome.files[i].path(), outcome.files[i].text(), &expected);
  }

  std::vector<std::string> reported;
  std::string messages;
  for (const compiler::Diagnostic& diagnostic : outcome.diagnostics) {
    const compiler::SourceFile& file = outcome.files[static_cast<size_t>(diagnostic.range.file)];
    const bool error = diagnostic.severity == compiler::Severity::kError;
    reported.push_back(Describe(file.path(), file.LineOf(diagnostic.range.begin),
                                error ? "error" : "warning",
                                compiler::DiagnosticName(diagnostic.info->code)));
    messages += reported.back() + ": " + diagnostic.message.en + '\n';
  }
  std::sort(reported.begin(), reported.end());
  std::sort(expected.diagnostics.begin(), expected.diagnostics.end());
  EXPECT_EQ(reported, expected.diagnostics) << messages;
  const bool bad = std::filesystem::path(path).filename().string().starts_with("bad_");
  EXPECT_EQ(outcome.good, !bad) << "the name says whether the program is good";
  if (outcome.object && !expected.values.empty()) {
    CheckValues(*outcome.object, expected.values);
  }
}

std::string TestName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Programs, LangTest, testing::ValuesIn(Programs()), TestName);

}  // namespace
}  // namespace oncard
