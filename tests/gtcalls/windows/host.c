/* A host that is linked with an import library. Each command answers with 1000 for each of its
   arguments plus its number; those with a card number with the number below 0, where the card does
   not count as an argument. The stack would be lost if a function took other arguments than the
   host passes. */
#ifdef SEVERAL_CARDS
#include "gts_multi.h"
#define CARD 3,
#define ANSWER(arguments, number) (-((arguments)*1000 + (number)))
#else
#include "gts.h"
#define CARD
#define ANSWER(arguments, number) ((arguments)*1000 + (number))
#endif
#include "LookAheadEx.h"

int main(void) {
  short(GTS_CALL_ * set_trigger)(
#ifdef SEVERAL_CARDS
      short,
#endif
      short, TTrigger*) = GT_SetTrigger;
  TTrigger trigger = {0};
  for (int i = 0; i < 1000; ++i) {
    if (GT_Open(CARD 0, 1) != ANSWER(2, 1)) return 1;
    if (GT_SetPos(CARD 1, 2) != ANSWER(2, 143)) return 2;
    if (GT_SetVel(CARD 1, 2.5) != ANSWER(2, 145)) return 3;
    if (GT_LnXY(CARD 1, 2, 3, 4, 5, 6, 0) != ANSWER(7, 230)) return 4;
    if (GT_SetTrigger(CARD 1, &trigger) != ANSWER(2, 343)) return 5;
    if (set_trigger(CARD 1, &trigger) != ANSWER(2, 343)) return 6;
  }
  return 0;
}
