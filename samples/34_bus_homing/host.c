/* Homing by the drive with method 3: the index mark left of a positive home switch (GTS manual S2,
   example 5-2). */
#include "bus.h"

#define AXIS 1
#define SUCCEEDED 3

int main(void) {
  short homing;
  long position;
  OpenBus();
  Enable(AXIS);

  ACCEPTED(GT_SetHomingMode(AXIS, 6));
  ACCEPTED(GT_SetEcatHomingPrm(AXIS, 3, 50, 3, 1, 0, 0));
  ACCEPTED(GT_StartEcatHoming(AXIS));
  do {
    ACCEPTED(GT_GetEcatHomingStatus(AXIS, &homing));
  } while (homing == 0);
  printf("homing ended with %d\n", homing);
  if (homing != SUCCEEDED) return 1;
  ACCEPTED(GT_SetHomingMode(AXIS, 8));

  ACCEPTED(GT_GetEcatEncPos(AXIS, &position));
  printf("the drive is at %ld\n", position);
  ACCEPTED(GT_Close());
  return 0;
}
