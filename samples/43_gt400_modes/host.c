/* Three modes of a GT400 card: axis 1 moves in mode T, axis 2 in mode V until it is stopped, axis 3
   in mode S. All of them begin in the same sample time. */
#include <unistd.h>

#include "GT400.h"
#include "accepted.h"

static void choose(unsigned short axis) { ACCEPTED(GT_Axis(axis)); }

int main(void) {
  unsigned short axis, status;
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  for (axis = 1; axis <= 3; ++axis) {
    choose(axis);
    ACCEPTED(GT_AxisOn());
  }

  choose(1);
  ACCEPTED(GT_PrflT());
  ACCEPTED(GT_SetPos(8000));
  ACCEPTED(GT_SetVel(10));
  ACCEPTED(GT_SetAcc(0.1));

  choose(2);
  ACCEPTED(GT_PrflV());
  ACCEPTED(GT_SetVel(10));
  ACCEPTED(GT_SetAcc(0.1));

  choose(3);
  ACCEPTED(GT_PrflS());
  ACCEPTED(GT_SetPos(8000));
  ACCEPTED(GT_SetVel(10));
  ACCEPTED(GT_SetMAcc(0.1));
  ACCEPTED(GT_SetJerk(0.002));

  /* The registers take effect together. */
  ACCEPTED(GT_MltiUpdt(7));
  usleep(100000);
  choose(2);
  ACCEPTED(GT_SmthStp());
  ACCEPTED(GT_Update());
  choose(3);
  do {
    ACCEPTED(GT_GetSts(&status));
  } while (status & IN_MOTION);
  ACCEPTED(GT_Close());
  return 0;
}
