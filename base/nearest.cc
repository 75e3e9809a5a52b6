// Tested by tests/base/nearest_test.cc.
#include "base/nearest.h"

#include <algorithm>
#include <cctype>

namespace oncard {
namespace {

// Edits are counted in halves, so that a letter in the wrong case is half an edit.
constexpr int kEdit = 2;
constexpr int kCaseEdit = 1;
// Longer names are not compared: the distance costs the product of the lengths.
constexpr size_t kComparedMax = 40;

int Distance(std::string_view a, std::string_view b, int limit) {
  const size_t longer = std::max(a.size(), b.size());
  const size_t shorter = std::min(a.size(), b.size());
  if (longer > kComparedMax || static_cast<int>(longer - shorter) * kEdit > limit) {
    return limit + 1;
  }
  // Optimal string alignment: insert, delete, replace, swap neighbours.
  int rows[3][kComparedMax + 1];
  for (size_t j = 0; j <= b.size(); ++j) rows[0][j] = static_cast<int>(j) * kEdit;
  for (size_t i = 1; i <= a.size(); ++i) {
    int* const row = rows[i % 3];
    const int* const above = rows[(i + 2) % 3];
    const int* const above2 = rows[(i + 1) % 3];
    row[0] = static_cast<int>(i) * kEdit;
    for (size_t j = 1; j <= b.size(); ++j) {
      const char x = a[i - 1];
      const char y = b[j - 1];
      const bool same_letter = std::tolower(static_cast<unsigned char>(x)) ==
                               std::tolower(static_cast<unsigned char>(y));
      const int replace = x == y ? 0 : same_letter ? kCaseEdit : kEdit;
      row[j] = std::min({above[j] + kEdit, row[j - 1] + kEdit, above[j - 1] + replace});
      if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y) {
        row[j] = std::min(row[j], above2[j - 2] + kEdit);
      }
    }
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

Nearest::Nearest(std::string_view wanted)
    : wanted_(wanted),
      // One edit in short names, one in three letters in long ones.
      limit_(wanted.size() <= 1 ? kCaseEdit
                                : std::max(kEdit, static_cast<int>(wanted.size()) / 3 * kEdit)) {}

void Nearest::Add(std::string_view candidate) {
  const int distance = Distance(wanted_, candidate, limit_);
  if (distance > limit_ || distance == 0) return;
  limit_ = distance - 1;
  best_ = candidate;
}

std::string_view NearestName(std::string_view name, std::span<const std::string_view> candidates) {
  Nearest nearest(name);
  for (const std::string_view candidate : candidates) nearest.Add(candidate);
  return nearest.best();
}

}  // namespace oncard
