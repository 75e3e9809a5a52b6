// Writes the C++ file, calls g++ and reads the values. The values for a file are kept for the other
// builds of this checkout: most of the time of these tests is spent compiling, and the values
// cannot change.
#include "oracle.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string_view>

#include "base/files.h"

namespace oncard::differential {
namespace {

constexpr std::string_view kOracleCompiler = "g++";
// The programs take milliseconds; if one does not end, the generator has an error.
constexpr int kSecondsMax = 60;

bool IsArray(const Declaration& declaration) {
  return declaration.slots[0].name != declaration.slots[0].symbol;
}

// Sets whole arrays: the time of g++ for these tests mostly depends on the number of calls.
std::string SetAll(const std::vector<Declaration>& declarations) {
  std::string text;
  for (const Declaration& declaration : declarations) {
    if (IsArray(declaration)) {
      std::string initial;
      for (const auto& slot : declaration.slots) initial += fmt::format("{}LL, ", slot.initial);
      text += fmt::format("SetArray({}, {{{}}}); ", declaration.slots[0].symbol, initial);
      continue;
    }
    for (const auto& slot : declaration.slots) {
      text += fmt::format("Set({}, {}LL); ", slot.name, slot.initial);
    }
  }
  return text;
}

std::string PutAll(const std::vector<Declaration>& declarations) {
  std::string text;
  for (const Declaration& declaration : declarations) {
    if (IsArray(declaration)) {
      text +=
          fmt::format("PutArray({}, {}); ", declaration.slots[0].symbol, declaration.slots.size());
      continue;
    }
    for (const auto& slot : declaration.slots) text += fmt::format("Put({}); ", slot.name);
  }
  return text;
}

// Replaces the next `what` of the text at or after `*at`.
void ReplaceNext(std::string* text, std::string_view what, const std::string& with, size_t* at) {
  *at = text->find(what, *at);
  text->replace(*at, what.size(), with);
}

// The unchanged program, except for the comments that are placeholders.
std::string Functions(const RandomProgram& program) {
  std::string text = SourceText(program);
  size_t at = 0;
  for (const RandomFunction& function : program.functions) {
    ReplaceNext(
        &text, kAfterLocals,
        fmt::format("{}{}AtEnd report_variables{{[&] {{ {}{}}}}};", SetAll(function.parameters),
                    SetAll(function.locals), PutAll(function.parameters), PutAll(function.locals)),
        &at);
    ReplaceNext(&text, kBeforeEnd, function.result == "void" ? "" : "return 0;", &at);
  }
  return text;
}

std::string RunFunctions(const RandomProgram& program) {
  std::string text;
  for (const RandomFunction& function : program.functions) {
    std::string arguments;
    for (size_t i = 0; i < function.parameters.size(); ++i) arguments += i == 0 ? "{}" : ", {}";
    text += fmt::format("Call([] {{ return {}({}); }});\n", function.name, arguments);
  }
  return text;
}

// The statement as a case of a switch over the function's statements.
std::string StatementCase(const Statement& statement, const std::string& result,
                          std::map<std::string, size_t>& index_of_label) {
  const std::string value =
      statement.value.empty() ? "0LL" : fmt::format("({})({})", result, statement.value);
  switch (statement.kind) {
    case Statement::Kind::kAssign:
      return fmt::format("{}; ++next;", statement.text);
    case Statement::Kind::kGoto:
      return fmt::format("next = {};", index_of_label[statement.target]);
    case Statement::Kind::kIfGoto:
      return fmt::format("next = {} ? {} : next + 1;", statement.condition,
                         index_of_label[statement.target]);
    case Statement::Kind::kReturn:
      return fmt::format("Return({});", value);
    case Statement::Kind::kIfReturn:
      return fmt::format("if ({}) Return({}); else ++next;", statement.condition, value);
    case Statement::Kind::kEmpty:
      break;
  }
  return "";
}

std::string ThreadClass(const RandomFunction& function) {
  std::string members;
  for (const auto* declarations : {&function.parameters, &function.locals}) {
    for (const Declaration& declaration : *declarations) members += declaration.text + "; ";
  }
  std::map<std::string, size_t> index_of_label;
  size_t count = 0;
  for (const Statement& statement : function.body) {
    if (statement.kind == Statement::Kind::kEmpty) continue;
    for (const std::string& label : statement.labels) index_of_label[label] = count;
    ++count;
  }
  std::string cases;
  size_t index = 0;
  for (const Statement& statement : function.body) {
    if (statement.kind == Statement::Kind::kEmpty) continue;
    cases += fmt::format("case {}: {} break;\n", index++,
                         StatementCase(statement, function.result, index_of_label));
  }
  return fmt::format(
      "struct Thread_{} : Thread {{\n{}\nThread_{}() {{ size = {}; {}{}}}\n"
      "void Report() override {{ {}{}}}\nvoid Statement() override {{ switch (next) {{\n{}}} "
      "}}\n}};\n",
      function.name, members, function.name, count, SetAll(function.parameters),
      SetAll(function.locals), PutAll(function.parameters), PutAll(function.locals), cases);
}

std::string Threads(const RandomProgram& program) {
  std::string text;
  for (const auto& [name, body] : program.macros) {
    text += fmt::format("#define {} {}\n", name, body);
  }
  for (const Declaration& global : program.globals) text += global.text + ";\n";
  for (const RandomFunction& function : program.functions) text += ThreadClass(function);
  return text;
}

std::string RunThreads(const RandomProgram& program, const Interleaving& interleaving) {
  std::string text, list;
  for (const RandomFunction& function : program.functions) {
    text += fmt::format("Thread_{0} thread_{0};\n", function.name);
    list += fmt::format("{}&thread_{}", list.empty() ? "" : ", ", function.name);
  }
  return text + fmt::format("RunThreads({{{}}}, \"{}\", {});\n", list, interleaving.order,
                            interleaving.quantum);
}

std::string OracleSource(const std::vector<RandomProgram>& programs,
                         const std::vector<Interleaving>& interleavings) {
  std::string text =
      "#include \"oracle_prelude.h\"\n"
      "#define int Int\n#define long Int\n#define short Int\n#define double Fixed\n";
  std::string calls;
  for (size_t i = 0; i < programs.size(); ++i) {
    const RandomProgram& program = programs[i];
    const bool threads = !interleavings.empty();
    text += fmt::format("namespace program_{} {{\n{}", i,
                        threads ? Threads(program) : Functions(program));
    text +=
        fmt::format("void Run() {{\ndouble_bits = {};\n{}\n{}{}PrintReport();\n}}\n}}\n",
                    program.format == vm::DoubleFormat::k32_16 ? 48 : 32, SetAll(program.globals),
                    threads ? RunThreads(program, interleavings[i]) : RunFunctions(program),
                    PutAll(program.globals));
    for (const auto& [name, body] : program.macros) text += fmt::format("#undef {}\n", name);
    calls += fmt::format("program_{}::Run();\n", i);
  }
  return text + fmt::format("#undef int\nint main() {{\n{}}}\n", calls);
}

// Runs a shell command; its output goes to a file. Paths are those of the build and are quoted.
bool Shell(const std::string& command, const std::string& output) {
  // NOLINTNEXTLINE(cert-env33-c): a test, calling the compiler that built it
  return std::system(fmt::format("{} > '{}' 2>&1", command, output).c_str()) == 0;
}

// Where the values for a source are kept, independent of the build.
std::string KeptValues(const std::string& source, const std::string& flags) {
  const auto prelude = ReadFile(ONCARD_SOURCE_DIR "/tests/differential/oracle_prelude.h");
  const std::string all = flags + source + (prelude.ok() ? prelude.value() : "");
  return fmt::format("{}/build/oracle/{:016x}.txt", ONCARD_SOURCE_DIR,
                     XXH3_64bits(all.data(), all.size()));
}

std::vector<Values> ParseValues(const std::string& text) {
  std::vector<Values> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    all.emplace_back();
    for (int64_t number = 0; numbers >> number;) all.back().push_back(number);
  }
  return all;
}

}  // namespace

