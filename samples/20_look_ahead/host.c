/* A circle of 72 short lines, first without look-ahead, so that every line ends at rest, and then
   with it. */
#include <math.h>

#include "accepted.h"
#include "gts.h"

#define CRD 1
#define VEL 50       /* pulse/ms */
#define ACC 0.5      /* pulse/ms^2 */
#define TURN_TIME 5  /* ms, of GT_InitLookAhead */
#define TURN_ACC 1   /* pulse/ms^2 */
#define SEGMENTS 72
#define RADIUS 5000
#define PI 3.14159265358979323846

static TCrdData look_ahead[SEGMENTS];

/* The X and Y axes of coordinate system 1 are axes 1 and 2. */
static void SetUp(void) {
  TCrdPrm crd = {0};
  crd.dimension = 2;
  crd.profile[0] = 1;
  crd.profile[1] = 2;
  crd.synVelMax = 500;
  crd.synAccMax = 2;
  crd.setOriginFlag = 1;
  ACCEPTED(GT_AxisOn(1));
  ACCEPTED(GT_AxisOn(2));
  ACCEPTED(GT_SetCrdPrm(CRD, &crd));
  ACCEPTED(GT_CrdClear(CRD, 0));
}

static void Circle(void) {
  int i;
  for (i = 1; i <= SEGMENTS; ++i) {
    const double angle = 2 * PI * i / SEGMENTS;
    ACCEPTED(GT_LnXY(CRD, lround(RADIUS * sin(angle)), lround(RADIUS * (1 - cos(angle))), VEL, ACC,
                     0, 0));
  }
}

/* Executes the content of the FIFO. Returns the time that it took, in ms. */
static unsigned long Run(void) {
  unsigned long begin = 0;
  unsigned long end = 0;
  short run = 0;
  long segment = 0;
  ACCEPTED(GT_GetClock(&begin, NULL));
  ACCEPTED(GT_CrdStart(CRD, 0));
  do {
    ACCEPTED(GT_CrdStatus(CRD, &run, &segment, 0));
  } while (run == 1);
  ACCEPTED(GT_GetClock(&end, NULL));
  return end - begin;
}

int main(void) {
  unsigned long without, with;
  ACCEPTED(GT_Open(0, 1));
  SetUp();
  Circle();
  without = Run();
  ACCEPTED(GT_InitLookAhead(CRD, 0, TURN_TIME, TURN_ACC, SEGMENTS, look_ahead));
  Circle();
  ACCEPTED(GT_CrdData(CRD, NULL, 0));
  with = Run();
  ACCEPTED(GT_Close());
  printf("without look-ahead %lu ms, with %lu ms\n", without, with);
  return 0;
}
