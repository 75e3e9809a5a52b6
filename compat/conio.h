/* The part of <conio.h> that host programs use: keys. They come from ONCARD_KEYS or the scenario;
   without these, from the terminal, which sends single keys without echo from the first read to the
   end of the program. */
#ifndef ONCARD_COMPAT_CONIO_H_
#define ONCARD_COMPAT_CONIO_H_

/* As on Windows, toupper() is declared too. */
#include <ctype.h>
#include <stdio.h>

#include "oncard_host.h"

/* Non-zero if a key has been pressed and not read. */
static inline int _kbhit(void) { return oncard_host_kbhit(); }
static inline int kbhit(void) { return oncard_host_kbhit(); }

/* Waits for a key; EOF if there are no more. */
static inline int _getch(void) { return oncard_host_getch(); }
static inline int getch(void) { return oncard_host_getch(); }

static inline int _putch(int character) { return putchar(character); }
static inline int putch(int character) { return putchar(character); }

static inline int _getche(void) {
  const int character = oncard_host_getch();
  if (character >= 0) putchar(character);
  return character;
}
static inline int getche(void) { return _getche(); }

#endif
