/* The part of <dos.h> that host programs use: waiting. */
#ifndef ONCARD_COMPAT_DOS_H_
#define ONCARD_COMPAT_DOS_H_

#include "oncard_host.h"

static inline void delay(unsigned milliseconds) {
  long long left_ns = (long long)milliseconds * 1000000;
  do {
    left_ns = oncard_host_sleep_ns(left_ns);
  } while (left_ns > 0);
}

#endif
