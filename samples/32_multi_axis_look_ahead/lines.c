/* The manual's example 1: 300 short lines in mm, three axes without limits, no follower. */
#include "path.h"

int main(void) {
  TLookAheadParameter parameter = Parameter();
  double x = 0;
  double y = 0;
  long space = 0;
  int i;
  ACCEPTED(GT_Open(0, 1));
  SetUp(2);
  ACCEPTED(GT_SetupLookAheadCrd(CRD, NORMAL_THREE_AXIS));
  ACCEPTED(GT_InitLookAheadEx(CRD, &parameter, FIFO, 0, NULL));
  for (i = 0; i < 300; ++i) {
    /* A segment that is refused because the buffer is full is sent again. */
    while (GT_LnXYEx(CRD, 8 + x, 9 + y, 100, 800, i, 0, FIFO) != 0) {
      do {
        ACCEPTED(GT_CrdSpace(CRD, &space, FIFO));
      } while (space == 0);
    }
    x += 1.6;
    y += 1.852;
  }
  while (GT_CrdDataEx(CRD, NULL, FIFO) != 0) {
  }
  Run();
  return GT_Close();
}
