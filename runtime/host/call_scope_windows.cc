#include "runtime/host/call_scope.h"

namespace oncard::runtime {

constinit thread_local CallState call_state ONCARD_CALL_STATE;

// Windows has no signals that interrupt a thread.
void CallScope::Deliver() {}

}  // namespace oncard::runtime
