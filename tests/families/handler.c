/* A host of the family of the tests that the card interrupts: while it sleeps, while a call waits
   for a tick, while another one takes its time, while it has disabled interrupts, and in the
   handler. */
#include <dos.h>
#include <stddef.h>

#include "toy.h"

static const unsigned char kHandler[] = {1};
static const unsigned char kMain[] = {2};
static int interrupts = 0;

static void Handle(void) {
  long sum;
  ++interrupts;
  TOY_Sum(kHandler, 1, &sum);
  if (interrupts == 5) delay(12); /* that of cycle 60 waits */
}

int main(void) {
  TToyMotion motion = {10, 10};
  long result;
  TOY_Open(0);
  TOY_OnInterrupt(Handle);
  TOY_Move(2, &motion);
  delay(19);         /* from 0.05 ms on, during the handler as well */
  TOY_Tick(&result); /* ends with cycle 20 */
  delay(9);
  oncard_host_sleep_ns(920000);
  TOY_Sum(kMain, 1, &result); /* cycle 30 ends meanwhile */
  disable();
  delay(10);
  TOY_Sum(kMain, 1, &result);
  enable(); /* now that of cycle 40 */
  while (interrupts < 6) delay(1);
  TOY_OnInterrupt(NULL);
  delay(10); /* nobody answers that of cycle 70 */
  return TOY_Close();
}
