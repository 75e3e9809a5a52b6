// The module `_oncard`: what the package `oncard` calls. Errors become exceptions of the package
// here; what is below does not know Python. Results that Python looks at are JSON.
// Tested by tests/python/.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/json_text.h"
#include "base/milliseconds.h"
#include "compiler/diagnostic_printer.h"
#include "python/await.h"
#include "python/runs.h"
#include "python/searches.h"
#include "python/sources.h"
#include "runtime/observe/trace_file.h"
#include "runtime/scenario/run/result_json.h"
#include "session/host.h"
#include "tools/project_session.h"
#include "tools/search_limits.h"
#include "vm/object_writer.h"

namespace oncard::python {
namespace {

namespace py = pybind11;

/// Names and comments of programs can be any bytes.
py::str TextOf(std::string_view bytes) {
  PyObject* text =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

Language LanguageOf(bool chinese) { return chinese ? Language::kChinese : Language::kEnglish; }

py::object ErrorType(const char* name) { return py::module_::import("oncard.errors").attr(name); }

[[noreturn]] void Raise(const py::object& type, const py::object& error) {
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

[[noreturn]] void Raise(const Error& error) {
  const py::object type = ErrorType("Error");
  Raise(type, type(TextOf(error.message.en), TextOf(error.message.zh)));
}

/// Both languages are in it.
py::str DiagnosticsOf(const compiler::Compilation& compilation) {
  return TextOf(JsonText(compiler::DiagnosticsJson(compilation, Language::kEnglish)));
}

[[noreturn]] void RaiseMistakes(const compiler::Compilation& compilation) {
  const py::object type = ErrorType("CompileError");
  const auto text = [&](Language language) {
    return TextOf(compiler::PrintText(compilation, {language, false})).attr("rstrip")();
  };
  Raise(type, type(text(Language::kEnglish), text(Language::kChinese), DiagnosticsOf(compilation)));
}

/// The value, or an exception.
template <typename T>
T Checked(Result<T> result) {
  if (!result.ok()) Raise(result.error());
  return std::move(result).value();
}

using Texts = std::map<std::string, std::string>;

// --- Programs ------------------------------------------------------------------------------------

CompiledProgram CompileProgram(const std::string& main, const Texts& files, bool structured) {
  const Source source = {main, files, structured};
  CompiledProgram program = Checked(Await([&] { return Compile(source); }, [] {}));
  if (!program.compilation.ok()) RaiseMistakes(program.compilation);
  return program;
}

vm::ObjectFiles ObjectOf(const CompiledProgram& program) {
  return vm::WriteObject(*program.compilation.object, false);
}

py::tuple ObjectBytes(const CompiledProgram& program) {
  const vm::ObjectFiles files = ObjectOf(program);
  return py::make_tuple(py::bytes(files.bin), py::bytes(files.ini));
}

py::tuple WriteProgram(const CompiledProgram& program, const std::string& folder) {
  const compiler::OutputPaths paths = compiler::OutputPathsFor(program.path, folder);
  const vm::ObjectFiles files = ObjectOf(program);
  const auto written = WritePairAtomically(paths.bin, files.bin, paths.ini, files.ini);
  if (!written.ok()) Raise(written.error());
  return py::make_tuple(py::bytes(paths.bin), py::bytes(paths.ini));
}

py::dict SourcesOf(const CompiledProgram& program) {
  py::dict sources;
  for (const compiler::SourceFile& file : program.compilation.files) {
    sources[py::bytes(file.path())] = py::bytes(file.text());
  }
  return sources;
}

py::tuple TestOf(const std::string& main, const Texts& files) {
  const TestKind kind = Checked(KindOfTest({main, files}));
  return py::make_tuple(TextOf(kind.name), TextOf(kind.verdict), kind.checks);
}

// --- Runs ----------------------------------------------------------------------------------------

RunOutcome RunProgram(const std::string& main, const Texts& files, bool structured,
                      const std::vector<std::string>& show, bool trace,
                      const std::vector<std::string>& columns, bool strict_commands,
                      const std::vector<std::string>& silent) {
  const Source source = {main, files, structured};
  const RunWish wish = {show, trace, columns, strict_commands, silent};
  std::atomic<bool> stop = false;
  RunOutcome outcome =
      Checked(Await([&] { return Run(source, wish, &stop); }, [&stop] { stop = true; }));
  if (!outcome.result) RaiseMistakes(outcome.compilation);
  return outcome;
}

py::str RunJson(const RunOutcome& outcome, bool chinese) {
  return TextOf(JsonText(runtime::ResultJson(*outcome.result, LanguageOf(chinese))));
}

/// The columns by their names, with the instants first.
py::dict TraceColumns(const RunOutcome& outcome) {
  const runtime::Trace& trace = *outcome.result->trace;
  std::vector<double> times;
  std::vector<std::vector<double>> columns(trace.columns().size());
  {
    const py::gil_scoped_release unlocked;
    for (runtime::RowLog::Reader reader(trace.rows()); reader.Next();) {
      times.push_back(ToMs(reader.row().time_us));
      for (size_t i = 0; i < columns.size(); ++i) columns[i].push_back(reader.row().values[i]);
    }
  }
  const auto array = [](const std::vector<double>& values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  py::dict arrays;
  arrays["time_ms"] = array(times);
  for (size_t i = 0; i < columns.size(); ++i) {
    arrays[TextOf(trace.columns()[i].quantity.name)] = array(columns[i]);
  }
  return arrays;
}

void WriteTrace(const RunOutcome& outcome, const std::string& path) {
  if (!runtime::IsTraceName(path)) {
    Raise(MakeError(1, "the name of a trace must end in .csv, .vcd, .json or .gnuplot, not '{0}'",
                    "轨迹文件名应以 .csv、.vcd、.json 或 .gnuplot 结尾，而不是“{0}”", path));
  }
  const auto written = [&]() -> Result<void> {
    const py::gil_scoped_release unlocked;
    auto text = runtime::TraceText(*outcome.result->trace, path, outcome.title);
    if (!text.ok()) return text.error();
    return WriteFileAtomically(path, std::move(text).value());
  }();
  if (!written.ok()) Raise(written.error());
}

py::bytes PictureOf(const RunOutcome& outcome, const std::string& path) {
  return py::bytes(Checked(runtime::PictureScript(*outcome.result->trace, path, outcome.title)));
}

// --- Explorations --------------------------------------------------------------------------------

/// A requirement: its scope and its text, of `within` the condition before and the one that must
/// follow, and its milliseconds.
using RequirementText = std::tuple<std::string, std::string, std::string, double>;

runtime::Requirement RequirementOf(const RequirementText& given) {
  const auto& [scope_name, text, then, ms] = given;
  const runtime::Scope scope = *runtime::ScopeNamed(scope_name);
  if (scope == runtime::Scope::kLeads) {
    return runtime::ReadResponse(scope, text, [](auto) { return runtime::TextPlace{}; });
  }
  runtime::Requirement requirement = {scope, text};
  requirement.then = then;
  requirement.within_us = FromMs(ms);
  return requirement;
}

SearchOutcome ExploreProgram(const std::string& main, const Texts& files, bool structured,
                             const std::vector<RequirementText>& requirements,
                             const std::string& engine, const std::string& races,
                             const std::map<std::string, std::optional<int64_t>>& numbers,
                             std::optional<bool> merge_private, std::optional<bool> dead_locals,
                             std::optional<bool> symmetry, std::optional<bool> islands,
                             std::optional<bool> reductions, bool all,
                             const std::vector<std::string>& silent, double seconds,
                             int64_t memory_mib) {
  const Source source = {main, files, structured};
  SearchWish wish;
  for (const RequirementText& given : requirements) {
    wish.requirements.push_back(RequirementOf(given));
  }
  wish.engine = engine;
  wish.races = races;
  wish.max_executions = numbers.at("max_executions");
  wish.max_states = numbers.at("max_states");
  wish.runs = numbers.at("runs");
  wish.seed = numbers.at("seed");
  wish.depth = numbers.at("depth");
  wish.preemptions = numbers.at("preemptions");
  wish.merge_private = merge_private;
  wish.dead_locals = dead_locals;
  wish.symmetry = symmetry;
  wish.islands = islands;
  wish.reductions = reductions;
  wish.all = all;
  wish.silent = silent;
  explore::SearchProgress progress;
  tools::SearchLimits limits(seconds, memory_mib, 1, &progress);
  const auto stop = [&progress] {
    progress.interrupted = true;
    progress.hurried = true;
    progress.stop = true;
  };
  SearchOutcome outcome = Checked(
      Await([&] { return Explore(source, wish, &progress); }, stop, [&limits] { limits.Look(); }));
  if (!outcome.findings) RaiseMistakes(outcome.compilation);
  return outcome;
}

py::list WarningsOf(const SearchOutcome& outcome, bool chinese) {
  py::list texts;
  for (const Message& warning : outcome.warnings) {
    texts.append(TextOf(warning.In(LanguageOf(chinese))));
  }
  for (const Message& untested : outcome.findings->untested) {
    texts.append(TextOf(untested.In(LanguageOf(chinese))));
  }
  return texts;
}

// --- Sessions ------------------------------------------------------------------------------------

/// A session of the protocol. The requests of several threads wait for each other.
class SharedSession {
 public:
  py::str Handle(const std::string& request) {
    std::string answer;
    {
      const py::gil_scoped_release unlocked;
      const std::lock_guard lock(*mutex_);
      answer = host_.Handle(request);
    }
    return TextOf(answer);
  }

 private:
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  session::SessionHost host_ = tools::NewProjectSession();
};

}  // namespace

// The macro defines the functions that Python looks for.
PYBIND11_MODULE(_oncard, module) {  // NOLINT
  module.doc() = "What the package oncard calls.";
  module.attr("version") = ONCARD_VERSION;
  module.def("environment_is_chinese",
             [] { return LanguageFromEnvironment() == Language::kChinese; });
  module.def("test_kind", &TestOf, py::arg("main"), py::arg("files"));

  py::class_<CompiledProgram>(module, "Program")
      .def("path", [](const CompiledProgram& program) { return py::bytes(program.path); })
      .def("diagnostics",
           [](const CompiledProgram& program) { return DiagnosticsOf(program.compilation); })
      .def("object", &ObjectBytes)
      .def("sources", &SourcesOf)
      .def("write", &WriteProgram, py::arg("folder"));
  module.def("compile", &CompileProgram, py::arg("main"), py::arg("files"), py::arg("structured"));

  py::class_<RunOutcome>(module, "Run")
      .def("json", &RunJson, py::arg("chinese"))
      .def("trace", &TraceColumns)
      .def("write_trace", &WriteTrace, py::arg("path"))
      .def("picture", &PictureOf, py::arg("path"));
  module.def("run", &RunProgram, py::arg("main"), py::arg("files"), py::arg("structured"),
             py::arg("show"), py::arg("trace"), py::arg("columns"), py::arg("strict_commands"),
             py::arg("silent"));

  py::class_<SearchOutcome>(module, "Exploration")
      .def("json",
           [](const SearchOutcome& outcome) {
             return TextOf(explore::JsonReport(*outcome.findings));
           })
      .def(
          "text",
          [](const SearchOutcome& outcome, bool chinese, bool full) {
            return TextOf(explore::TextReport(*outcome.findings, LanguageOf(chinese), {full}));
          },
          py::arg("chinese"), py::arg("full"))
      .def(
          "html",
          [](const SearchOutcome& outcome, bool chinese) {
            return TextOf(explore::HtmlReport(*outcome.findings, LanguageOf(chinese)));
          },
          py::arg("chinese"))
      .def("cut", [](const SearchOutcome& outcome) { return outcome.cut; })
      .def("warnings", &WarningsOf, py::arg("chinese"))
      .def("schedule", [](const SearchOutcome& outcome) { return TextOf(outcome.schedule); });
  module.def("explore", &ExploreProgram, py::arg("main"), py::arg("files"), py::arg("structured"),
             py::arg("requirements"), py::arg("engine"), py::arg("races"), py::arg("numbers"),
             py::arg("merge_private"), py::arg("dead_locals"), py::arg("symmetry"),
             py::arg("islands"), py::arg("reductions"), py::arg("all"), py::arg("silent"),
             py::arg("seconds"), py::arg("memory_mib"));

  py::class_<SharedSession>(module, "Session")
      .def(py::init<>())
      .def("handle", &SharedSession::Handle, py::arg("request"));
}

}  // namespace oncard::python
