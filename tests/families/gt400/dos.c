/* A host for DOS, where the address of the card opens it. */
#include <stdio.h>

#include "userlib.h"

static void interrupt Handler(void) {}

static void ShowAddress(void) {
  unsigned short address = 0;
  const short code = GT_GetAddr(&address);
  printf("address: %d, 0x%X\n", code, address);
}

int main(void) {
  GT_ISR handler = Handler;
  handler();
  ShowAddress();
  printf("axis before: %d\n", GT_Axis(1));
  printf("no card there: %d\n", GT_SetAddr(0x280));
  ShowAddress();
  printf("axis before: %d\n", GT_Axis(1));
  printf("set: %d\n", GT_SetAddr(0x300));
  GT_Axis(2);
  printf("set again: %d\n", GT_SetAddr(0x300));
  ShowAddress();
  printf("axis: %d\n", GT_Axis(1));
  printf("another card: %d\n", GT_SwitchtoCardNo(1));
  return 0;
}
