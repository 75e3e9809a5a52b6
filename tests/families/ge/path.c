/* A host for GE cards for paths: a list, and what both spellings of the interface give. */
#include <stdio.h>

#include "ges.h"

int main(void) {
  double point[3] = {-1, -1, -1};
  unsigned short word = 0;
  short code = GT_Open(65535);
  printf("open: %d\n", code);
  GT_Reset();
  GT_AxisOn(2);
  printf("no length: %d\n", GT_LnXY(0, 0));
  GT_StrtList();
  GT_MvXY(0, 0, 10, 1);
  GT_LnXY(100, 0);
  GT_EndList();
  GT_StrtMtn();
  do {
    GT_GetCrdSts(&word);
  } while (!(word & 1));
  GT_GetPrfPnt(point);
  printf("path status 0x%X, at (%.0f, %.0f, %.0f)\n", (unsigned)word, point[0], point[1], point[2]);
#ifdef __cplusplus
  unsigned long status = 0;
  GT_GetSts(2, &status);
  printf("look-ahead: %d\n", GT_InitLookAheadExx(0.002, 500, 200, 500, 2000, 0, NULL));
#else
  unsigned short status = 0;
  GT_GetSts(2, &status);
  printf("look-ahead: %d\n", GT_InitLookAheadExx(0.002, 500, 200, 500, 2000));
#endif
  printf("status 0x%lX\n", (unsigned long)status);
  return 0;
}
