/* The part of <windows.h> that host programs of motion cards use: types, sleeping, clocks, events
   and threads. All of them use the card's virtual time if ONCARD_CLOCK is virtual. `long` has the
   computer's width; DWORD and LONG are the types of gts.h, as on Windows.

   Events and threads are in the libraries of cards that interrupt their host. */
#ifndef ONCARD_COMPAT_WINDOWS_H_
#define ONCARD_COMPAT_WINDOWS_H_

/* As on Windows, these are included too. */
#include <ctype.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "oncard_host.h"

#define WINAPI
#define CALLBACK
#define APIENTRY
#ifndef __stdcall
#define __stdcall
#endif
#ifndef __cdecl
#define __cdecl
#endif

typedef int BOOL;
typedef unsigned char BYTE;
typedef unsigned short WORD;
typedef unsigned long DWORD;
typedef char CHAR;
typedef short SHORT;
typedef int INT;
typedef unsigned int UINT;
typedef long LONG;
typedef unsigned long ULONG;
typedef long long LONGLONG;
typedef unsigned long long ULONGLONG;
typedef float FLOAT;
typedef double DOUBLE;
typedef char* LPSTR;
typedef const char* LPCSTR;
typedef void* PVOID;
typedef void* LPVOID;
typedef DWORD* LPDWORD;
typedef void* HANDLE;
typedef HANDLE HEVENT;

#ifndef TRUE
#define TRUE 1
#endif
#ifndef FALSE
#define FALSE 0
#endif

typedef union {
  struct {
    uint32_t LowPart;
    int32_t HighPart;
  } u;
  LONGLONG QuadPart;
} LARGE_INTEGER;

#define ZeroMemory(destination, length) memset((destination), 0, (length))

/* A host requests these steps for exact sleeps. Here sleeps are always exact. */
static inline UINT timeBeginPeriod(UINT milliseconds) {
  (void)milliseconds;
  return 0;
}
static inline UINT timeEndPeriod(UINT milliseconds) {
  (void)milliseconds;
  return 0;
}

static inline void Sleep(DWORD milliseconds) {
  long long left_ns = (long long)milliseconds * 1000000;
  do {
    left_ns = oncard_host_sleep_ns(left_ns);
  } while (left_ns > 0);
}

static inline ULONGLONG GetTickCount64(void) {
  return (ULONGLONG)(oncard_host_time_ns() / 1000000);
}
static inline DWORD GetTickCount(void) { return (DWORD)(uint32_t)GetTickCount64(); }
static inline DWORD timeGetTime(void) { return GetTickCount(); }

/* Steps of 100 ns, as on Windows. */
static inline BOOL QueryPerformanceFrequency(LARGE_INTEGER* frequency) {
  frequency->QuadPart = 10000000;
  return TRUE;
}
static inline BOOL QueryPerformanceCounter(LARGE_INTEGER* counter) {
  counter->QuadPart = oncard_host_time_ns() / 100;
  return TRUE;
}

/* A handle that cannot be made is NULL. */
#define INVALID_HANDLE_VALUE ((HANDLE)(intptr_t)-1)
#define INFINITE 0xFFFFFFFFu
#define WAIT_OBJECT_0 0u
#define WAIT_TIMEOUT 258u
#define WAIT_FAILED 0xFFFFFFFFu

/* Security and names of events are for other processes, and are not used. */
static inline HANDLE CreateEvent(void* security, BOOL manual_reset, BOOL initial_state,
                                 LPCSTR name) {
  (void)security;
  (void)name;
  return oncard_host_event_new(!manual_reset, initial_state);
}
static inline BOOL SetEvent(HANDLE event) { return oncard_host_event_set(event, 1); }
static inline BOOL ResetEvent(HANDLE event) { return oncard_host_event_set(event, 0); }
static inline BOOL CloseHandle(HANDLE object) { return oncard_host_event_close(object); }

/* Of an event, or of the end of a thread. */
static inline DWORD WaitForSingleObject(HANDLE object, DWORD milliseconds) {
  const int how = oncard_host_event_wait(
      object, milliseconds == INFINITE ? -1 : (long long)milliseconds * 1000000);
  return how > 0 ? WAIT_OBJECT_0 : how == 0 ? WAIT_TIMEOUT : WAIT_FAILED;
}

typedef DWORD(WINAPI* LPTHREAD_START_ROUTINE)(LPVOID parameter);

/* The stack has the size that is usual here, and the thread runs at once. */
static inline HANDLE CreateThread(void* security, size_t stack_size, LPTHREAD_START_ROUTINE start,
                                  LPVOID parameter, DWORD flags, LPDWORD thread_id) {
  (void)security;
  (void)stack_size;
  (void)flags;
  return oncard_host_thread_new(start, parameter, thread_id);
}
static inline void ExitThread(DWORD code) {
  (void)code;
  oncard_host_thread_exit();
}

#endif
