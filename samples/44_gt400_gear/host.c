/* The electronic gear of a GT400 card: axis 1 follows axis 4, axis 3 follows axis 1, and axis 2 the
   hand wheel at auxiliary encoder 1. */
#include "GT400.h"
#include "accepted.h"

#define MASTER_AXIS 4
#define MASTER_ENCODER 5 /* auxiliary encoder 1 */

static void follow(unsigned short axis, unsigned short master, double ratio) {
  ACCEPTED(GT_Axis(axis));
  ACCEPTED(GT_AxisOn());
  ACCEPTED(GT_PrflG(master));
  ACCEPTED(GT_SetRatio(ratio));
  ACCEPTED(GT_Update());
}

int main(void) {
  unsigned short status;
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  follow(1, MASTER_AXIS, -1.5);
  follow(3, 1, 0.5);
  follow(2, MASTER_ENCODER, 2);

  ACCEPTED(GT_Axis(MASTER_AXIS));
  ACCEPTED(GT_AxisOn());
  ACCEPTED(GT_PrflT());
  ACCEPTED(GT_SetPos(4000));
  ACCEPTED(GT_SetVel(5));
  ACCEPTED(GT_SetAcc(0.05));
  ACCEPTED(GT_Update());
  do {
    ACCEPTED(GT_GetSts(&status));
  } while (status & IN_MOTION);
  ACCEPTED(GT_Close());
  return 0;
}
