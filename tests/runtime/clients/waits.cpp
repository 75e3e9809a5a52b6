// Waits with a time-out; the argument selects one. Each is executed twice: for something that does
// not happen within 2 s, and for something that another thread does after 300 ms. The results are
// printed with the milliseconds that they took.
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <mqueue.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <sys/times.h>
#include <sys/wait.h>
#include <threads.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <semaphore>
#include <shared_mutex>
#include <string>
#include <thread>

#include "check.h"
#include "gts.h"

namespace {

using std::chrono::milliseconds;

constexpr int kTimeoutMs = 2000;
constexpr int kBringMs = 300;

timespec In(clockid_t clock, int ms) {
  timespec now;
  clock_gettime(clock, &now);
  now.tv_sec += ms / 1000;
  now.tv_nsec += ms % 1000 * 1000000L;
  if (now.tv_nsec >= 1000000000) {
    now.tv_nsec -= 1000000000;
    ++now.tv_sec;
  }
  return now;
}

double NowMs() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

// `wait` returns true if the event happened within kTimeoutMs; `bring` causes the event.
void Report(const std::function<bool()>& wait, const std::function<void()>& bring) {
  const auto print = [&] {
    const double begin = NowMs();
    const bool came = wait();
    printf("%s %.0f\n", came ? "came" : "timeout", NowMs() - begin);
  };
  print();
  std::thread other([&] {
    usleep(kBringMs * 1000);
    bring();
  });
  print();
  other.join();
}

// True if the event happened, for functions that return their error, or -1 with errno.
bool Came(int error, int timeout = ETIMEDOUT) {
  CHECK_EQ(error == 0 || error == timeout, 1);
  return error == 0;
}
bool CameErrno(int result) { return Came(result == 0 ? 0 : errno); }

void Conditions(const std::string& name) {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
  const clockid_t clock = name == "cond_realtime" ? CLOCK_REALTIME : CLOCK_MONOTONIC;
  if (name == "cond_monotonic") {
    pthread_condattr_t attributes;
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&condition, &attributes);
  }
  Report(
      [&] {
        const timespec until = In(clock, kTimeoutMs);
        pthread_mutex_lock(&mutex);
        const int error = name == "cond_clockwait"
                              ? pthread_cond_clockwait(&condition, &mutex, clock, &until)
                              : pthread_cond_timedwait(&condition, &mutex, &until);
        pthread_mutex_unlock(&mutex);
        return Came(error);
      },
      [&] {
        pthread_mutex_lock(&mutex);
        pthread_mutex_unlock(&mutex);
        pthread_cond_signal(&condition);
      });
}

void Cnd() {
  mtx_t mutex;
  cnd_t condition;
  mtx_init(&mutex, mtx_timed);
  cnd_init(&condition);
  Report(
      [&] {
        const timespec until = In(CLOCK_REALTIME, kTimeoutMs);
        mtx_lock(&mutex);
        const int result = cnd_timedwait(&condition, &mutex, &until);
        mtx_unlock(&mutex);
        return Came(result, thrd_timedout);
      },
      [&] { cnd_broadcast(&condition); });
}

// A lock that another thread holds until `bring`: that thread waits for a byte in a pipe.
template <typename Take, typename Lock, typename Give>
void Locks(const Take& take, const Lock& lock, const Give& give) {
  int bytes[2];
  CHECK_EQ(pipe(bytes), 0);
  std::promise<void> held;
  std::thread holder([&] {
    char byte;
    lock();
    held.set_value();
    CHECK_EQ(read(bytes[0], &byte, 1), 1);
    give();
  });
  held.get_future().wait();
  Report(
      [&] {
        const bool came = take();
        if (came) give();
        return came;
      },
      [&] { CHECK_EQ(write(bytes[1], "x", 1), 1); });
  holder.join();
}

