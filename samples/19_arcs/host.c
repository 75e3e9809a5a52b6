/* A line, a semicircle, a quarter circle given by its radius, and one turn of a helix. */
#include "accepted.h"
#include "gts.h"

#define CRD 1
#define VEL 50  /* pulse/ms */
#define ACC 0.5 /* pulse/ms^2 */
#define CLOCKWISE 0
#define COUNTERCLOCKWISE 1

/* X, Y and Z of coordinate system 1 are axes 1, 2 and 3. */
static void SetUp(void) {
  TCrdPrm crd = {0};
  int axis;
  crd.dimension = 3;
  for (axis = 1; axis <= 3; ++axis) {
    crd.profile[axis - 1] = (short)axis;
    ACCEPTED(GT_AxisOn((short)axis));
  }
  crd.synVelMax = 500;
  crd.synAccMax = 2;
  crd.setOriginFlag = 1;
  ACCEPTED(GT_SetCrdPrm(CRD, &crd));
  ACCEPTED(GT_CrdClear(CRD, 0));
}

int main(void) {
  short run = 0;
  long segment = 0;

  ACCEPTED(GT_Open(0, 1));
  SetUp();
  ACCEPTED(GT_LnXYZ(CRD, 20000, 0, 0, VEL, ACC, VEL, 0));
  /* the centre, relative to the start of the arc */
  ACCEPTED(GT_ArcXYC(CRD, 20000, 20000, 0, 10000, COUNTERCLOCKWISE, VEL, ACC, VEL, 0));
  ACCEPTED(GT_ArcXYR(CRD, 10000, 10000, 10000, COUNTERCLOCKWISE, VEL, ACC, 0, 0));
  ACCEPTED(GT_HelixXYCZ(CRD, 10000, 10000, 8000, -5000, 0, CLOCKWISE, VEL, ACC, 0, 0));
  ACCEPTED(GT_CrdStart(CRD, 0));
  do {
    ACCEPTED(GT_CrdStatus(CRD, &run, &segment, 0));
  } while (run == 1);
  ACCEPTED(GT_Close());
  return 0;
}
