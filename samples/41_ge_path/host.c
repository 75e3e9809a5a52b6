/* A list of a GE card for paths: two lines and two half circles, which are stopped on the way and
   go on from the break point. A watch records where the axes are. */
#include <unistd.h>

#include "accepted.h"
#include "ges.h"

#define NO_PATH 1 /* bit 0 of the path status word */
#define SAMPLES 16
#define CYCLES_BETWEEN 399 /* a sample every 400 cycles of 250 us */

static void wait_for_rest(void) {
  unsigned short status;
  do {
    ACCEPTED(GT_GetCrdSts(&status));
  } while (!(status & NO_PATH));
}

int main(void) {
  unsigned short config[AXIS_NUM] = {1, 1}; /* the profile positions of axes 1 and 2 */
  unsigned short available;
  long x[SAMPLES], y[SAMPLES];
  TWatchBuffer buffer = {0};
  ACCEPTED(GT_Open(65535));
  ACCEPTED(GT_Reset());
  ACCEPTED(GT_AxisOn(1));
  ACCEPTED(GT_AxisOn(2));
  ACCEPTED(GT_SetWatch(config, SAMPLES));
  ACCEPTED(GT_StartWatch(CYCLES_BETWEEN));

  ACCEPTED(GT_StrtList());
  ACCEPTED(GT_MvXY(0, 0, 20, 0.5));
  ACCEPTED(GT_LnXY(8000, 0));
  ACCEPTED(GT_ArcXY(8000, 2000, 180));
  ACCEPTED(GT_LnXY(0, 4000));
  ACCEPTED(GT_ArcXY(0, 2000, 180));
  ACCEPTED(GT_EndList());
  ACCEPTED(GT_StrtMtn());

  usleep(300000);
  ACCEPTED(GT_StpMtn());
  wait_for_rest();
  usleep(100000);
  ACCEPTED(GT_RestoreMtn());
  wait_for_rest();

  buffer.Axis[0].PrfPos = x;
  buffer.Axis[1].PrfPos = y;
  ACCEPTED(GT_GetWatch(&buffer, &available));
  if (available) printf("at rest after 400 ms at (%ld, %ld)\n", x[4], y[4]);
  ACCEPTED(GT_Close());
  return available && x[4] == 6020 ? 0 : 1;
}
