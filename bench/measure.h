// How the benchmarks measure: the median of several repetitions, CPU time or wall-clock time.
#pragma once

#include <functional>
#include <string>

namespace oncard::bench {

/// Ends the program with 1: what was measured did not do what it should.
[[noreturn]] void Fail(const std::string& why);

/// Median CPU seconds of `work`.
double MeasureCpu(const std::function<void()>& work);
/// Median wall-clock seconds of `work`.
double MeasureWall(const std::function<void()>& work);

/// `oncard_bench motion`: what a profile cycle and a command cost.
void BenchMotion();

/// `oncard_bench explore`: how fast interleavings are searched, beside SPIN.
void BenchExplore();

/// `oncard_bench editor`: how long requests about a source take.
void BenchEditor();

/// `oncard_bench session`: how fast a session goes back.
void BenchSession();

}  // namespace oncard::bench
