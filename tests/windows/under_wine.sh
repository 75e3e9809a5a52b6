#!/usr/bin/env bash
# under_wine.sh PROGRAM [ARGUMENTS]: runs a program for Windows, with the settings of Wine that all tests
# share: WINEPREFIX is in the build folder, and nothing is shown or said by Wine itself.
set -euo pipefail
export WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
unset DISPLAY
exec "${WINE:-/usr/lib/wine/wine64}" "$@"
