/* A host for DOS whose handler takes the captured home position as the target, as in the manual,
   and then counts time interrupts. Its own calls are told from those of the handler by the axis. */
#include <dos.h>
#include <stdio.h>

#include "userlib.h"

static int events = 0;
static int times = 0;
static unsigned short word = 0;

static void interrupt OnEvent(void) {
  long home = 0;
  disable();
  GT_AxisI();
  GT_GetIntr(&word);
  if (word & 0x8) {
    GT_GetCapt(&home);
    GT_SetPos(home);
    GT_Update();
  }
  ++events;
  GT_RstIntr(0);
  outportb(0x20, 0x20);
  outportb(0xa0, 0x20);
  enable();
}

static void interrupt OnTime(void) { ++times; }

static void Show(const char* what, int code) { printf("%s: %d\n", what, code); }

int main(void) {
  GT_ISR former;
  unsigned short status = 0;
  int i;
  Show("no card", GT_HookIsr(OnEvent) != NULL);
  GT_Open();
  GT_Reset();
  GT_Axis(3);
  GT_CtrlMode(1);
  GT_AxisOn();
  GT_ClrSts();
  former = GT_HookIsr(OnEvent);
  Show("first", former != NULL);
  GT_SetIntrMsk(0x8);
  GT_CaptHome();
  GT_SetVel(4);
  GT_SetAcc(1);
  GT_SetPos(200000);
  GT_Update();
  GT_Axis(1);
  while (events == 0) delay(1);
  GT_GetSts(&status);
  printf("word 0x%04X, current axis %d, captured %d\n", word, (status >> 12 & 3) + 1,
         status >> 3 & 1);
  while (GT_GetSts(&status) == 0 && (status & 0x400)) delay(1);
  Show("once", events);
  Show("hooked before", GT_HookIsr(OnTime) == OnEvent);
  GT_SetIntrTm(10);
  GT_TmrIntr();
  for (i = 0; i < 3; ++i) delay(4);
  Show("in 12 ms", times);
  Show("no such card", GT_ClearInt(16));
  Show("card not used", GT_ClearInt(3));
  Show("unhook", GT_UnhookIsr(former));
  Show("unhook again", GT_UnhookIsr(former));
  delay(10);
  Show("unhooked", times);
  return GT_Close();
}
