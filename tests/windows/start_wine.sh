#!/usr/bin/env bash
# start_wine.sh WINESERVER [ARGUMENTS]: makes the folder of Wine, and starts its server, which stays for a
# minute after its last program: one that ends sooner refuses a program that begins at that moment.
set -euo pipefail
mkdir -p "$WINEPREFIX"
"$@" --persistent=60 >/dev/null 2>&1 || [ $? -eq 2 ] # 2: one is there already
exec "$(dirname "$0")/under_wine.sh" wineboot --init
