// Converter values of extension modules.
#include "motion/io/extension.h"

#include <gtest/gtest.h>

namespace oncard::motion {
namespace {

TEST(ExtensionModule, SixteenBitsCoverTenVoltsBothWays) {
  struct {
    double volts;
    int value;
  } const cases[] = {{-10, 0}, {10, 65535}, {-11, 0}, {11, 65535}, {5, 49151}, {0, 32768}};
  for (const auto& c : cases) EXPECT_EQ(ModuleValue(c.volts), c.value) << c.volts;
  EXPECT_DOUBLE_EQ(ModuleVolts(0), -10);
  EXPECT_DOUBLE_EQ(ModuleVolts(65535), 10);
  for (int value = 0; value <= 65535; ++value) {
    ASSERT_EQ(ModuleValue(ModuleVolts(static_cast<uint16_t>(value))), value);
  }
}

}  // namespace
}  // namespace oncard::motion
