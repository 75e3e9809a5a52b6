// A session of the record of a host program. The module for programs has none: what reads records
// is in the module with everything only (web/wasm/full.cc). Tested by
// tests/session/host_calls_test.cc.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/result.h"
#include "session/session.h"

namespace oncard::session {

struct RecordedHost {
  Session session;
  /// Of the request `load`, without the state.
  nlohmann::ordered_json answer;
};

/// Opens the record of one card; without `card` that of the lowest number. `path` is the file's
/// name in messages. Fails if the text is no record, and if it has no such opening.
Result<RecordedHost> OpenRecordedHost(const std::string& text, const std::string& path,
                                      std::optional<int> card, int opening);

}  // namespace oncard::session
