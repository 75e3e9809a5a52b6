/* A host whose signal handlers call the card and read the clock, as an emergency stop does. The
   arguments are what the handler does, and how many signals arrive while the host makes calls:

     stop close exit    GT_Stop; also GT_Close; also GT_Close and exit(3) at the last signal
     wait               GT_Stop and reads of the status, during waits with a deadline, which time
                        passes meanwhile; another thread calls the card
     fork               GT_Stop, while the host makes child processes and another thread sets
                        handlers
     nap                as exit, but the host does nothing but sleep for ten minutes
     clock              all that POSIX allows in a handler and that depends on time
     direct             GT_Stop in a handler of which libgts does not know, as in a host that loads
                        libgts itself
     sleep              nothing, but the signals arrive during sleeps of a minute

   A host that hangs is ended by a real-time alarm. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "gts.h"
#include "oncard_host.h"

typedef int (*SetAction)(int, const struct sigaction*, struct sigaction*);

static const char* mode;
static int wanted;
static pthread_t host_thread, other;
static volatile sig_atomic_t handled, unexpected, refused;
static volatile int over;
static int never[2]; /* a pipe into which nothing is written */
static struct timespec latest;
static sem_t done;

static int IsMode(const char* name) { return strcmp(mode, name) == 0; }

static void Expect(short code, short also) {
  if (code != 0 && code != also) unexpected = code;
  if (code == 1) refused = refused + 1;
}

static void ReadClocks(void) {
  struct timespec now, shortly = {0, 1000};
  struct timeval at_once = {0, 0};
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (now.tv_sec < latest.tv_sec || (now.tv_sec == latest.tv_sec && now.tv_nsec < latest.tv_nsec)) {
    unexpected = 1;
  }
  latest = now;
  if (time(NULL) <= 0) unexpected = 2;
  if (nanosleep(&shortly, NULL) != 0) unexpected = 3;
  if (poll(NULL, 0, 0) != 0) unexpected = 4;
  if (select(0, NULL, NULL, NULL, &at_once) != 0) unexpected = 5;
}

/* 2 ms; a wait takes 1 ms. */
static void ReadStatus(void) {
  long status;
  int times;
  for (times = 0; times < 40; ++times) Expect(GT_GetSts(1, &status, 1, NULL), 0);
}

static void OnSignal(int number) {
  (void)number;
  if (IsMode("sleep")) return;
  if (IsMode("clock")) {
    ReadClocks();
  } else {
    Expect(GT_Stop(1, 0), IsMode("direct") ? 1 : 0);
    if (IsMode("wait")) ReadStatus();
  }
  handled = handled + 1;
  if (IsMode("close")) {
    Expect(GT_Close(), 0); /* the host opens it again */
    return;
  }
  if ((IsMode("exit") || IsMode("nap")) && handled == wanted) {
    Expect(GT_Close(), 0);
    exit(unexpected != 0 ? 4 : 3);
  }
  sem_post(&done);
}

/* Each signal arrives some time after the one before has been handled, wherever the host then is.
 */
static void* SendSignals(void* unused) {
  int sent;
  for (sent = 1; sent <= wanted; ++sent) {
    const struct timespec pause = {0, 20000};
    syscall(SYS_nanosleep, &pause, NULL);
    pthread_kill(host_thread, SIGINT);
    sem_wait(&done);
  }
  over = 1;
  return unused;
}

static void Listen(void) {
  struct sigaction action;
  memset(&action, 0, sizeof action);
  action.sa_handler = OnSignal;
  action.sa_flags = SA_RESTART;
  if (IsMode("direct")) {
    void* found = dlsym(dlopen("libc.so.6", RTLD_LAZY | RTLD_NOLOAD), "sigaction");
    SetAction set;
    memcpy(&set, &found, sizeof set);
    CHECK_EQ(set(SIGINT, &action, NULL), 0);
  } else if (IsMode("stop")) {
    struct sigaction is;
    CHECK_EQ(signal(SIGINT, OnSignal) == SIG_DFL, 1);
    CHECK_EQ(sigaction(SIGINT, NULL, &is), 0);
    CHECK_EQ(is.sa_handler == OnSignal, 1);
    CHECK_EQ(is.sa_flags & SA_SIGINFO, 0);
  } else {
    CHECK_EQ(sigaction(SIGINT, &action, NULL), 0);
  }
}

