// A part of `oncard_bench vm`: how long it takes to compile a long program, and to lower and check
// one in structured C. CPU time.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "base/files.h"
#include "bench/measure.h"
#include "compiler/compiler.h"
#include "compiler/lowering/lowering.h"
#include "vm/limits.h"

namespace oncard::bench {
namespace {

void MeasureCompiler() {
  constexpr int kStatements = 10'000;
  std::string text = "int a[100];\nint f(int n)\n{\n    int i, x, cc;\n    i = 0;\n";
  for (int i = 0; i < kStatements / 5; ++i) {
    text += fmt::format(
        "l{0}:\n    x = i * {1};\n    cc = x > n;\n    if (cc) goto l{0};\n    a[{2}] = x;\n"
        "    i = i + 1;\n",
        i % 1000, i, i % 100);
    if (i % 1000 == 999)
      text += "    return i;\n}\nint f" + std::to_string(i) +
              "(int n)\n{\n    int i, x, cc;\n    i = 0;\n";
  }
  text += "    return i;\n}\n";
  const double seconds = MeasureCpu([&] {
    const auto compilation = compiler::CompileText("big.c", text, {}, compiler::ReadSource);
    if (!compilation.ok()) Fail("the generated program does not compile");
  });
  std::printf("compile %d statements: %.1f ms\n", kStatements, seconds * 1e3);
}

// A program of structured C with 10 000 lines, in ten thread functions.
void MeasureLowering() {
  constexpr int kFunctions = 10;
  constexpr int kParts = 100;
  std::string text = "int a[100], m[8][8], limit;\ndouble gain;\n\n";
  for (int f = 0; f < kFunctions; ++f) {
    text += fmt::format("int f{}(int n) {{\n  int i, x = 0;\n  double y = 0.5;\n", f);
    for (int part = 0; part < kParts; ++part) {
      text += fmt::format(
          "  for (i = 0; i < n; i++) {{\n    if (a[i] > limit && x != {0}) {{\n"
          "      x += a[i] * {0} - (i & 3);\n    }} else {{\n      m[i & 7][x & 7] = -x;\n    }}\n"
          "    y = y * gain + i;\n  }}\n  a[{0}] = x > {0} ? x : (int)y;\n\n",
          part);
    }
    text += "  return x;\n}\n\n";
  }
  const double seconds = MeasureCpu([&] {
    const auto lowering =
        compiler::LowerText("big.c", text, {}, compiler::LoweringOptions(), compiler::ReadSource);
    if (!lowering.text) Fail("the generated program cannot be lowered");
  });
  std::printf("lower and check %ld lines of structured C: %.1f ms\n",
              static_cast<long>(std::count(text.begin(), text.end(), '\n')), seconds * 1e3);
}

// 32 thread functions with 100 calls each, which are inlined or become jumps, with the passes and
// without them in turns. The argument is known, so that each call decides what the next one does,
// or it is not.
void MeasureCalls(const char* what, const char* thread) {
  std::string text =
      "int total[32];\nstatic int clamp(int v, int lo, int hi) {\n  if (v < lo) return lo;\n"
      "  if (v > hi) return hi;\n  return v;\n}\n"
      "static int scale(int v, int k) { return clamp(v * k / 3, -1000, 1000); }\n";
  for (int t = 0; t < vm::kThreadCount; ++t) {
    text += fmt::format(fmt::runtime(thread), t);
    for (int call = 0; call < 100; ++call) text += fmt::format("  x += scale(x, {});\n", call);
    text += fmt::format("  total[{}] = x;\n}}\n\n", t);
  }
  const auto lower = [&text](bool optimize) {
    return [&text, options = compiler::LoweringOptions{.optimize = optimize}] {
      const auto lowering = compiler::LowerText("calls.c", text, {}, options, compiler::ReadSource);
      if (!lowering.text) Fail("the generated program cannot be lowered");
    };
  };
  const auto samples = MeasureInTurns(Clock::kCpu, {lower(true), lower(false)});
  std::printf("lower and check 3200 calls, %s: %.0f ms, %.2f x --no-optimize\n", what,
              Shortest(samples[0]) * 1e3, RatioOf(samples[0], samples[1]).shortest);
}

}  // namespace

void BenchCompiler() {
  MeasureCompiler();
  MeasureLowering();
  MeasureCalls("their argument known", "void thread{}() {{\n  int x = 1;\n");
  MeasureCalls("their argument not known", "void thread{}(int x) {{\n");
}

}  // namespace oncard::bench
