/* A host of the family of the tests that changes the cycle of the card while an axis moves. */
#include <unistd.h>

#include "toy.h"

int main(void) {
  TToyMotion motion = {10, 10};
  TOY_Open(0);
  TOY_Move(1, &motion);
  usleep(2000);
  TOY_SetCycle(48.03);
  usleep(10000);
  return TOY_Close();
}
