// Records values of a card over time, a row of them for a cycle, into two banks of fixed size that
// take turns: a host reads one while the other is filled.
//
// The owner asks at the end of each tick whether a row is due, and appends it. While both banks are
// full, rows are lost (assumption: the manual does not say). Plain data; nothing is allocated after
// SetUp(). Not thread-safe. Source: GE manual 10.1. Tested by tests/motion/recorder_test.cc.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace oncard::motion {

class Recorder {
 public:
  /// Chooses the number of values in a row and of rows in a bank, both > 0. Ends a recording.
  void SetUp(size_t width, size_t rows) {
    *this = {};
    width_ = width;
    values_.resize(kBanks * width * rows);
  }
  /// Begins a recording with empty banks: a row of the next cycle, then one every `interval` + 1
  /// cycles. After SetUp().
  void Start(uint32_t interval) {
    running_ = true;
    interval_ = interval;
    wait_ = 0;
    begin_ = 0;
    count_ = 0;
  }
  /// Ends it; full banks can still be read.
  void Stop() { running_ = false; }

  bool set_up() const { return width_ > 0; }
  bool running() const { return running_; }

  /// To be called once at the end of each tick: true if a row belongs to it.
  bool Due() {
    if (!running_) return false;
    if (wait_ > 0) {
      --wait_;
      return false;
    }
    wait_ = interval_;
    return count_ < values_.size();
  }
  /// Appends the row of a cycle in which one is due.
  void Append(std::span<const double> row) {
    assert(row.size() == width_ && count_ < values_.size());
    const size_t to = (begin_ + count_) % values_.size();
    std::ranges::copy(row, values_.begin() + static_cast<std::ptrdiff_t>(to));
    count_ += width_;
  }

  /// The older one of the full banks, row by row; nothing if none is full.
  std::span<const double> FullBank() const {
    if (!set_up() || count_ < bank_size()) return {};
    return std::span(values_).subspan(begin_, bank_size());
  }
  /// Makes room in place of that bank.
  void FreeBank() {
    assert(count_ >= bank_size());
    begin_ = (begin_ + bank_size()) % values_.size();
    count_ -= bank_size();
  }

  auto Fields(auto visit) const {
    return visit(width_, running_, interval_, wait_, begin_, count_, values_);
  }

 private:
  static constexpr size_t kBanks = 2;

  size_t bank_size() const { return values_.size() / kBanks; }

  size_t width_ = 0;
  bool running_ = false;
  uint32_t interval_ = 0;  ///< cycles left out between two rows
  uint32_t wait_ = 0;      ///< cycles until the next row
  // A ring: a bank begins at its begin or in its middle.
  size_t begin_ = 0;
  size_t count_ = 0;
  std::vector<double> values_;
};

}  // namespace oncard::motion
