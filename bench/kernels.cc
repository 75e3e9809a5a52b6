#include "bench/kernels.h"

#include "bench/measure.h"
#include "bench/native_kernels.h"
#include "compiler/compiler.h"

namespace oncard::bench {
namespace {

double FromRaw(int64_t raw) { return static_cast<double>(raw) / 65536; }

}  // namespace

const KernelSet& OwnKernels() {
  static const KernelSet set = {
      "",
      ONCARD_KERNELS,
      ONCARD_KERNELS "/kernels.lua",
      {
          {"sum", "end", 20'000'000, [] { return NativeSum(20'000'000); }},
          {"multiply_accumulate", "n", 20'000'000,
           [] { return FromRaw(NativeMultiplyAccumulate(20'000'000)); }},
          {"prefix_sum", "n", 20'000, [] { return NativePrefixSum(20'000); }},
          {"collatz", "n", 100'000, [] { return NativeCollatz(100'000); }},
      }};
  return set;
}

const KernelSet& HeldOutKernels() {
  static const KernelSet set = {
      "held-out ",
      ONCARD_KERNELS "/held_out",
      ONCARD_KERNELS "/held_out.lua",
      {
          {"gcd", "n", 1'000'000, [] { return NativeGcd(1'000'000); }},
          {"sieve", "n", 3000, [] { return NativeSieve(3000); }},
          {"hash_mix", "n", 10'000'000, [] { return NativeHashMix(10'000'000); }},
          {"biquad", "n", 4'000'000, [] { return FromRaw(NativeBiquad(4'000'000)); }},
          {"bubble_sort", "n", 500, [] { return NativeBubbleSort(500); }},
          {"plc", "n", 5'000'000, [] { return NativePlc(5'000'000); }},
      }};
  return set;
}

std::shared_ptr<const vm::Image> LoadProgram(const std::string& path,
                                             const vm::CommandTable& commands) {
  const auto compilation = compiler::Compile(path);
  if (!compilation.ok()) Fail("cannot compile " + path);
  auto image = vm::LinkObject(*compilation.object, commands);
  if (!image.ok()) Fail(image.error().message.en);
  return std::move(image).value();
}

void StartKernel(vm::Machine& machine, const vm::Image& image, const Kernel& kernel, int thread,
                 int function, int32_t size) {
  machine.Bind(thread, function + 1, thread);
  const auto set = [&](const char* name, int32_t value) {
    const vm::Symbol* symbol = vm::FindLocal(image, function, name);
    if (symbol == nullptr) return;
    machine.WriteRaw({false, static_cast<uint8_t>(thread), symbol->id, vm::DataType::kInt}, value);
  };
  set(kernel.parameter, size);
  set("begin", 1);
  machine.Run(thread);
}

}  // namespace oncard::bench
