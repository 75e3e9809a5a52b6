#!/bin/sh
# Explores in parts with GNU parallel, on this machine or, with --sshloginfile, on several that
# share the current folder, and merges them.
#
#   explore_parallel.sh INPUT PARTS [OPTIONS OF parallel]
#
# Each part is kept in NAME.I-of-PARTS.search in the current folder. If started again, it continues
# the parts that are not complete. The exit code is that of the whole search.
set -eu

input=$1
parts=$2
shift 2
name=$(basename "${input%.*}")

# If a part finds a fault (1) or stops at its limits (6), the others still continue.
seq "$parts" | parallel --workdir . "$@" "oncard explore '$input' --shard {}/$parts >/dev/null" ||
  true

exec oncard explore --merge "$name".*-of-"$parts".search
