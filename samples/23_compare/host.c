/* 2-D compare used in one dimension: while axis 1 moves to 30000, channel 0 outputs a pulse of
   500 us when the encoder passes 10000, and another one when it passes 20000. */
#include "accepted.h"
#include "gts.h"

#define AXIS 1
#define CHANNEL 0

int main(void) {
  TTrapPrm trap = {1, 1, 0, 0};
  T2DComparePrm prm = {0};
  T2DCompareData points[2] = {{0, 10000}, {0, 20000}};
  long status = 0;
  short running = 0;
  long count = 0;
  short fifo = 0;
  short space = 0;
  short waiting = 0;
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_AxisOn(AXIS));
  ACCEPTED(GT_2DCompareMode(CHANNEL, COMPARE2D_MODE_1D));
  prm.encx = 2;
  prm.ency = AXIS;
  prm.source = 1;
  prm.time = 500;
  prm.maxerr = 3;
  ACCEPTED(GT_2DCompareSetPrm(CHANNEL, &prm));
  ACCEPTED(GT_2DCompareData(CHANNEL, 2, points, 0));
  ACCEPTED(GT_2DCompareStart(CHANNEL));
  ACCEPTED(GT_PrfTrap(AXIS));
  ACCEPTED(GT_SetTrapPrm(AXIS, &trap));
  ACCEPTED(GT_SetVel(AXIS, 100));
  ACCEPTED(GT_SetPos(AXIS, 30000));
  ACCEPTED(GT_Update(1 << (AXIS - 1)));
  do {
    ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
  } while (status & IN_MOTION);
  ACCEPTED(GT_2DCompareStatus(CHANNEL, &running, &count, &fifo, &space, &waiting));
  printf("%ld pulses\n", count);
  ACCEPTED(GT_Close());
  return count == 2 ? 0 : 1;
}
