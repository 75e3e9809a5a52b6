/* The part of <windows.h> that host programs of motion cards use: types, sleeping, clocks. Sleep
   and the clocks use the card's virtual time if ONCARD_CLOCK is virtual. `long` has the computer's
   width; DWORD and LONG are the types of gts.h, as on Windows. */
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

#endif
