/* A list of a GT400 card: two lines and two half circles, which are stopped on the way and go on
   from the break point. */
#include <unistd.h>

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
  double maps[2][5] = {{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}};
  double point[4];
  unsigned short axis, number;
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  for (axis = 1; axis <= 2; ++axis) {
    ACCEPTED(GT_Axis(axis));
    ACCEPTED(GT_AxisOn());
    ACCEPTED(GT_MapAxis(axis, maps[axis - 1]));
  }

  ACCEPTED(GT_StrtList());
  ACCEPTED(GT_MvXY(0, 0, 20, 0.2));
  ACCEPTED(GT_LnXY(8000, 0));
  ACCEPTED(GT_ArcXY(8000, 2000, 180));
  ACCEPTED(GT_LnXY(0, 4000));
  ACCEPTED(GT_ArcXY(0, 2000, 180));
  ACCEPTED(GT_EndList());
  ACCEPTED(GT_StrtMtn());

  usleep(200000);
  ACCEPTED(GT_StpMtn());
  wait_for_rest();
  ACCEPTED(GT_GetMtnNm(&number));
  ACCEPTED(GT_GetBrkPnt(point));
  printf("stopped in segment %d at (%.3f, %.3f)\n", number, point[0], point[1]);
  usleep(100000);
  ACCEPTED(GT_StrtMtn());
  wait_for_rest();
  ACCEPTED(GT_Close());
  return number == 3 ? 0 : 1;
}
