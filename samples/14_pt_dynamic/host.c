/* GTS manual, example 7-4: velocity 50 sin(2 pi t / 1000), in segments of 16 ms that the host
   writes to the dynamic FIFO while the axis moves. There are two periods of 63 segments: 62 of 16 ms,
   and a last one of 8 ms that ends at rest. */
#include <math.h>

#include "accepted.h"
#include "gts.h"

#define AXIS 1
#define PERIOD_MS 1000
#define PERIODS 2
#define STEP_MS 16
#define PI 3.14159265358979323846

static int started = 0;

/* Waits until the FIFO has space. When it is full for the first time, the motion is started. */
static void WaitForRoom(void) {
  short space = 0;
  for (;;) {
    ACCEPTED(GT_PtSpace(AXIS, &space, 0));
    if (space > 0) return;
    if (!started) ACCEPTED(GT_PtStart(1 << (AXIS - 1), 0));
    started = 1;
  }
}

static void FeedPeriod(int begin) {
  double pos = 0;
  double vel = 0;
  int ms;
  for (ms = STEP_MS; ms < PERIOD_MS; ms += STEP_MS) {
    const double next = 50 * sin(2 * PI * ms / PERIOD_MS);
    pos += (vel + next) / 2 * STEP_MS;
    vel = next;
    WaitForRoom();
    ACCEPTED(GT_PtData(AXIS, pos, begin + ms, PT_SEGMENT_NORMAL, 0));
  }
  WaitForRoom();
  ACCEPTED(GT_PtData(AXIS, 0, begin + PERIOD_MS, PT_SEGMENT_STOP, 0));
}

int main(void) {
  long status = 0;
  int period;
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_AxisOn(AXIS));
  ACCEPTED(GT_PrfPt(AXIS, PT_MODE_DYNAMIC));
  ACCEPTED(GT_PtClear(AXIS, 0));
  for (period = 0; period < PERIODS; ++period) FeedPeriod(period * PERIOD_MS);
  do {
    ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
  } while (status & IN_MOTION);
  ACCEPTED(GT_Close());
  return 0;
}
