/* Touch probe 1 captures every rising edge while the axis moves (GTS manual S2, example 5-3). Bit 6
   of the status changes with each capture. */
#include "bus.h"

#define AXIS 1
#define PROBE_ON 0x13      /* probe 1, continuous, rising edges */
#define PROBE_CAPTURED 0x3 /* probe 1 is on, and has captured a rising edge */
#define PROBE_AGAIN 0x40

int main(void) {
  unsigned short status;
  unsigned short before = 0;
  long rise1, fall1, rise2, fall2;
  int captures = 0;
  TJogPrm jog = {1, 1, 0};
  OpenBus();
  Enable(AXIS);
  ACCEPTED(GT_PrfJog(AXIS));
  ACCEPTED(GT_SetJogPrm(AXIS, &jog));
  ACCEPTED(GT_SetVel(AXIS, 20));
  ACCEPTED(GT_Update(1 << (AXIS - 1)));
  ACCEPTED(GT_SetTouchProbeFunction(AXIS, PROBE_ON));
  while (captures < 3) {
    ACCEPTED(GT_GetTouchProbeStatus(AXIS, &status, &rise1, &fall1, &rise2, &fall2));
    if ((status & PROBE_CAPTURED) != PROBE_CAPTURED) continue;
    if ((status & PROBE_AGAIN) == (before & PROBE_AGAIN)) continue;
    before = status;
    ++captures;
    printf("captured %ld\n", rise1);
  }
  ACCEPTED(GT_SetTouchProbeFunction(AXIS, 0));
  ACCEPTED(GT_Stop(1 << (AXIS - 1), 0));
  ACCEPTED(GT_Close());
  return 0;
}
