// The kernels: the same computation as a motion program, in Lua and in C++.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::bench {

struct Kernel {
  const char* name;       ///< of the motion program's file and of the Lua function
  const char* parameter;  ///< the local variable with the size
  int32_t size;           ///< for the comparison
  std::function<double()> native;
};

/// A size so large that a thread does not end during a measurement.
inline constexpr int32_t kEndless = 2'000'000'000;

/// What belongs together: kernels with the same purpose and their sources.
struct KernelSet {
  const char* prefix;  ///< of the lines with the results
  std::string folder;  ///< of the motion programs
  std::string lua;     ///< the file with their Lua functions
  std::vector<Kernel> kernels;
};

/// The kernels that optimisations were chosen from.
const KernelSet& OwnKernels();
/// Kernels that no optimisation was chosen from.
const KernelSet& HeldOutKernels();

/// The motion program in this file below bench/kernels, linked.
std::shared_ptr<const vm::Image> LoadProgram(const std::string& path,
                                             const vm::CommandTable& commands);

/// Binds a function of `image` to a thread on the page of the same number, gives it its size and
/// starts it.
void StartKernel(vm::Machine& machine, const vm::Image& image, const Kernel& kernel, int thread,
                 int function, int32_t size);

}  // namespace oncard::bench