void Mutexes(const std::string& name) {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  mtx_t mtx;
  mtx_init(&mtx, mtx_timed);
  if (name == "mtx_timedlock") {
    Locks(
        [&] {
          const timespec until = In(CLOCK_REALTIME, kTimeoutMs);
          return Came(mtx_timedlock(&mtx, &until), thrd_timedout);
        },
        [&] { mtx_lock(&mtx); }, [&] { mtx_unlock(&mtx); });
    return;
  }
  Locks(
      [&] {
        const clockid_t clock = name == "mutex_timedlock" ? CLOCK_REALTIME : CLOCK_MONOTONIC;
        const timespec until = In(clock, kTimeoutMs);
        return Came(name == "mutex_timedlock" ? pthread_mutex_timedlock(&mutex, &until)
                                              : pthread_mutex_clocklock(&mutex, clock, &until));
      },
      [&] { pthread_mutex_lock(&mutex); }, [&] { pthread_mutex_unlock(&mutex); });
}

void RwLocks(const std::string& name) {
  pthread_rwlock_t lock = PTHREAD_RWLOCK_INITIALIZER;
  const bool clocked =
      name.find("clock") != std::string::npos && name.find("timed") == std::string::npos;
  const clockid_t clock = clocked ? CLOCK_MONOTONIC : CLOCK_REALTIME;
  Locks(
      [&] {
        const timespec until = In(clock, kTimeoutMs);
        if (name == "rwlock_timedrdlock") return Came(pthread_rwlock_timedrdlock(&lock, &until));
        if (name == "rwlock_timedwrlock") return Came(pthread_rwlock_timedwrlock(&lock, &until));
        if (name == "rwlock_clockrdlock") {
          return Came(pthread_rwlock_clockrdlock(&lock, clock, &until));
        }
        return Came(pthread_rwlock_clockwrlock(&lock, clock, &until));
      },
      [&] { pthread_rwlock_wrlock(&lock); }, [&] { pthread_rwlock_unlock(&lock); });
}

void Semaphores(const std::string& name) {
  sem_t semaphore;
  sem_init(&semaphore, 0, 0);
  Report(
      [&] {
        const clockid_t clock = name == "sem_timedwait" ? CLOCK_REALTIME : CLOCK_MONOTONIC;
        const timespec until = In(clock, kTimeoutMs);
        return CameErrno(name == "sem_timedwait" ? sem_timedwait(&semaphore, &until)
                                                 : sem_clockwait(&semaphore, clock, &until));
      },
      [&] { sem_post(&semaphore); });
}

void Descriptors(const std::string& name) {
  int bytes[2];
  CHECK_EQ(pipe(bytes), 0);
  const int epoll = epoll_create1(0);
  epoll_event event = {EPOLLIN, {}};
  epoll_ctl(epoll, EPOLL_CTL_ADD, bytes[0], &event);
  const timespec timeout = {kTimeoutMs / 1000, 0};
  Report(
      [&] {
        pollfd descriptor = {bytes[0], POLLIN, 0};
        timeval select_timeout = {kTimeoutMs / 1000, 0};
        fd_set set;
        FD_ZERO(&set);
        FD_SET(bytes[0], &set);
        int ready = -1;
        if (name == "poll") ready = poll(&descriptor, 1, kTimeoutMs);
        if (name == "ppoll") ready = ppoll(&descriptor, 1, &timeout, nullptr);
        if (name == "pselect") {
          ready = pselect(bytes[0] + 1, &set, nullptr, nullptr, &timeout, nullptr);
        }
        if (name == "select") {
          ready = select(bytes[0] + 1, &set, nullptr, nullptr, &select_timeout);
          CHECK_EQ(FD_ISSET(bytes[0], &set) != 0, ready == 1);
          // Linux stores the remaining time in it.
          const double left_ms = static_cast<double>(select_timeout.tv_sec) * 1e3 +
                                 static_cast<double>(select_timeout.tv_usec) / 1e3;
          const double expected_ms = ready == 1 ? kTimeoutMs - kBringMs : 0;
          CHECK_EQ(left_ms > expected_ms - 1 && left_ms < expected_ms + 1, 1);
        }
        if (name == "epoll_wait") ready = epoll_wait(epoll, &event, 1, kTimeoutMs);
        if (name == "epoll_pwait") ready = epoll_pwait(epoll, &event, 1, kTimeoutMs, nullptr);
        if (name == "epoll_pwait2") ready = epoll_pwait2(epoll, &event, 1, &timeout, nullptr);
        CHECK_EQ(ready == 0 || ready == 1, 1);
        return ready == 1;
      },
      [&] { CHECK_EQ(write(bytes[1], "x", 1), 1); });
}

