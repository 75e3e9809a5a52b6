/* A host of the family of the tests that lets a command fill its arrays. */
#include <stdio.h>
#include <unistd.h>

#include "toy.h"

int main(void) {
  TToyMotion motion = {10, 10};
  long positions[2][4] = {{-1, -1, -1, -1}, {-1, -1, -1, -1}};
  double velocities[4] = {-1, -1, -1, -1};
  TToySamples samples = {{{positions[0], velocities}, {positions[1], velocities}}};
  TOY_Open(0);
  TOY_Move(1, &motion);
  usleep(5000);
  TOY_Sample(&samples);
  for (int i = 0; i < 4; ++i) {
    printf("%ld %g %ld\n", positions[0][i], velocities[i], positions[1][i]);
  }
  samples.axis[0].velocity = NULL;
  printf("%d\n", TOY_Sample(&samples));
  samples.axis[1].position = NULL;
  printf("%d\n", TOY_Sample(&samples));
  const unsigned char bytes[] = {1, 20, 255};
  long sum = 0;
  printf("%d", TOY_Sum(bytes, 3, &sum));
  printf(" %ld\n", sum);
  return TOY_Close();
}
