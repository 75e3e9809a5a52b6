#!/usr/bin/env bash
# wine32.sh PROGRAM [ARGUMENTS]: the Wine of the 32-bit Debian in build/wine32, where in_wine32.sh shows
# the project at its own path; with wineserver as the program, its server.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")/build/wine32
wine=(wine)
if [ "$1" = wineserver ]; then wine=(); fi
exec chroot "$root" /bin/bash -c 'cd "$0" && exec "$@"' "$PWD" "${wine[@]}" "$@"
