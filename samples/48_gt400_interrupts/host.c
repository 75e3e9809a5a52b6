/* Interrupts of a GT400 card: the handler of an event makes the captured home position the target
   of axis 1, then the handler of a clock looks where the axis is on its way back. */
#include <unistd.h>

#include "accepted.h"
#include "userlib.h"

#define CAPTURED 0x8 /* bit 3 of the status word */
#define LOOKS 5

static volatile int captures, looks;
static long home, positions[LOOKS];

static void interrupt on_capture(void) {
  unsigned short status;
  ACCEPTED(GT_AxisI());
  ACCEPTED(GT_GetIntr(&status));
  if (status & CAPTURED) {
    ACCEPTED(GT_GetCapt(&home));
    ACCEPTED(GT_SetPos(home));
    ACCEPTED(GT_Update());
    ++captures;
  }
  ACCEPTED(GT_RstIntr(0));
}

static void interrupt on_clock(void) {
  if (looks < LOOKS) ACCEPTED(GT_GetAtlPos(&positions[looks]));
  ++looks;
  ACCEPTED(GT_ClearInt(0));
}

static void wait_for_rest(void) {
  unsigned short status;
  do {
    ACCEPTED(GT_GetSts(&status));
  } while (status & IN_MOTION);
}

int main(void) {
  GT_ISR old;
  int i;
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  ACCEPTED(GT_AxisOn());
  ACCEPTED(GT_ClrSts());

  old = GT_HookIsr(on_capture);
  ACCEPTED(GT_SetIntrMsk(CAPTURED));
  ACCEPTED(GT_CaptHome());
  ACCEPTED(GT_SetPos(20000));
  ACCEPTED(GT_SetVel(10));
  ACCEPTED(GT_SetAcc(0.1));
  ACCEPTED(GT_Update());
  while (captures == 0) usleep(1000);
  wait_for_rest();

  ACCEPTED(GT_UnhookIsr(old));
  old = GT_HookIsr(on_clock);
  ACCEPTED(GT_SetIntrTm(100));
  ACCEPTED(GT_SetPos(0));
  ACCEPTED(GT_Update());
  ACCEPTED(GT_TmrIntr());
  wait_for_rest();
  ACCEPTED(GT_EvntIntr());
  ACCEPTED(GT_UnhookIsr(old));
  printf("home at %ld\n", home);
  for (i = 0; i < LOOKS; ++i) printf("after %d ms at %ld\n", 20 * (i + 1), positions[i]);
  ACCEPTED(GT_Close());
  return home == 6000 && captures == 1 ? 0 : 1;
}
