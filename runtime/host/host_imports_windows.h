// The functions of Windows and of the C libraries that the host library replaces in its host
// (import_patches_windows.h), which is what `oncard exec` preloads under Linux: sleeps, clocks,
// waits and locks use virtual time, keys come from the script, and the end of the process is
// judged. docs/windows.md lists them for users.
//
// The calendar begins on 2026-01-01 00:00 UTC, the counters of ticks at 0. Tested by
// tests/windows/.
#pragma once

#include <span>

#include "runtime/host/import_patches_windows.h"

namespace oncard::runtime {

// For a host with any clock.

std::span<const Replacement> ProcessImports();
std::span<const Replacement> KeyImports();

// For a host with the virtual clock, and for one whose cards may interrupt it.

/// Sleeps and waits.
std::span<const Replacement> WaitImports();
/// New threads and modules.
std::span<const Replacement> LoaderImports();

// For a host with the virtual clock.

std::span<const Replacement> ClockImports();
std::span<const Replacement> LockImports();

}  // namespace oncard::runtime
