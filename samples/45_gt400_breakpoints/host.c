/* Breakpoints of a GT400 card, at which it updates by itself: axis 1 moves faster from a position
   on, axis 2 returns as soon as it has arrived. */
#include "GT400.h"
#include "accepted.h"

#define AT_BREAKPOINT 0x4 /* bit 2 of the status word */

static void prepare(unsigned short axis, long position, double velocity) {
  ACCEPTED(GT_Axis(axis));
  ACCEPTED(GT_AxisOn());
  ACCEPTED(GT_PrflT());
  ACCEPTED(GT_SetPos(position));
  ACCEPTED(GT_SetVel(velocity));
  ACCEPTED(GT_SetAcc(0.1));
  ACCEPTED(GT_AuUpdtOn());
}

static void wait_for_rest(unsigned short axis) {
  unsigned short status;
  ACCEPTED(GT_Axis(axis));
  do {
    ACCEPTED(GT_GetSts(&status));
  } while (status & IN_MOTION);
  if (!(status & AT_BREAKPOINT)) exit(2);
}

int main(void) {
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  prepare(1, 10000, 5);
  ACCEPTED(GT_SetBrkCn(4000));
  prepare(2, 2000, 10);
  ACCEPTED(GT_MltiUpdt(3));

  /* These values wait for the breakpoints. */
  ACCEPTED(GT_Axis(1));
  ACCEPTED(GT_PosBrk());
  ACCEPTED(GT_SetVel(10));
  ACCEPTED(GT_Axis(2));
  ACCEPTED(GT_MtnBrk());
  ACCEPTED(GT_SetPos(0));

  wait_for_rest(1);
  wait_for_rest(2);
  ACCEPTED(GT_Close());
  return 0;
}
