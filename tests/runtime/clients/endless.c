/* A host that moves an axis and waits forever; `endless TIMES` is killed after so many waits. */
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include "gts.h"

int main(int argc, char** argv) {
  int times = argc > 1 ? atoi(argv[1]) : 0;
  TJogPrm jog = {1, 1, 0};
  if (GT_Open(0, 1) != 0 || GT_AxisOn(1) != 0 || GT_PrfJog(1) != 0) return 2;
  if (GT_SetJogPrm(1, &jog) != 0 || GT_SetVel(1, 10) != 0 || GT_Update(1) != 0) return 2;
  for (;;) {
    usleep(1000);
    GT_ClrSts(1, 1);
    if (times > 0 && --times == 0) raise(SIGKILL);
  }
}
