#include "tools/out_of_memory.h"

#include <unistd.h>

#include <new>
#include <string>

#include "base/files.h"

namespace oncard::tools {
namespace {

/// The message, allocated in advance because nothing can be allocated then.
std::string* said = nullptr;

[[noreturn]] void End() {
  UndoWrites();
  // An error of this write cannot be handled.
  static_cast<void>(!::write(STDERR_FILENO, said->data(), static_cast<unsigned>(said->size())));
  ::_exit(kExitIncomplete);
}

}  // namespace

void EndWhenOutOfMemory(const Invocation& invocation) {
  static std::string text;
  text = invocation.Say(
      {"oncard: out of memory: 'explore' needs less with --max-states, --engine=dpor or "
       "--engine=bounded, with a card also with a longer cycle_us or a smaller rate; 'run' with a "
       "shorter limit_ms, or without --trace, --plot, --steps and --record\n",
       "oncard: 内存不足：“explore”可用 --max-states、--engine=dpor 或 --engine=bounded "
       "减少内存，带控制卡时还可增大 cycle_us 或减小 rate；“run”可缩短 limit_ms，或去掉 "
       "--trace、--plot、--steps 和 --record\n"});
  said = &text;
  std::set_new_handler(End);
}

}  // namespace oncard::tools
