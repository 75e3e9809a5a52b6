/* Declarations of a host in another language, for one card or for several, with the structure of
   the vendor's basic header: the plain names of the library. Answers as in host.c. */
#ifdef SEVERAL_CARDS
#define CARD_ short cardNum,
#define CARD 3,
#define ANSWER(arguments, number) (-((arguments)*1000 + (number)))
#else
#define CARD_
#define CARD
#define ANSWER(arguments, number) ((arguments)*1000 + (number))
#endif

typedef struct {
  short encoder;
  short probeType;
  short probeIndex;
  short offset;
  short windowOnly;
  int firstPosition;
  int lastPosition;
} Trigger;

short __stdcall GT_Open(CARD_ short channel, short param);
short __stdcall GT_SetVel(CARD_ short profile, double vel);
short __stdcall GT_SetTrigger(CARD_ short i, Trigger* pTrigger);

int main(void) {
  Trigger trigger = {0};
  for (int i = 0; i < 1000; ++i) {
    if (GT_Open(CARD 0, 1) != ANSWER(2, 1)) return 1;
    if (GT_SetVel(CARD 1, 2.5) != ANSWER(2, 145)) return 2;
    if (GT_SetTrigger(CARD 1, &trigger) != ANSWER(2, 343)) return 3;
  }
  return 0;
}
