// What one module has and the other has not: in functions of their own, so that the module that
// pages load first has neither searches nor the reader of records, nor the families of cards that
// only hosts use. Defined beside the list of families that the module knows.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "session/arguments.h"
#include "session/host.h"

namespace oncard::web {

/// Answers a request to explore (exploration.h).
using Explorer = Result<session::Json> (*)(const session::Json& arguments, Language* language,
                                           std::vector<std::string>* missing);

/// How the module reads the records of hosts; nullptr: it reads none.
session::CallReader RecordReader();

/// nullptr: it searches no interleavings.
Explorer ExplorerOfModule();

}  // namespace oncard::web
