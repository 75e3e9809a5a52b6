#pragma once

// A few lines in the style of the vendor's basic header: no includes, functions are __stdcall,
// TTrigger has neither `sense` nor `loop`, TCrdData has four coordinates.
#define GT_API extern "C" short __stdcall

#define CAPTURE_HOME 1
#define INTERPOLATION_AXIS_MAX 4
#define CRD_OPERATION_DATA_EXT_MAX 2

typedef struct CrdPrm {
  short dimension;
  short profile[8];
  double synVelMax;
  double synAccMax;
  short evenTime;
  short setOriginFlag;
  long originPos[8];
} TCrdPrm;

typedef struct CrdBufOperation {
  short flag;
  unsigned short delay;
  short doType;
  unsigned short doMask;
  unsigned short doValue;
  unsigned short dataExt[CRD_OPERATION_DATA_EXT_MAX];
} TCrdBufOperation;

typedef struct CrdData {
  short motionType;
  short circlePlat;
  long pos[INTERPOLATION_AXIS_MAX];
  double radius;
  short circleDir;
  double center[3];
  double vel;
  double acc;
  short velEndZero;
  TCrdBufOperation operation;
  double cos[INTERPOLATION_AXIS_MAX];
  double velEnd;
  double velEndAdjust;
  double r;
} TCrdData;

typedef struct Trigger {
  short encoder;
  short probeType;
  short probeIndex;
  short offset;
  short windowOnly;
  long firstPosition;
  long lastPosition;
} TTrigger;

GT_API GT_Open(short channel = 0, short param = 1);
GT_API GT_Close(void);
GT_API GT_Reset();
GT_API GT_ClrSts(short axis, short count = 1);
GT_API GT_AxisOn(short axis);
GT_API GT_SetTrigger(short i, TTrigger* pTrigger);
GT_API GT_GetTrigger(short i, TTrigger* pTrigger);
GT_API GT_SetCrdPrm(short crd, TCrdPrm* pCrdPrm);
GT_API GT_CrdData(short crd, TCrdData* pCrdData, short fifo = 0);
GT_API GT_CrdStart(short mask, short option);
GT_API GT_CrdStatus(short crd, short* pRun, long* pSegment, short fifo = 0);
GT_API GT_GetCrdPos(short crd, double* pPos);
