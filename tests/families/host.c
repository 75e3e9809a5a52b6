/* A host of the family of the tests: moves axis 3 for 100 ms. In C++ it is compiled again, with the
   default argument and the overload. Its exit code is that of TOY_Open if that fails, as a positive
   number. */
#include <stdio.h>
#include <unistd.h>

#include "toy.h"

static void Greet(int card) { printf("card %d\n", card); }

int main(void) {
#ifdef __cplusplus
  const short opened = TOY_Open();
#else
  const short opened = TOY_Open(0);
#endif
  if (opened != 0) return -opened;
  TOY_Call(Greet);
#ifdef __cplusplus
  TOY_Move(TOY_AXES, 10, 1);
  TOY_Move(TOY_AXES + 1, 10, 1);
#else
  TToyMotion motion = {10, 1};
  TOY_Move(TOY_AXES, &motion);
  TOY_Move(TOY_AXES + 1, &motion);
#endif
  usleep(100000);
  return TOY_Close();
}
