/* A host that fills in a set of background commands, as the manual does, and prints its bytes. Two
   kinds of interrupt with three commands need 60 bytes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "GT400.H"
#include "Gt400.h"
#include "gt400.h"

static void Fill(PGENERAL_COMMAND command, unsigned short number, uint32_t input, uint32_t output) {
  command->usCommand = number;
  command->OutputLength = 2;
  command->InputLength = 1;
  command->in.lData = input;
  command->out.lData = output;
}

int main(void) {
  enum { kSize = 60 };
  unsigned char* memory = (unsigned char*)calloc(1, kSize);
  PBGCOMMANDSET set = (PBGCOMMANDSET)(void*)memory;
  PBACKGROUND_COMMAND kind = set->BackgroundCommand;
  PGENERAL_COMMAND command = kind->GenCommand;
  int i;
  set->Count = 2;
  kind->InterruptMask = 0x01;
  kind->CommandCount = 2;
  Fill(command, Intr_GT_SetPos, 0x04030201, 0);
  command = (PGENERAL_COMMAND)((char*)command + sizeof(GENERAL_COMMAND));
  Fill(command, Intr_GT_Update, 0, 0);
  kind = (PBACKGROUND_COMMAND)((char*)command + sizeof(GENERAL_COMMAND));
  kind->InterruptMask = 0x20;
  kind->CommandCount = 1;
  Fill(kind->GenCommand, Intr_GT_SetKp, 0, 20);
  kind->GenCommand->usResult = 0xFFFF;
  for (i = 0; i < kSize; ++i)
    printf("%s%02X", i % 16 == 0 && i > 0 ? "\n" : i > 0 ? " " : "", memory[i]);
  printf("\n%d\n", kind->GenCommand->cCommand == Intr_GT_SetKp);
  free(memory);
  return 0;
}
