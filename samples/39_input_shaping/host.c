/* Two axes make the same move. An elastic arm behind axis 2 swings with a period of 200 ms and a
   damping ratio of 0.1; the command of that axis is shaped, so that the arm rests when it stops. */
#include <math.h>

#include "accepted.h"
#include "gts.h"

#define PERIOD_MS 200.0
#define CYCLE_MS 0.25
#define DAMPING 0.1
#define IN_POSITION 0x800 /* bit 11 of the status word */

static void Prepare(short axis) {
  TTrapPrm trap = {1, 1, 0, 0};
  ACCEPTED(GT_AxisOn(axis));
  ACCEPTED(GT_PrfTrap(axis));
  ACCEPTED(GT_SetTrapPrm(axis, &trap));
  ACCEPTED(GT_SetVel(axis, 50));
  ACCEPTED(GT_SetPos(axis, 10000));
}

int main(void) {
  const short count = (short)(PERIOD_MS / 2 / CYCLE_MS);
  const double k = exp(-acos(-1.0) * DAMPING / sqrt(1 - DAMPING * DAMPING));
  long status = 0;
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_SetAxisBand(2, 1, 1));
  ACCEPTED(GT_SetAxisInputShaping(2, 1, count, k));
  Prepare(1);
  Prepare(2);
  ACCEPTED(GT_Update(3));
  do {
    ACCEPTED(GT_GetSts(2, &status, 1, NULL));
  } while (!(status & IN_POSITION));
  ACCEPTED(GT_Close());
  return 0;
}
