/* A PVT table: positions and velocities at five times, and a cubic between neighbours. */
#include "accepted.h"
#include "gts.h"

#define AXIS 1
#define TABLE 1

int main(void) {
  double time[] = {0, 1000, 2000, 3000, 4500};
  double pos[] = {0, 10000, 30000, 40000, 0};
  double vel[] = {0, 20, 20, 0, 0};
  long status = 0;

  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_AxisOn(AXIS));
  ACCEPTED(GT_PrfPvt(AXIS));
  ACCEPTED(GT_PvtTable(TABLE, 5, time, pos, vel));
  ACCEPTED(GT_PvtTableSelect(AXIS, TABLE));
  ACCEPTED(GT_SetPvtLoop(AXIS, 1));
  ACCEPTED(GT_PvtStart(1 << (AXIS - 1)));
  do {
    ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
  } while (status & IN_MOTION);
  ACCEPTED(GT_Close());
  return 0;
}
