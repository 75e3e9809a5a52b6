/* A host of a GE card for point-to-point motion, as the manual's examples are written, for DOS. In
   C++ it is compiled again, with the default argument. Prints how long a move takes. */
#include <conio.h>
#include <dos.h>
#include <stdio.h>

#include "gep.h"

static int calls = 0;

static void __stdcall Told(char* command, short error) {
  unsigned short status = 0;
  ++calls;
  /* The handler may call commands; it is not told of them. */
  if (error != 0) GT_GetCmdSts(&status);
  if (error != 0) printf("%s = %d, %u\n", command, error, status);
}

int main(void) {
  unsigned long status;
  long position;
  int polls = 0;
  GT_HookCommand(Told);
#ifdef __cplusplus
  if (GT_Open() != 0) return 1;
#else
  if (GT_Open(65535) != 0) return 1;
#endif
  GT_Reset();
  GT_AxisOn(1);
  GT_PrflT(1);
  GT_SetPos(1, 10000);
  GT_SetVel(1, 10);
  GT_SetAcc(1, 1);
  GT_Update(1);
  GT_SetAtlPos(1, 0);
  GT_SetKp(9, 1);
  GT_GetPrfPos(1, NULL);
  do {
    delay(10);
    ++polls;
    GT_GetSts(1, &status);
  } while (status & 0x400);
  GT_GetPrfPos(1, &position);
  printf("%d0 ms, position %ld, status 0x%lX\n", polls, position, status);
  GT_HookCommand(NULL);
  GT_Close();
  printf("%d calls\n", calls);
  return 0;
}
