/* Lines and arcs of a GT400 card, in millimetres: a screw of 2000 pulses per millimetre on each
   axis. A second motor of the X axis is mounted the other way round. Each segment is executed at
   once. */
#include "GT400.h"
#include "accepted.h"

#define NO_PATH 1 /* bit 0 of the status word of the path */

static void wait_for_rest(void) {
  unsigned short status;
  do {
    ACCEPTED(GT_GetCrdSts(&status));
  } while (!(status & NO_PATH));
}

int main(void) {
  /* axis = Cx x + Cy y + Cz z + Ca a + C */
  double maps[3][5] = {{2000, 0, 0, 0, 0}, {0, 2000, 0, 0, 0}, {-2000, 0, 0, 0, 0}};
  unsigned short axis;
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  for (axis = 1; axis <= 3; ++axis) {
    ACCEPTED(GT_Axis(axis));
    ACCEPTED(GT_AxisOn());
    ACCEPTED(GT_MapAxis(axis, maps[axis - 1]));
  }
  ACCEPTED(GT_SetSynVel(0.01));
  ACCEPTED(GT_SetSynAcc(0.0001));

  ACCEPTED(GT_LnXY(10, 0));
  wait_for_rest();
  ACCEPTED(GT_ArcXY(10, 5, 180));
  wait_for_rest();
  ACCEPTED(GT_LnXY(0, 10));
  wait_for_rest();
  ACCEPTED(GT_ArcXYP(0, 0, 5, 1));
  wait_for_rest();
  ACCEPTED(GT_Close());
  return 0;
}
