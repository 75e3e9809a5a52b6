// In WebAssembly, whose system ends the command at a signal.
#include "tools/stop_signals.h"

namespace oncard::tools {

StopSignals::StopSignals() = default;

StopSignals::~StopSignals() = default;

}  // namespace oncard::tools
