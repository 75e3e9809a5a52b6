/* The three modes of a GE card for point-to-point motion: axis 1 moves in mode T, axis 2 in the
   velocity mode until it is stopped, axis 3 in mode S. All of them begin in the same cycle. */
#include <unistd.h>

#include "accepted.h"
#include "gep.h"

int main(void) {
  unsigned short axis;
  unsigned long status;
  ACCEPTED(GT_Open(65535));
  ACCEPTED(GT_Reset());
  for (axis = 1; axis <= 3; ++axis) ACCEPTED(GT_AxisOn(axis));

  ACCEPTED(GT_PrflT(1));
  ACCEPTED(GT_SetPos(1, 20000));
  ACCEPTED(GT_SetVel(1, 50));
  ACCEPTED(GT_SetAcc(1, 0.5));

  ACCEPTED(GT_PrflV(2));
  ACCEPTED(GT_SetVel(2, 50));
  ACCEPTED(GT_SetAcc(2, 0.5));

  ACCEPTED(GT_PrflS(3));
  ACCEPTED(GT_SetPos(3, 20000));
  ACCEPTED(GT_SetVel(3, 50));
  ACCEPTED(GT_SetMAcc(3, 0.5));
  ACCEPTED(GT_SetJerk(3, 0.01));

  /* The registers take effect together. */
  ACCEPTED(GT_MltiUpdt(7));
  usleep(300000);
  ACCEPTED(GT_SmthStp(2));
  do {
    ACCEPTED(GT_GetSts(3, &status));
  } while (status & IN_MOTION);
  ACCEPTED(GT_Close());
  return 0;
}
