#!/usr/bin/env bash
# documented.sh FOLDER ONCARD: the command in docs/host-api.md builds a 32-bit host.
set -euo pipefail
folder=$1 oncard=$2
root=$(realpath "$(dirname "$0")/../../..")
mkdir -p "$folder"
cd "$folder"
rm -f host
ln -sfn "$root/build" build
cp "$root/tests/runtime/clients/sleeper.c" host.c
cp "$root/tests/runtime/clients/check.h" .
command=$(sed -n 's/^    \(gcc -m32 .*\)/\1/p' "$root/docs/host-api.md")
echo "$command"
sh -c "$command"
[ "$(od -An -tu1 -j4 -N1 host)" -eq 1 ] # a program of 32 bits
"$oncard" exec -- ./host 0 60 | grep 'card 62126 ms'
