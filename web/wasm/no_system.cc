// What the standard library would ask of a system, refused here: the module imports nothing, so
// that nothing but its requests can influence its answers. No clock, no random numbers, no files,
// no environment; a failed assertion of the library ends the module with a trap.
#include <cstdint>

namespace {

/// Numbers of errors of WASI (wasi/api.h): a bad descriptor.
constexpr int32_t kBadDescriptor = 8;

}  // namespace

extern "C" {

// The names that wasi-libc imports from `wasi_snapshot_preview1`.
int32_t __imported_wasi_snapshot_preview1_environ_get(int32_t, int32_t) { return 0; }

int32_t __imported_wasi_snapshot_preview1_environ_sizes_get(int32_t count, int32_t bytes) {
  *reinterpret_cast<int32_t*>(count) = 0;
  *reinterpret_cast<int32_t*>(bytes) = 0;
  return 0;
}

int32_t __imported_wasi_snapshot_preview1_fd_close(int32_t) { return kBadDescriptor; }

int32_t __imported_wasi_snapshot_preview1_fd_seek(int32_t, int64_t, int32_t, int32_t) {
  return kBadDescriptor;
}

int32_t __imported_wasi_snapshot_preview1_fd_write(int32_t, int32_t, int32_t, int32_t) {
  return kBadDescriptor;
}

[[noreturn]] void __imported_wasi_snapshot_preview1_proc_exit(int32_t) { __builtin_trap(); }

}  // extern "C"
