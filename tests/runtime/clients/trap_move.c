/* A point-to-point move as in the manual: open, reset, enable the axis, set up Trap, start, poll
   until the axis is at rest. 50000 pulses at 50 pulse/ms with 0.25 and 0.125 pulse/ms^2 and a
   smoothing time of 25 ms take 1325 ms: 50000 / 50 + 50 / 0.25 / 2 + 50 / 0.125 / 2 + 25. The clock
   of the card and of the computer must say so, within 20 ms; a computer that is busy with something
   else gets more than one chance. */
#include <math.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "gts.h"

#define AXIS 1
#define ATTEMPTS 5

static double ComputerMs(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec * 1000 + (double)now.tv_nsec / 1e6;
}

static double CardMs(void) {
  unsigned long clock = 0;
  ACCEPTED(GT_GetClock(&clock, NULL));
  return (double)clock;
}

int main(void) {
  TTrapPrm trap;
  double position = -1;
  double computer_ms = 0;
  double card_ms = 0;
  long status = 0;
  int attempt;

  for (attempt = 0; attempt < ATTEMPTS; ++attempt) {
    ACCEPTED(GT_Open(0, 1));
    ACCEPTED(GT_Reset());
    ACCEPTED(GT_ClrSts(1, 8));
    ACCEPTED(GT_AxisOn(AXIS));
    ACCEPTED(GT_PrfTrap(AXIS));
    ACCEPTED(GT_GetTrapPrm(AXIS, &trap));
    trap.acc = 0.25;
    trap.dec = 0.125;
    trap.velStart = 0;
    trap.smoothTime = 25;
    ACCEPTED(GT_SetTrapPrm(AXIS, &trap));
    ACCEPTED(GT_SetPos(AXIS, 50000));
    ACCEPTED(GT_SetVel(AXIS, 50));
    ACCEPTED(GT_Update(1 << (AXIS - 1)));
    computer_ms = -ComputerMs();
    card_ms = -CardMs();
    do {
      usleep(1000);
      ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
    } while (status & 0x400);
    computer_ms += ComputerMs();
    card_ms += CardMs();
    ACCEPTED(GT_GetPrfPos(AXIS, &position, 1, NULL));
    ACCEPTED(GT_AxisOff(AXIS));
    ACCEPTED(GT_Close());
    CHECK_EQ(position, 50000);
    if (fabs(computer_ms - 1325) <= 20 && fabs(card_ms - 1325) <= 20) break;
  }
  printf("%.0f pulses in %.0f ms\n", position, card_ms);
  CHECK_EQ(attempt < ATTEMPTS, 1);
  return 0;
}
