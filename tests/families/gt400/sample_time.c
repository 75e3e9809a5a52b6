/* A host of a GT400 card that changes the sample time, and whose updates take until the next one.
 */
#include <stdio.h>
#include <unistd.h>

#include "GT400.h"

static void ShowClock(const char* when) {
  unsigned long clock = 0;
  GT_GetClock(&clock);
  printf("%s: %lu\n", when, clock);
}

int main(void) {
  double us = 0;
  GT_Open();
  usleep(10000);
  ShowClock("10 ms");
  GT_SetSmplTm(400);
  usleep(10000);
  ShowClock("10 ms of 400 us");
  GT_Reset();
  usleep(10000);
  ShowClock("10 ms after a reset");
  GT_GetSmplTm(&us);
  printf("sample time: %g us\n", us);
  GT_Update();
  ShowClock("an update");
  GT_MltiUpdt(15);
  ShowClock("another one");
  return GT_Close();
}
