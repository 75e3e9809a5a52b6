/* The manual's example 2, second form: the nozzle is axis 3, outside the coordinate system of X and
   Y. It follows each side of the rectangle by 10 mm, and its limits hold back the path. */
#include "path.h"

static void Side(double x, double y, long number) {
  ACCEPTED(GT_BufGearEx(CRD, 3, 10, FIFO));
  ACCEPTED(GT_LnXYEx(CRD, x, y, 100, 1000, number, 0, FIFO));
}

int main(void) {
  TLookAheadParameter parameter = Parameter();
  int follows[LA_AXIS_NUM] = {0};
  follows[2] = AXIS_LIMIT_MAX_VEL | AXIS_LIMIT_MAX_ACC | AXIS_LIMIT_MAX_DV;
  ACCEPTED(GT_Open(0, 1));
  SetUp(2);
  ACCEPTED(GT_SetupLookAheadCrd(CRD, NORMAL_THREE_AXIS));
  ACCEPTED(GT_SetFollowAxisParaLa(CRD, follows, parameter.vMax, parameter.aMax, parameter.DVMax));
  ACCEPTED(GT_InitLookAheadEx(CRD, &parameter, FIFO, 0, NULL));
  ACCEPTED(GT_LnXYEx(CRD, 20, 20, 100, 1000, 0, 0, FIFO));
  Side(20, 40, 1);
  Side(50, 40, 2);
  Side(50, 20, 3);
  Side(20, 20, 4);
  while (GT_CrdDataEx(CRD, NULL, FIFO) != 0) {
  }
  Run();
  return GT_Close();
}
