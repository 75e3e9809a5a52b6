// Two cards that move at the same time, each observed by a thread of the host: the longer move ends
// when it should, and the shorter one has ended before.
#include <chrono>
#include <cmath>
#include <thread>

#include "check.h"
#include "gts_multi.h"

namespace {

// 20 pulse/ms, acceleration and deceleration 0.2 pulse/ms^2: the time is position / 20 + 100 ms.
void Start(short card, long position) {
  TTrapPrm trap = {0.2, 0.2, 0, 0};
  ACCEPTED(GT_Open(card));
  ACCEPTED(GT_ClrSts(card, 1, 8));
  ACCEPTED(GT_AxisOn(card, 2));
  ACCEPTED(GT_PrfTrap(card, 2));
  ACCEPTED(GT_SetTrapPrm(card, 2, &trap));
  ACCEPTED(GT_SetVel(card, 2, 20));
  ACCEPTED(GT_SetPos(card, 2, position));
  ACCEPTED(GT_Update(card, 1 << 1));
}

double Wait(short card) {
  const auto begin = std::chrono::steady_clock::now();
  long status = 0;
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ACCEPTED(GT_GetSts(card, 2, &status));
  } while ((status & 0x400) != 0);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

double PositionOf(short card) {
  double position = -1;
  ACCEPTED(GT_GetPrfPos(card, 2, &position));
  return position;
}

}  // namespace

int main() {
  Start(0, 100000);
  Start(1, 60000);
  double first_ms = 0;
  double second_ms = 0;
  std::thread first([&first_ms] { first_ms = Wait(0); });
  std::thread second([&second_ms] { second_ms = Wait(1); });
  first.join();
  second.join();
  CHECK_EQ(PositionOf(0), 100000);
  CHECK_EQ(PositionOf(1), 60000);
  std::printf("%.0f ms, %.0f ms\n", first_ms, second_ms);
  CHECK_EQ(std::fabs(first_ms - 5100) <= 20, true);
  CHECK_EQ(std::fabs(second_ms - 3100) <= 20, true);
  ACCEPTED(GT_Close(0));
  ACCEPTED(GT_Close(1));
  return 0;
}
