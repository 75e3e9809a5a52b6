/* Homing by the drive with method 3: the index mark left of a positive home switch (GTS manual S2,
   example 5-2). */
#include "accepted.h"
#include "gts.h"

#define AXIS 1
#define ENABLED 0x200 /* bit 9 of the status word */
#define SUCCEEDED 3

int main(void) {
  short ready;
  short homing;
  long status;
  long position;
  ACCEPTED(GT_Open(CHANNEL_PCI_ECAT, 1));
  ACCEPTED(GT_InitEcatComm());
  do {
    ACCEPTED(GT_IsEcatReady(&ready));
  } while (ready != 1);
  ACCEPTED(GT_StartEcatComm());
  ACCEPTED(GT_AxisOn(AXIS));
  do {
    ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
  } while (!(status & ENABLED));

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
