// Random motion programs whose threads move axes: Trap, Jog and Gear motions, waits for positions,
// shared counters, outputs, delays. Some of their commands are refused, as when a mode is changed
// in motion.
#pragma once

#include <cstdint>
#include <string>

namespace oncard::web {

struct MovingProgram {
  std::string source;
  int threads = 0;  ///< functions `f0` ..., one for each thread
};

/// Everything is derived from the seed.
MovingProgram MakeMovingProgram(uint64_t seed);

}  // namespace oncard::web
