/* A host of the family of the tests that hears of its calls, and makes others meanwhile. */
#include <stdio.h>

#include "toy.h"

static int heard = 0;

static void Hear(const char* call, short code) {
  TToyMotion motion = {5, 1};
  printf("%s = %d\n", call, code);
  if (++heard == 2) printf("meanwhile %d\n", TOY_Move(2, &motion));
}

int main(void) {
  TToyMotion motion = {10, 1};
  TOY_Hook(Hear);
  TOY_Move(1, &motion);
  TOY_Open(0);
  TOY_Move(1, &motion);
  if (TOY_Hook(NULL) != Hear || TOY_Hook(NULL) != NULL) printf("not the one before\n");
  return TOY_Close();
}
