// The module with everything, which pages load when somebody explores or opens a record: it knows
// all families of cards (gtcalls/families.cc), as a host can drive any of them.
#include "session/recorded_host.h"
#include "web/wasm/exploration.h"
#include "web/wasm/module_parts.h"

namespace oncard::web {

session::CallReader RecordReader() { return session::OpenRecordedHost; }

Explorer ExplorerOfModule() { return Explore; }

}  // namespace oncard::web