Result<std::vector<Values>> RunOracle(const std::vector<RandomProgram>& programs,
                                      const std::vector<Interleaving>& interleavings,
                                      const std::string& folder) {
  const std::string prelude =
      fmt::format("-std=gnu++20 -I '{}/tests/differential'", ONCARD_SOURCE_DIR);
  return RunOracle(OracleSource(programs, interleavings), prelude, folder);
}

Result<std::vector<Values>> RunOracle(const std::string& text, const std::string& flags,
                                      const std::string& folder) {
  std::error_code failure;
  const std::string kept = KeptValues(text, flags);
  if (const auto known = ReadFile(kept); known.ok()) return ParseValues(known.value());
  std::filesystem::create_directories(folder, failure);
  const std::string source = folder + "/oracle.cc", program = folder + "/oracle";
  const std::string messages = folder + "/messages.txt", values = folder + "/values.txt";
  if (auto written = WriteFileAtomically(source, text); !written.ok()) return written.error();
  if (!Shell(fmt::format("{} --version", kOracleCompiler), messages)) {
    return MakeError(1, "{0} is not on this machine; the differential tests need it: install {0}",
                     "本机没有 {0}；差分测试需要它：请安装 {0}", kOracleCompiler);
  }
  if (!Shell(fmt::format("{} -O0 -w {} -o '{}' '{}'", kOracleCompiler, flags, program, source),
             messages)) {
    const auto said = ReadFile(messages);
    return MakeError(1, "{} does not compile {}: {}", "{} 无法编译 {}：{}", kOracleCompiler, source,
                     said.ok() ? said.value().substr(0, 4000) : "");
  }
  if (!Shell(fmt::format("timeout {} '{}'", kSecondsMax, program), values)) {
    return MakeError(1, "{} did not run to its end", "{} 没有运行到结束", program);
  }
  const auto computed = ReadFile(values);
  if (!computed.ok()) return computed.error();
  std::filesystem::create_directories(std::filesystem::path(kept).parent_path(), failure);
  if (auto written = WriteFileAtomically(kept, computed.value()); !written.ok()) {
    return written.error();
  }
  return ParseValues(computed.value());
}

std::vector<std::string> ValueNames(const RandomProgram& program) {
  std::vector<std::string> names;
  for (const RandomFunction& function : program.functions) {
    for (const auto* declarations : {&function.parameters, &function.locals}) {
      for (const Declaration& declaration : *declarations) {
        for (const auto& slot : declaration.slots) {
          names.push_back(function.name + ": " + slot.name);
        }
      }
    }
    names.push_back(function.name + ": result");
    names.push_back(function.name + ": fault");
  }
  for (const Declaration& global : program.globals) {
    for (const auto& slot : global.slots) names.push_back(slot.name);
  }
  return names;
}

}  // namespace oncard::differential
