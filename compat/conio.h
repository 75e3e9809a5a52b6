/* The part of <conio.h> that host programs use: keys. They come from ONCARD_KEYS or the scenario;
   without either from the terminal, which gives single keys without echo from the first question
   to the end of the program. */
#ifndef ONCARD_COMPAT_CONIO_H_
#define ONCARD_COMPAT_CONIO_H_

/* As on Windows, toupper() comes along. */
#include <ctype.h>
#include <stdio.h>

#include "oncard_host.h"

/* Other than 0 when a key has been pressed and not read. */
static inline int _kbhit(void) { return oncard_host_kbhit(); }
static inline int kbhit(void) { return oncard_host_kbhit(); }

/* Waits for a key; EOF when no more can come. */
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
