#include "runtime/conditions/program_names.h"

namespace oncard::runtime {

ProgramNames ProgramNames::Of(const Controller& controller) {
  const vm::Machine& machine = controller.machine();
  ProgramNames names;
  names.image = machine.shared_image();
  for (size_t i = 0; i < names.bindings.size(); ++i) {
    const vm::ThreadState& thread = machine.thread(static_cast<int>(i));
    if (thread.run == vm::ThreadRun::kUnbound) continue;
    names.bindings[i] = {true, thread.function, thread.page};
  }
  return names;
}

}  // namespace oncard::runtime
