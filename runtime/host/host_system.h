// What a host library needs of the operating system about the process of its host: how it ends,
// where its program is, small writes. Thread-safe.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace oncard::runtime {

/// False for what can be no handle of an object of the system, nor NULL.
bool CanBeHandle(const void* handle);

/// What separates names of files in a variable of the environment.
extern const char kNameSeparator;

/// The folder of the host's program; empty if it is unknown.
std::string FolderOfProgram();

/// Adds a line to a file, in one piece, although other processes may do the same. False if that
/// fails.
bool AppendLine(const char* path, std::string_view line);

/// Writes to standard error, in one piece. Safe in a handler of a signal.
void WriteToStandardError(std::span<const std::string_view> parts);

/// Ends the process as exit() does.
[[noreturn]] void ExitHost(int code);
/// Ends the process at once. What the host has written is flushed.
[[noreturn]] void EndProcess(int code);
/// To be called while the process ends: with this code if its own is 0.
void ReplaceSuccess(int code);

}  // namespace oncard::runtime
