/* A host that moves an axis and waits forever. */
#include <unistd.h>

#include "gts.h"

int main(void) {
  TJogPrm jog = {1, 1, 0};
  if (GT_Open(0, 1) != 0 || GT_AxisOn(1) != 0 || GT_PrfJog(1) != 0) return 2;
  if (GT_SetJogPrm(1, &jog) != 0 || GT_SetVel(1, 10) != 0 || GT_Update(1) != 0) return 2;
  for (;;) {
    usleep(1000);
    GT_ClrSts(1, 1);
  }
}
