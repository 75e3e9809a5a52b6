#include <thread>

#include "tools/isolation.h"

namespace oncard::tools {

int ProcessorCount() { return static_cast<int>(std::thread::hardware_concurrency()); }

}  // namespace oncard::tools
