#include <conio.h>
#include <windows.h>

#include "runtime/host/host_threads_windows.h"
#include "runtime/host/terminal.h"

namespace oncard::runtime {
namespace {

HANDLE Input() { return ::GetStdHandle(STD_INPUT_HANDLE); }

bool IsConsole() {
  DWORD mode = 0;
  return ::GetConsoleMode(Input(), &mode) != 0;
}

}  // namespace

bool TerminalHasKey() {
  if (IsConsole()) return ::_kbhit() != 0;
  DWORD available = 0;
  if (::PeekNamedPipe(Input(), nullptr, 0, nullptr, &available, nullptr) != 0) return available > 0;
  LARGE_INTEGER size{};
  LARGE_INTEGER place{};
  return ::GetFileSizeEx(Input(), &size) != 0 &&
         ::SetFilePointerEx(Input(), {}, &place, FILE_CURRENT) != 0 &&
         place.QuadPart < size.QuadPart;
}

int ReadTerminalKey() {
  const WaitsForOutside outside;
  if (IsConsole()) return ::_getch();
  unsigned char character = 0;
  DWORD count = 0;
  return ::ReadFile(Input(), &character, 1, &count, nullptr) != 0 && count == 1 ? character : -1;
}

}  // namespace oncard::runtime
