// The session protocol as a JSON Schema (draft 2020-12): every request with its arguments and its
// result, answers, events, and the parts of all of them (protocol_parts.h). It is the exact form of
// what docs/session-protocol.md explains; the types of TypeScript (web/engine/src/protocol.ts) are
// made from it. Ranges of numbers are not in it: the session says what is wrong with a number.
//
// Only the command and tests link it: the module for WebAssembly does not carry it.
// Tested by tests/session/protocol_schema_test.cc.
#pragma once

#include <string>

namespace oncard::session {

/// The schema as text; ends in a newline. The object that it describes has `requests`, with
/// `arguments` and `result` of each request by its name, `answer`, and `event`.
std::string ProtocolSchema();

}  // namespace oncard::session
