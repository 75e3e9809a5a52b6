#!/usr/bin/env bash
# imports.sh OBJDUMP LIBRARY: the library needs nothing that Windows does not have, and is no larger than
# 8 MB.
set -euo pipefail
imports=$("$1" -p "$2" | sed -n 's/.*DLL Name: //p' | sort | tr '\n' ' ')
if [ "$imports" != 'KERNEL32.dll msvcrt.dll ' ]; then
  echo "$2 imports $imports, expected KERNEL32.dll and msvcrt.dll alone" >&2
  exit 1
fi
size=$(stat -c %s "$2")
if [ "$size" -gt 8388608 ]; then
  echo "$2 has $size bytes, at most 8388608 are allowed" >&2
  exit 1
fi
