/* Passes NULL and numbers to the functions of the C library that `oncard exec` covers. */
#define _GNU_SOURCE
#include <errno.h>
#include <linux/futex.h>
#include <poll.h>
#include <pthread.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <threads.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "gts.h"

/* Fails with EFAULT. */
#define FAULT(call)          \
  do {                       \
    errno = 0;               \
    CHECK_EQ(call, -1);      \
    CHECK_EQ(errno, EFAULT); \
  } while (0)

/* Volatile, so that the compiler does not notice. */
static void* volatile null = NULL;
static void* volatile eight = (void*)8;

int main(void) {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  struct timespec soon = {0, 1000};
  struct timeval short_time = {0, 1};
  struct epoll_event event;
  int word = 0;
  ACCEPTED(GT_Open(0, 1));
  FAULT(nanosleep(null, NULL));
  FAULT(nanosleep(eight, NULL));
  CHECK_EQ(clock_nanosleep(CLOCK_MONOTONIC, 0, null, NULL), EFAULT);
  CHECK_EQ(clock_nanosleep(CLOCK_REALTIME, TIMER_ABSTIME, eight, NULL), EFAULT);
  CHECK_EQ(thrd_sleep(null, NULL) < -1, 1);
  FAULT(clock_gettime(CLOCK_MONOTONIC, null));
  FAULT(gettimeofday(eight, NULL));
  CHECK_EQ(gettimeofday(null, NULL), 0);
  FAULT(poll(eight, 1, 1));
  FAULT(select(1, eight, NULL, NULL, &short_time));
  FAULT(pselect(1, NULL, eight, NULL, &soon, NULL));
  FAULT(epoll_pwait2(epoll_create1(0), &event, 1, eight, NULL));
  FAULT((int)syscall(SYS_futex, &word, FUTEX_WAIT, 0, eight, NULL, 0));
  FAULT((int)syscall(SYS_futex, eight, FUTEX_WAIT, 0, &soon, NULL, 0));
  /* The C library needs no time for a free lock. */
  CHECK_EQ(pthread_mutex_timedlock(&mutex, null), 0);
  ACCEPTED(GT_Close());
  return 0;
}
