#include "gtcalls/card_elements.h"

namespace oncard::gtcalls {

size_t CrdDimension(const Card& card, double crd) {
  const auto& crds = card.motion.part<&motion::MotionState::crds>();
  for (size_t i = 0; i < crds.size(); ++i) {
    if (crd == static_cast<double>(i + 1)) return crds[i].dimension();
  }
  return 0;
}

namespace {

/// The length of an encoder's list of capture offsets; 0 for a number the card does not have.
size_t OffsetCount(const Card& card, double encoder) {
  for (size_t i = 0; i < motion::kAxisMax; ++i) {
    if (encoder != static_cast<double>(i + 1)) continue;
    return card.motion.part<&motion::MotionState::capture>().capture(i).offsets.size();
  }
  return 0;
}

}  // namespace

size_t ElementsOnCard(const Parameter& parameter, const Card& card, double first) {
  if (parameter.per_dimension) return CrdDimension(card, first);
  if (parameter.per_offset) return OffsetCount(card, first);
  if (parameter.per_axis) return card.motion.axis_count();
  if (parameter.passing == Passing::kHostMemory) return 1 + card.family.array_elements(card.view());
  return 1;
}

std::optional<size_t> ElementsBehind(const Command& command, const Parameter& parameter,
                                     std::span<const vm::CommandArgument> arguments,
                                     const Card* card) {
  if (parameter.CountedByCard()) {
    return card == nullptr ? 0 : ElementsOnCard(parameter, *card, arguments[0].value);
  }
  if (parameter.count_parameter < 0) return 1;
  const auto index = static_cast<size_t>(parameter.count_parameter);
  const Parameter& counter = command.parameters[index];
  const double count = arguments[index].value;
  // Written so that the check fails for a NaN.
  if (!(count >= counter.minimum && count <= counter.maximum)) return std::nullopt;
  return static_cast<size_t>(count);
}

size_t CellsPerElement(const Parameter& parameter) {
  if (parameter.passing == Passing::kHostMemory) return ArraysOf(*parameter.structure).size();
  return static_cast<size_t>(parameter.structure != nullptr ? CellCount(*parameter.structure)
                                                            : parameter.array_size);
}

}  // namespace oncard::gtcalls
