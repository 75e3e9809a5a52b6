// The properties of a host program that `oncard exec` and `oncard test` need before they start the
// program, and where the libraries and headers for it are.
#pragma once

#include <string>

namespace oncard::tools {

/// True for a 32-bit program. `name` is found as execvp() finds it: a name without a slash in PATH.
/// False for any other file, scripts among them, and for none. Reads its first bytes.
bool IsProgramOf32Bits(const std::string& name);

/// What `oncard exec` loads into a host.
inline constexpr const char* kPreloadLibrary = "liboncard_host.so";

/// The folders of libgts and the preload library; empty if they were not found.
struct LibraryFolders {
  std::string own;       ///< 64-bit: beside the command, or in ../lib
  std::string of32bits;  ///< for 32-bit hosts: ../lib32
};

LibraryFolders FindLibraries();

/// The folders of `gts.h` and of the headers for hosts written for Windows, beside the folder of
/// the command; empty if they were not found.
struct HeaderFolders {
  std::string own;
  std::string compat;
};

HeaderFolders FindHeaders();

}  // namespace oncard::tools
