#include "gtcalls/gts/numbers.h"

#include <algorithm>
#include <iterator>

namespace oncard::gtcalls {
namespace {

using motion::DiType;
using motion::DoType;
using motion::HomeError;
using motion::HomeMode;
using motion::HomeStage;

template <typename Name>
struct Row {
  int number;
  Name name;
};

constexpr Row<DiType> kInputWords[] = {
    {0, DiType::kLimitPositive}, {1, DiType::kLimitNegative}, {2, DiType::kAlarm},
    {3, DiType::kHome},          {4, DiType::kGpi},           {5, DiType::kArrive},
    {6, DiType::kMpg},
};

constexpr Row<DoType> kOutputWords[] = {
    {10, DoType::kEnable}, {11, DoType::kClear}, {12, DoType::kGpo}};

constexpr Row<HomeMode> kHomeModes[] = {
    {0, HomeMode::kNone},
    {10, HomeMode::kLimit},
    {11, HomeMode::kLimitHome},
    {12, HomeMode::kLimitIndex},
    {13, HomeMode::kLimitHomeIndex},
    {20, HomeMode::kHome},
    {22, HomeMode::kHomeIndex},
    {30, HomeMode::kIndex},
    {40, HomeMode::kForcedHome},
    {41, HomeMode::kForcedHomeIndex},
};

constexpr Row<HomeStage> kHomeStages[] = {
    {0, HomeStage::kIdle},
    {1, HomeStage::kStart},
    {2, HomeStage::kEscape},
    {10, HomeStage::kSearchLimit},
    {11, HomeStage::kSearchLimitStop},
    {13, HomeStage::kLimitEscape},
    {15, HomeStage::kLimitReturn},
    {16, HomeStage::kLimitReturnStop},
    {20, HomeStage::kSearchHome},
    {22, HomeStage::kSearchHomeStop},
    {25, HomeStage::kHomeReturn},
    {30, HomeStage::kSearchIndex},
    {80, HomeStage::kGoHome},
    {100, HomeStage::kEnd},
};

constexpr Row<HomeError> kHomeErrors[] = {
    {0, HomeError::kNone},     {1, HomeError::kNotTrap},
    {2, HomeError::kDisabled}, {3, HomeError::kAlarm},
    {4, HomeError::kStop},     {5, HomeError::kStage},
    {6, HomeError::kMode},     {7, HomeError::kSetCaptureHome},
    {8, HomeError::kNoHome},   {9, HomeError::kSetCaptureIndex},
    {10, HomeError::kNoIndex},
};

template <typename Name, size_t kSize>
std::optional<Name> NameIn(const Row<Name> (&rows)[kSize], int number) {
  const auto* row = std::find_if(std::begin(rows), std::end(rows),
                                 [&](const auto& r) { return r.number == number; });
  return row == std::end(rows) ? std::nullopt : std::optional(row->name);
}

/// The tables name every enumerator.
template <typename Name, size_t kSize>
int NumberIn(const Row<Name> (&rows)[kSize], Name name) {
  return std::find_if(std::begin(rows), std::end(rows),
                      [&](const auto& r) { return r.name == name; })
      ->number;
}

}  // namespace

std::optional<DiType> DiTypeOf(int number) { return NameIn(kInputWords, number); }
std::optional<DoType> DoTypeOf(int number) { return NameIn(kOutputWords, number); }

HomeMode HomeModeOf(int number) { return NameIn(kHomeModes, number).value_or(HomeMode::kNone); }
int HomeNumber(HomeMode mode) { return NumberIn(kHomeModes, mode); }
int HomeNumber(HomeStage stage) { return NumberIn(kHomeStages, stage); }
int HomeNumber(HomeError error) { return NumberIn(kHomeErrors, error); }

}  // namespace oncard::gtcalls
