/* The functions of host libraries besides the commands: time and keys of the host program, for the
   preload library of `oncard exec` and for the headers of compat/. With ONCARD_CLOCK=virtual they
   use the virtual time of the process (virtual_time.h), otherwise the wall clock.

   All but oncard_host_getch may be called in a handler of a signal.

   In C, so that both sides can include it and dlsym() finds the names.
   Tested by tests/tools/exec_command_test.cc, those for interrupts by
   tests/families/toy_family_test.cc and tests/families/gt400/gt400_family_test.cc. */
#ifndef ONCARD_RUNTIME_HOST_HOOKS_H_
#define ONCARD_RUNTIME_HOST_HOOKS_H_

#ifdef __cplusplus
extern "C" {
#endif

/** 1 if the host uses virtual time, otherwise 0. */
int oncard_host_virtual(void);
/** Nanoseconds since the start of the host. In virtual time reading takes a microsecond, so that
    time passes for a program that waits by reading a clock. */
long long oncard_host_time_ns(void);
/** Sleeps; in virtual time without delay. A duration of 0 or less only reads the clock. Returns
   what is left of it if a signal ends the sleep, otherwise 0. */
long long oncard_host_sleep_ns(long long duration_ns);
/** A wait for an event with a deadline in virtual time (virtual_time.h). */
struct oncard_host_wait {
  long long deadline_ns;
  long long number;
};
/** Begins such a wait of the calling thread; the deadline counts from the start of the host. */
void oncard_host_wait_begin(long long deadline_ns, struct oncard_host_wait* wait);
/** How long the thread must wait in real time before it calls this again; 0 if the deadline has
    passed, or passes now because all threads wait: then it checks the event once more and ends. */
long long oncard_host_wait_slice_ns(const struct oncard_host_wait* wait);
/** Ends the wait; a non-zero `expired` means that the deadline has passed. */
void oncard_host_wait_end(const struct oncard_host_wait* wait, int expired);
/** 1 if a key has been pressed and not read. Keys come from ONCARD_KEYS and the scenario's `keys`;
    without these, from the terminal. */
int oncard_host_kbhit(void);
/** Waits for a key and returns its character, without echo; -1 if there are no more. */
int oncard_host_getch(void);

/* Only in the libraries of families whose cards interrupt their host (host_interrupts.h), for hosts
   written for Windows or DOS. None but the last may be called in a handler of a signal that has
   interrupted a call of these functions; it is refused. */

/** A new object for which threads can wait: its handle. It is set, or not. With `automatic` one
   wait that ends because it is set resets it. */
void* oncard_host_event_new(int automatic, int is_set);
/** Sets or resets the object; 0 if there is no such handle, or it is that of a thread, otherwise
    1. */
int oncard_host_event_set(void* handle, int is_set);
/** Waits until the object is set, at most this long; a negative duration means for ever. 1: it is
    set, 0: the time has passed, -1: there is no such handle, or nobody can set it any more. */
int oncard_host_event_wait(void* handle, long long duration_ns);
/** Ends the use of a handle; 0 if there is none. */
int oncard_host_event_close(void* handle);
/** Starts a thread: the handle of an object that is set when it ends, or NULL. Threads are numbered
    from 1 on. */
void* oncard_host_thread_new(unsigned long (*function)(void*), void* argument,
                             unsigned long* number);
/** Ends such a thread, which calls it. */
void oncard_host_thread_exit(void);
/** 0: handlers of interrupts wait from now on, 1: they are called again. */
void oncard_host_interrupts(int enabled);

#ifdef __cplusplus
}
#endif

#endif
