#include "tools/stop_signal_numbers.h"

#include <csignal>

namespace oncard::tools {

// SIGBREAK is Ctrl-Break, a closed console, the end of the session.
const StopSignalNumbers kStopSignals = {SIGINT, SIGTERM, SIGBREAK};

}  // namespace oncard::tools
