/* A host that takes the number of an axis for its mask, does not switch a drive on, and does not
   wait for the end of a motion. */
#include "gts.h"

int main(void) {
  if (GT_Open(0, 1) != 0) return 2;
  GT_AxisOn(3);
  GT_PrfTrap(3);
  GT_SetVel(3, 10);
  GT_SetPos(3, 100);
  GT_Update(3);
  GT_PrfJog(4);
  GT_SetVel(4, 10);
  GT_Update(1 << 3);
  return GT_Close();
}
