/* A host of the family of the tests that waits for two cycles of the card. */
#include "toy.h"

int main(void) {
  TToyMotion motion = {10, 10};
  long cycle;
  TOY_Open(0);
  TOY_Move(1, &motion);
  TOY_Tick(&cycle);
  TOY_Tick(&cycle);
  TOY_Move(2, &motion);
  return TOY_Close();
}
