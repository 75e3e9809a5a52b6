#include "vm/operand_slots.h"

#include <gtest/gtest.h>

#include <vector>

namespace oncard::vm {
namespace {

using Slots = std::vector<uint32_t>;

Slots Own(const Operand& operand, Storage storage) {
  Slots slots;
  ForEachSlot(operand, storage, [&](uint32_t slot) { slots.push_back(slot); });
  return slots;
}
Slots Named(const Operand& operand, Storage storage) {
  Slots slots;
  ForEachNamedSlot(operand, storage, [&](uint32_t slot) { slots.push_back(slot); });
  return slots;
}

TEST(OperandSlots, OfAVariableIsItsOwn) {
  const Operand global = Variable{Storage::kGlobal, 7};
  EXPECT_EQ(Own(global, Storage::kGlobal), Slots({7}));
  EXPECT_EQ(Own(global, Storage::kLocal), Slots());
  EXPECT_EQ(Named(global, Storage::kGlobal), Slots({7}));
  EXPECT_EQ(IndexVariableOf(global), nullptr);
}

TEST(OperandSlots, OfAnElementAreThoseOfTheArray) {
  const Operand element = Element{Storage::kGlobal, 4, 3, {Storage::kLocal, 9}};
  EXPECT_EQ(Own(element, Storage::kGlobal), Slots({4, 5, 6}));
  EXPECT_EQ(Own(element, Storage::kLocal), Slots());
  EXPECT_EQ(Named(element, Storage::kLocal), Slots({9}));
  EXPECT_EQ(IndexVariableOf(element)->id, 9);
}

TEST(OperandSlots, ALiteralHasNone) {
  EXPECT_EQ(Named(ImmediateInt(3), Storage::kGlobal), Slots());
  EXPECT_EQ(Named(ImmediateInt(3), Storage::kLocal), Slots());
}

}  // namespace
}  // namespace oncard::vm
