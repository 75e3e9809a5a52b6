/* A host that waits for its first general input and then switches an output on. A scenario has the
   expectations with their times. The argument is the exit code. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "check.h"
#include "gts.h"

int main(int argc, char** argv) {
  long inputs = 0;
  unsigned long clock = 0;

  if (argc != 2) return 2;
  if (GT_Open(0, 1) != 0) {
    printf("not opened\n");
    return 5;
  }
  do {
    usleep(1000);
    ACCEPTED(GT_GetDi(MC_GPI, &inputs));
  } while ((inputs & 1) == 0 && GT_GetClock(&clock, NULL) == 0 && clock < 2000);
  ACCEPTED(GT_SetDoBit(MC_GPO, 1, 1));
  sleep(1);
  printf("input %ld at %lu ms\n", inputs & 1, clock);
  return atoi(argv[1]);
}
