// What the libraries of WebAssembly lack, or do otherwise than the command needs it.
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>

#include "tools/thrown.h"

// Its standard library declares streams of files, but has none; CLI11 has a function, which is
// never called, that reads one.
template class std::basic_filebuf<char>;
template class std::basic_ifstream<char>;

extern "C" {

// wasi-libc asks this first which folder a path is in. All paths go to the system as they are
// (web/cli/src/system.ts), in a folder whose descriptor is 3.
int __wasilibc_find_relpath_alloc(const char* path, const char** absolute, char** relative,
                                  size_t* size, int can_grow) {
  constexpr int kFolder = 3;
  const size_t needed = std::strlen(path) + 1;
  if (needed > *size) {
    auto* const larger =
        can_grow != 0 ? static_cast<char*>(std::realloc(*relative, needed)) : nullptr;
    if (larger == nullptr) return -1;
    *relative = larger;
    *size = needed;
  }
  *absolute = "/";
  std::memcpy(*relative, path, needed);
  return kFolder;
}

// There are no exceptions: what is thrown ends the command, after it has been reported.

void* __cxa_allocate_exception(size_t size) { return std::malloc(size); }

void __cxa_free_exception(void* thrown) { std::free(thrown); }

[[noreturn]] void __cxa_throw(void* thrown, void* /*type*/, void (* /*destructor*/)(void*)) {
  // Everything that is thrown here has std::exception as its first base class.
  std::exit(oncard::tools::ReportThrown(*static_cast<const std::exception*>(thrown)));
}

}  // extern "C"
