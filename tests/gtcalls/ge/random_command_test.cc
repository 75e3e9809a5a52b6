// Random sequences of all GE commands: nothing fails, codes are those of the manual, and planned
// motion keeps within the ranges of its registers. ONCARD_RANDOM_CALLS makes the sequences longer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "gtcalls/card_elements.h"
#include "tests/gtcalls/ge/ge_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ge {
namespace {

int CallCount() {
  const char* count = std::getenv("ONCARD_RANDOM_CALLS");
  return count != nullptr ? std::atoi(count) : 4000;
}

class RandomCalls : public testing::TestWithParam<const char*> {
 protected:
  /// A value that a command takes, one at the end of its range, or any.
  double ValueOf(const Parameter& parameter) {
    const auto below = [this](int end) {
      return static_cast<int>(random_() % static_cast<unsigned>(end));
    };
    if (parameter.axis_number) return below(40) == 0 ? below(12) : 1 + below(card_axes_);
    const double low = std::isfinite(parameter.minimum) ? parameter.minimum : -40000;
    const double high = std::isfinite(parameter.maximum) ? parameter.maximum : 70000;
    double value = 0;
    switch (below(8)) {
      case 0:
        value = low;
        break;
      case 1:
        value = high;
        break;
      case 2:
        value = low - 1;
        break;
      case 3:
        value = low + (high - low) * below(1000) / 1000;
        break;
      default:
        value = below(200) / 10.0;
    }
    return parameter.type == Scalar::kDouble ? value : std::floor(value);
  }

  /// As many as any pointer of the command needs.
  static size_t CellsOf(const Command& command, const GeTestCard& card) {
    size_t cells = kAxisMax;
    for (const Parameter& parameter : command.parameters) {
      if (parameter.passing != Passing::kHostMemory) continue;
      cells = ElementsOnCard(parameter, card.card, 0) * CellsPerElement(parameter);
    }
    return cells;
  }

  std::mt19937 random_{20260101};
  int card_axes_ = 0;
};

TEST_P(RandomCalls, NeverFail) {
  GeTestCard card(GetParam());
  card_axes_ = card.motion.config().axis_count;
  const auto commands = card.family.catalogue.commands();
  const int calls = CallCount();
  for (int i = 0; i < calls; ++i) {
    const Command& command = commands[random_() % commands.size()];
    if (!card.family.Executes(command)) continue;
    std::vector<double> values;
    for (const Parameter& parameter : command.parameters) {
      if (parameter.passing == Passing::kValue) values.push_back(ValueOf(parameter));
    }
    std::vector<double> cells(CellsOf(command, card), static_cast<double>(random_() % 128));
    const int16_t code = card.Call(command.name, values, &cells);
    ASSERT_TRUE(code >= -1 && code <= 9 && code != 6 && code != 8) << command.name << ' ' << code;
    // The last velocity of a calculation is code 1, too.
    if (command.name != "GT_GetCmdSts" && !command.name.starts_with("GT_CalVel")) {
      ASSERT_EQ(card.Cause() == 0, code == 0) << command.name;
    }
    if (random_() % 16 == 0) {
      const auto bit = static_cast<int>(random_() % 8);
      ChangeState(card.motion)
          .io.SetPin(static_cast<motion::DiType>(random_() % 5), bit, random_() % 2 == 0);
    }
    for (auto cycles = random_() % 20; cycles > 0; --cycles) card.Cycle();
    for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
      const motion::Sample& now = card.motion.profile(axis).now;
      ASSERT_LE(std::fabs(now.velocity), 40958.001) << command.name;
      ASSERT_LE(std::fabs(now.acceleration), 102400.001) << command.name;
      ASSERT_TRUE(std::isfinite(now.position)) << command.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cards, RandomCalls,
                         testing::Values("GE-800-PG", "GE-800-PV", "GE-200-PG", "GE-300-PV",
                                         "GE-300-SG", "GE-400-SV", "GE-200-SV"),
                         [](const auto& card) {
                           std::string name = card.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace oncard::gtcalls::ge
