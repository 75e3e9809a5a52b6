#include "gtcalls/gts/mram.h"

#include <algorithm>

namespace oncard::gtcalls::gts {

void Mram::Put(int address, int16_t value, std::vector<int16_t>* words) {
  if (words->empty()) words->resize(kMramWords);
  (*words)[static_cast<size_t>(address)] = value;
}

void Mram::Start(motion::Micros now, int address, int count, MramAccess access) {
  // Both are allocated before the transfer ends, because a cycle does not allocate.
  buffer_.resize(kMramWords);
  memory_.resize(kMramWords);
  busy_ = true;
  access_ = access;
  address_ = address;
  count_ = count;
  end_ = now + count * kMramWordUs;
}

void Mram::Finish() {
  busy_ = false;
  const std::vector<int16_t>& from = access_ == MramAccess::kRead ? memory_ : buffer_;
  std::vector<int16_t>& to = access_ == MramAccess::kRead ? buffer_ : memory_;
  std::copy_n(from.begin() + address_, count_, to.begin() + address_);
}

void Mram::Reset() {
  buffer_.clear();
  busy_ = false;
}

}  // namespace oncard::gtcalls::gts
