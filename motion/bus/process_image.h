// The process image of a bus: the bytes that the controller and its slaves exchange in each cycle.
// What a host writes over an output of the controller lasts for one exchange. Bits and bytes are
// numbered as EtherCAT does, little-endian. Tested by tests/motion/bus/process_image_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace oncard::motion::bus {

class ProcessImage {
 public:
  explicit ProcessImage(size_t size = 0) : bytes_(size), held_(size) {}

  size_t size() const { return bytes_.size(); }
  std::span<const uint8_t> bytes() const { return bytes_; }

  /// A number of 1 to 32 bits.
  int64_t Get(size_t bit, uint8_t bits, bool is_signed) const;
  void Put(size_t bit, uint8_t bits, int64_t value);
  /// The same by the controller, which does not overwrite what a host has just written.
  void PutUnlessHeld(size_t bit, uint8_t bits, int64_t value);

  /// True if so many bytes from an offset on are inside.
  bool Contains(size_t offset, size_t count) const {
    return offset <= size() && count <= size() - offset;
  }
  /// Writes of a host, inside the image; they hold until EndExchange().
  void WriteByHost(size_t offset, std::span<const uint8_t> data);
  void EndExchange();
  /// True if a host has written since the last exchange.
  bool held() const { return any_held_; }
  /// All bytes 0.
  void Clear();

  auto Fields(auto visit) const { return visit(bytes_, held_, any_held_); }

 private:
  std::vector<uint8_t> bytes_;
  std::vector<uint8_t> held_;
  bool any_held_ = false;
};

}  // namespace oncard::motion::bus
