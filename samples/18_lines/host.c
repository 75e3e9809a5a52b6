/* GTS manual, example 6-10: around a hexagon, with outputs and pauses between the lines. */
#include "accepted.h"
#include "gts.h"

#define CRD 1
#define VEL 100 /* pulse/ms */
#define ACC 0.1 /* pulse/ms^2 */

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

static void Line(long x, long y) { ACCEPTED(GT_LnXY(CRD, x, y, VEL, ACC, 0, 0)); }

int main(void) {
  short run = 0;
  long segment = 0;

  ACCEPTED(GT_Open(0, 1));
  SetUp();
  Line(200000, 0);
  Line(100000, 173205);
  ACCEPTED(GT_BufIO(CRD, MC_GPO, 0xffff, 0x55, 0));
  Line(-100000, 173205);
  ACCEPTED(GT_BufIO(CRD, MC_GPO, 0xffff, 0xaa, 0));
  Line(-200000, 0);
  ACCEPTED(GT_BufDelay(CRD, 400, 0));
  Line(-100000, -173205);
  ACCEPTED(GT_BufIO(CRD, MC_GPO, 0xffff, 0x55, 0));
  ACCEPTED(GT_BufDelay(CRD, 100, 0));
  Line(100000, -173205);
  Line(200000, 0);
  ACCEPTED(GT_CrdStart(CRD, 0));
  do {
    ACCEPTED(GT_CrdStatus(CRD, &run, &segment, 0));
  } while (run == 1);
  ACCEPTED(GT_Close());
  return 0;
}
