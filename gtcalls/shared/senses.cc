#include "gtcalls/shared/senses.h"

namespace oncard::gtcalls {

using motion::DiType;

void InvertLimits(uint32_t sense, motion::MotionCore& core) {
  uint32_t positive = 0;
  uint32_t negative = 0;
  for (int axis = 0; axis < motion::DiWidth(DiType::kLimitPositive); ++axis) {
    positive |= (sense >> (2 * axis) & 1) << axis;
    negative |= (sense >> (2 * axis + 1) & 1) << axis;
  }
  core.digital_io().SetInverted(DiType::kLimitPositive, positive);
  core.digital_io().SetInverted(DiType::kLimitNegative, negative);
}

void ReverseEncoders(uint32_t sense, size_t first, size_t count, motion::MotionCore& core) {
  for (size_t i = 0; i < count; ++i) {
    if (core.HasEncoder(first + i)) core.EncoderAt(first + i).SetSense((sense >> i & 1) != 0);
  }
}

void ChooseHomeEdges(uint32_t sense, motion::MotionCore& core) {
  for (size_t axis = 0; axis < core.axis_count(); ++axis) {
    core.capture().SetSense(axis, motion::CaptureSource::kHome, (sense >> axis & 1) != 0);
  }
}

}  // namespace oncard::gtcalls
