// A file descriptor that is closed with its scope.
#pragma once

#include <unistd.h>

namespace oncard {

class Descriptor {
 public:
  /// Takes ownership of a descriptor; a negative number stands for none.
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int get() const { return number_; }

 private:
  int number_;
};

}  // namespace oncard
