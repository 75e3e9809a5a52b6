/* Axes on the EtherCAT bus, a path through the multi-axis look-ahead, and a motion program on the
   card beside it. The program is in the folder in which the host runs. */
#include <string.h>

#include "LookAheadEx.h"
#include "bus.h"

#define CRD 1
#define FIFO 0
#define THREAD_VALVE 0
#define THREAD_COUNT 1

static void Start(short thread, char* name) {
  short function;
  ACCEPTED(GT_GetFunId(name, &function));
  ACCEPTED(GT_Bind(thread, function, thread));
  ACCEPTED(GT_RunThread(thread));
}

static void SetGlobal(char* name, double value) {
  TVarInfo variable;
  ACCEPTED(GT_GetVarId(NULL, name, &variable));
  ACCEPTED(GT_SetVarValue(-1, &variable, &value, 1));
}

/* Axes 1 and 2 are X and Y; 1000 pulses are 1 mm. */
static void SetUpPath(void) {
  TCrdPrm crd;
  TLookAheadParameter parameter;
  int i;
  memset(&crd, 0, sizeof(crd));
  crd.dimension = 2;
  crd.synVelMax = 500;
  crd.synAccMax = 1;
  crd.evenTime = 50;
  crd.profile[0] = 1;
  crd.profile[1] = 2;
  ACCEPTED(GT_SetCrdPrm(CRD, &crd));
  ACCEPTED(GT_CrdClear(CRD, FIFO));
  memset(&parameter, 0, sizeof(parameter));
  parameter.lookAheadNum = 20;
  parameter.time = 0.01;
  parameter.radiusRatio = 1;
  for (i = 0; i < LA_AXIS_NUM; ++i) {
    parameter.vMax[i] = 100;
    parameter.aMax[i] = 500;
    parameter.DVMax[i] = 500;
    parameter.scale[i] = 1000;
    parameter.axisRelation[i] = (short)(i + 1);
  }
  ACCEPTED(GT_SetupLookAheadCrd(CRD, NORMAL_THREE_AXIS));
  ACCEPTED(GT_InitLookAheadEx(CRD, &parameter, FIFO, 0, NULL));
}

int main(void) {
  TCompileInfo nowhere = {NULL, NULL, NULL};
  TThreadSts valve;
  TThreadSts count;
  short run = 0;
  long segment = 0;
  long position;
  OpenBus();
  Enable(1);
  Enable(2);

  ACCEPTED(GT_Compile("bus_path.c", &nowhere));
  ACCEPTED(GT_Download("bus_path.bin"));
  SetGlobal("open_at", 5000);
  SetGlobal("close_at", 15000);
  Start(THREAD_VALVE, "valve");
  Start(THREAD_COUNT, "count");

  SetUpPath();
  ACCEPTED(GT_LnXYEx(CRD, 10, 0, 100, 1000, 1, 0, FIFO));
  ACCEPTED(GT_LnXYEx(CRD, 20, 1, 100, 1000, 2, 0, FIFO));
  ACCEPTED(GT_LnXYEx(CRD, 20, 10, 100, 1000, 3, 0, FIFO));
  while (GT_CrdDataEx(CRD, NULL, FIFO) != 0) {
  }
  ACCEPTED(GT_CrdStart(CRD, FIFO));
  do {
    ACCEPTED(GT_CrdStatus(CRD, &run, &segment, FIFO));
    ACCEPTED(GT_GetThreadSts(THREAD_VALVE, &valve));
    ACCEPTED(GT_GetThreadSts(THREAD_COUNT, &count));
  } while (run == 1 || valve.run == 1 || count.run == 1);
  ACCEPTED(GT_GetEcatEncPos(1, &position));
  printf("%ld segments, %.0f filled, drive 1 is at %ld\n", segment, count.result, position);
  ACCEPTED(GT_Close());
  return 0;
}