static void* CallToo(void* unused) {
  while (!over) ReadStatus();
  return unused;
}

/* Never waits, so that virtual time cannot go on to the end of a sleep. */
static void* DisturbSleeps(void* unused) {
  while (!over) pthread_kill(host_thread, SIGINT);
  return unused;
}

static void Sleep(void) {
  struct timespec minute = {60, 0}, rest = {0, 0};
  struct timeval timeout = {60, 0};
  CHECK_EQ(nanosleep(&minute, &rest), -1);
  CHECK_EQ(errno, EINTR);
  CHECK_EQ(rest.tv_sec == 60 || rest.tv_sec == 59, 1);
  CHECK_EQ(clock_nanosleep(CLOCK_MONOTONIC, 0, &minute, NULL), EINTR);
  CHECK_EQ(sleep(60) > 50, 1);
  CHECK_EQ(usleep(60000000), -1);
  CHECK_EQ(poll(NULL, 0, 60000), -1);
  CHECK_EQ(errno, EINTR);
  CHECK_EQ(select(0, NULL, NULL, NULL, &timeout), -1);
  CHECK_EQ(errno, EINTR);
}

static void* SetHandlers(void* unused) {
  while (!over) signal(SIGUSR1, SIG_IGN);
  return unused;
}

static void MakeChild(void) {
  int status = -1;
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);
    signal(SIGUSR1, SIG_DFL);
    _exit(0);
  }
  CHECK_EQ(waitpid(child, &status, 0), child);
  CHECK_EQ(status, 0);
}

int main(int argc, char** argv) {
  pthread_t sender;
  double position = 0;
  struct timespec now, shortly = {0, 1000000};
  if (argc != 3) return 2;
  mode = argv[1];
  wanted = atoi(argv[2]);
  alarm(60);
  host_thread = pthread_self();
  sem_init(&done, 0, 0);
  Listen();
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_AxisOn(1));
  CHECK_EQ(pthread_create(&sender, NULL, IsMode("sleep") ? DisturbSleeps : SendSignals, NULL), 0);
  if (IsMode("wait")) {
    CHECK_EQ(pipe(never), 0);
    CHECK_EQ(pthread_create(&other, NULL, CallToo, NULL), 0);
  }
  if (IsMode("fork")) CHECK_EQ(pthread_create(&other, NULL, SetHandlers, NULL), 0);
  if (IsMode("sleep")) {
    Sleep();
    over = 1;
  }
  while (!over) {
    if (IsMode("wait")) {
      struct pollfd nothing = {never[0], POLLIN, 0};
      CHECK_EQ(poll(&nothing, 1, 1) <= 0, 1);
    } else if (IsMode("fork")) {
      MakeChild();
    } else if (IsMode("nap")) {
      oncard_host_sleep_ns(600000000000LL);
    } else if (IsMode("clock")) {
      clock_gettime(CLOCK_MONOTONIC, &now);
      nanosleep(&shortly, NULL);
    } else if (GT_GetPrfPos(1, &position, 1, NULL) == -1) {
      if (GT_Open(0, 1) != 0) return 5;
      sem_post(&done);
    }
  }
  pthread_join(sender, NULL);
  if (IsMode("wait") || IsMode("fork")) pthread_join(other, NULL);
  printf("%d handled, unexpected %d, %s\n", (int)handled, (int)unexpected,
         refused > 0 ? "some refused" : "none refused");
  return 0;
}
