// Digital inputs: pins, filter, sense, edge counters. Digital outputs: registers, masks, timed
// inversion, pulse trains.
#include "motion/io/digital_io.h"

#include <gtest/gtest.h>

#include <string>

namespace oncard::motion {
namespace {

constexpr DiType kGpi = DiType::kGpi;
constexpr DoType kGpo = DoType::kGpo;

void Sample(DigitalIo& io, int ticks) {
  for (int i = 0; i < ticks; ++i) io.SampleInputs();
}

bool Bit(uint32_t word, int bit) { return (word >> bit & 1) != 0; }

/// The level of an output after each of `ticks` ticks, as '0' and '1'.
std::string Trace(DigitalIo& io, DoType type, int bit, int ticks, int64_t cycle_us) {
  std::string levels;
  for (int i = 0; i < ticks; ++i) {
    io.AdvanceOutputs(cycle_us);
    levels += Bit(io.Register(type), bit) ? '1' : '0';
  }
  return levels;
}

TEST(DigitalInput, WordsHaveTheWidthsOfTheCard) {
  struct {
    DiType type;
    int width;
  } const words[] = {{DiType::kLimitPositive, 8},
                     {DiType::kLimitNegative, 8},
                     {DiType::kAlarm, 8},
                     {DiType::kHome, 8},
                     {DiType::kGpi, 16},
                     {DiType::kArrive, 8},
                     {DiType::kMpg, 7}};
  for (const auto& word : words) EXPECT_EQ(DiWidth(word.type), word.width);
}

TEST(DigitalOutput, WordsHaveTheWidthsOfTheCard) {
  EXPECT_EQ(DoWidth(DoType::kEnable), 8);
  EXPECT_EQ(DoWidth(DoType::kClear), 8);
  EXPECT_EQ(DoWidth(DoType::kGpo), 16);
}

TEST(DigitalInput, PinIsRawAndUnfiltered) {
  DigitalIo io;
  io.SetPin(kGpi, 5, true);
  EXPECT_EQ(io.Pins(kGpi), 0x20u);
  EXPECT_EQ(io.Read(kGpi), 0u);
}

TEST(DigitalInput, DefaultFilterLetsALevelThroughAtTheThirdTick) {
  DigitalIo io;
  io.SetPin(kGpi, 0, true);
  Sample(io, 2);
  EXPECT_EQ(io.Read(kGpi), 0u);
  Sample(io, 1);
  EXPECT_EQ(io.Read(kGpi), 1u);
}

TEST(DigitalInput, FilterTakesExactlyItsTicksForBothEdges) {
  for (const int ticks : {1, 2, 3, 4, 10, 500}) {
    DigitalIo io;
    io.SetFilterTicks(kGpi, 15, static_cast<uint16_t>(ticks));
    for (bool level : {true, false}) {
      io.SetPin(kGpi, 15, level);
      Sample(io, ticks - 1);
      EXPECT_EQ(Bit(io.Read(kGpi), 15), !level) << ticks;
      Sample(io, 1);
      EXPECT_EQ(Bit(io.Read(kGpi), 15), level) << ticks;
    }
  }
}

TEST(DigitalInput, FilterOfZeroActsAtTheFirstTick) {
  DigitalIo io;
  io.SetFilterTicks(kGpi, 0, 0);
  io.SetPin(kGpi, 0, true);
  Sample(io, 1);
  EXPECT_EQ(io.Read(kGpi), 1u);
}

TEST(DigitalInput, PulseShorterThanTheFilterIsInvisible) {
  DigitalIo io;
  io.SetPin(kGpi, 0, true);
  Sample(io, 2);
  io.SetPin(kGpi, 0, false);
  Sample(io, 1);
  io.SetPin(kGpi, 0, true);
  Sample(io, 2);
  EXPECT_EQ(io.Read(kGpi), 0u);
  EXPECT_EQ(io.Edges(kGpi, 0), 0u);
}

TEST(DigitalInput, EdgesCountBothChangesOfTheFilteredLevel) {
  DigitalIo io;
  for (int i = 0; i < 5; ++i) {
    io.SetPin(kGpi, 3, true);
    Sample(io, 3);
    io.SetPin(kGpi, 3, false);
    Sample(io, 3);
  }
  EXPECT_EQ(io.Edges(kGpi, 3), 10u);
  EXPECT_EQ(io.Edges(kGpi, 2), 0u);
}

TEST(DigitalInput, EdgeCounterIsPresetAndWrapsAt32Bits) {
  DigitalIo io;
  io.SetEdges(kGpi, 0, 0xFFFFFFFFu);
  io.SetPin(kGpi, 0, true);
  Sample(io, 3);
  EXPECT_EQ(io.Edges(kGpi, 0), 0u);
}

TEST(DigitalInput, SenseInvertsADrivenInputWithoutAnEdge) {
  DigitalIo io;
  io.SetPin(kGpi, 0, false);
  Sample(io, 3);
  io.SetInverted(kGpi, 1);
  EXPECT_EQ(io.Read(kGpi), 1u);
  EXPECT_EQ(io.Pins(kGpi), 0u);
  Sample(io, 10);
  EXPECT_EQ(io.Edges(kGpi, 0), 0u);
}

TEST(DigitalInput, UndrivenInputReadsZeroWhateverItsSense) {
  DigitalIo io;
  io.SetInverted(DiType::kLimitPositive, 0xFF);
  EXPECT_EQ(io.Read(DiType::kLimitPositive), 0u);
  EXPECT_EQ(io.Pins(DiType::kLimitPositive), 0xFFu);
  Sample(io, 5);
  EXPECT_EQ(io.Read(DiType::kLimitPositive), 0u);
  EXPECT_EQ(io.Edges(DiType::kLimitPositive, 0), 0u);
}

TEST(DigitalInput, SenseIsLimitedToTheInputsThatExist) {
  DigitalIo io;
  io.SetInverted(DiType::kMpg, 0xFFFF);
  EXPECT_EQ(io.inverted(DiType::kMpg), 0x7Fu);
}

TEST(DigitalInput, ResetKeepsThePinsAndSettlesTheFilters) {
  DigitalIo io;
  io.SetFilterTicks(kGpi, 0, 9);
  io.SetInverted(kGpi, 2);
  io.SetEdges(kGpi, 4, 7);
  io.SetPin(kGpi, 0, true);
  io.Reset();
  EXPECT_EQ(io.Read(kGpi), 1u);
  EXPECT_EQ(io.inverted(kGpi), 0u);
  EXPECT_EQ(io.Edges(kGpi, 4), 0u);
  io.SetPin(kGpi, 0, false);
  Sample(io, 3);
  EXPECT_EQ(io.Read(kGpi), 0u);
}

TEST(DigitalOutput, WriteChangesOnlyTheMaskedBits) {
  DigitalIo io;
  io.Write(kGpo, 0xFFFF, 0x0F0F);
  io.Write(kGpo, 0x00FF, 0x55AA);
  EXPECT_EQ(io.Register(kGpo), 0x0FAAu);
}

TEST(DigitalOutput, WriteIsLimitedToTheOutputsThatExist) {
  DigitalIo io;
  io.Write(DoType::kEnable, 0xFFFFFFFF, 0xFFFFFFFF);
  EXPECT_EQ(io.Register(DoType::kEnable), 0xFFu);
  io.Write(kGpo, 0xFFFFFFFF, 0xFFFFFFFF);
  EXPECT_EQ(io.Register(kGpo), 0xFFFFu);
}

TEST(DigitalOutput, PinsCarryTheConfiguredReversal) {
  DigitalIo io;
  io.SetOutputInverted(DoType::kEnable, 0xFF);
  io.Write(DoType::kEnable, 1, 1);
  EXPECT_EQ(io.Register(DoType::kEnable), 1u);
  EXPECT_EQ(io.OutputPins(DoType::kEnable), 0xFEu);
}

TEST(TimedReversal, FlipsAfterItsTimeAtEveryCycleLength) {
  // 6 x 250 us = 1500 us: the first tick that ends at or after 1500 us.
  struct {
    int64_t cycle_us;
    const char* levels;
  } const cases[] = {{125, "11111111111000"}, {250, "11111000"}, {500, "1100"},
                     {1000, "100"},           {1500, "00"},      {4000, "0"}};
  for (const auto& c : cases) {
    DigitalIo io;
    io.WriteForAWhile(kGpo, 7, true, 1500);
    EXPECT_TRUE(Bit(io.Register(kGpo), 7));
    const std::string expected = c.levels;
    EXPECT_EQ(Trace(io, kGpo, 7, static_cast<int>(expected.size()), c.cycle_us), expected)
        << c.cycle_us;
  }
}

TEST(TimedReversal, WorksForALowLevelToo) {
  DigitalIo io;
  io.Write(kGpo, 1, 1);
  io.WriteForAWhile(kGpo, 0, false, 500);
  EXPECT_EQ(Trace(io, kGpo, 0, 4, 250), "0111");
}

TEST(TimedReversal, TimeZeroNeverFlips) {
  DigitalIo io;
  io.WriteForAWhile(kGpo, 0, true, 0);
  EXPECT_EQ(Trace(io, kGpo, 0, 5, 250), "11111");
}

TEST(TimedReversal, ANewOneStartsTheTimeAgain) {
  DigitalIo io;
  io.WriteForAWhile(kGpo, 0, true, 750);
  EXPECT_EQ(Trace(io, kGpo, 0, 2, 250), "11");
  io.WriteForAWhile(kGpo, 0, true, 750);
  EXPECT_EQ(Trace(io, kGpo, 0, 4, 250), "1100");
}

TEST(TimedReversal, APlainWriteOfTheBitEndsIt) {
  DigitalIo io;
  io.WriteForAWhile(kGpo, 0, true, 500);
  io.Write(kGpo, 1, 1);
  EXPECT_EQ(Trace(io, kGpo, 0, 4, 250), "1111");
}

TEST(TimedReversal, AWriteOfOtherBitsLeavesIt) {
  DigitalIo io;
  io.WriteForAWhile(kGpo, 0, true, 500);
  io.Write(kGpo, 2, 2);
  EXPECT_EQ(Trace(io, kGpo, 0, 4, 250), "1000");
}

TEST(PulseTrain, HasTheAskedNumberOfPulsesAndPhases) {
  struct {
    bool first_level;
    int64_t pulses;
    const char* levels;  // after each tick of 250 us; high 500 us, low 250 us
  } const cases[] = {
      {true, 1, "100000"}, {true, 2, "10110000"},  {true, 3, "10110110000"},
      {false, 1, "1111"},  {false, 2, "11011111"},
  };
  for (const auto& c : cases) {
    DigitalIo io;
    io.StartPulses(kGpo, 0, 500, 250, c.pulses, c.first_level);
    EXPECT_EQ(Bit(io.Register(kGpo), 0), c.first_level);
    const std::string expected = c.levels;
    EXPECT_EQ(Trace(io, kGpo, 0, static_cast<int>(expected.size()), 250), expected);
  }
}

TEST(PulseTrain, ZeroPulsesGoOnForEver) {
  DigitalIo io;
  io.StartPulses(kGpo, 0, 250, 250, 0, true);
  EXPECT_EQ(Trace(io, kGpo, 0, 8, 250), "01010101");
}

TEST(PulseTrain, DoesNotDriftWhenThePhaseIsNoMultipleOfTheCycle) {
  // High 1500 us, low 1500 us, cycle 1000 us: the edges at 1.5, 3, 4.5, 6 ms appear at 2, 3, 5, 6
  // ms.
  DigitalIo io;
  io.StartPulses(kGpo, 0, 1500, 1500, 0, true);
  EXPECT_EQ(Trace(io, kGpo, 0, 6, 1000), "101101");
}

TEST(PulseTrain, SeveralFlipsFitIntoOneLongCycle) {
  // 250 us phases, cycle 1 ms: four edges per cycle do not change the level.
  DigitalIo io;
  io.StartPulses(kGpo, 0, 250, 250, 0, true);
  EXPECT_EQ(Trace(io, kGpo, 0, 3, 1000), "111");
  io.StartPulses(kGpo, 0, 250, 250, 2, true);
  EXPECT_EQ(Trace(io, kGpo, 0, 3, 1000), "000");
}

TEST(PulseTrain, StopLeavesTheBitAsItIs) {
  DigitalIo io;
  io.StartPulses(kGpo, 0, 500, 500, 0, true);
  EXPECT_EQ(Trace(io, kGpo, 0, 1, 250), "1");
  io.StopTiming(kGpo, 0);
  EXPECT_EQ(Trace(io, kGpo, 0, 4, 250), "1111");
}

TEST(DigitalOutput, ResetClearsRegistersAndTimings) {
  DigitalIo io;
  io.SetOutputInverted(kGpo, 1);
  io.StartPulses(kGpo, 0, 250, 250, 0, true);
  io.Reset();
  EXPECT_EQ(io.Register(kGpo), 0u);
  EXPECT_EQ(io.OutputPins(kGpo), 0u);
  EXPECT_EQ(Trace(io, kGpo, 0, 4, 250), "0000");
}

}  // namespace
}  // namespace oncard::motion
