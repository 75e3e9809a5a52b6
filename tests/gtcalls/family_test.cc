// What a family says of itself, and the cards that users can name.
#include "gtcalls/family.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command_test_card.h"
#include "gtcalls/card_type.h"
#include "gtcalls/families.h"

namespace oncard::gtcalls::gts {
namespace {

using ::testing::ElementsAre;

TEST(CardTypes, AreNamedOnceInAllFamilies) {
  EXPECT_THAT(
      CardTypeNames(),
      ElementsAre("GTS-400", "GTS-800", "GTS-1200", "GE-800-PG", "GE-200-PV", "GE-200-PG",
                  "GE-300-PV", "GE-300-PG", "GE-400-PV", "GE-400-PG", "GE-800-PV", "GE-300-SG",
                  "GE-200-SV", "GE-200-SG", "GE-300-SV", "GE-400-SV", "GE-400-SG", "GT-400-SV",
                  "GT-400-SG", "GT-400-SE", "GT-400-SD", "GT-400-SP"));
}

TEST(CardTypes, HaveTheseNumbersOfAxes) { EXPECT_THAT(AxisCounts(), ElementsAre(2, 3, 4, 8, 12)); }

TEST(CardTypes, BeginWithThoseOfGts) { EXPECT_EQ(Families().front(), &GtsFamily()); }

TEST(CardTypes, AreFoundWithTheirFamilyAndNumberOfAxes) {
  const struct {
    const char* name;
    const char* family;
    int axis_count;
  } cases[] = {{"GTS-400", "gts", 4},   {"GTS-800", "gts", 8},   {"GTS-1200", "gts", 12},
               {"GE-200-PG", "gep", 2}, {"GE-300-PV", "gep", 3}, {"GE-800-PV", "gep", 8},
               {"GE-300-SG", "ges", 3}, {"GE-400-SV", "ges", 4}, {"GT-400-SV", "gt400", 4}};
  for (const auto& c : cases) {
    const auto card = FindCard(c.name);
    ASSERT_TRUE(card) << c.name;
    EXPECT_EQ(card->family->name, c.family);
    EXPECT_EQ(card->type->axis_count, c.axis_count);
  }
}

TEST(CardTypes, HaveExactNames) {
  for (const char* name : {"", "gts-800", "GTS-8000", "GTS"}) EXPECT_FALSE(FindCard(name)) << name;
}

TEST(Family, ConfiguresACardAsItsType) {
  const CardType slow = {"", 4, {.smooth_stop = 0.5}};
  EXPECT_EQ(GtsFamily().Configured({}, &slow).defaults.smooth_stop, 0.5);
  EXPECT_EQ(GtsFamily().Configured({}).defaults.smooth_stop, 1);
}

TEST(Family, OfGtsOpensACardWithEightAxes) {
  EXPECT_EQ(GtsFamily().default_card.name, "GTS-800");
  EXPECT_EQ(GtsFamily().name, "gts");
}

TEST(Family, FinishesEveryCommandOfTheCard) {
  CommandTestCard card;
  Family family = GtsFamily();
  family.finish = [](Call&, int16_t code) { return static_cast<int16_t>(code + 100); };
  Card other{family, card.machine, card.motion, card.family_state};
  const auto code = [&](std::string_view name, double thread) {
    std::vector<vm::CommandArgument> arguments(1);
    arguments[0].value = thread;
    Call call{*GtsCatalogue().Find(name), other, vm::kHostCaller, arguments, {}};
    return ExecuteCommand(call);
  };
  EXPECT_EQ(code("GT_AxisOn", 1), 100);
  EXPECT_EQ(code("GT_AxisOn", 9), 107);  // refused
}

}  // namespace
}  // namespace oncard::gtcalls::gts
