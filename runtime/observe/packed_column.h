// Doubles that change smoothly or seldom, such as the positions of an axis cycle by cycle, in few
// bytes. Every value is predicted from those before it. Values that are as predicted are counted;
// of any other, the difference between its bits and those of the prediction is kept, without the
// zero bytes at its ends. Nothing is lost, not even the bits of a NaN or the sign of a zero. Values
// are read in order. Tested by tests/runtime/packed_column_test.cc.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oncard::runtime {

/// How the next value is expected to follow the last ones.
enum class Prediction : uint8_t { kSame, kLine, kParabola };

/// The last three values of a column: all that predictions depend on.
class ValueHistory {
 public:
  double last() const { return last_; }
  /// The bits of the value that a prediction gives. Only sums of doubles, so that every compiler
  /// and computer gets the same bits; those of a NaN would depend on the order of its operands.
  uint64_t Predict(Prediction prediction) const {
    const double rise = last_ - second_;
    double value = last_;
    if (prediction == Prediction::kLine) value = last_ + rise;
    if (prediction == Prediction::kParabola) value = last_ + (rise + (rise - (second_ - third_)));
    return std::bit_cast<uint64_t>(std::isnan(value) ? last_ : value);
  }
  void Push(double value) {
    third_ = second_;
    second_ = last_;
    last_ = value;
  }

 private:
  double last_ = 0;
  double second_ = 0;  ///< last but one
  double third_ = 0;   ///< last but two
};

class PackedColumn {
 public:
  class Reader;

  /// Number of values.
  size_t size() const { return size_; }
  /// Memory that the values take.
  size_t bytes() const { return bytes_.capacity(); }

  void Append(double value) {
    const auto bits = std::bit_cast<uint64_t>(value);
    if (run_.count != 0 && history_.Predict(run_.prediction) == bits) {
      ++run_.count;
    } else {
      AppendUnexpected(bits);
    }
    history_.Push(value);
    ++size_;
  }
  /// Appends the last value `count` times. There must be one unless `count` is 0.
  void Repeat(size_t count);

 private:
  // Values that are as one prediction says.
  struct Run {
    Prediction prediction = Prediction::kSame;
    size_t count = 0;
  };

  /// Ends the run and begins another one, or adds a difference.
  void AppendUnexpected(uint64_t bits);
  void EndRun();

  std::vector<uint8_t> bytes_;
  Run run_;  // the end of the column, not yet in bytes_
  ValueHistory history_;
  size_t size_ = 0;
};

/// Reads a column from its beginning. The column must neither change nor move meanwhile.
class PackedColumn::Reader {
 public:
  explicit Reader(const PackedColumn& column) : column_(&column) {}

  /// The next value; after the end of the column its last one again.
  double Next() {
    if (left_ == 0) ReadToken();
    --left_;
    const auto value = std::bit_cast<double>(history_.Predict(prediction_) + difference_);
    history_.Push(value);
    return value;
  }

 private:
  void ReadToken();

  const PackedColumn* column_;
  size_t at_ = 0;  // in the bytes of the column
  bool at_end_ = false;
  // The next values: so many as predicted, or one that differs from the prediction.
  size_t left_ = 0;
  Prediction prediction_ = Prediction::kSame;
  uint64_t difference_ = 0;
  ValueHistory history_;
};

}  // namespace oncard::runtime
