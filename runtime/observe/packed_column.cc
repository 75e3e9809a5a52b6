#include "runtime/observe/packed_column.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

// The bytes of a column are tokens. Bits 7 and 6 of the first byte of a token say what it is:
//
//   0 to 2   a difference from this prediction: bits 5 to 3 its number of bytes less 1, bits 2 to 0
//            the number of zero bytes below them; its bytes follow, the lowest first, the sign in
//            the last
//   3        a run: bits 5 and 4 the prediction, bits 3 to 0 the number of values less 1; if that
//            is 15, the number of further values follows, 7 bits in a byte, the lowest first
namespace oncard::runtime {
namespace {

constexpr Prediction kPredictions[] = {Prediction::kSame, Prediction::kLine, Prediction::kParabola};

constexpr unsigned kRunToken = 3;
constexpr size_t kShortRunMax = 15;

/// A difference as a token holds it.
struct ShortDifference {
  Prediction prediction = Prediction::kSame;
  int64_t digits = 0;
  unsigned zeros = 0;   ///< bytes below the digits
  unsigned length = 9;  ///< bytes of the digits
};

ShortDifference Shortened(Prediction prediction, uint64_t difference) {
  ShortDifference result;
  result.prediction = prediction;
  result.zeros = static_cast<unsigned>(std::countr_zero(difference)) / 8;
  result.digits = static_cast<int64_t>(difference) >> (8 * result.zeros);
  const auto magnitude = static_cast<uint64_t>(result.digits ^ (result.digits >> 63));
  result.length = static_cast<unsigned>(std::bit_width(magnitude)) / 8 + 1;  // with the sign
  return result;
}

}  // namespace

// Only sums of doubles, so that every compiler and computer gets the same bits. Those of a NaN
// would depend on the order of its operands.
uint64_t ValueHistory::Predict(Prediction prediction) const {
  const double rise = last_ - second_;
  double value = last_;
  if (prediction == Prediction::kLine) value = last_ + rise;
  if (prediction == Prediction::kParabola) value = last_ + (rise + (rise - (second_ - third_)));
  return std::bit_cast<uint64_t>(std::isnan(value) ? last_ : value);
}

void PackedColumn::Append(double value) {
  const auto bits = std::bit_cast<uint64_t>(value);
  if (run_.count != 0 && history_.Predict(run_.prediction) == bits) {
    ++run_.count;
  } else {
    EndRun();
    if (!BeginRun(bits)) AddDifference(bits);
  }
  history_.Push(value);
  ++size_;
}

void PackedColumn::Repeat(size_t count) {
  if (count == 0) return;
  if (run_.prediction != Prediction::kSame) EndRun();
  run_ = {Prediction::kSame, run_.count + count};
  for (size_t i = 0; i < std::min<size_t>(count, 3); ++i) history_.Push(history_.last());
  size_ += count;
}

bool PackedColumn::BeginRun(uint64_t bits) {
  for (const Prediction prediction : kPredictions) {
    if (history_.Predict(prediction) != bits) continue;
    run_ = {prediction, 1};
    return true;
  }
  return false;
}

void PackedColumn::EndRun() {
  if (run_.count == 0) return;
  const size_t more = run_.count - 1;
  const auto head = kRunToken << 6 | static_cast<unsigned>(run_.prediction) << 4;
  bytes_.push_back(static_cast<uint8_t>(head | std::min(more, kShortRunMax)));
  if (more >= kShortRunMax) {
    size_t rest = more - kShortRunMax;
    for (; rest >= 0x80; rest >>= 7) bytes_.push_back(static_cast<uint8_t>(0x80 | (rest & 0x7F)));
    bytes_.push_back(static_cast<uint8_t>(rest));
  }
  run_.count = 0;
}

void PackedColumn::AddDifference(uint64_t bits) {
  ShortDifference shortest;
  for (const Prediction prediction : kPredictions) {
    const ShortDifference other = Shortened(prediction, bits - history_.Predict(prediction));
    if (other.length < shortest.length) shortest = other;
  }
  bytes_.push_back(static_cast<uint8_t>(static_cast<unsigned>(shortest.prediction) << 6 |
                                        (shortest.length - 1) << 3 | shortest.zeros));
  for (unsigned i = 0; i < shortest.length; ++i) {
    bytes_.push_back(static_cast<uint8_t>(shortest.digits >> (8 * i)));
  }
}

void PackedColumn::Reader::ReadToken() {
  difference_ = 0;
  if (at_ == column_->bytes_.size()) {
    const Run& rest = column_->run_;
    const bool runs = !std::exchange(at_end_, true) && rest.count != 0;
    prediction_ = runs ? rest.prediction : Prediction::kSame;
    left_ = runs ? rest.count : std::numeric_limits<size_t>::max();
    return;
  }
  const uint8_t* bytes = column_->bytes_.data();
  const unsigned head = bytes[at_++];
  if (head >> 6 != kRunToken) {
    prediction_ = static_cast<Prediction>(head >> 6);
    left_ = 1;
    const unsigned length = (head >> 3 & 7) + 1;
    uint64_t digits = 0;
    for (unsigned i = 0; i < length; ++i) digits |= uint64_t{bytes[at_++]} << (8 * i);
    const unsigned above = 64 - 8 * length;
    const int64_t extended = static_cast<int64_t>(digits << above) >> above;
    difference_ = static_cast<uint64_t>(extended) << (8 * (head & 7));
    return;
  }
  prediction_ = static_cast<Prediction>(head >> 4 & 3);
  left_ = (head & 0xF) + 1;
  if (left_ <= kShortRunMax) return;
  for (unsigned shift = 0;; shift += 7) {
    const uint8_t byte = bytes[at_++];
    left_ += size_t{byte & 0x7Fu} << shift;
    if (byte < 0x80) return;
  }
}

double PackedColumn::Reader::Advance() {
  const auto value = std::bit_cast<double>(history_.Predict(prediction_) + difference_);
  history_.Push(value);
  return value;
}

}  // namespace oncard::runtime
