/* Preloaded into the command: the call that ONCARD_FAIL names fails where it says, as in `rename:2`
   for the second one. Says "injected" on standard error then. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

extern void* __libc_malloc(size_t size);

static int Fails(const char* call) {
  static int count;
  static __thread int busy;
  if (busy) return 0;
  busy = 1;
  const char* wanted = getenv("ONCARD_FAIL");
  const size_t length = strlen(call);
  int fails = 0;
  if (wanted != NULL && strncmp(wanted, call, length) == 0 && wanted[length] == ':') {
    fails = ++count == atoi(wanted + length + 1);
  }
  if (fails) {
    static const char said[] = "injected\n";
    ssize_t (*real)(int, const void*, size_t) =
        (ssize_t(*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write");
    (void)!real(STDERR_FILENO, said, sizeof said - 1);
    errno = EIO;
  }
  busy = 0;
  return fails;
}

#define REAL(name, ...) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))(__VA_ARGS__)

void* malloc(size_t size) {
  if (!Fails("malloc")) return __libc_malloc(size);
  errno = ENOMEM;
  return NULL;
}

int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if (flags & O_CREAT) {
    va_list arguments;
    va_start(arguments, flags);
    mode = va_arg(arguments, mode_t);
    va_end(arguments);
  }
  return Fails("open") ? -1 : REAL(open, path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t count) {
  if (file <= STDERR_FILENO) return REAL(write, file, bytes, count);
  if (Fails("write")) return -1;
  /* A disk that takes a part only. */
  return REAL(write, file, bytes, Fails("short_write") ? (count + 1) / 2 : count);
}

int fsync(int file) { return Fails("fsync") ? -1 : REAL(fsync, file); }
int fchmod(int file, mode_t mode) { return Fails("fchmod") ? -1 : REAL(fchmod, file, mode); }
int flock(int file, int kind) { return Fails("flock") ? -1 : REAL(flock, file, kind); }
int rename(const char* from, const char* to) {
  return Fails("rename") ? -1 : REAL(rename, from, to);
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  return Fails("renameat2") ? -1 : REAL(renameat2, from_folder, from, to_folder, to, flags);
}
