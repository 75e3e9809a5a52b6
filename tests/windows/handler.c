/* A host of a GE card whose handler is told of every command: a refused one a thousand times. In 32
   bits a call by another convention would leave its arguments on the stack. */
#include <stdio.h>

#include "gep.h"

static int refusals = 0;

static void __stdcall Told(char* command, short error) {
  if (error == 0) return;
  if (refusals == 0) printf("%s = %d\n", command, error);
  ++refusals;
}

int main(void) {
  int i;
  GT_HookCommand(Told);
  if (GT_Open(65535) != 0) return 1;
  for (i = 0; i < 1000; ++i) GT_SetKp(9, 1);
  GT_Close();
  printf("%d\n", refusals);
  return refusals == 1000 ? 0 : 1;
}
