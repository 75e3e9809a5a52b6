// How the benchmarks measure: each work is repeated, and its shortest time counts, because other
// work on the computer can only make it longer. Contenders take turns, so that what slows the
// computer down for a while slows all of them down.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace oncard::bench {

/// Ends the program with 1: what was measured did not do what it should.
[[noreturn]] void Fail(const std::string& why);

enum class Clock {
  kCpu,       ///< processor time of this process
  kChildren,  ///< processor time of the processes that the work starts and waits for
  kWall,
};

/// The seconds of each repetition.
using Samples = std::vector<double>;

/// Shortest CPU seconds of `work`.
double MeasureCpu(const std::function<void()>& work);
/// Shortest wall-clock seconds of `work`.
double MeasureWall(const std::function<void()>& work);
/// Lets the contenders work in turns, one repetition each; the samples of each. Those that need
/// much memory say how many bytes at most: a virtual computer has returned what was free for a
/// while to its host, and gets it back slowly, so that as much is used before each repetition.
std::vector<Samples> MeasureInTurns(Clock clock,
                                    const std::vector<std::function<void()>>& contenders,
                                    size_t memory = 0);

double Shortest(const Samples& samples);

/// How long one contender takes, relative to another.
struct Ratio {
  double shortest = 0;  ///< of the shortest times
  double low = 0;       ///< the smallest and the largest ratio of two neighbouring repetitions
  double high = 0;
};
Ratio RatioOf(const Samples& samples, const Samples& reference);

double GeometricMean(const std::vector<double>& values);

/// `oncard_bench vm`: how fast statements are executed, beside Lua and gcc, and compiled.
void BenchVm();

/// A part of BenchVm(): how long compiling and lowering take.
void BenchCompiler();

/// `oncard_bench run`: how long whole runs take, and what recording them costs.
void BenchRun();

/// A part of BenchRun(): how fast host programs run. Files are written into the folder.
void BenchHosts(const std::string& folder);

/// `oncard_bench motion`: what a profile cycle and a command cost.
void BenchMotion();

/// `oncard_bench explore`: how fast interleavings are searched, beside SPIN.
void BenchExplore();

/// A part of BenchExplore(): whole machines, with their card and its world.
void BenchCardSearches();

/// `oncard_bench editor`: how long requests about a source take.
void BenchEditor();

/// `oncard_bench session`: how fast a session goes back.
void BenchSession();

}  // namespace oncard::bench
