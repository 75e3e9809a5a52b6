/* A host of several GT400 cards: all are opened at once, and one is current. */
#include <stdio.h>
#include <unistd.h>

#include "GT400.h"

static void Show(const char* what, short code) { printf("%s: %d\n", what, code); }

static void ShowCard(void) {
  unsigned long clock = 0;
  long position = 0;
  GT_GetPos(&position);
  GT_GetClock(&clock);
  printf("card %d, position %ld, clock %lu\n", GT_GetCurrentCardNo(), position, clock);
}

int main(void) {
  Show("axis before opening", GT_Axis(1));
  Show("reset before opening", GT_Reset());
  Show("number before opening", GT_GetCurrentCardNo());
  Show("switch before opening", GT_SwitchtoCardNo(0));
  Show("close before opening", GT_Close());
  Show("open", GT_Open());
  GT_SetPos(5);
  Show("open again", GT_Open());
  ShowCard();
  usleep(10000);
  Show("switch", GT_SwitchtoCardNo(15));
  GT_SetPos(7);
  ShowCard();
  Show("no such card", GT_SwitchtoCardNo(16));
  Show("no such card", GT_SwitchtoCardNo(-1));
  ShowCard();
  GT_SwitchtoCardNo(0);
  Show("reset", GT_Reset());
  ShowCard();
  GT_SwitchtoCardNo(15);
  ShowCard();
  Show("close", GT_Close());
  Show("axis after closing", GT_Axis(1));
  Show("close again", GT_Close());
  Show("open once more", GT_Open());
  ShowCard();
  GT_SwitchtoCardNo(15);
  ShowCard();
  return 0;
}
