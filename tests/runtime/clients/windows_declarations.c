/* What hosts in C#, Visual Basic and Python declare by themselves, written for Windows: a `long` of
   32 bits, alone, in arrays and in structures, and the layouts of the vendor's basic header. Linked
   with libgts_long32. */
#include <stdint.h>
#include <string.h>

#include "check.h"

typedef struct {
  int16_t dimension;
  int16_t profile[8];
  double synVelMax;
  double synAccMax;
  int16_t evenTime;
  int16_t setOriginFlag;
  int32_t originPos[8];
} CrdPrm;

typedef struct {
  int16_t encoder;
  int16_t probeType;
  int16_t probeIndex;
  int16_t offset;
  int16_t windowOnly;
  int32_t firstPosition;
  int32_t lastPosition;
} Trigger;

int16_t GT_Open(int16_t channel, int16_t param);
int16_t GT_Close(void);
int16_t GT_ClrSts(int16_t axis, int16_t count);
int16_t GT_AxisOn(int16_t axis);
int16_t GT_GetSts(int16_t axis, int32_t* status, int16_t count, uint32_t* clock);
int16_t GT_SetLongVar(int16_t index, int32_t value);
int16_t GT_GetLongVar(int16_t index, int32_t* value);
int16_t GT_SetPrfPos(int16_t profile, int32_t position);
int16_t GT_GetPrfPos(int16_t profile, double* position, int16_t count, uint32_t* clock);
int16_t GT_SetCrdPrm(int16_t crd, CrdPrm* parameters);
int16_t GT_GetCrdPrm(int16_t crd, CrdPrm* parameters);
int16_t GT_SetTrigger(int16_t index, Trigger* trigger);
int16_t GT_GetTrigger(int16_t index, Trigger* trigger);
int16_t GT_EncOff(int16_t encoder);
int16_t GT_CompareData(int16_t encoder, int16_t source, int16_t type, int16_t level, int16_t time,
                       int32_t* first, int16_t first_count, int32_t* second, int16_t second_count);
int16_t GTM_GetLongVar(int16_t card, int16_t index, int32_t* value);

enum { kBehind = 0x5A5A5A5A };

static void ValuesHave32Bits(void) {
  int32_t value[2] = {0, kBehind};
  double position = 0;
  ACCEPTED(GT_SetLongVar(0, INT32_MIN));
  ACCEPTED(GT_GetLongVar(0, value));
  CHECK_EQ(value[0], INT32_MIN);
  CHECK_EQ(value[1], kBehind);
  ACCEPTED(GTM_GetLongVar(0, 0, value));
  CHECK_EQ(value[0], INT32_MIN);
  CHECK_EQ(value[1], kBehind);
  ACCEPTED(GT_SetPrfPos(2, -2147483647));
  ACCEPTED(GT_GetPrfPos(2, &position, 1, NULL));
  CHECK_EQ(position, -2147483647.0);
}

static void ArraysAreFilledElementByElement(void) {
  int32_t status[5] = {-1, -1, -1, -1, kBehind};
  uint32_t clock[2] = {0, kBehind};
  ACCEPTED(GT_AxisOn(3));
  ACCEPTED(GT_GetSts(1, status, 4, clock));
  CHECK_EQ(status[1] & 0x200, 0); /* the bit of an axis that is on */
  CHECK_EQ(status[2] & 0x200, 0x200);
  CHECK_EQ(status[3] & 0x200, 0);
  CHECK_EQ(status[4], kBehind);
  CHECK_EQ(clock[1], kBehind);
}

static void ArraysAreReadElementByElement(void) {
  int32_t first[2] = {1000, 2000};
  ACCEPTED(GT_EncOff(1)); /* the pulses are compared */
  ACCEPTED(GT_CompareData(1, 0, 0, 0, 100, first, 2, NULL, 0));
}

static void StructuresHaveTheirLayout(void) {
  struct {
    CrdPrm parameters;
    int32_t behind;
  } set, read;
  memset(&set, 0, sizeof set);
  memset(&read, 0x5A, sizeof read);
  CHECK_EQ(sizeof(CrdPrm), 80);
  set.parameters.dimension = 2;
  set.parameters.profile[0] = 1;
  set.parameters.profile[1] = 2;
  set.parameters.synVelMax = 500;
  set.parameters.synAccMax = 1;
  set.parameters.setOriginFlag = 1;
  set.parameters.originPos[0] = -100000;
  set.parameters.originPos[1] = 200000;
  ACCEPTED(GT_SetCrdPrm(1, &set.parameters));
  ACCEPTED(GT_GetCrdPrm(1, &read.parameters));
  CHECK_EQ(read.parameters.dimension, 2);
  CHECK_EQ(read.parameters.profile[1], 2);
  CHECK_EQ(read.parameters.synVelMax, 500);
  CHECK_EQ(read.parameters.originPos[0], -100000);
  CHECK_EQ(read.parameters.originPos[1], 200000);
  CHECK_EQ(read.behind, kBehind);
}

static void BasicLayoutsServe(void) {
  struct {
    Trigger trigger;
    int32_t behind;
  } read;
  Trigger trigger = {2, 1, 3, 40, 1, -1000000, 2000000};
  memset(&read, 0x5A, sizeof read);
  ACCEPTED(GT_SetTrigger(1, &trigger));
  ACCEPTED(GT_GetTrigger(1, &read.trigger));
  CHECK_EQ(read.trigger.probeIndex, 3);
  CHECK_EQ(read.trigger.offset, 40);
  CHECK_EQ(read.trigger.windowOnly, 1);
  CHECK_EQ(read.trigger.firstPosition, -1000000);
  CHECK_EQ(read.trigger.lastPosition, 2000000);
  CHECK_EQ(read.behind, kBehind);
}

int main(void) {
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_ClrSts(1, 8));
  ValuesHave32Bits();
  ArraysAreFilledElementByElement();
  ArraysAreReadElementByElement();
  StructuresHaveTheirLayout();
  BasicLayoutsServe();
  ACCEPTED(GT_Close());
  return 0;
}
