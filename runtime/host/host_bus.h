// The bus of a host program's card: Gecat.eni in the folder of the program, and the slaves of the
// scenario. Safe to call from any thread. Tested by tests/runtime/eni_file_test.cc.
#pragma once

#include <string>

#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {

/// Adds what the ENI file in a folder describes to a scenario: the configuration of its bus and, if
/// it has no slaves, the slaves; or BusSetup::eni_error. Does nothing if there is no such file. A
/// drive that is connected says which motor it moves; others have the axes that are free.
void TakeEni(const std::string& folder, Scenario* scenario);

}  // namespace oncard::runtime
