#include "runtime/host/terminal.h"

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>

namespace oncard::runtime {
namespace {

/// Switches the terminal to single keys without echo, from the first read to the end of the
/// process.
class RawTerminal {
 public:
  RawTerminal() {
    if (::tcgetattr(STDIN_FILENO, &before_) != 0) return;
    changed_ = true;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
  ~RawTerminal() {
    if (changed_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }

 private:
  termios before_{};
  bool changed_ = false;
};

void OpenTerminal() { static const RawTerminal terminal; }

}  // namespace

bool TerminalHasKey() {
  OpenTerminal();
  // Not poll(), which would report the end of the input as a key.
  int available = 0;
  return ::ioctl(STDIN_FILENO, FIONREAD, &available) == 0 && available > 0;
}

int ReadTerminalKey() {
  OpenTerminal();
  std::fflush(stdout);
  unsigned char character = 0;
  return ::read(STDIN_FILENO, &character, 1) == 1 ? character : -1;
}

}  // namespace oncard::runtime
