/* A laser cuts a square. It is switched on and off between segments, and its power follows the
   velocity along the path, so that the corners, at which the path comes to rest, are not burnt. */
#include "accepted.h"
#include "gts.h"

#define CRD 1
#define FIFO 0
#define LASER 0
#define DUTY 0             /* the power is the duty of pulses, percent */
#define PLANNED_VELOCITY 0 /* what the power follows */

static void Line(long x, long y) { ACCEPTED(GT_LnXY(CRD, x, y, 50, 1, 0, FIFO)); }

int main(void) {
  TCrdPrm crd = {0};
  short run;
  long segment;
  crd.dimension = 2;
  crd.synVelMax = 100;
  crd.synAccMax = 1;
  crd.profile[0] = 1;
  crd.profile[1] = 2;
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_AxisOn(1));
  ACCEPTED(GT_AxisOn(2));
  ACCEPTED(GT_SetCrdPrm(CRD, &crd));
  ACCEPTED(GT_LaserPowerMode(DUTY, 100, 0, LASER, 0));
  ACCEPTED(GT_LaserOutFrq(10, LASER));
  ACCEPTED(GT_BufLaserFollowMode(CRD, PLANNED_VELOCITY, FIFO, LASER, 0));
  /* 0.5 percent for 1 pulse/ms, from 5 to 80 percent. */
  ACCEPTED(GT_BufLaserFollowRatio(CRD, 0.5, 5, 80, FIFO, LASER));
  Line(5000, 0);
  ACCEPTED(GT_BufLaserOn(CRD, FIFO, LASER));
  Line(15000, 0);
  Line(15000, 10000);
  Line(5000, 10000);
  Line(5000, 0);
  ACCEPTED(GT_BufLaserOff(CRD, FIFO, LASER));
  ACCEPTED(GT_CrdStart(CRD, FIFO));
  do {
    ACCEPTED(GT_CrdStatus(CRD, &run, &segment, FIFO));
  } while (run == 1);
  ACCEPTED(GT_Close());
  return 0;
}
