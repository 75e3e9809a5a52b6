/* Sleeps, clocks, waits and locks of a host for Windows in virtual time. The argument says what is
   checked. The times are those that the program asks for: nothing else takes a millisecond, and
   calls and looks at the clock take microseconds. */
#define _WIN32_WINNT 0x0601
#include <conio.h>
#include <process.h>
#include <stdio.h>
#include <string.h>
#include <windows.h>

#include "check.h"
#include "gts.h"

static ULONGLONG begin;

/* Milliseconds since the last call. */
static double Passed(void) {
  const ULONGLONG now = GetTickCount64();
  const double passed = (double)(now - begin);
  begin = now;
  return passed;
}

static HANDLE event, semaphore, mutex;
static CRITICAL_SECTION section;
static SRWLOCK lock = SRWLOCK_INIT;
static CONDITION_VARIABLE condition = CONDITION_VARIABLE_INIT;
static int is_ready;

/* Starts a thread as the run-time libraries of C do. */
static HANDLE Start(unsigned(__stdcall* function)(void*)) {
  return (HANDLE)_beginthreadex(NULL, 0, function, NULL, 0, NULL);
}

static void Clocks(void) {
  LARGE_INTEGER frequency, first, last;
  SYSTEMTIME date;
  GetSystemTime(&date);
  CHECK_EQ(date.wYear, 2026);
  CHECK_EQ(date.wMonth, 1);
  CHECK_EQ(date.wDay, 1);
  CHECK_EQ(date.wHour, 0);
  QueryPerformanceFrequency(&frequency);
  QueryPerformanceCounter(&first);
  Sleep(250);
  QueryPerformanceCounter(&last);
  CHECK_EQ((last.QuadPart - first.QuadPart) * 1000 / frequency.QuadPart, 250);
  CHECK_EQ(Passed(), 250);
  Sleep(3600 * 1000);
  CHECK_EQ(Passed(), 3600 * 1000);
  GetSystemTime(&date);
  CHECK_EQ(date.wHour, 1);
}

static void TimeOuts(void) {
  CHECK_EQ(WaitForSingleObject(event, 100), WAIT_TIMEOUT);
  CHECK_EQ(Passed(), 100);
  const HANDLE both[] = {event, semaphore};
  CHECK_EQ(WaitForMultipleObjects(2, both, FALSE, 70), WAIT_TIMEOUT);
  CHECK_EQ(Passed(), 70);
  EnterCriticalSection(&section);
  CHECK_EQ(SleepConditionVariableCS(&condition, &section, 30), FALSE);
  CHECK_EQ(GetLastError(), ERROR_TIMEOUT);
  LeaveCriticalSection(&section);
  CHECK_EQ(Passed(), 30);
}

static unsigned __stdcall SetLater(void* argument) {
  Sleep(300);
  SetEvent(event);
  Sleep(200);
  ReleaseSemaphore(semaphore, 1, NULL);
  Sleep(100);
  (void)argument;
  return 0;
}

static void Events(void) {
  const HANDLE thread = Start(SetLater);
  CHECK_EQ(WaitForSingleObject(event, INFINITE), WAIT_OBJECT_0);
  CHECK_EQ(Passed(), 300);
  CHECK_EQ(WaitForSingleObject(semaphore, 10000), WAIT_OBJECT_0);
  CHECK_EQ(Passed(), 200);
  CHECK_EQ(WaitForSingleObject(thread, INFINITE), WAIT_OBJECT_0);
  CHECK_EQ(Passed(), 100);
}

static unsigned __stdcall HoldLocks(void* argument) {
  (void)argument;
  WaitForSingleObject(mutex, INFINITE);
  EnterCriticalSection(&section);
  AcquireSRWLockExclusive(&lock);
  SetEvent(event);
  Sleep(40);
  ReleaseSRWLockExclusive(&lock);
  Sleep(40);
  LeaveCriticalSection(&section);
  Sleep(40);
  ReleaseMutex(mutex);
  return 0;
}

static void Locks(void) {
  const HANDLE thread = Start(HoldLocks);
  CHECK_EQ(WaitForSingleObject(event, INFINITE), WAIT_OBJECT_0);
  Passed();
  AcquireSRWLockExclusive(&lock);
  CHECK_EQ(Passed(), 40);
  ReleaseSRWLockExclusive(&lock);
  EnterCriticalSection(&section);
  CHECK_EQ(Passed(), 40);
  LeaveCriticalSection(&section);
  CHECK_EQ(WaitForSingleObject(mutex, INFINITE), WAIT_OBJECT_0);
  CHECK_EQ(Passed(), 40);
  ReleaseMutex(mutex);
  WaitForSingleObject(thread, INFINITE);
}

