#include "tools/stop_signal_numbers.h"

#include <csignal>

namespace oncard::tools {

const StopSignalNumbers kStopSignals = {SIGINT, SIGTERM, SIGHUP};

}  // namespace oncard::tools
