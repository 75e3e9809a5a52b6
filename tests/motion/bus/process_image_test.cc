// The process image: where the data of slaves are, byte by byte, and who writes them.
#include "motion/bus/process_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/motion/bus/bus_card.h"
#include "tests/motion/change_state.h"

namespace oncard::motion::bus {
namespace {

using ::testing::ElementsAreArray;

Slave DefaultDrive(int axis) {
  Slave drive = DefaultSlave(SlaveKind::kDrive);
  drive.axis = static_cast<int8_t>(axis);
  return drive;
}

/// The manual's example: two drives and two slaves with inputs and outputs (5.2.2.4).
Slaves ManualExample() {
  return {DefaultDrive(0), DefaultDrive(1), DefaultSlave(SlaveKind::kIo),
          DefaultSlave(SlaveKind::kIo)};
}

TEST(ProcessImage, HasTheOffsetsOfTheManual) {
  const std::vector<SlavePlace> places = PlacesOf(ManualExample());
  EXPECT_EQ(places[0].outputs, 0u);
  EXPECT_EQ(places[0].inputs, 6u);
  EXPECT_EQ(places[1].outputs, 16u);
  EXPECT_EQ(places[1].inputs, 22u);
  EXPECT_EQ(places[2].outputs, 32u);
  EXPECT_EQ(places[2].inputs, 34u);
  EXPECT_EQ(places[3].outputs, 36u);
  EXPECT_EQ(places[3].inputs, 38u);
  EXPECT_EQ(ImageSize(ManualExample()), 40u);
}

TEST(ProcessImage, OfTheManualsCouplerHasItsOffsets) {
  const Slave coupler = DefaultSlave(SlaveKind::kCoupler);
  const SlavePlace place = PlacesOf({coupler})[0];
  EXPECT_EQ(FindEntry(coupler.outputs, 0x7010, 1)->bit, 8u * 2);
  EXPECT_EQ(FindEntry(coupler.outputs, 0x7030, 1)->bit, 8u * 4);
  EXPECT_EQ(8 * place.inputs + FindEntry(coupler.inputs, 0x6000, 1)->bit, 8u * 14);
  EXPECT_EQ(8 * place.inputs + FindEntry(coupler.inputs, 0x6020, 1)->bit, 8u * 16);
  EXPECT_EQ(8 * place.inputs + FindEntry(coupler.inputs, 0x6020, 3)->bit, 8u * 20);
}

TEST(ProcessImage, ShowsDrivesAndTerminalsByteByByte) {
  BusCard card(ManualExample());
  card.core.PlaceMotor(1, 0);
  card.Power();
  card.Enable(2);
  card.core.ProfileAt(1).SetPosition(0);
  card.core.AxisAt(1).SynchPosition();
  ChangeState(card.core).profiles[1].now.position = 0x010203;
  card.bus().SetTerminal(2, 0, 0x5AA5);
  card.bus().image().WriteByHost(36, std::vector<uint8_t>{0x11, 0x22});
  card.Ticks(1);
  const uint8_t kDrive0[] = {0x0F, 0, 0, 0, 0, 0, 0x37, 0x12, 0, 0, 0, 0, 0, 0, 0, 0};
  const uint8_t kDrive1[] = {0x0F, 0, 3, 2, 1, 0, 0x37, 0x12, 3, 2, 1, 0, 0, 0, 0, 0};
  const uint8_t kTerminals[] = {0, 0, 0xA5, 0x5A, 0x11, 0x22, 0, 0};
  std::vector<uint8_t> expected(std::begin(kDrive0), std::end(kDrive0));
  expected.insert(expected.end(), std::begin(kDrive1), std::end(kDrive1));
  expected.insert(expected.end(), std::begin(kTerminals), std::end(kTerminals));
  EXPECT_THAT(
      std::vector<uint8_t>(card.bus().image().bytes().begin(), card.bus().image().bytes().end()),
      ElementsAreArray(expected));
}

TEST(ProcessImage, AnOutputOfTheControllerThatAHostWritesLastsForOneExchange) {
  ProcessImage image(4);
  image.PutUnlessHeld(0, 16, 0x0F);
  image.WriteByHost(0, std::vector<uint8_t>{0x06, 0});
  image.PutUnlessHeld(0, 16, 0x0F);
  EXPECT_EQ(image.Get(0, 16, false), 0x06);
  image.EndExchange();
  image.PutUnlessHeld(0, 16, 0x0F);
  EXPECT_EQ(image.Get(0, 16, false), 0x0F);
}

TEST(ProcessImage, HasNumbersOfAnyLengthAtAnyBit) {
  ProcessImage image(4);
  image.Put(3, 5, 0b10110);
  image.Put(8, 12, -2);
  EXPECT_EQ(image.Get(3, 5, false), 0b10110);
  EXPECT_EQ(image.Get(8, 12, true), -2);
  EXPECT_EQ(image.Get(8, 12, false), 0xFFE);
  EXPECT_EQ(image.Get(0, 3, false), 0);
  EXPECT_EQ(image.Get(20, 12, false), 0);
}

TEST(ProcessImage, PutsEachBitOfANumberInItsPlaceAndNoOther) {
  constexpr int64_t kValue = 0x1234'5678'9ABC'DEF1;
  for (const int64_t value : {kValue, ~kValue, int64_t{-1}, int64_t{0}}) {
    for (size_t bit = 0; bit < 16; ++bit) {
      for (uint8_t bits = 1; bits <= 64; ++bits) {
        ProcessImage image(10);
        image.WriteByHost(0, std::vector<uint8_t>(10, 0x5A));
        image.Put(bit, bits, value);
        for (size_t at = 0; at < 80; ++at) {
          const bool inside = at >= bit && at < bit + bits;
          const int expected =
              inside ? static_cast<int>(value >> (at - bit) & 1) : 0x5A >> at % 8 & 1;
          ASSERT_EQ(image.bytes()[at / 8] >> at % 8 & 1, expected) << bit << " " << int{bits};
        }
        const unsigned unused = 64u - bits;
        const uint64_t upper = static_cast<uint64_t>(value) << unused;
        EXPECT_EQ(image.Get(bit, bits, true), static_cast<int64_t>(upper) >> unused);
        EXPECT_EQ(image.Get(bit, bits, false), static_cast<int64_t>(upper >> unused));
      }
    }
  }
}

TEST(ProcessImage, EndsBehindTheLastByte) {
  const ProcessImage image(4);
  EXPECT_TRUE(image.Contains(0, 4));
  EXPECT_TRUE(image.Contains(4, 0));
  EXPECT_FALSE(image.Contains(4, 1));
  EXPECT_FALSE(image.Contains(5, 0));
  EXPECT_FALSE(image.Contains(1, SIZE_MAX));
}

}  // namespace
}  // namespace oncard::motion::bus
