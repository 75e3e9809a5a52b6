/* A host that does nothing but wait and sleep: its card interrupts it all the same, with any clock.
 */
#include <windows.h>

#include "GT400.h"
#include "check.h"

static volatile int handled;

static void Handle(void) { ++handled; }

int main(void) {
  const HANDLE event = CreateEventA(NULL, FALSE, FALSE, NULL);
  ACCEPTED(GT_Open());
  ACCEPTED(GT_SetIntSyncEvent(event));
  /* 20 ms. */
  ACCEPTED(GT_SetIntrTm(100));
  ACCEPTED(GT_TmrIntr());
  CHECK_EQ(WaitForSingleObject(event, 10000), WAIT_OBJECT_0);
  CHECK_EQ(WaitForMultipleObjects(1, &event, TRUE, 10000), WAIT_OBJECT_0);
  ACCEPTED(GT_SetIntSyncEvent(NULL));
  GT_HookIsr(Handle);
  handled = 0;
  Sleep(500);
  CHECK_EQ(handled > 0, 1);
  return GT_Close();
}
