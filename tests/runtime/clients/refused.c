/* A host with one call that is refused three times, and one that is refused once. */
#include "gts.h"

int main(void) {
  int i;
  if (GT_Open(0, 1) != 0) return 2;
  for (i = 0; i < 3; ++i) GT_AxisOn(9);
  GT_AxisOff(9);
  return GT_Close();
}
