// Moves axis 1 and waits until it has arrived.
#include <cstdlib>
#include <iostream>

#include "gts.h"

namespace {

constexpr long kInMotion = 0x400;  // bit 10 of the status word

// Ends the program if the card has refused a command.
void Accepted(const char* command, short code) {
  if (code == 0) return;
  std::cerr << command << ": the card answers " << code << '\n';
  std::exit(1);
}

}  // namespace

int main() {
  TTrapPrm trap = {};
  long status = 0;
  unsigned long clock = 0;
  double position = 0;

  Accepted("GT_Open", GT_Open(0, 1));
  Accepted("GT_AxisOn", GT_AxisOn(1));
  Accepted("GT_PrfTrap", GT_PrfTrap(1));
  trap.acc = 0.25;
  trap.dec = 0.25;
  Accepted("GT_SetTrapPrm", GT_SetTrapPrm(1, &trap));
  Accepted("GT_SetPos", GT_SetPos(1, 50000));
  Accepted("GT_SetVel", GT_SetVel(1, 50));
  Accepted("GT_Update", GT_Update(1));
  do {
    Accepted("GT_GetSts", GT_GetSts(1, &status, 1, &clock));
  } while ((status & kInMotion) != 0);
  Accepted("GT_GetPrfPos", GT_GetPrfPos(1, &position, 1, nullptr));
  std::cout << "at " << position << " after " << clock << " ms\n";
  Accepted("GT_Close", GT_Close());
  return 0;
}
