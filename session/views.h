// What a session shows of its run, as JSON. docs/session-protocol.md describes the members.
// Tested by tests/session/host_test.cc.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "session/line_writes.h"
#include "session/session.h"

namespace oncard::session {

// The names of what can come next, of ends of a run, and of the reasons for which a walk ends.

std::string_view StepName(StepKind kind);
std::string_view OverName(runtime::RunOver over);
std::string_view ReasonName(StopReason reason);

/// The present: moment, time, threads, what comes next.
nlohmann::ordered_json StateView(const RewindableRun& run, Language language);

/// Why a walk ended.
nlohmann::ordered_json StopView(const Stop& stop, Language language);

/// Global variables, or the variables of the function on a data page.
nlohmann::ordered_json GlobalsView(const RewindableRun& run);
nlohmann::ordered_json PageView(const RewindableRun& run, int page);
/// The 1024 slots of a data page as they are.
nlohmann::ordered_json SlotsView(const RewindableRun& run, int page);

/// Of a path that lies ahead, the next points that CardView shows.
inline constexpr size_t kPathPointsMax = 200;

/// Axes, profiles and the other parts of the card, its inputs and outputs, the switches, and the
/// coordinate systems with the paths that lie ahead, and how the machine looks.
nlohmann::ordered_json CardView(const RewindableRun& run, Language language);

/// A text of a user: the values of a name (quantity.h), or whether a condition holds; with a
/// thread, as its function means the names. Fails if it is neither.
Result<nlohmann::ordered_json> Evaluate(const std::string& text, std::optional<int> thread,
                                        const RewindableRun& run);

/// The functions of the program with the lines of their statements and their texts.
nlohmann::ordered_json ListingView(const RewindableRun& run);

nlohmann::ordered_json ChannelsView(const std::vector<Session::Channel>& channels);
nlohmann::ordered_json SpansView(const std::vector<RewindableRun::Span>& spans,
                                 const RewindableRun& run, Language language);
nlohmann::ordered_json LineWritesView(const std::vector<LineWrites>& lines);
nlohmann::ordered_json TurnsView(const std::vector<RewindableRun::Turn>& turns,
                                 const RewindableRun& run);

}  // namespace oncard::session
