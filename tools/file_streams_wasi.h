// Included before everything else: the standard library of WebAssembly hides its streams of files,
// which CLI11 names (system_wasi.cc).
#pragma once

#include <__config>

#undef _LIBCPP_HAS_NO_FILESYSTEM
