/* A host of the family of the tests in the style of Windows: a thread waits for the interrupts of
   the card and looks at its clock, while the first one sleeps. */
#include <stdio.h>
#include <windows.h>

#include "toy.h"

static HANDLE interrupted;
static volatile int stops = 0;
static volatile int seen = 0;

static DWORD WINAPI Work(LPVOID first) {
  long number = *(long*)first;
  for (;;) {
    const DWORD how = WaitForSingleObject(interrupted, INFINITE);
    if (stops) break;
    printf("%ld: %lu at %llu\n", number++, (unsigned long)how, GetTickCount64());
    ResetEvent(interrupted);
    ++seen;
  }
  ExitThread(0);
  return 0;
}

int main(void) {
  TToyMotion motion = {10, 10};
  long first = 1;
  DWORD id = 0;
  HANDLE thread;
  TOY_Open(0);
  interrupted = CreateEvent(NULL, TRUE, FALSE, NULL);
  TOY_SetEvent(interrupted);
  TOY_Move(2, &motion);
  thread = CreateThread(NULL, 0, Work, &first, 0, &id);
  while (seen < 3) Sleep(5);
  stops = 1;
  TOY_SetEvent(NULL);
  SetEvent(interrupted);
  printf("ended %lu\n", (unsigned long)WaitForSingleObject(thread, INFINITE));
  printf("closed %d %d\n", CloseHandle(thread), CloseHandle(interrupted));
  return TOY_Close();
}
