/* A host with one call that is refused three times, one that is refused once, and one that is
   refused for as many reasons as the argument says. */
#include <stdlib.h>

#include "gts.h"

int main(int argc, char** argv) {
  int i;
  if (GT_Open(0, 1) != 0) return 2;
  for (i = 0; i < 3; ++i) GT_AxisOn(9);
  GT_AxisOff(9);
  for (i = 0; argc > 1 && i < 2 * atoi(argv[1]); ++i) GT_ClrSts((short)(100 + i / 2), 1);
  return GT_Close();
}
