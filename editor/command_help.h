// What the catalogue says about a GT command, for people: prototype, parameters, effects.
// Tested by tests/editor/describe_test.cc.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/message.h"
#include "gtcalls/catalogue.h"

namespace oncard::editor {

/// `GT_GetClock(unsigned long *pClock, unsigned long *pLoop = NULL)`.
std::string Prototype(const gtcalls::Command& command);
/// The declaration of a parameter with its default: `short count = 1`.
std::string ParameterLabel(const gtcalls::Parameter& parameter);
/// Whether a value is passed by its address.
bool IsPointer(const gtcalls::Parameter& parameter);

/// `name`, `label`, `type`, and where they apply `passing`, `unit`, `range`, `default` and `note`.
nlohmann::ordered_json ParameterJson(const gtcalls::Command& command,
                                     const gtcalls::Parameter& parameter, Language language);

/// What is worth knowing of a parameter in one line: `pulse/ms, (0, 32767]`; empty if nothing is.
std::string ParameterNote(const gtcalls::Command& command, const gtcalls::Parameter& parameter,
                          Language language);

/// What the command does, in one line.
std::string_view Brief(const gtcalls::Command& command, Language language);

/// Who may call the command.
std::string Callers(const gtcalls::Command& command, Language language);

/// Markdown: prototype, what it does, a table of the parameters, return codes, sources.
std::string CommandMarkdown(const gtcalls::Command& command, Language language);

}  // namespace oncard::editor
