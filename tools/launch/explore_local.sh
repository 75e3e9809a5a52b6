#!/bin/sh
# Explores in parts, as many at a time as the machine has processors, and merges them.
#
#   explore_local.sh INPUT PARTS [OPTIONS OF oncard explore]
#
# Each part is kept in NAME.I-of-PARTS.search in the current folder. If started again, it continues
# the parts that are not complete. The exit code is that of the whole search.
set -eu

input=$1
parts=$2
shift 2
name=$(basename "${input%.*}")

seq "$parts" | xargs -P "$(nproc)" -I '{}' sh -c '
  part=$1 parts=$2 input=$3
  shift 3
  oncard explore "$input" --shard "$part/$parts" "$@" >/dev/null
  # If a part finds a fault (1) or stops at its limits (6), the others still continue.
  case $? in
    0 | 1 | 5 | 6) exit 0 ;;
    *) exit 255 ;;
  esac
' sh '{}' "$parts" "$input" "$@"

exec oncard explore --merge "$name".*-of-"$parts".search
