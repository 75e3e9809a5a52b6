// Random programs with a card for the explorer's tests, with what must hold.
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace oncard::explore {

/// Two or three threads, most of which use things of their own only.
class RandomMachine {
 public:
  explicit RandomMachine(uint64_t seed) : RandomMachine(seed, false) {}
  /// With a global `sum` that its threads only add to, and that is asked for at the end.
  static RandomMachine ThatCounts(uint64_t seed) { return {seed, true}; }

  const std::string& source() const { return source_; }
  /// Further lines of the scenario.
  const std::string& keys() const { return keys_; }

 private:
  RandomMachine(uint64_t seed, bool counts);
  int Draw(int count) { return static_cast<int>(random_() % static_cast<uint64_t>(count)); }
  /// Seldom that of another thread.
  int ThingOf(int thread) { return Draw(14) == 0 ? Draw(threads_) : thread; }
  void AddThread(int thread);
  void AddStatement(int thread, int number);
  std::string Condition();
  void AddCount(int number);
  void AddKeys();

  std::mt19937_64 random_;
  bool counts_;
  int threads_;
  std::string source_;
  std::string keys_;
};

}  // namespace oncard::explore
