// How a module reads the records of hosts: in a function of its own, so that the module that pages
// load first has neither the reader nor the families of cards that only hosts use.
#pragma once

#include "session/host.h"

namespace oncard::web {

/// nullptr: it reads none. Defined beside the list of families that the module knows.
session::CallReader RecordReader();

}  // namespace oncard::web
