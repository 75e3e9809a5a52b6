#!/usr/bin/env bash
# same.sh FOLDER ONCARD HOST32 HOST64 [ONCARD EXEC OPTIONS] -- [ARGUMENTS]: a host does the same in
# 32 bits and in 64. Each runs in its own folder under FOLDER, with a copy of the motion program
# sum.c; its output, the log of its calls, the trace of its card and the files that it leaves must
# be identical, and the exit code 0.
set -euo pipefail
folder=$1 oncard=$2 host32=$3 host64=$4
shift 4
options=()
while [ "$1" != -- ]; do options+=("$1"); shift; done
shift
export LC_ALL=C ONCARD_LOG=calls:calls.txt

# run BITS HOST ARGUMENTS
run() {
  local home=$folder/$1
  rm -rf "$home"
  mkdir -p "$home"
  cp "$(dirname "$0")/../../../samples/01_sum/sum.c" "$home"
  (
    cd "$home"
    code=0
    "$oncard" exec --trace trace.csv "${options[@]}" -- "${@:2}" >out.txt 2>err.txt || code=$?
    echo "$code" >code.txt
  )
}

run 32 "$host32" "$@"
run 64 "$host64" "$@"
diff -r "$folder/64" "$folder/32"
if [ "$(cat "$folder/32/code.txt")" != 0 ]; then
  cat "$folder/32/err.txt" >&2
  exit 1
fi
