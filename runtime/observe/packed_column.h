// Doubles that change smoothly or seldom, such as the positions of an axis cycle by cycle, in few
// bytes. Every value is predicted from those before it. Values that are as predicted are counted;
// of any other, the difference between its bits and those of the prediction is kept, without the
// zero bytes at its ends. Nothing is lost, not even the bits of a NaN or the sign of a zero. Values
// are read in order. Tested by tests/runtime/packed_column_test.cc.
#pragma once

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
  /// The bits of the value that a prediction gives.
  uint64_t Predict(Prediction prediction) const;
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

  void Append(double value);
  /// Appends the last value `count` times. There must be one unless `count` is 0.
  void Repeat(size_t count);

 private:
  // Values that are as one prediction says.
  struct Run {
    Prediction prediction = Prediction::kSame;
    size_t count = 0;
  };

  bool BeginRun(uint64_t bits);
  void EndRun();
  void AddDifference(uint64_t bits);

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
    return Advance();
  }

 private:
  void ReadToken();
  double Advance();

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
