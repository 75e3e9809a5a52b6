#include "tools/host_tests.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/files.h"
#include "gtcalls/family.h"
#include "runtime/host/eni_file.h"
#include "runtime/host/host_report.h"
#include "runtime/host/host_scenario.h"
#include "runtime/scenario/run/scenario_card.h"
#include "tools/child_process.h"
#include "tools/host_program.h"
#include "tools/packed_outcome.h"

namespace oncard::tools {
namespace {

namespace fs = std::filesystem;

/// How many lines of a failed host's output are shown.
constexpr int kLinesShown = 20;

std::string FolderOf(const runtime::Scenario& scenario) {
  return fs::path(scenario.path).parent_path().string();
}

std::string EnvironmentOr(const char* name, const char* otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr || *value == '\0' ? otherwise : value;
}

/// $CC or $CXX, which can contain options, or the usual name.
std::vector<std::string> CompilerOf(const std::string& source) {
  const bool c = fs::path(source).extension() == ".c";
  std::string text = c ? EnvironmentOr("CC", "cc") : EnvironmentOr("CXX", "c++");
  std::vector<std::string> words;
  while (!text.empty()) {
    const size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.erase(0, end + 1);
  }
  return words;
}

/// The last lines of what a program has printed, indented: they are no lines of a report.
std::string LastLines(std::string_view output) {
  while (output.ends_with('\n')) output.remove_suffix(1);
  size_t begin = output.size();
  for (int lines = 0; lines < kLinesShown && begin != std::string_view::npos; ++lines) {
    begin = begin == 0 ? std::string_view::npos : output.rfind('\n', begin - 1);
  }
  if (begin != std::string_view::npos) output.remove_prefix(begin + 1);
  std::string lines;
  while (!output.empty()) {
    const size_t end = std::min(output.find('\n'), output.size());
    lines += fmt::format("{}    {}", lines.empty() ? "" : "\n", output.substr(0, end));
    output.remove_prefix(std::min(end + 1, output.size()));
  }
  return lines;
}

/// A failure, and what the program printed.
Message WithOutput(Message failure, const std::string& output) {
  const std::string lines = LastLines(output);
  if (lines.empty()) return failure;
  return {failure.en + "; its output ends with:\n" + lines,
          failure.zh + "；其输出的末尾为：\n" + lines};
}

/// How a program ended that did not end with 0.
Message DescribeEndOfProgram(const std::string& name, int status) {
  if (WIFSIGNALED(status)) {
    return MakeMessage("'{0}' was ended by a signal ({1})", "“{0}”被信号终止（{1}）", name,
                       ::strsignal(WTERMSIG(status)));
  }
  return MakeMessage("'{0}' ended with the exit code {1}", "“{0}”结束，退出码为 {1}", name,
                     WEXITSTATUS(status));
}

/// The line of docs/host-api.md that builds the host of a scenario, for the family of its card.
std::vector<std::string> BuildLine(const runtime::Scenario& scenario, const std::string& program) {
  const runtime::HostProgram& host = *scenario.host_program;
  const std::string library = "-l" + std::string(runtime::FamilyOf(scenario).name);
  const HeaderFolders headers = FindHeaders();
  const LibraryFolders libraries = FindLibraries();
  std::vector<std::string> line = CompilerOf(host.source);
  for (const std::string& folder : {headers.own, headers.compat}) {
    if (!folder.empty()) line.push_back("-I" + folder);
  }
  line.push_back(host.source);
  line.insert(line.end(), host.flags.begin(), host.flags.end());
  for (const std::string& folder : {libraries.own, libraries.of32bits}) {
    if (!folder.empty()) line.push_back("-L" + folder);
  }
  line.insert(line.end(), {library, "-lm", "-o", program});
  return line;
}

/// Compiles the source. False if that fails.
bool BuildHost(const runtime::Scenario& scenario, const HostTestOptions& options,
               const std::string& program, TestOutcome* outcome) {
  const std::string& source = scenario.host_program->source;
  const auto built =
      RunChild({BuildLine(scenario, program), FolderOf(scenario), {}, options.limit_s});
  if (!built.ok()) {
    outcome->failures.push_back(built.error().message);
  } else if (built.value().out_of_time) {
    outcome->failures.push_back(TookTooLong(options.limit_s));
  } else if (built.value().status != 0) {
    const Message text = MakeMessage("'{0}' cannot be compiled", "“{0}”无法编译", source);
    outcome->failures.push_back(WithOutput(text, built.value().output));
  } else {
    if (const std::string lines = LastLines(built.value().output); !lines.empty()) {
      outcome->warnings.push_back(
          MakeMessage("the compiler says:\n{0}", "编译器报告：\n{0}", lines));
    }
    return true;
  }
  return false;
}

/// An ENI file is looked for in the folder of the program: that beside the source is meant.
void LinkEni(const runtime::Scenario& scenario, const std::string& scratch) {
  std::error_code ignored;
  const fs::path source = runtime::PathFromScenario(scenario, scenario.host_program->source);
  const fs::path eni = fs::absolute(source, ignored).parent_path() / runtime::kEniName;
  if (fs::exists(eni, ignored)) {
    fs::create_symlink(eni, fs::path(scratch) / runtime::kEniName, ignored);
  }
}

/// The host's command line, without the compiled program if that fails.
std::optional<std::vector<std::string>> HostLine(const runtime::Scenario& scenario,
                                                 const HostTestOptions& options,
                                                 TestOutcome* outcome) {
  const runtime::HostProgram& host = *scenario.host_program;
  if (host.source.empty()) return host.command;
  const std::string program = options.scratch + '/' + fs::path(host.source).stem().string();
  if (!BuildHost(scenario, options, program, outcome)) return std::nullopt;
  LinkEni(scenario, options.scratch);
  std::vector<std::string> line = {program};
  line.insert(line.end(), host.arguments.begin(), host.arguments.end());
  return line;
}

void TakeReport(const std::string& path, TestOutcome* outcome) {
  const auto text = ReadFile(path);
  if (!text.ok()) return;  // no process of the host uses libgts
  const auto report = runtime::ReadHostReports(text.value());
  if (!report.ok()) {
    outcome->failures.push_back(report.error().message);
    return;
  }
  outcome->time_ms = report.value().end_ms;
  for (const Message& failure : report.value().failures) outcome->failures.push_back(failure);
  for (const Message& warning : report.value().warnings) outcome->warnings.push_back(warning);
}

}  // namespace

HostTestFolder::HostTestFolder() {
  std::error_code error;
  auto folder = fs::temp_directory_path(error);
  // The compiler and the host run in other folders.
  if (!error) folder = fs::absolute(folder, error);
  path_ = (folder / "oncard-test.XXXXXX").string();
  if (error || ::mkdtemp(path_.data()) == nullptr) path_.clear();
}

HostTestFolder::~HostTestFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Message WhyNoHostTests() { return {}; }

void RunHostTest(const runtime::Scenario& scenario, const HostTestOptions& options,
                 const Invocation& invocation, TestOutcome* outcome) {
  std::error_code error;
  if (options.scratch.empty() || !fs::create_directory(options.scratch, error)) {
    outcome->failures.push_back(
        {"no temporary folder can be made for it", "无法为其创建临时文件夹"});
    return;
  }
  const auto host = HostLine(scenario, options, outcome);
  if (!host) return;
  std::error_code ignored;
  const std::string name = fs::path(scenario.path).filename().string();
  const std::string report = options.scratch + "/report";
  ChildProgram child;
  child.words = {fs::read_symlink("/proc/self/exe", ignored).string(),
                 invocation.language == Language::kChinese ? "--lang=zh" : "--lang=en", "exec",
                 "--scenario=" + name};
  if (options.strict_commands) child.words.emplace_back("--strict-commands");
  for (const std::string& warning : options.silent) child.words.push_back("-W" + warning);
  child.words.emplace_back("--");
  child.words.insert(child.words.end(), host->begin(), host->end());
  child.folder = FolderOf(scenario);
  child.environment = {"ONCARD_REPORT=" + report};
  child.limit_s = options.limit_s;
  const auto end = RunChild(child);
  if (!end.ok()) {
    outcome->failures.push_back(end.error().message);
    return;
  }
  TakeReport(report, outcome);
  if (end.value().out_of_time) {
    outcome->failures.push_back(WithOutput(TookTooLong(options.limit_s), end.value().output));
  } else if (end.value().status != 0 &&
             (outcome->failures.empty() || !WIFEXITED(end.value().status) ||
              WEXITSTATUS(end.value().status) != runtime::kExitNotAsExpected)) {
    const std::string& source = scenario.host_program->source;
    outcome->failures.push_back(WithOutput(
        DescribeEndOfProgram(source.empty() ? host->front() : source, end.value().status),
        end.value().output));
  }
}

}  // namespace oncard::tools
