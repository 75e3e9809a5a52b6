#!/bin/sh
# Explores in parts with GNU parallel, on this machine or, with --sshloginfile, on several that share
# the current folder, and puts them together.
#
#   explore_parallel.sh INPUT PARTS [OPTIONS OF parallel]
#
# Each part is kept in NAME.I-of-PARTS.search in the current folder. Started again, it goes on with
# the parts that are not done. The exit code is that of the whole search.
set -eu

input=$1
parts=$2
shift 2
name=$(basename "${input%.*}")

# A part that finds a fault (1) or stops at its limits (6) is no reason to give up the others.
seq "$parts" | parallel --workdir . "$@" "oncard explore '$input' --shard {}/$parts >/dev/null" ||
  true

exec oncard explore --merge "$name".*-of-"$parts".search
