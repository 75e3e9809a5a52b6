// Slaves as they are described: the first difference between two descriptions.
#include "motion/bus/slaves.h"

#include <gtest/gtest.h>

namespace oncard::motion::bus {
namespace {

using What = SlaveDifference::What;

const Slaves kConfigured = {DefaultSlave(SlaveKind::kDrive), DefaultSlave(SlaveKind::kIo)};

TEST(Slaves, ThatFitHaveNoDifference) {
  EXPECT_FALSE(FirstDifference(kConfigured, kConfigured).has_value());
}

TEST(Slaves, TheFirstDifferenceIsNamed) {
  struct Case {
    Slaves connected;
    What what;
    size_t slave;
  };
  Slave other = kConfigured[1];
  other.product += 1;
  Slave longer = kConfigured[1];
  longer.inputs.push_back({0x6000, 2, 16});
  Slave disguised = kConfigured[0];
  disguised.kind = SlaveKind::kIo;
  const Case cases[] = {
      {{disguised, kConfigured[1]}, What::kIdentity, 0},
      {{kConfigured[0]}, What::kMissing, 1},
      {{kConfigured[0], kConfigured[1], kConfigured[1]}, What::kUnexpected, 2},
      {{kConfigured[1], kConfigured[0]}, What::kIdentity, 0},
      {{kConfigured[0], other}, What::kIdentity, 1},
      {{kConfigured[0], longer}, What::kProcessData, 1},
  };
  for (const Case& each : cases) {
    const auto difference = FirstDifference(kConfigured, each.connected);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->what, each.what);
    EXPECT_EQ(difference->slave, each.slave);
  }
}

TEST(Slaves, EntriesAreFoundAtTheirBits) {
  const std::vector<PdoEntry> entries = {{0x6000, 1, 1}, {0, 0, 7}, {0x6000, 2, 16}};
  EXPECT_EQ(FindEntry(entries, 0x6000, 2)->bit, 8u);
  EXPECT_EQ(FindEntry(entries, 0x6000, 2)->bits, 16);
  EXPECT_FALSE(FindEntry(entries, 0x6000, 3).has_value());
  EXPECT_EQ(BytesOf(entries), 3u);
}

}  // namespace
}  // namespace oncard::motion::bus
