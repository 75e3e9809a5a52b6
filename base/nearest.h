// "Did you mean": the candidate most similar to a misspelt name.
#pragma once

#include <span>
#include <string_view>

namespace oncard {

/// The most similar of the candidates, if one is similar enough to be the intended name: the
/// candidate with the fewest insertions, deletions, exchanges and swaps of neighbours (letter case
/// counts little), at most one in three letters; the first of several. Add() all, then ask.
class Nearest {
 public:
  /// `wanted` must outlive the search.
  explicit Nearest(std::string_view wanted);
  void Add(std::string_view candidate);
  /// Empty if nothing is similar enough.
  std::string_view best() const { return best_; }

 private:
  std::string_view wanted_;
  int limit_;
  std::string_view best_;
};

/// The same for candidates in one list.
std::string_view NearestName(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace oncard
