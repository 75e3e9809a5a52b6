/* The watch of a GE card records where a servo axis should be and where it is, a sample each
   millisecond. The host fetches the samples in batches, and looks for the largest following
   error. */
#include <unistd.h>

#include "accepted.h"
#include "gep.h"

#define AXIS 1
#define PLANNED 0x1 /* bits of GT_SetWatch */
#define ACTUAL 0x2
#define SAMPLES 100
#define CYCLES_BETWEEN 3 /* a sample every 4 cycles of 250 us */
#define BATCHES 7        /* 700 ms */

int main(void) {
  unsigned short config[AXIS_NUM] = {PLANNED | ACTUAL};
  long planned[SAMPLES], actual[SAMPLES];
  TWatchBuffer buffer = {0};
  long largest = 0;
  int batch, i;
  ACCEPTED(GT_Open(65535));
  ACCEPTED(GT_Reset());
  ACCEPTED(GT_AxisOn(AXIS));
  ACCEPTED(GT_SetKp(AXIS, 20));
  ACCEPTED(GT_PrflT(AXIS));
  ACCEPTED(GT_SetPos(AXIS, 5000));
  ACCEPTED(GT_SetVel(AXIS, 10));
  ACCEPTED(GT_SetAcc(AXIS, 0.1));
  ACCEPTED(GT_SetWatch(config, SAMPLES));
  ACCEPTED(GT_StartWatch(CYCLES_BETWEEN));
  ACCEPTED(GT_Update(AXIS));

  buffer.Axis[AXIS - 1].PrfPos = planned;
  buffer.Axis[AXIS - 1].AtlPos = actual;
  for (batch = 0; batch < BATCHES; ++batch) {
    unsigned short available;
    /* The card fills one bank while the other one waits for the host. */
    for (;;) {
      ACCEPTED(GT_GetWatch(&buffer, &available));
      if (available) break;
      usleep(20000);
    }
    for (i = 0; i < SAMPLES; ++i) {
      const long error = planned[i] - actual[i];
      if (error > largest) largest = error;
    }
    printf("after %d ms at %ld instead of %ld\n", (batch + 1) * SAMPLES, actual[SAMPLES - 1],
           planned[SAMPLES - 1]);
  }
  ACCEPTED(GT_StopWatch());
  printf("the following error was at most %ld pulses\n", largest);
  ACCEPTED(GT_Close());
  return largest >= 163 && largest <= 165 ? 0 : 1;
}
