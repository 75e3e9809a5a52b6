#!/usr/bin/env bash
# same.sh FOLDER SOURCE LIBRARY [OPTIONS OF ONCARD EXEC] -- [ARGUMENTS]: a host does the same on Windows
# as on Linux. It is compiled for both as its author would, against the headers of the build, and runs
# in a folder of its own under FOLDER, with a copy of the files beside SOURCE: under Linux with `oncard
# exec`, under Wine with the environment that stands for its options. Its output, the log and the
# record of its calls, which contains the hashes of the states of its cards, its traces, all other
# files that it leaves and its exit code must be identical.
#
# The environment names the builds: NATIVE for Linux, WINDOWS, and the compilers: MINGW, the first words
# of their names.
set -euo pipefail
folder=$1 source=$2 library=$3
shift 3
root=$(realpath "$(dirname "$0")/../..")
export LC_ALL=C ONCARD_LOG=calls:calls.txt ONCARD_RECORD=host.calls
exec_options=() environment=(ONCARD_CLOCK=virtual ONCARD_LANG=en ONCARD_REFUSALS=warn)
while [ "$1" != -- ]; do
  exec_options+=("$1")
  case $1 in
    --scenario=*) environment+=("ONCARD_SCENARIO=${1#*=}") ;;
    --keys=*) environment+=("ONCARD_KEYS=${1#*=}") ;;
    *) echo "same.sh: no variable of the environment stands for $1" >&2; exit 2 ;;
  esac
  shift
done
shift

# build HOME COMPILER OPTIONS: in a folder with the files of the source and a motion program.
build() {
  local home=$1
  rm -rf "$home"
  mkdir -p "$home"
  cp "$root/samples/01_sum/sum.c" "$home"
  find "$(dirname "$source")" -maxdepth 1 -type f -exec cp -t "$home" {} +
  local language=gcc standard=-std=gnu99
  case $source in *.cpp) language=g++ standard=-std=c++20 ;; esac
  # Doubles in 64 bits, as on Linux: the registers of the 32-bit processor have 80.
  "$2$language$3" "$standard" -O1 -msse2 -mfpmath=sse -I"$root/samples" -I"$root/tests/runtime/clients" "${@:4}" -lm \
    -o "$home/host.exe"
}

# run HOME COMMAND: runs it, and keeps what it says and how it ends.
run() {
  local home=$1
  (
    cd "$home"
    code=0
    "${@:2}" >out.raw 2>err.raw || code=$?
    echo "$code" >code.txt
    # Texts of Windows have other ends of lines, and a name of a file has a drive there.
    tr -d '\r' <out.raw >out.txt
    for record in *.calls; do
      [ -e "$record" ] || continue
      sed -i 's/"path": *"[^"]*[/\\]\([^"/\\]*\)"/"path": "\1"/g' "$record"
    done
    mv out.raw err.raw host.exe ..
  )
}

mkdir -p "$folder"
folder=$(realpath "$folder")
build "$folder/linux" "" "" -I"$NATIVE/include" -I"$NATIVE/include/compat" "$source" \
  "-L$NATIVE/lib" "-l$library" -pthread
build "$folder/windows" "$MINGW-" -posix -static -D__USE_MINGW_ANSI_STDIO=1 -I"$WINDOWS/include" \
  -I"$SPELLINGS" "$source" \
  "-L$WINDOWS/bin" "-l$library"
ONCARD_TRACE=trace.csv:trace.vcd run "$folder/linux" \
  "$NATIVE/bin/oncard" exec "${exec_options[@]}" -- ./host.exe "$@"
cp "$WINDOWS/bin/$library.dll" "$folder/windows"
run "$folder/windows" env "${environment[@]}" 'ONCARD_TRACE=trace.csv;trace.vcd' \
  "$(dirname "$0")/under_wine.sh" host.exe "$@"
rm "$folder/windows/$library.dll"
diff -r "$folder/linux" "$folder/windows"
