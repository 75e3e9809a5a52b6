#include "runtime/observe/packed_column.h"

#include <algorithm>
#include <array>
#include <bit>
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

void PackedColumn::Repeat(size_t count) {
  if (count == 0) return;
  if (run_.prediction != Prediction::kSame) EndRun();
  run_ = {Prediction::kSame, run_.count + count};
  for (size_t i = 0; i < std::min<size_t>(count, 3); ++i) history_.Push(history_.last());
  size_ += count;
}

void PackedColumn::AppendUnexpected(uint64_t bits) {
  EndRun();
  ShortDifference shortest;
  for (const Prediction prediction : kPredictions) {
    const uint64_t difference = bits - history_.Predict(prediction);
    if (difference == 0) {
      run_ = {prediction, 1};
      return;
    }
    const ShortDifference other = Shortened(prediction, difference);
    if (other.length < shortest.length) shortest = other;
  }
  std::array<uint8_t, 9> token;
  token[0] = static_cast<uint8_t>(static_cast<unsigned>(shortest.prediction) << 6 |
                                  (shortest.length - 1) << 3 | shortest.zeros);
  for (unsigned i = 0; i < shortest.length; ++i) {
    token[i + 1] = static_cast<uint8_t>(shortest.digits >> (8 * i));
  }
  bytes_.insert(bytes_.end(), token.data(), token.data() + 1 + shortest.length);
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

}  // namespace oncard::runtime
