/* The part of <dos.h> that host programs use: waiting, and what handlers of interrupts do. A card
   needs nothing of the interrupt controller, so writing to its ports has no effect.

   disable() and enable() are in the libraries of cards that interrupt their host. */
#ifndef ONCARD_COMPAT_DOS_H_
#define ONCARD_COMPAT_DOS_H_

#include "oncard_host.h"

static inline void delay(unsigned milliseconds) {
  long long left_ns = (long long)milliseconds * 1000000;
  do {
    left_ns = oncard_host_sleep_ns(left_ns);
  } while (left_ns > 0);
}

/* Handlers of interrupts wait from now on; they are called again. */
static inline void disable(void) { oncard_host_interrupts(0); }
static inline void enable(void) { oncard_host_interrupts(1); }

static inline void outportb(int port, unsigned char value) {
  (void)port;
  (void)value;
}
static inline unsigned char inportb(int port) {
  (void)port;
  return 0;
}

#endif
