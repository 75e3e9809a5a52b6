#include <cstdint>

#include "tools/isolation.h"

// How many tests at a time are worth it (web/cli/src/tests.ts).
extern "C" __attribute__((import_module("oncard"), import_name("processors"))) int32_t
oncard_processors();

namespace oncard::tools {

int ProcessorCount() { return oncard_processors(); }

}  // namespace oncard::tools
