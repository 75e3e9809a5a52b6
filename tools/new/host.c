/* Moves axis 1 and waits until it has arrived. */
#include <stdio.h>
#include <stdlib.h>

#include "gts.h"

#define IN_MOTION 0x400 /* bit 10 of the status word */

/* Ends the program if the card has refused a command. */
static void Accepted(const char* command, short code) {
  if (code == 0) return;
  fprintf(stderr, "%s: the card answers %d\n", command, code);
  exit(1);
}

int main(void) {
  TTrapPrm trap = {0};
  long status = 0;
  unsigned long clock = 0;
  double position = 0;

  Accepted("GT_Open", GT_Open(0, 1));
  Accepted("GT_AxisOn", GT_AxisOn(1));
  Accepted("GT_PrfTrap", GT_PrfTrap(1));
  trap.acc = 0.25;
  trap.dec = 0.25;
  Accepted("GT_SetTrapPrm", GT_SetTrapPrm(1, &trap));
  Accepted("GT_SetPos", GT_SetPos(1, 50000));
  Accepted("GT_SetVel", GT_SetVel(1, 50));
  Accepted("GT_Update", GT_Update(1));
  do {
    Accepted("GT_GetSts", GT_GetSts(1, &status, 1, &clock));
  } while (status & IN_MOTION);
  Accepted("GT_GetPrfPos", GT_GetPrfPos(1, &position, 1, NULL));
  printf("at %.0f after %lu ms\n", position, clock);
  Accepted("GT_Close", GT_Close());
  return 0;
}
