/* What a host of the family of the tests is told of its waits, with the virtual time of each. */
#include <stdio.h>
#include <windows.h>

#include "toy.h"

static void Tell(const char* what, DWORD how) {
  printf("%s %lu at %llu\n", what, (unsigned long)(how & 0xFFFFFFFFu), GetTickCount64());
}

static DWORD WINAPI SetLater(LPVOID event) {
  Sleep(5);
  SetEvent((HANDLE)event);
  return 0;
}

int main(void) {
  TToyMotion motion = {10, 10};
  HANDLE manual = CreateEvent(NULL, TRUE, TRUE, NULL);
  HANDLE automatic = CreateEvent(NULL, FALSE, TRUE, NULL);
  DWORD id = 0;
  HANDLE thread;
  Tell("manual", WaitForSingleObject(manual, 0));
  Tell("manual", WaitForSingleObject(manual, INFINITE));
  Tell("automatic", WaitForSingleObject(automatic, INFINITE));
  Tell("automatic", WaitForSingleObject(automatic, 0));
  Tell("time-out", WaitForSingleObject(automatic, 20));
  thread = CreateThread(NULL, 0, SetLater, automatic, 0, &id);
  Tell("thread", WaitForSingleObject(thread, 1000));
  Tell("set", WaitForSingleObject(automatic, 1000));
  TOY_Open(0);
  TOY_SetEvent(automatic);
  TOY_Move(1, &motion); /* which interrupts nobody */
  Tell("hopeless", WaitForSingleObject(automatic, INFINITE));
  CloseHandle(automatic);
  Tell("closed", WaitForSingleObject(automatic, INFINITE));
  printf("%d %d\n", SetEvent(automatic), SetEvent(NULL));
  return TOY_Close();
}
