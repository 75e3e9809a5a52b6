/* Starts the EtherCAT bus and moves an axis on it (GTS manual S2, examples 5-1 and 5-5). The folder
   of the program contains Gecat.eni, which describes the slaves. */
#include "accepted.h"
#include "gts.h"

#define AXIS 1
#define ENABLED 0x200 /* bit 9 of the status word */

static void wait_until_enabled(void) {
  long status;
  do {
    ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
  } while (!(status & ENABLED));
}

int main(void) {
  short ready;
  short slaves;
  short drives;
  long position;
  long status;
  TTrapPrm trap;
  ACCEPTED(GT_Open(CHANNEL_PCI_ECAT, 1));
  ACCEPTED(GT_InitEcatComm());
  do {
    ACCEPTED(GT_IsEcatReady(&ready));
  } while (ready != 1);
  ACCEPTED(GT_StartEcatComm());
  ACCEPTED(GT_Reset());
  ACCEPTED(GT_GetEcatSlaves(&slaves));
  ACCEPTED(GT_GetMcEcatAxisNum(&drives));
  printf("%d slaves, %d drives\n", slaves, drives);

  ACCEPTED(GT_AxisOn(AXIS));
  wait_until_enabled();
  ACCEPTED(GT_PrfTrap(AXIS));
  ACCEPTED(GT_GetTrapPrm(AXIS, &trap));
  trap.acc = 0.5;
  trap.dec = 0.5;
  ACCEPTED(GT_SetTrapPrm(AXIS, &trap));
  ACCEPTED(GT_SetVel(AXIS, 20));
  ACCEPTED(GT_SetPos(AXIS, 5000));
  ACCEPTED(GT_Update(1 << (AXIS - 1)));
  do {
    ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
  } while (status & IN_MOTION);
  ACCEPTED(GT_GetEcatEncPos(AXIS, &position));
  printf("the drive is at %ld\n", position);
  ACCEPTED(GT_TerminateEcatComm());
  ACCEPTED(GT_Close());
  return 0;
}
