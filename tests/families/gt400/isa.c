/* A host of an ISA card: GT_Open has the address of the card and the number of its interrupt. */
#include <stdio.h>

#include "GTDLL.h"

int main(void) {
  unsigned long port_base = 0x300;
  short status = GT_Open(port_base, 10);
  printf("open: %d\n", status);
  printf("open with another address: %d\n", GT_Open(0x280, 0));
  printf("axis: %d\n", GT_Axis(4));
#ifdef __cplusplus
  printf("open without parameters: %d\n", GT_Open());
#endif
  return GT_Close();
}
