// The entry points that libFuzzer calls. ONCARD_FUZZ_TARGET names the target.
#include <algorithm>
#include <cstring>
#include <iterator>

#include "tests/fuzz/fuzz.h"

// A function of libFuzzer.
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace oncard::fuzz {
namespace {

struct Target {
  std::string_view name;
  void (*run)(std::string_view);
};

constexpr Target kTargets[] = {
    {"source", FuzzSource},
    {"structured", FuzzStructured},
    {"object", FuzzObject},
    {"disassembler", FuzzDisassembler},
    {"scenario", FuzzScenario},
    {"schedule", FuzzSchedule},
    {"search", FuzzSearch},
    {"config", FuzzConfig},
    {"eni", FuzzEni},
    {"requirement", FuzzRequirement},
    {"session", FuzzSession},
    {"commands", FuzzCommands},
    {"threads", FuzzCommandsOfThreads},
    {"families", FuzzFamilies},
    {"calls", FuzzCalls},
};

const Target* ChosenTarget() {
  const char* name = std::getenv("ONCARD_FUZZ_TARGET");
  const auto* found =
      std::find_if(std::begin(kTargets), std::end(kTargets),
                   [name](const Target& target) { return name != nullptr && target.name == name; });
  return found == std::end(kTargets) ? nullptr : found;
}

const Target* target = nullptr;

}  // namespace
}  // namespace oncard::fuzz

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  using namespace oncard::fuzz;  // NOLINT: the names belong together
  target = ChosenTarget();
  if (target != nullptr) return 0;
  std::fprintf(stderr, "ONCARD_FUZZ_TARGET must be one of:");
  for (const Target& each : kTargets) std::fprintf(stderr, " %s", each.name.data());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  oncard::fuzz::target->run({reinterpret_cast<const char*>(data), size});
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size,
                                          unsigned seed) {
  // Every fourth mutation changes bytes, to test the JSON parser too.
  if (oncard::fuzz::target->name != "search" || seed % 4 == 0) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  return oncard::fuzz::MutateSearch(data, size, max_size, seed);
}
