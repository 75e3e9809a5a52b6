// Damaged configuration files: whatever a file contains, reading and applying it must not access
// memory outside the card, and the positions of a card that runs with it must be numbers. Also
// meant for the build with sanitizers. A failure prints its seed.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "gtcalls/gts/card_config.h"
#include "tests/gtcalls/axis_command_support.h"

namespace oncard::gtcalls::gts {
namespace {

/// The kinds of files that hosts use.
enum class Shape { kPulses, kServo, kNoLimits, kSwitches };

void Add(std::string& text, std::string_view section, int number, std::string_view keys) {
  text += '[';
  text += section;
  text += std::to_string(number) + "]\n";
  text += keys;
}

/// A complete file for eight axes.
std::string ConfigOf(Shape shape) {
  std::string text;
  for (int i = 1; i <= 8; ++i) {
    const std::string number = std::to_string(i);
    const std::string limit = shape == Shape::kNoLimits ? "-1" : number;
    Add(text, "profile", i, "active=1\ndecSmoothStop=0.062500\ndecAbruptStop=1.000000\n");
    Add(text, "axis", i,
        "active=1\nalarmType=2\nalarmIndex=" + limit +
            "\nlimitPositiveType=0\nlimitPositiveIndex=" + limit +
            "\nlimitNegativeType=1\nlimitNegativeIndex=" + limit +
            "\nsmoothStopType=4\nsmoothStopIndex=-1\nabruptStopType=4\nabruptStopIndex=-1\n"
            "prfMap=0x" +
            std::to_string(i <= 3 ? 1 << (i - 1) : 8) +
            "\nencMap=0x1\nprfMapAlpha1=1\nprfMapBeta1=1\nencMapAlpha1=1\nencMapBeta1=1\n");
    Add(text, "control", i,
        "active=1\naxis=" + number + "\nencoder1=" + number +
            "\nencoder2=-1\nerrorLimit=32767\nfilterType1=0\n");
    Add(text, "dac", i,
        "active=1\ncontrol=" + (shape == Shape::kServo ? number : "-1") +
            "\nreverse=0\nbias=0\nlimit=32767\n");
    Add(text, "step", i, "active=1\naxis=" + number + "\nmode=0\nparameter=0\nreverse=0\n");
    Add(text, "encoder", i,
        "active=1\nreverse=1\nfilterType=" + std::string(shape == Shape::kPulses ? "1" : "0") +
            "\ncaptureSource=0\n");
    Add(text, "enable", i, "active=1\naxis=" + number + "\naxisItem=0\nreverse=0\n");
    for (const std::string_view word : {"limitPositive", "limitNegative", "alarm", "home", "gpi"}) {
      const bool reversed = shape == Shape::kSwitches && word != "gpi";
      Add(text, word, i, reversed ? "reverse=1\nfilterTime=3\n" : "reverse=0\nfilterTime=3\n");
    }
  }
  return text;
}

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  void Apply(std::string& text) {
    for (int i = 1 + Choose(30); i > 0 && !text.empty(); --i) Once(text);
  }

 private:
  int Choose(size_t count) { return static_cast<int>(random_() % count); }
  size_t Place(const std::string& text) { return random_() % text.size(); }

  void Once(std::string& text) {
    constexpr std::string_view kValues[] = {
        "65536", "0xFFFFFFFF", "4294967295", "-1", "1e308", "-1e308", "5e-324", "nan",
        "inf",   "0.5",        "2147483648", "0",  "13",    "127",    "-32768", "0x"};
    switch (Choose(4)) {
      case 0: {  // another value
        const size_t equals = text.find('=', Place(text));
        if (equals == std::string::npos) return;
        const size_t end = std::min(text.find('\n', equals), text.size());
        text.replace(equals + 1, end - equals - 1, kValues[Choose(std::size(kValues))]);
        return;
      }
      case 1:  // another byte
        text[Place(text)] = static_cast<char>(Choose(256));
        return;
      case 2: {  // a part left out
        const size_t begin = Place(text);
        text.erase(begin, static_cast<size_t>(Choose(200)));
        return;
      }
      default: {  // a part duplicated
        const size_t begin = Place(text);
        text.insert(Place(text), text.substr(begin, static_cast<size_t>(Choose(200))));
        return;
      }
    }
  }

  std::mt19937 random_;
};

/// Every axis enabled and moved.
void RunCard(AxisCommandCard& card) {
  for (int axis = 1; axis <= card.motion.config().axis_count; ++axis) {
    card.Call("GT_ClrSts", {axis, 1});
    card.Call("GT_AxisOn", {axis});
    card.Call("GT_SetPos", {axis, 1000});
    card.Call("GT_SetVel", {axis, 10.0});
    card.Call("GT_Update", {1 << (axis - 1)});
  }
  card.Cycles(20);
  card.Call("GT_Stop", {0xFF, 0});
  card.Cycles(20);
  for (int axis = 1; axis <= card.motion.config().axis_count; ++axis) {
    card.Call("GT_ZeroPos", {axis, 1});
    for (const std::string_view command : {"GT_GetPrfPos", "GT_GetAxisPrfPos", "GT_GetEncPos"}) {
      EXPECT_TRUE(std::isfinite(card.Read(command, axis))) << command << " of axis " << axis;
    }
  }
}

TEST(DamagedConfig, KeepsInsideTheCard) {
  for (unsigned seed = 1; seed <= 2000 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::string text = ConfigOf(static_cast<Shape>(seed % 4));
    Damage(seed).Apply(text);
    constexpr int kAxes[] = {4, 8, 12};
    AxisCommandCard card({.axis_count = kAxes[seed / 4 % 3], .cycle_us = 1000});
    ApplyCardConfig(ParseCardConfig(text), &card.motion);
    RunCard(card);
  }
}

TEST(DamagedConfig, AMapBeyondTheCardsProfilesMapsNothing) {
  AxisCommandCard card;
  const CardConfig config = ParseCardConfig("[axis1]\nprfMap=65536\nencMap=0x10000\n");
  ApplyCardConfig(config, &card.motion);
  EXPECT_EQ(card.motion.state().axes[0].profile_map, 0u);
  EXPECT_EQ(card.motion.state().axes[0].encoder_map, 0u);
  RunCard(card);
}

TEST(DamagedConfig, ARatioBelowOneIsNoRatio) {
  AxisCommandCard card;
  ApplyCardConfig(ParseCardConfig("[axis1]\nprfMapAlpha1=0.5\nprfMapBeta1=0.5\n"), &card.motion);
  EXPECT_EQ(card.motion.state().axes[0].profile_scale, motion::Scale{});
}

}  // namespace
}  // namespace oncard::gtcalls::gts
