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

static void ShowSampleTime(void) {
  double us = 0;
  GT_GetSmplTm(&us);
  printf("sample time: %g us\n", us);
}

int main(void) {
  GT_Open();
  usleep(10000);
  ShowClock("10 ms");
  GT_SetSmplTm(400);
  usleep(10000);
  ShowClock("10 ms of 400 us");
  GT_Reset();
  usleep(10000);
  ShowClock("10 ms after a reset");
  ShowSampleTime();
  GT_Update();
  ShowClock("an update");
  GT_MltiUpdt(15);
  ShowClock("another one");
  GT_SetSmplTm(400);
  GT_HardRst();
  ShowSampleTime();
  ShowClock("a hard reset");
  return GT_Close();
}
