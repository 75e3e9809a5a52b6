// How many random cases a test tries.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace oncard {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

/// The percentage of the random cases that is tried. The plain build shows that a property holds; a
/// sanitizer watches the code that the cases run, which a tenth of them runs, too.
/// ONCARD_RANDOM_CASES sets another one: 1000 tries ten times as many.
inline int PercentOfRandomCases() {
  const char* given = std::getenv("ONCARD_RANDOM_CASES");
  if (given != nullptr) return std::atoi(given);
  return kSanitized ? 10 : 100;
}

/// How many cases a test tries that has `all` of them: three at least, if it has as many.
template <typename Number>
Number RandomCases(Number all) {
  const auto percent = static_cast<Number>(PercentOfRandomCases());
  return std::max<Number>(all * percent / 100, std::min<Number>(all, 3));
}

/// How many of the tried cases a test expects to have something that `least` of all have. Chance is
/// larger among few: if fewer are tried than all, half of their share.
template <typename Number>
Number LeastOfCases(Number least) {
  const auto percent = static_cast<Number>(PercentOfRandomCases());
  return percent < 100 ? least * percent / 200 : least * percent / 100;
}

/// As RandomCases(), of cases that there are already.
inline size_t RandomPart(size_t all) { return std::min(RandomCases(all), all); }

}  // namespace oncard
