// Registers that wait for an Update: what they take, and what they give. Source: GT manual 4.3,
// chapter 11.
#include <gtest/gtest.h>

#include <limits>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

/// The commands of a register.
std::string Get(const std::string& name) { return "GT_Get" + name; }
std::string Set(const std::string& name) { return "GT_Set" + name; }

TEST(Gt400Register, KeepsTheValuesWithinItsRange) {
  const struct {
    const char* mode;
    const char* name;
    std::vector<double> values;
  } cases[] = {
      {"GT_PrflT", "Pos", {-1073741824, 0, 1073741823}},
      {"GT_PrflT", "Vel", {0, 16384}},
      {"GT_PrflS", "Vel", {0, 16384}},
      {"GT_PrflV", "Vel", {-16384, 0, 16384}},
      {"GT_PrflT", "Acc", {0, 16384}},
      {"GT_PrflV", "Acc", {0, 16383.99}},
      {"GT_PrflT", "MAcc", {0, 0.4999}},
      {"GT_PrflT", "Jerk", {0, 2e-8, 0.4999}},
  };
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Do(c.mode);
    EXPECT_EQ(card.Read(Get(c.name)), 0) << c.name;
    for (const double value : c.values) {
      card.Do(Set(c.name), {value});
      EXPECT_EQ(card.Read(Get(c.name)), value) << c.name;
    }
  }
}

TEST(Gt400Register, RefusesOtherValues) {
  const struct {
    const char* mode;
    const char* name;
    CommandCause cause;
    std::vector<double> values;
  } cases[] = {
      {"GT_PrflT", "Pos", kOverflow, {-1073741825, 1073741824}},
      {"GT_PrflT", "Vel", kOverflow, {-16384.01, 16384.01}},
      {"GT_PrflT", "Vel", kIllegal, {-0.01, -16384}},
      {"GT_PrflS", "Vel", kIllegal, {-1}},
      {"GT_PrflV", "Vel", kOverflow, {-16384.01, 16384.01}},
      {"GT_PrflT", "Acc", kOverflow, {16384.01}},
      {"GT_PrflV", "Acc", kOverflow, {16384}},
      {"GT_PrflT", "Acc", kIllegal, {-0.01}},
      {"GT_PrflS", "MAcc", kIllegal, {-1e-9, 0.5, 16385}},
      {"GT_PrflS", "Jerk", kIllegal, {-1e-9, 0.5}},
  };
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Do(c.mode);
    for (const double value : c.values) {
      card.Refuses(c.cause, Set(c.name), {value});
      EXPECT_EQ(card.Read(Get(c.name)), 0) << c.name;
    }
  }
}

TEST(Gt400Register, TakesNoNumberThatIsNone) {
  for (const char* name : {"Vel", "Acc", "MAcc", "Jerk"}) {
    Gt400TestCard().RefusesParameter(Set(name), {std::numeric_limits<double>::quiet_NaN()});
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
