/* Two cards in one host, with the interface that has a card number in every call. */
#define GTS_MULTI_CARD
#include "check.h"
#include "gts.h"

/* Starts add(1, last) on a card. */
static void Start(short card, double last) {
  TVarInfo begin;
  TVarInfo end;
  short function = 0;
  double value = 1;
  ACCEPTED(GT_Download(card, "sum.bin"));
  ACCEPTED(GT_GetFunId(card, "add", &function));
  ACCEPTED(GT_GetVarId(card, "add", "begin", &begin));
  ACCEPTED(GT_GetVarId(card, "add", "end", &end));
  ACCEPTED(GT_Bind(card, 0, function, 0));
  ACCEPTED(GT_SetVarValue(card, 0, &begin, &value, 1));
  ACCEPTED(GT_SetVarValue(card, 0, &end, &last, 1));
  ACCEPTED(GT_RunThread(card, 0));
}

/* Waits for the thread of a card and returns its result. */
static double Finish(short card) {
  TThreadSts status;
  do {
    ACCEPTED(GT_GetThreadSts(card, 0, &status));
  } while (status.run == 1);
  CHECK_EQ(status.error, 0);
  return status.result;
}

int main(int argc, char** argv) {
  TCompileInfo nowhere = {NULL, NULL, NULL};
  unsigned long clock = 0;
  TThreadSts status;

  if (argc != 2) return 2;
  ACCEPTED(GT_Open(0, 0, 1));
  CHECK_EQ(GT_GetClock(1, &clock, NULL), -1); /* card 1 is not open yet */
  ACCEPTED(GT_Open(1, 0, 1));
  CHECK_EQ(GT_Open(1, 0, 1), -6);
  CHECK_EQ(GT_Open(16, 0, 1), 7);
  CHECK_EQ(GT_Open(-1, 0, 1), 7);
  CHECK_EQ(GT_GetClock(2, &clock, NULL), -1);

  ACCEPTED(GT_Compile(0, argv[1], &nowhere));
  Start(0, 100);
  ACCEPTED(GT_GetThreadSts(1, 0, &status)); /* the other card has no thread yet */
  CHECK_EQ(status.run, 0);
  Start(1, 10);
  CHECK_EQ(Finish(1), 55);
  CHECK_EQ(Finish(0), 5050);

  ACCEPTED(GT_Reset(1));
  CHECK_EQ(GT_RunThread(1, 0), 1);
  ACCEPTED(GT_RunThread(0, 0)); /* the reset of card 1 left card 0 alone */
  ACCEPTED(GT_Close(0));
  CHECK_EQ(GT_Close(0), -1);
  ACCEPTED(GT_GetClock(1, &clock, NULL));
  ACCEPTED(GT_Close(1));
  return 0;
}
