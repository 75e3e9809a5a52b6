// The module for records, which pages load when one is opened: it knows all families of cards
// (gtcalls/families.cc), as a host can drive any of them.
#include "session/recorded_host.h"
#include "web/wasm/record_reader.h"

namespace oncard::web {

session::CallReader RecordReader() { return session::OpenRecordedHost; }

}  // namespace oncard::web
