#!/usr/bin/env bash
# start_wine.sh WINESERVER [ARGUMENTS]: makes the folder of Wine, and starts its server, which stays until
# end_wine.sh. One that ends by itself after its last program can refuse or end a program that begins at
# that moment. What Wine says is in a file of that folder: its services keep the streams that they are given.
set -euo pipefail
here=$(dirname "$0")
mkdir -p "$WINEPREFIX"
"$here/end_wine.sh" "$@"
{
  "$here/under_wine.sh" wineboot --init
  "$@" --wait
  "$@" --persistent
} >"$WINEPREFIX/start.log" 2>&1 </dev/null
