// "Did you mean": the candidate nearest to a misspelt name.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace oncard::runtime {

/// The candidate that the fewest insertions, deletions, exchanges and swaps of neighbours turn the
/// name into; empty when even the best needs more than a third of the name's length (at least one).
/// Of equally near ones the first.
std::string_view NearestName(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace oncard::runtime
