/* All functions of the C library that sleep or read a clock, and their results. The arguments are
   the exit code and the seconds of the long sleep. */
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/select.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "gts.h"

static double Now(clockid_t clock) {
  struct timespec now;
  clock_gettime(clock, &now);
  return (double)now.tv_sec * 1000 + (double)now.tv_nsec / 1e6;
}

static void Report(const char* name) { printf("%s %.3f\n", name, Now(CLOCK_MONOTONIC) - 1e6); }

int main(int argc, char** argv) {
  struct timespec duration = {0, 250000000};
  struct timespec rest = {9, 9};
  struct timespec wrong = {0, 1000000000};
  struct timespec moment;
  struct timeval timeout = {0, 500000};
  struct timeval day;
  unsigned long clock = 0;
  char date[64];
  time_t now;

  if (argc != 3) return 2;
  ACCEPTED(GT_Open(0, 1));
  Report("open");
  usleep(1000);
  Report("usleep");
  CHECK_EQ(nanosleep(&duration, &rest), 0);
  CHECK_EQ(rest.tv_sec, 9); /* nothing was left */
  CHECK_EQ(nanosleep(&wrong, NULL), -1);
  CHECK_EQ(errno, EINVAL);
  Report("nanosleep");
  CHECK_EQ(clock_nanosleep(CLOCK_REALTIME, 0, &duration, NULL), 0);
  Report("clock_nanosleep");
  clock_gettime(CLOCK_MONOTONIC, &moment);
  moment.tv_sec += 1;
  CHECK_EQ(clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &moment, NULL), 0);
  Report("until");
  CHECK_EQ(select(0, NULL, NULL, NULL, &timeout), 0);
  Report("select");
  CHECK_EQ(poll(NULL, 0, 125), 0);
  Report("poll");
  CHECK_EQ(sleep((unsigned)atoi(argv[2])), 0);
  Report("sleep");

  gettimeofday(&day, NULL);
  now = time(NULL);
  /* A second may begin between the two, and time() may be behind by a tick of the kernel. */
  CHECK_EQ(labs((long)(now - day.tv_sec)) <= 1, 1);
  strftime(date, sizeof date, "%Y-%m-%d %H:%M:%S", gmtime(&now));
  ACCEPTED(GT_GetClock(&clock, NULL));
  printf("%s, card %lu ms\n", date, clock);
  ACCEPTED(GT_Close());
  return atoi(argv[1]);
}
