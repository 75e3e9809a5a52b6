// Objects of the dictionary in process data: which there are, and where in the process image.
#include "motion/bus/process_data.h"

#include <gtest/gtest.h>

#include <vector>

namespace oncard::motion::bus {
namespace {

TEST(ProcessData, HasTheObjectsOfTheDictionaryAtTheirBits) {
  // A gap, an object that no dictionary has, and a signed one; from byte 10 of the image on.
  const std::vector<PdoEntry> entries = {
      {0x6041, 0, 16}, {0, 0, 4}, {0x7123, 1, 12}, {0x6064, 0, 32}};
  const MappedObjects objects(entries, 80);
  ASSERT_EQ(objects.all().size(), 2u);
  const MappedObject* status = objects.Find(ObjectId::kStatusWord);
  ASSERT_NE(status, nullptr);
  EXPECT_EQ(status->place.bit, 80u);
  EXPECT_EQ(status->place.bits, 16);
  EXPECT_FALSE(status->is_signed);
  const MappedObject* position = objects.Find(ObjectId::kPositionActual);
  ASSERT_NE(position, nullptr);
  EXPECT_EQ(position->id, ObjectId::kPositionActual);
  EXPECT_EQ(position->place.bit, 80u + 16 + 4 + 12);
  EXPECT_TRUE(position->is_signed);
  EXPECT_EQ(objects.Find(ObjectId::kModeDisplay), nullptr);
}

TEST(ProcessData, FindsTheFirstOfTwoEqualObjects) {
  const MappedObjects objects({{0x6041, 0, 16}, {0x6041, 0, 16}}, 0);
  ASSERT_EQ(objects.all().size(), 2u);
  EXPECT_EQ(objects.all()[1].place.bit, 16u);
  EXPECT_EQ(objects.Find(ObjectId::kStatusWord), &objects.all()[0]);
}

TEST(ProcessData, OfASlaveFollowsThatOfTheOneBefore) {
  const Slave drive = DefaultSlave(SlaveKind::kDrive);
  const std::vector<MappedSlave> slaves = MapSlaves({DefaultSlave(SlaveKind::kIo), drive});
  // 2 bytes in each direction of the first; 6 bytes of outputs of the second.
  EXPECT_TRUE(slaves[0].inputs.all().empty());
  EXPECT_EQ(slaves[1].place.outputs, 4u);
  EXPECT_EQ(slaves[1].outputs.Find(ObjectId::kTargetPosition)->place.bit, 8u * (4 + 2));
  EXPECT_EQ(slaves[1].inputs.Find(ObjectId::kStatusWord)->place.bit, 8u * (4 + 6));
}

}  // namespace
}  // namespace oncard::motion::bus
