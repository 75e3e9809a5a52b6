// A scenario: which program runs, how its threads start, what happens around the card, and what is
// expected. Scenarios are TOML files (docs/scenarios.md); recordings contain the same text. Tested
// by tests/runtime/scenario_parse_test.cc.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "compiler/compiler.h"
#include "gtcalls/card_type.h"
#include "motion/motion_core.h"
#include "runtime/scenario/file/expectation.h"
#include "runtime/scenario/file/key_script.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/scenario_keys.h"
#include "runtime/scenario/file/view_setup.h"
#include "runtime/scenario/world/bus_setup.h"
#include "runtime/scenario/world/world_setup.h"
#include "vm/fixed_point.h"

namespace oncard::runtime {

/// A variable's value before the start. Several values go to consecutive elements of an array.
struct InitialValue {
  std::string name;  ///< `v`, `a`, `a[3]`, `s.member`
  std::vector<double> values;
  TextPlace place = {};  ///< of the name
  /// It is any whole number from the only value to here; empty: exactly what `values` says.
  std::optional<int64_t> last = {};
  bool operator==(const InitialValue&) const = default;
};

/// A thread to bind and start.
struct ThreadStart {
  int thread = 0;
  std::string function;
  int page = 0;
  std::vector<InitialValue> values;  ///< parameters and locals
  /// Period in milliseconds for repeated starts (GT_RunThreadPeriod); 0: started once.
  int64_t period_ms = 0;
  int priority = 4;  ///< of a periodic thread
  TextPlace function_place = {};
  TextPlace page_place = {};
  bool operator==(const ThreadStart&) const = default;
};

/// The host program that a test runs: a source that is compiled, or a command.
struct HostProgram {
  std::string source;                  ///< relative to the scenario's folder
  std::vector<std::string> flags;      ///< of the compiler
  std::vector<std::string> arguments;  ///< of the compiled program
  std::vector<std::string> command;    ///< the program and its arguments
  bool operator==(const HostProgram&) const = default;
};

/// The host writes variables, as by GT_SetVarValue: between two cycles, or in the middle of one.
struct HostEvent {
  int64_t at_us = 0;
  std::vector<InitialValue> values;
  /// In the cycle at at_us, when the threads have executed so many of its statements; empty: after
  /// all of them.
  std::optional<int64_t> after_statements = {};
  bool operator==(const HostEvent&) const = default;
};

/// A condition that another one must follow in time.
struct TimedResponse {
  std::string after;
  std::string then;
  int64_t us = 0;
  TextPlace after_place = {};
  TextPlace then_place = {};
  TextPlace us_place = {};
  bool operator==(const TimedResponse&) const = default;
};

/// Options for exploring a scenario.
struct ExploreWish {
  std::string engine = "auto";
  std::string verdict = "PROVED";  ///< the expected verdict
  /// 0: the explorer's default.
  int64_t max_executions = 0;
  int64_t runs = 0;
  int64_t max_states = 0;
  /// A schedule file: only this schedule is checked, as far as the program can still follow it.
  std::string follow = {};
  bool operator==(const ExploreWish&) const = default;
};

/// Defaults and limits of a scenario.
inline constexpr int kRateDefault = 100;           ///< statements per ms (GTS manual 10.2)
inline constexpr int64_t kCycleUsDefault = 250;    ///< profile cycle
inline constexpr int64_t kLimitMsDefault = 60000;  ///< a minute of virtual time
inline constexpr int64_t kTimeMsMax = 1'000'000'000;

/// Before the file in a `schedule` that replays a recording.
inline constexpr std::string_view kReplayPrefix = "replay:";

/// Scenario::text_places of the conditions of World::reactions, and of what is open in
/// World::inputs and World::faults.
inline constexpr std::string_view kReactionPlaces = "world.react";
inline constexpr std::string_view kInputPlaces = "world.input";
inline constexpr std::string_view kFaultPlaces = "world.fault";

struct Scenario {
  /// The file it was read from; the program's path is relative to its folder.
  std::string path;
  /// Title of its picture; empty: the file's name.
  std::string title;
  /// `.c` is compiled, `.bin` loaded with the `.ini` beside it.
  std::string program;
  std::vector<std::string> include_folders;
  vm::DoubleFormat double_format = vm::DoubleFormat::k32_16;
  /// The program is structured C, even if its first line does not say so.
  bool structured = false;
  /// Empty: the function `main`, or the first function if there is no `main`, on thread 0 and page
  /// 0.
  std::vector<ThreadStart> threads;
  std::vector<InitialValue> globals;
  std::string schedule = "rr";
  int rate = kRateDefault;
  /// The name of a gtcalls::CardType, which then has axis_count axes; empty: any GTS card.
  std::string card = {};
  int axis_count = motion::MotionConfig{}.axis_count;
  int64_t cycle_us = kCycleUsDefault;
  /// Reaching it is a failure.
  int64_t limit_ms = kLimitMsDefault;
  /// The run ends at this time, whatever the threads do; empty: when all threads have stopped.
  std::optional<int64_t> until_us;
  World world;
  BusSetup bus;
  ViewSetup view;
  /// Of a scenario for a host; those of the keys `host` exclude each other.
  std::optional<HostProgram> host_program = {};
  std::vector<HostEvent> host;  ///< in order of time
  /// Names of the values in a trace; empty: as described at RunOptions::trace.
  std::vector<std::string> trace;
  std::vector<Expectation> expectations;
  /// Expressions that must hold at the end of every run.
  std::vector<std::string> final;
  /// Expressions that must hold, or not hold, in every state.
  std::vector<std::string> always;
  std::vector<std::string> never;
  /// Expressions that must hold in some state of every run.
  std::vector<std::string> eventually;
  /// `p -> q`: each state with `p` is followed by this or a later one with `q`.
  std::vector<std::string> leads;
  std::vector<TimedResponse> within;
  /// The program is meant to run for ever: no run has to end.
  bool endless = false;
  /// Allowed endings without an end: of threads that execute statements for ever, and of threads
  /// that wait for ever. `none` or `any`.
  std::string livelock = "none";
  std::string deadlock = "none";
  /// The places of the texts of `schedule`, `trace`, `final`, `always`, `never`, `eventually`,
  /// `leads`, `races`, `sync` and `explore.engine`, by key, and those of the world; what does not
  /// come from a file has none, at the end of the list.
  std::map<std::string, std::vector<TextPlace>, std::less<>> text_places;
  /// Allowed data races: `any`, `benign` or `none`.
  std::string races = "any";
  /// Globals that synchronise threads and are not checked for races themselves.
  std::vector<std::string> sync;
  /// If set, `oncard test` explores the scenario.
  std::optional<ExploreWish> explore;
  std::vector<KeyPress> keys;  ///< of a host program, in order of time
  /// The file of the card's memory that survives power-off, for a host program; empty: none.
  std::string mram = {};
  /// What that memory holds when the card is switched on, as Family::memory_text() of the card
  /// gives it; empty: it is clear. No key: it is in the file, or in the record of a host.
  std::string memory = {};
};

/// Reads TOML text. The error contains all mistakes, each with its own lines: `path:line:column:
/// what`, the line, and a caret. Unknown keys are errors, with a suggestion of the most similar
/// key; so are keys that cannot be used for `use`. Any text is safe to read. `margin` is for a text
/// that is only a part of its file.
Result<Scenario> ParseScenario(std::string_view text, const std::string& path,
                               ScenarioUse use = ScenarioUse::kText, TextMargin margin = {});

/// Reads a scenario file. For ScenarioUse::kHost it needs no program, and `host_card` is the card
/// that ONCARD_CARD names, if any.
Result<Scenario> LoadScenario(const std::string& path, ScenarioUse use,
                              const gtcalls::CardType* host_card = nullptr);

/// True if a run that lasts for ever is no failure.
bool MayLastForEver(const Scenario& scenario);
/// True if it is no failure that all threads wait for ever.
bool MayDeadlock(const Scenario& scenario);

/// The place of one of the texts of a key, if it is in Scenario::text_places.
TextPlace PlaceOfText(const Scenario& scenario, std::string_view key, size_t index = 0);

/// The text that ParseScenario() reads back; ends in a newline.
std::string FormatScenario(const Scenario& scenario);
/// Its tables that are read back as the same world, for a card with `axis_count` axes.
std::string FormatWorld(const World& world, int axis_count);
/// Its tables that are read back as the same bus.
std::string FormatBus(const BusSetup& bus);
/// Its tables that are read back as the same view.
std::string FormatView(const ViewSetup& view);

/// A path of the scenario, which is relative to the scenario's folder, for the caller to open.
std::string PathFromScenario(const Scenario& scenario, const std::string& path);
/// The reverse: a path of the caller relative to the scenario's folder.
std::string PathToScenario(const Scenario& scenario, const std::string& path);
/// The title of a picture of the scenario: its `title`, otherwise the name of its file or program.
std::string TitleOf(const Scenario& scenario);
/// The program file, for the caller to open.
std::string ProgramPath(const Scenario& scenario);
/// The options with which a source is compiled.
compiler::Options CompileOptions(const Scenario& scenario);
/// The same scenario with paths relative to the file `path`.
Scenario MoveScenario(const Scenario& scenario, const std::string& path);

/// The same scenario without the keys that concern all schedules, for the recording of one run.
Scenario ScenarioOfOneRun(const Scenario& scenario);

/// Reads `thread=function[@page][:name=value,...]`, the form of `oncard run --thread`.
Result<ThreadStart> ParseThreadStart(std::string_view text);

/// Reads `name=value` or `name=value,value,...` (the form of `--set`, for arrays).
Result<InitialValue> ParseInitialValue(std::string_view text);

/// Whole numbers of which one is chosen are at most so far from 0: doubles are exact up to here.
inline constexpr int64_t kChosenMax = int64_t{1} << 53;
/// True if one of the whole numbers from `first` to `last` can be chosen.
constexpr bool IsChoice(int64_t first, int64_t last) {
  return -kChosenMax <= first && first <= last && last <= kChosenMax;
}

/// Reads `name = first..last`, the form of `//@ input`: any whole number between them.
Result<InitialValue> ParseValueRange(std::string_view text);

}  // namespace oncard::runtime
