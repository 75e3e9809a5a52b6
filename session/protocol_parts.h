// The parts of the session protocol: what has a name there (schema_words.h), in the order in which
// a reader meets it.
#pragma once

#include <vector>

#include "session/schema_words.h"

namespace oncard::session::schema {

/// A program: the arguments that most requests about one have.
Members ProgramMembers();
/// A place in a file of a program.
Members SourcePlaceMembers();

/// What goes through a session: programs, the state, walks and stops, values.
std::vector<Part> RunParts();
/// What is asked and answered about sources (editor_requests.h).
std::vector<Part> SourceParts();

}  // namespace oncard::session::schema
