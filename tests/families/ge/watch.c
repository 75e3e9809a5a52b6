/* A host that watches an axis: batches of 100 samples of its position and velocity. */
#include <stdio.h>

#include "gep.h"

int main(void) {
  static long positions[100];
  static double velocities[100];
  unsigned short config[AXIS_NUM] = {5};
  TWatchBuffer buffer = {0};
  unsigned short available = 0;
  int batch;
  if (GT_Open(65535) != 0) return 1;
  buffer.Axis[0].PrfPos = positions;
  printf("not started: %d\n", GT_GetWatch(&buffer, &available));
  GT_SetWatch(config, 100);
  GT_SetPos(1, 100000);
  GT_SetVel(1, 10);
  GT_SetAcc(1, 1);
  GT_StartWatch(0);
  GT_Update(1);
  printf("no array: %d\n", GT_GetWatch(&buffer, &available));
  buffer.Axis[0].PrfVel = velocities;
  for (batch = 0; batch < 3; ++batch) {
    do {
      GT_GetWatch(&buffer, &available);
    } while (!available);
    printf("%ld %g\n", positions[99], velocities[99]);
  }
  return GT_StopWatch();
}
