// Writes requests to the module, one in each line, and beside them the answers of this computer's
// build: whole runs of all scenarios in samples/ and of random programs, sessions with them, what
// editors ask about the samples, and explorations of those that are for the explorer.
// tests/web/equality_test.mjs gives the requests to the module.
//   web_requests SAMPLES REQUESTS ANSWERS
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "fixed_program.h"
#include "moving_program.h"
#include "random_program.h"
#include "session/editor_requests.h"
#include "structured_program.h"
#include "tests/web/request_files.h"

namespace oncard::web {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr uint64_t kFirstSeed = 31'000'000;
// A thousand in total.
constexpr uint64_t kInterleaved = 400;
constexpr uint64_t kMoving = 300;
constexpr uint64_t kStructured = 150;
constexpr uint64_t kWithDoubles = 150;
/// So many of the moving programs are also driven in a session.
constexpr uint64_t kWalks = 100;

Json RequestFor(std::string_view kind, const std::string& main, Json files) {
  return {{"id", main},
          {"request", kind},
          {"arguments", {{"main", main}, {"files", std::move(files)}}}};
}

/// Runs a random program.
Json RunOf(const std::string& source, const std::string& scenario) {
  return RequestFor("run", "random.toml",
                    {{"random.toml", "program = \"random.c\"\n" + scenario}, {"random.c", source}});
}

/// The initial values as a table of TOML.
std::string ValuesOf(const std::vector<differential::Declaration>& declarations) {
  constexpr double kOne = 65536;
  std::string table;
  for (const differential::Declaration& declaration : declarations) {
    for (const auto& slot : declaration.slots) {
      const double scale = slot.type == vm::DataType::kDouble ? kOne : 1;
      table += fmt::format("{}\"{}\" = {}", table.empty() ? "" : ", ", slot.name,
                           static_cast<double>(slot.initial) / scale);
    }
  }
  return "{ " + table + " }";
}

Json InterleavedRun(uint64_t seed) {
  const differential::RandomProgram program =
      differential::MakeProgram(seed, differential::Sharing::kInterleaved);
  std::string scenario = fmt::format("double = \"{}\"\nschedule = \"random:{}\"\nglobals = {}\n",
                                     program.format == vm::DoubleFormat::k32_16 ? "32.16" : "16.16",
                                     seed, ValuesOf(program.globals));
  for (size_t thread = 0; thread < program.functions.size(); ++thread) {
    const differential::RandomFunction& function = program.functions[thread];
    scenario +=
        fmt::format("[[thread]]\nthread = {0}\npage = {0}\nfunction = \"{1}\"\ninit = {2}\n",
                    thread, function.name, ValuesOf(function.parameters));
  }
  return RunOf(differential::SourceText(program), scenario);
}

Json MovingRun(uint64_t seed) {
  std::mt19937_64 random(seed);
  const MovingProgram program = MakeMovingProgram(seed);
  const uint64_t rate = 20 + random() % 400;
  const int cycle_us = 125 << random() % 4;
  const std::string schedule = random() % 2 == 0 ? "rr" : fmt::format("random:{}", seed);
  std::string scenario = fmt::format(
      "until_ms = 300\nrate = {}\ncycle_us = {}\nschedule = \"{}\"\n", rate, cycle_us, schedule);
  for (int thread = 0; thread < program.threads; ++thread) {
    scenario += fmt::format("[[thread]]\nthread = {0}\npage = {0}\nfunction = \"f{0}\"\n", thread);
  }
  return RunOf(program.source, scenario);
}

Json StructuredRun(const differential::StructuredProgram& program) {
  return RunOf(program.text, "structured = true\n");
}

/// Drives a program in a session forward and back, and looks into it. `load` is its first request.
void AddWalk(Json load, std::vector<Json>* requests) {
  const std::string id = "walk " + load["id"].get<std::string>();
  load["id"] = id;
  load["request"] = "load";
  requests->push_back(std::move(load));
  const auto add = [&](std::string_view request, Json arguments) {
    requests->push_back({{"id", id}, {"request", request}, {"arguments", std::move(arguments)}});
  };
  const Json none = Json::object();
  for (int i = 0; i < 5; ++i) add("forward", {{"goal", "step"}});
  add("forward", {{"goal", "line"}, {"thread", 0}, {"budget", 1000}});
  add("forward", {{"goal", "time"}, {"ms", 20}, {"budget", 5000}});
  add("variables", none);
  add("card", none);
  add("back", {{"goal", "cycle"}});
  add("back", {{"goal", "step"}});
  add("set_stops", {{"lines", Json::array({{{"line", 9}}})}, {"faults", true}});
  add("forward", {{"goal", "stop"}, {"budget", 5000}});
  add("back", {{"goal", "stop"}, {"budget", 5000}});
  add("trace", {{"names", {"axis1.prfPos"}}, {"from_ms", 0}, {"to_ms", 10}, {"points", 20}});
  add("turns", {{"from", 0}, {"to", 1000}});
  add("spans", none);
  add("written", none);
  add("listing", none);
  add("record", none);
}

/// What an editor asks about the program of a scenario, at some of its places.
void AddQuestions(const std::string& path, const Json& files, std::vector<Json>* requests) {
  for (const session::EditorRequest& each : session::EditorRequests()) {
    Json request = RequestFor(each.text.name, path, files);
    request["id"] = "source " + path;
    Json& arguments = request["arguments"];
    if (each.text.name == "rename") arguments["name"] = "renamed";
    if (each.text.arguments.find("line") == std::string_view::npos) {
      requests->push_back(std::move(request));
      continue;
    }
    constexpr int kLines = 24;
    for (int line = 1; line <= kLines; ++line) {
      arguments["line"] = line;
      arguments["column"] = 3 + line % 5;
      requests->push_back(request);
    }
  }
}

/// A request for each scenario of a sample's folder, with all its files.
void AddSample(const fs::path& folder, std::vector<Json>* requests) {
  Json files = Json::object();
  std::vector<std::string> scenarios;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string path = (folder.filename() / entry.path().filename()).string();
    files[path] = ReadFile(entry.path().string()).value();
    if (path.ends_with(".toml")) scenarios.push_back(path);
  }
  std::ranges::sort(scenarios);
  for (const std::string& path : scenarios) {
    requests->push_back(RequestFor("run", path, files));
    AddWalk(RequestFor("load", path, files), requests);
    AddQuestions(path, files, requests);
    if (files[path].get<std::string>().find("explore") == std::string::npos) continue;
    requests->push_back(RequestFor("explore", path, files));
  }
}

std::vector<Json> Requests(const fs::path& samples) {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(samples)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::ranges::sort(folders);
  std::vector<Json> requests;
  for (const fs::path& folder : folders) AddSample(folder, &requests);
  for (uint64_t i = 0; i < kInterleaved; ++i) requests.push_back(InterleavedRun(kFirstSeed + i));
  for (uint64_t i = 0; i < kMoving; ++i) {
    requests.push_back(MovingRun(kFirstSeed + i));
    if (i < kWalks) AddWalk(requests.back(), &requests);
  }
  for (uint64_t i = 0; i < kStructured; ++i) {
    requests.push_back(StructuredRun(
        differential::MakeStructuredProgram(kFirstSeed + i, differential::Floats::kNone)));
  }
  for (uint64_t i = 0; i < kWithDoubles; ++i) {
    requests.push_back(StructuredRun(differential::MakeFixedProgram(kFirstSeed + i)));
  }
  return requests;
}

}  // namespace
}  // namespace oncard::web

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  return oncard::web::WriteRequests(oncard::web::Requests(argv[1]), argv[2], argv[3]);
}
