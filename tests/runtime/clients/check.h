/* What the host programs of the tests use to check a call: prints what differs and ends. */
#ifndef ONCARD_TESTS_CHECK_H
#define ONCARD_TESTS_CHECK_H

#include <stdio.h>
#include <stdlib.h>

#define CHECK_EQ(found, expected)                                                                \
  do {                                                                                           \
    const double check_found = (double)(found);                                                  \
    const double check_expected = (double)(expected);                                            \
    if (check_found != check_expected) {                                                         \
      fprintf(stderr, "%s:%d: %s is %g, expected %g\n", __FILE__, __LINE__, #found, check_found, \
              check_expected);                                                                   \
      exit(1);                                                                                   \
    }                                                                                            \
  } while (0)

/* A command that must be accepted. */
#define ACCEPTED(call) CHECK_EQ(call, 0)

#endif
