/* Smart homing: axis 1 searches for its home switch at 5 pulse/ms and for the index mark after it
   at 1 pulse/ms, and moves 250 pulses further. That position becomes 0. */
#include "accepted.h"
#include "gts.h"

#define AXIS 1

int main(void) {
  THomePrm prm;
  THomeStatus status;
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_AxisOn(AXIS));
  ACCEPTED(GT_GetHomePrm(AXIS, &prm));
  prm.mode = HOME_MODE_HOME_INDEX;
  prm.moveDir = 1;
  prm.indexDir = 1;
  prm.edge = 0;
  prm.velHigh = 5;
  prm.velLow = 1;
  prm.acc = 0.1;
  prm.dec = 0.1;
  prm.smoothTime = 0;
  prm.homeOffset = 250;
  prm.searchHomeDistance = 50000;
  prm.searchIndexDistance = 5000;
  prm.escapeStep = 1000;
  ACCEPTED(GT_GoHome(AXIS, &prm));
  do {
    ACCEPTED(GT_GetHomeStatus(AXIS, &status));
  } while (status.run);
  printf("stage %d, error %d, home at %ld\n", status.stage, status.error, status.targetPos);
  if (status.error != HOME_ERROR_NONE) return 1;
  ACCEPTED(GT_ZeroPos(AXIS, 1));
  ACCEPTED(GT_Close());
  return 0;
}
