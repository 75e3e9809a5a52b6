// Extension modules: 16 digital inputs and outputs and analogue channels each.
//
// Assumption: unless something else is specified, all modules are present, with inputs that read 0,
// so that host programs that use modules run unchanged; if modules are listed, only those are
// present. Assumption: 8 analogue channels from 0, converter values 0 to 65535 for -10 to 10 V
// (unsigned in the public header). Tested by tests/motion/extension_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace oncard::motion {

inline constexpr size_t kModuleCount = 16;
inline constexpr size_t kModuleChannels = 8;
inline constexpr double kModuleFullVolts = 10;

struct ExtensionModule {
  bool present = true;  ///< from outside the card
  uint16_t inputs = 0;  ///< from outside the card
  uint16_t outputs = 0;
  std::array<double, kModuleChannels> input_volts{};  ///< from outside the card
  std::array<double, kModuleChannels> output_volts{};

  auto Fields(auto visit) const {
    return visit(present, inputs, outputs, input_volts, output_volts);
  }
};

/// The converter's value of a voltage, and the voltage of a value. Volts outside +-10 are limited.
uint16_t ModuleValue(double volts);
double ModuleVolts(uint16_t value);

}  // namespace oncard::motion
