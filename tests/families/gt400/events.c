/* A host for Windows: a thread waits for the event that interrupts of the card set, of time and of
   an axis, whose background commands have acted by then. */
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>

#include "GT400.h"

static HANDLE interrupted;
static volatile int count = 0;
static volatile int stops = 0;

static DWORD WINAPI Work(LPVOID parameter) {
  (void)parameter;
  for (;;) {
    unsigned short word = 1;
    unsigned long clock = 0;
    if (WaitForSingleObject(interrupted, INFINITE) != WAIT_OBJECT_0 || stops) break;
    GT_GetIntr(&word);
    GT_GetClock(&clock);
    ++count;
    printf("%d: 0x%04X at %lu\n", count, word, clock);
    ResetEvent(interrupted);
  }
  return 0;
}

enum { kSetSize = 4 + 4 + 2 * 16 };

/* The first command of the set; the second one follows. */
static PGENERAL_COMMAND FirstOf(PBGCOMMANDSET set) { return set->BackgroundCommand[0].GenCommand; }
static PGENERAL_COMMAND NextOf(PGENERAL_COMMAND command) {
  return (PGENERAL_COMMAND)((char*)command + sizeof(GENERAL_COMMAND));
}

/* At the end of a motion the next target is set, and the position is read. */
static void SetBackground(long target) {
  PBGCOMMANDSET set = (PBGCOMMANDSET)calloc(1, kSetSize);
  set->Count = 1;
  set->BackgroundCommand[0].InterruptMask = 1;
  set->BackgroundCommand[0].CommandCount = 2;
  FirstOf(set)->usCommand = Intr_GT_SetPos;
  FirstOf(set)->in.lData = (uint32_t)target;
  NextOf(FirstOf(set))->usCommand = Intr_GT_GetAtlPos;
  printf("too short: %d\n", GT_SetBgCommandSet(set, kSetSize - 1));
  printf("set: %d\n", GT_SetBgCommandSet(set, kSetSize));
  free(set);
}

static void ShowBackground(void) {
  PBGCOMMANDSET set = (PBGCOMMANDSET)calloc(1, kSetSize);
  long target = 0;
  printf("result: %d\n", GT_GetBgCommandResult(set, kSetSize));
  GT_GetPos(&target);
  printf("target %ld, position %lu\n", target, (unsigned long)NextOf(FirstOf(set))->out.lData);
  free(set);
}

int main(void) {
  DWORD id = 0;
  HANDLE thread;
  GT_Open();
  printf("no event: %d\n", GT_SetIntSyncEvent((HANDLE)&id));
  interrupted = CreateEvent(NULL, TRUE, FALSE, NULL);
  printf("event: %d\n", GT_SetIntSyncEvent(interrupted));
  thread = CreateThread(NULL, 0, Work, NULL, 0, &id);
  printf("a thread: %d, %d\n", GT_SetIntSyncEvent(thread), SetEvent(thread));
  GT_SetIntrTm(100);
  GT_TmrIntr();
  Sleep(50);
  GT_EvntIntr();
  SetBackground(50);
  GT_Axis(2);
  GT_CtrlMode(1);
  GT_AxisOn();
  GT_ClrSts();
  GT_SetVel(1);
  GT_SetAcc(1);
  GT_SetIntrMsk(1);
  GT_SetPos(100);
  GT_Update();
  Sleep(50);
  ShowBackground();
  GT_SetIntSyncEvent(NULL);
  stops = 1;
  SetEvent(interrupted);
  WaitForSingleObject(thread, INFINITE);
  CloseHandle(thread);
  printf("closed: %d\n", CloseHandle(interrupted));
  printf("closed event: %d\n", GT_SetIntSyncEvent(interrupted));
  return GT_Close();
}
