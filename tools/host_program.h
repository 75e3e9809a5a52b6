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

/// The folders of libgts and the preload library; empty if they were not found. In an installation
/// the libraries are in a `lib`, and its folder `oncard` holds the preload library and links to
/// them: where `lib` is one of the system's, the programs that a host starts search it in their
/// own order.
struct LibraryFolders {
  /// 64-bit: beside the command, in ../lib, or in the folder `oncard` of ../lib or of the folder
  /// that Debian has there for each processor, as ../lib/x86_64-linux-gnu.
  std::string own;
  std::string of32bits;  ///< for 32-bit hosts: ../lib32 or its folder `oncard`
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