void Joins(const std::string& name) {
  int bytes[2];
  CHECK_EQ(pipe(bytes), 0);
  pthread_t thread;
  pthread_create(
      &thread, nullptr,
      [](void* end) -> void* {
        char byte;
        CHECK_EQ(read(*static_cast<int*>(end), &byte, 1), 1);
        return nullptr;
      },
      &bytes[0]);
  Report(
      [&] {
        const clockid_t clock = name == "timedjoin" ? CLOCK_REALTIME : CLOCK_MONOTONIC;
        const timespec until = In(clock, kTimeoutMs);
        return Came(name == "timedjoin" ? pthread_timedjoin_np(thread, nullptr, &until)
                                        : pthread_clockjoin_np(thread, nullptr, clock, &until));
      },
      [&] { CHECK_EQ(write(bytes[1], "x", 1), 1); });
}

void Queues(const std::string& name) {
  const std::string path = "/oncard_waits_" + std::to_string(getpid());
  mq_attr attributes = {};
  attributes.mq_maxmsg = 1;
  attributes.mq_msgsize = 1;
  const mqd_t queue = mq_open(path.c_str(), O_RDWR | O_CREAT, 0600, &attributes);
  CHECK_EQ(queue == -1, 0);
  mq_unlink(path.c_str());
  const bool receives = name == "mq_timedreceive";
  char byte = 0;
  if (!receives) CHECK_EQ(mq_send(queue, "x", 1, 0), 0);
  Report(
      [&] {
        const timespec until = In(CLOCK_REALTIME, kTimeoutMs);
        if (!receives) return CameErrno(mq_timedsend(queue, "x", 1, 0, &until));
        return CameErrno(mq_timedreceive(queue, &byte, 1, nullptr, &until) == 1 ? 0 : -1);
      },
      [&] {
        if (receives) {
          CHECK_EQ(mq_send(queue, "x", 1, 0), 0);
        } else {
          CHECK_EQ(mq_receive(queue, &byte, 1, nullptr), 1);
        }
      });
}

void Signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  const pthread_t self = pthread_self();
  const timespec timeout = {kTimeoutMs / 1000, 0};
  Report(
      [&] {
        const int signal = sigtimedwait(&set, nullptr, &timeout);
        CHECK_EQ(signal == SIGUSR1 || errno == EAGAIN, 1);
        return signal == SIGUSR1;
      },
      [&] { pthread_kill(self, SIGUSR1); });
}

void Cpp(const std::string& name) {
  std::mutex mutex;
  std::condition_variable condition;
  bool ready = false;
  if (name == "cpp_condition_for" || name == "cpp_condition_until") {
    Report(
        [&] {
          std::unique_lock lock(mutex);
          const auto is_ready = [&] { return ready; };
          if (name == "cpp_condition_for") {
            return condition.wait_for(lock, milliseconds(kTimeoutMs), is_ready);
          }
          return condition.wait_until(
              lock, std::chrono::system_clock::now() + milliseconds(kTimeoutMs), is_ready);
        },
        [&] {
          const std::lock_guard lock(mutex);
          ready = true;
          condition.notify_one();
        });
  }
  if (name == "cpp_future") {
    std::promise<void> promise;
    std::future<void> future = promise.get_future();
    Report([&] { return future.wait_for(milliseconds(kTimeoutMs)) == std::future_status::ready; },
           [&] { promise.set_value(); });
  }
  if (name == "cpp_semaphore") {
    std::counting_semaphore<2> semaphore(0);
    Report([&] { return semaphore.try_acquire_for(milliseconds(kTimeoutMs)); },
           [&] { semaphore.release(); });
  }
  if (name == "cpp_mutex") {
    std::timed_mutex timed;
    Locks([&] { return timed.try_lock_for(milliseconds(kTimeoutMs)); }, [&] { timed.lock(); },
          [&] { timed.unlock(); });
  }
  if (name == "cpp_shared_mutex") {
    std::shared_timed_mutex shared;
    Locks([&] { return shared.try_lock_for(milliseconds(kTimeoutMs)); }, [&] { shared.lock(); },
          [&] { shared.unlock(); });
  }
}

