// What hosts do that were written for a 32-bit `long`: comparing words with unsigned numbers,
// numbers that wrap, arrays of int in place of arrays of long, a mask most of which was never set.
// Only valid with -m32.
#include <limits.h>
#include <windows.h>

#include "gts.h"

#include "check.h"

static_assert(sizeof(long) == 4 && sizeof(DWORD) == 4 && sizeof(void*) == 4, "for 32 bits");

static void WordsAreComparedWithUnsignedOnes() {
  long word = 0;
  ACCEPTED(GT_SetLongVar(0, 0x80000000));
  ACCEPTED(GT_GetLongVar(0, &word));
  CHECK_EQ(word == static_cast<long>(0x80000000), 1);
  CHECK_EQ(static_cast<DWORD>(word) == 0x80000000, 1);
  CHECK_EQ(word, INT_MIN);
}

static void NumbersWrap() {
  DWORD position = LONG_MAX;
  double reached = 0;
  position += 2;
  ACCEPTED(GT_SetPrfPos(2, position));
  ACCEPTED(GT_GetPrfPos(2, &reached));
  CHECK_EQ(reached, -2147483647.0);
}

static void ArraysOfIntServe() {
  int status[5] = {-1, -1, -1, -1, 0x5A5A5A5A};
  ACCEPTED(GT_AxisOn(3));
  ACCEPTED(GT_GetSts(1, reinterpret_cast<long*>(status), 4));
  CHECK_EQ(status[0] & 0x200, 0); /* the bit of an axis that is on */
  CHECK_EQ(status[1] & 0x200, 0);
  CHECK_EQ(status[2] & 0x200, 0x200);
  CHECK_EQ(status[3] & 0x200, 0);
  CHECK_EQ(status[4], 0x5A5A5A5A);
}

static void MasksHaveRubbish() {
  long mask = INT_MIN | 0x5A5A0000; /* was in the memory */
  long outputs = 0;
  mask |= 1;
  ACCEPTED(GT_SetDo(MC_GPO, mask));
  ACCEPTED(GT_GetDo(MC_GPO, &outputs));
  CHECK_EQ(outputs & 0xFFFF, 1);
}

int main() {
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  ACCEPTED(GT_ClrSts(1, 8));
  WordsAreComparedWithUnsignedOnes();
  NumbersWrap();
  ArraysOfIntServe();
  MasksHaveRubbish();
  ACCEPTED(GT_Close());
  return 0;
}
