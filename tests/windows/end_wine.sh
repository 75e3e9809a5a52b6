#!/usr/bin/env bash
# end_wine.sh WINESERVER [ARGUMENTS]: ends the server that start_wine.sh has started.
set -euo pipefail
"$@" --kill >/dev/null 2>&1 || [ $? -eq 1 ] # 1: there is none any more
