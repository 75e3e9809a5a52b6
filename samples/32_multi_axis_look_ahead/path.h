/* What the host programs of this sample share: the coordinate system, the look-ahead parameters and
   the run of the manual's examples. */
#ifndef ONCARD_SAMPLES_PATH_H
#define ONCARD_SAMPLES_PATH_H

#include <string.h>

#include "LookAheadEx.h"
#include "accepted.h"

#define CRD 1
#define FIFO 0

/* Axes 1 to `dimension` are the axes of coordinate system 1. */
static void SetUp(short dimension) {
  TCrdPrm crd;
  short axis;
  memset(&crd, 0, sizeof(crd));
  crd.dimension = dimension;
  crd.synVelMax = 500; /* pulse/ms */
  crd.synAccMax = 1;   /* pulse/ms^2 */
  crd.evenTime = 50;   /* ms; the multi-axis look-ahead does not use it */
  for (axis = 1; axis <= dimension; ++axis) crd.profile[axis - 1] = axis;
  for (axis = 1; axis <= 4; ++axis) ACCEPTED(GT_AxisOn(axis));
  ACCEPTED(GT_SetCrdPrm(CRD, &crd));
  ACCEPTED(GT_CrdClear(CRD, FIFO));
}

/* 200 segments, a time constant of 0.1 s, 1000 pulses per mm. Unused by pulses.c. */
__attribute__((unused)) static TLookAheadParameter Parameter(void) {
  TLookAheadParameter parameter;
  int i;
  memset(&parameter, 0, sizeof(parameter));
  parameter.lookAheadNum = 200;
  parameter.time = 0.1;
  parameter.radiusRatio = 0.01;
  for (i = 0; i < LA_AXIS_NUM; ++i) {
    parameter.vMax[i] = 100;   /* mm/s */
    parameter.aMax[i] = 500;   /* mm/s^2 */
    parameter.DVMax[i] = 500;  /* times the time constant: 50 mm/s at once */
    parameter.scale[i] = 1000; /* pulse/mm */
    parameter.axisRelation[i] = (short)(i + 1);
  }
  return parameter;
}

/* Executes the path. */
static void Run(void) {
  short run = 0;
  long segment = 0;
  ACCEPTED(GT_CrdStart(CRD, FIFO));
  do {
    ACCEPTED(GT_CrdStatus(CRD, &run, &segment, FIFO));
  } while (run == 1);
  printf("%ld segments\n", segment);
}

#endif