// Durations beyond the range of the clock end at the end of time, one after the other; if time_t
// has 64 bits.
void ForEver() {
  const timespec centuries = {static_cast<time_t>(20'000'000'000), 0};
  const timespec longest = {LONG_MAX, 999999999};
  CHECK_EQ(nanosleep(&centuries, nullptr), 0);
  CHECK_EQ(NowMs() > 4e12, 1);
  const double end = NowMs();
  CHECK_EQ(nanosleep(&longest, nullptr), 0);
  CHECK_EQ(clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &longest, nullptr), 0);
  CHECK_EQ(thrd_sleep(&longest, nullptr), 0);
  timeval timeout = {LONG_MAX, 999999};
  CHECK_EQ(select(0, nullptr, nullptr, nullptr, &timeout), 0);
  CHECK_EQ(NowMs(), end);
  printf("the end\n");
}

void Times() {
  struct tms used;
  const clock_t begin = times(&used);
  const timespec duration = {1, 500000000};
  CHECK_EQ(thrd_sleep(&duration, nullptr), 0);
  printf("%ld ticks\n", static_cast<long>(times(&used) - begin));
}

// Threads that are repeatedly cancelled while they wait; time continues without them.
void Cancel() {
  const std::function<void()> waits[] = {
      [] { usleep(1000000); },
      [] { poll(nullptr, 0, 1000); },
      [] {
        sem_t semaphore;
        sem_init(&semaphore, 0, 0);
        const timespec until = In(CLOCK_REALTIME, 1000);
        sem_timedwait(&semaphore, &until);
      },
      [] {
        pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
        pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
        const timespec until = In(CLOCK_REALTIME, 1000);
        pthread_mutex_lock(&mutex);
        pthread_cond_timedwait(&condition, &mutex, &until);
        pthread_mutex_unlock(&mutex);
      },
  };
  for (const auto& wait : waits) {
    pthread_t thread;
    pthread_create(
        &thread, nullptr,
        [](void* argument) -> void* {
          while (true) (*static_cast<const std::function<void()>*>(argument))();
        },
        const_cast<std::function<void()>*>(&wait));
    usleep(2500000);
    pthread_cancel(thread);
    void* result = nullptr;
    pthread_join(thread, &result);
    CHECK_EQ(result == PTHREAD_CANCELED, 1);
    sleep(100);
  }
  printf("%zu cancelled\n", sizeof waits / sizeof waits[0]);
}

// A child of a host with several threads, one of which is always in a command and one asleep.
void Fork() {
  std::atomic<bool> work = true;
  ACCEPTED(GT_Open());
  std::thread caller([&] {
    TThreadSts status;
    while (work) GT_GetThreadSts(0, &status);
  });
  std::thread sleeper([&] {
    while (work) usleep(1000);
  });
  for (int i = 0; i < 50; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      unsigned long clock = 0;
      sleep(10);
      std::mutex mutex;
      std::condition_variable condition;
      std::unique_lock lock(mutex);
      condition.wait_for(lock, std::chrono::seconds(10));
      CHECK_EQ(GT_GetClock(&clock), 0);
      _exit(clock >= 20000 ? 0 : 1);
    }
    int status = -1;
    CHECK_EQ(waitpid(child, &status, 0), child);
    CHECK_EQ(status, 0);
  }
  work = false;
  caller.join();
  sleeper.join();
  printf("50 children\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string name = argv[1];
  const auto begins = [&](const char* prefix) { return name.rfind(prefix, 0) == 0; };
  if (begins("cond_")) Conditions(name);
  if (name == "cnd_timedwait") Cnd();
  if (begins("mutex_") || begins("mtx_")) Mutexes(name);
  if (begins("rwlock_")) RwLocks(name);
  if (begins("sem_")) Semaphores(name);
  if (begins("poll") || begins("ppoll") || begins("select") || begins("pselect") ||
      begins("epoll")) {
    Descriptors(name);
  }
  if (name == "timedjoin" || name == "clockjoin") Joins(name);
  if (begins("mq_")) Queues(name);
  if (name == "sigtimedwait") Signals();
  if (begins("cpp_")) Cpp(name);
  if (name == "forever") ForEver();
  if (name == "times") Times();
  if (name == "cancel") Cancel();
  if (name == "fork") Fork();
  fflush(stdout);
  return 0;
}
