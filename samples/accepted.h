/* What the host programs of the samples share: every command must be accepted. */
#ifndef ONCARD_SAMPLES_ACCEPTED_H
#define ONCARD_SAMPLES_ACCEPTED_H

#include <stdio.h>
#include <stdlib.h>

/* Ends the program at a command that the card refuses. */
#define ACCEPTED(call)                           \
  do {                                           \
    const short code = (call);                   \
    if (code != 0) {                             \
      fprintf(stderr, "%s = %d\n", #call, code); \
      exit(1);                                   \
    }                                            \
  } while (0)

#define IN_MOTION 0x400 /* bit 10 of the status word */

#endif
