/* A host of several GE cards: which one is open, and which one is current. */
#include <stdio.h>

#include "gep.h"

static void Show(const char* what, short code) {
  printf("%s: %d, card %d\n", what, code, GT_GetCurrentCardNo());
}

int main(void) {
  int i;
  long position;
  Show("hard reset before opening", GT_HardRst());
  Show("switch to a closed card", GT_SwitchtoCardNo(2));
  Show("command of a closed card", GT_ClrSts(1));
  Show("open", GT_Open(65535));
  Show("set", GT_SetAtlPos(1, 22));
  Show("open the lowest closed one", GT_Open(65535));
  GT_GetAtlPos(1, &position);
  printf("position %ld\n", position);
  Show("switch back", GT_SwitchtoCardNo(2));
  GT_GetAtlPos(1, &position);
  printf("position %ld\n", position);
  Show("no such card", GT_SwitchtoCardNo(16));
  Show("reset", GT_HardRst());
  GT_GetAtlPos(1, &position);
  printf("position %ld\n", position);
  for (i = 0; i < 14; ++i) GT_Open(65535);
  Show("all are open", GT_Open(65535));
  GT_SwitchtoCardNo(7);
  Show("close", GT_Close());
  Show("close again", GT_Close());
  Show("open again", GT_Open(65535));
  return 0;
}
