// What the names of conditions on a card depend on: the program, and which function is bound to
// which thread and page. A host changes both while the card runs, and conditions are then bound
// anew. Tested by tests/runtime/requirement_watch_test.cc and reactions_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "runtime/sim/controller.h"
#include "vm/image.h"

namespace oncard::runtime {

struct ProgramNames {
  std::shared_ptr<const vm::Image> image;
  struct Binding {
    bool bound = false;
    uint8_t function = 0;
    uint8_t page = 0;
    bool operator==(const Binding&) const = default;
  };
  std::array<Binding, vm::kThreadCount> bindings = {};

  static ProgramNames Of(const Controller& controller);
  bool operator==(const ProgramNames&) const = default;
};

}  // namespace oncard::runtime
