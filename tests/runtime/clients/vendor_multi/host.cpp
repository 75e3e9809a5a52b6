// A host for several cards with the vendor's header in its folder. The functions with which it is
// linked are those for one card. Arguments: the cards to open, then the command to try.
#include <Windows.h>
#include <stdio.h>
#include <stdlib.h>

#include "gts.h"

int main(int argc, char** argv) {
  unsigned long clock = 0;
  short code = 0;

  if (argc != 3) return 2;
  for (const char* card = argv[1]; *card != '\0'; ++card) code = GT_Open((short)(*card - '0'));
  const short card = (short)(argv[1][strlen(argv[1]) - 1] - '0');
  if (strcmp(argv[2], "axis") == 0) code = GT_AxisOn(card, 3);
  if (strcmp(argv[2], "file") == 0) {
    char name[] = "card.cfg";
    code = GT_LoadConfig(card, name);
  }
  if (strcmp(argv[2], "clock") == 0) code = GT_GetClock(card, &clock);
  printf("%d\n", code);
  return 0;
}
