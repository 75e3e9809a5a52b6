// Gear slaves and their masters. A slave follows from the Update that makes a ratio valid. Source:
// GT manual 4.1.4 and 7.3. Tested by tests/gtcalls/gt400/gear_command_test.cc.
#pragma once

#include <cstddef>
#include <optional>

#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

/// GT_PrflG: masters 1 to 4 are axes, 5 and 6 auxiliary encoders.
void ChooseMaster(Card& card, size_t axis, int number);
/// The slave follows its master with the valid ratio from this instant on.
void Engage(Card& card, size_t axis);
/// True if an axis follows a master, also while a limit holds it.
bool IsEngaged(const CardView& card, size_t axis);
/// The axis that a slave follows; nothing if that is an auxiliary encoder.
std::optional<size_t> MasterAxis(const CardView& card, size_t slave);
/// Something has stopped a slave: the axis that leads it stops at once, too, unless it has no plan.
void StopMaster(Card& card, size_t slave);

}  // namespace oncard::gtcalls::gt400
