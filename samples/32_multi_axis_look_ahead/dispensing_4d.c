/* The manual's example 2, first form: dispensing glue along a rectangle. At every corner the nozzle
   turns by 90 degrees, which is 10 mm of axis A. A is the fourth axis of the coordinate system; the
   velocity along the path is that of X, Y and Z. */
#include "path.h"

int main(void) {
  TLookAheadParameter parameter = Parameter();
  int limits[LA_AXIS_NUM] = {AXIS_LIMIT_NONE};
  int i;
  for (i = 0; i < 3; ++i) limits[i] = AXIS_LIMIT_MAX_VEL | AXIS_LIMIT_MAX_ACC;
  limits[3] = AXIS_LIMIT_MAX_VEL | AXIS_LIMIT_MAX_ACC | AXIS_LIMIT_MAX_DV;
  ACCEPTED(GT_Open(0, 1));
  SetUp(4);
  ACCEPTED(GT_SetupLookAheadCrd(CRD, NORMAL_THREE_AXIS));
  ACCEPTED(GT_SetAxisLimitModeLa(CRD, limits));
  ACCEPTED(GT_SetAxisVelValidModeLa(CRD, 0xF));
  ACCEPTED(GT_InitLookAheadEx(CRD, &parameter, FIFO, 0, NULL));
  ACCEPTED(GT_LnXYEx(CRD, 20, 20, 100, 1000, 0, 0, FIFO));
  ACCEPTED(GT_LnXYZAEx(CRD, 20, 40, 0, 10, 100, 1000, 1, 0, FIFO));
  ACCEPTED(GT_LnXYZAEx(CRD, 50, 40, 0, 20, 100, 1000, 2, 0, FIFO));
  ACCEPTED(GT_LnXYZAEx(CRD, 50, 20, 0, 30, 100, 1000, 3, 0, FIFO));
  ACCEPTED(GT_LnXYZAEx(CRD, 20, 20, 0, 40, 100, 1000, 4, 0, FIFO));
  while (GT_CrdDataEx(CRD, NULL, FIFO) != 0) {
  }
  Run();
  return GT_Close();
}
