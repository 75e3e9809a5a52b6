#include "tools/terminal.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cstdio>
#include <cstdlib>
#include <initializer_list>

namespace oncard::tools {
namespace {

/// Newer than the headers' oldest Windows, which then ignores it.
constexpr DWORD kEscapeSequences = 0x0004;

UINT code_page_before = 0;

void PutCodePageBack() { ::SetConsoleOutputCP(code_page_before); }

}  // namespace

void PrepareStreams() {
  for (std::FILE* stream : {stdin, stdout, stderr}) ::_setmode(::_fileno(stream), _O_BINARY);
  for (const DWORD stream : {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) {
    const HANDLE console = ::GetStdHandle(stream);
    DWORD mode = 0;
    if (::GetConsoleMode(console, &mode) == 0) continue;  // a file or a pipe
    ::SetConsoleMode(console, mode | kEscapeSequences);
    if (code_page_before != 0) continue;
    // The console keeps it after the end of the command.
    code_page_before = ::GetConsoleOutputCP();
    ::SetConsoleOutputCP(CP_UTF8);
    std::atexit(PutCodePageBack);
  }
}

bool ErrorsGoToTerminal() {
  DWORD mode = 0;
  return ::GetConsoleMode(::GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

bool ErrorsHaveColors() {
  DWORD mode = 0;
  return ::GetConsoleMode(::GetStdHandle(STD_ERROR_HANDLE), &mode) != 0 &&
         (mode & kEscapeSequences) != 0;
}

}  // namespace oncard::tools
