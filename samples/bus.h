/* What the host programs of the EtherCAT samples share: the bus, as 33_bus_start shows it step by
   step, and the enabling of a drive. */
#ifndef ONCARD_SAMPLES_BUS_H
#define ONCARD_SAMPLES_BUS_H

#include "accepted.h"
#include "gts.h"

#define ENABLED 0x200 /* bit 9 of the status word */

/* Opens the card and starts its bus. */
__attribute__((unused)) static void OpenBus(void) {
  short ready;
  ACCEPTED(GT_Open(CHANNEL_PCI_ECAT, 1));
  ACCEPTED(GT_InitEcatComm());
  do {
    ACCEPTED(GT_IsEcatReady(&ready));
  } while (ready != 1);
  ACCEPTED(GT_StartEcatComm());
}

/* Enables the drive of an axis. */
__attribute__((unused)) static void Enable(short axis) {
  long status;
  ACCEPTED(GT_AxisOn(axis));
  do {
    ACCEPTED(GT_GetSts(axis, &status, 1, NULL));
  } while (!(status & ENABLED));
}

#endif
