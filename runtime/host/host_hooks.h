/* What libgts offers beside the commands: time and keys of the host program, for the preload
   library of `oncard exec` and for the headers of compat/. With ONCARD_CLOCK=virtual they go by the
   virtual time of the process (virtual_time.h), otherwise by the wall clock.

   C, so that both sides can include it and dlsym() finds the names.
   Tested by tests/tools/exec_command_test.cc. */
#ifndef ONCARD_RUNTIME_HOST_HOOKS_H_
#define ONCARD_RUNTIME_HOST_HOOKS_H_

#ifdef __cplusplus
extern "C" {
#endif

/** 1 when the host goes by virtual time, otherwise 0. */
int oncard_host_virtual(void);
/** Nanoseconds since the start of the host. With virtual time a look takes a microsecond, so that a
    program that waits by looking at a clock gets on. */
long long oncard_host_time_ns(void);
/** Sleeps; with virtual time, without delay. A duration of 0 or less is a look at the clock. */
void oncard_host_sleep_ns(long long duration_ns);
/** A wait for something else than time that ends at a moment of virtual time (virtual_time.h). */
struct oncard_host_wait {
  long long deadline_ns;
  long long number;
};
/** The calling thread begins such a wait; the moment counts from the start of the host. */
void oncard_host_wait_begin(long long deadline_ns, struct oncard_host_wait* wait);
/** How long it is to wait in reality before it asks again; 0 when the moment has come, or would
   come now as all threads wait: then it looks a last time and ends. */
long long oncard_host_wait_slice_ns(const struct oncard_host_wait* wait);
/** Ends it; with `expired` other than 0 the moment has come. */
void oncard_host_wait_end(const struct oncard_host_wait* wait, int expired);
/** 1 when a key has been pressed and not read. Keys come from ONCARD_KEYS and from the scenario's
    `keys`, without either from the terminal. */
int oncard_host_kbhit(void);
/** Waits for a key and gives its character, without echo; -1 when no more can come. */
int oncard_host_getch(void);

#ifdef __cplusplus
}
#endif

#endif