static unsigned __stdcall MakeReady(void* argument) {
  (void)argument;
  Sleep(500);
  AcquireSRWLockExclusive(&lock);
  is_ready = 1;
  ReleaseSRWLockExclusive(&lock);
  WakeConditionVariable(&condition);
  return 0;
}

static void Conditions(void) {
  const HANDLE thread = Start(MakeReady);
  AcquireSRWLockExclusive(&lock);
  while (!is_ready) CHECK_EQ(SleepConditionVariableSRW(&condition, &lock, INFINITE, 0), TRUE);
  ReleaseSRWLockExclusive(&lock);
  CHECK_EQ(Passed(), 500);
  WaitForSingleObject(thread, INFINITE);
}

static void CALLBACK Called(ULONG_PTR argument) { *(int*)argument = 1; }

static unsigned __stdcall SleepUntilCalled(void* argument) {
  (void)argument;
  return SleepEx(INFINITE, TRUE);
}

/* A procedure ends an endless sleep, during which time goes on for others. */
static void Procedures(void) {
  const HANDLE thread = Start(SleepUntilCalled);
  int called = 0;
  DWORD code = 0;
  Sleep(100);
  CHECK_EQ(QueueUserAPC(Called, thread, (ULONG_PTR)&called) != 0, 1);
  CHECK_EQ(WaitForSingleObject(thread, INFINITE), WAIT_OBJECT_0);
  CHECK_EQ(called, 1);
  CHECK_EQ(GetExitCodeThread(thread, &code), TRUE);
  CHECK_EQ(code, WAIT_IO_COMPLETION);
  CHECK_EQ(Passed(), 100);
}

static unsigned __stdcall AwaitKey(void* argument) {
  (void)argument;
  return (unsigned)_getch();
}

/* Time goes on for others while a thread waits for a key that no script has. */
static void Keys(void) {
  HANDLE from = NULL, to = NULL, thread = NULL;
  DWORD count = 0, code = 0;
  CHECK_EQ(CreatePipe(&from, &to, NULL, 0), TRUE);
  CHECK_EQ(SetStdHandle(STD_INPUT_HANDLE, from), TRUE);
  thread = Start(AwaitKey);
  Sleep(1000);
  CHECK_EQ(Passed(), 1000);
  CHECK_EQ(WriteFile(to, "k", 1, &count, NULL), TRUE);
  CHECK_EQ(WaitForSingleObject(thread, INFINITE), WAIT_OBJECT_0);
  CHECK_EQ(GetExitCodeThread(thread, &code), TRUE);
  CHECK_EQ(code, 'k');
}

/* What is found by its name is replaced, too. */
static void Found(void) {
  void(WINAPI * sleep)(DWORD) =
      (void(WINAPI*)(DWORD))(void*)GetProcAddress(GetModuleHandleA("kernel32.dll"), "Sleep");
  sleep(1000000);
  CHECK_EQ(Passed(), 1000000);
}

int main(int argc, char** argv) {
  const char* const what = argc > 1 ? argv[1] : "";
  event = CreateEventA(NULL, FALSE, FALSE, NULL);
  semaphore = CreateSemaphoreA(NULL, 0, 1, NULL);
  mutex = CreateMutexA(NULL, FALSE, NULL);
  InitializeCriticalSection(&section);
  ACCEPTED(GT_Open(0, 1));
  Passed();
  if (strcmp(what, "clocks") == 0) {
    Clocks();
  } else if (strcmp(what, "time_outs") == 0) {
    TimeOuts();
  } else if (strcmp(what, "events") == 0) {
    Events();
  } else if (strcmp(what, "locks") == 0) {
    Locks();
  } else if (strcmp(what, "conditions") == 0) {
    Conditions();
  } else if (strcmp(what, "keys") == 0) {
    Keys();
  } else if (strcmp(what, "procedures") == 0) {
    Procedures();
  } else if (strcmp(what, "found") == 0) {
    Found();
  } else {
    return 2;
  }
  ACCEPTED(GT_Close());
  printf("%s\n", what);
  return 0;
}
