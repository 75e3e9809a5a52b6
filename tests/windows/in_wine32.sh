#!/usr/bin/env bash
# in_wine32.sh COMMAND: runs a command for which wine32.sh works. To be called in the project's folder by
# root, in a mount namespace of its own (unshare --mount), with which the mounts end.
set -euo pipefail
root=$PWD/build/wine32
mkdir -p "$root$PWD"
mount --bind "$PWD" "$root$PWD"
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
exec "$@"
