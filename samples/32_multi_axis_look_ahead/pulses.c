/* The manual's example 3: a program for the older look-ahead. Only the initialisation has been
   replaced; its segments are in pulses and pulse/ms, and the multi-axis look-ahead plans them. */
#include "path.h"

int main(void) {
  long x = 0;
  long y = 0;
  long space = 0;
  int i;
  ACCEPTED(GT_Open(0, 1));
  SetUp(2);
  ACCEPTED(GT_InitLookAheadPara(CRD, 200, 0.1, 0.01, 1000, FIFO));
  for (i = 0; i < 300; ++i) {
    while (GT_LnXY(CRD, 8000 + x, 9000 + y, 100, 0.8, 0, FIFO) != 0) {
      do {
        ACCEPTED(GT_CrdSpace(CRD, &space, FIFO));
      } while (space == 0);
    }
    x += 1600;
    y += 1852;
  }
  while (GT_CrdData(CRD, NULL, FIFO) != 0) {
  }
  Run();
  return GT_Close();
}
