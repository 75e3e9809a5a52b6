#!/usr/bin/env bash
# command.sh WHAT FOLDER: oncard.exe, run by Wine, does what oncard does on this computer. Each runs in
# a folder of its own under FOLDER, with copies of the same files. The environment is that of same.sh.
set -euo pipefail
what=$1 home=$2
here=$(realpath "$(dirname "$0")")
samples=$(realpath "$here/../../samples")
export LC_ALL=C.UTF-8 ONCARD_LANG=en
rm -rf "$home"
mkdir -p "$home/native" "$home/windows"

on_native() { (cd "$home/native" && "$NATIVE/bin/oncard" "$@"); }
on_windows() { (cd "$home/windows" && "$here/under_wine.sh" "$WINDOWS/bin/oncard.exe" "$@"); }

fail() { printf '%s\n' "$@" >&2; exit 1; }

# same ARGUMENTS: both print the same on both streams and end with the same code.
same() {
  local code=0 other=0
  on_native "$@" >"$home/native.out" 2>"$home/native.err" || code=$?
  on_windows "$@" >"$home/windows.out" 2>"$home/windows.err" || other=$?
  [ "$code" = "$other" ] ||
    fail "oncard $*: exit code $other, expected $code" "$(cat "$home/windows.out" "$home/windows.err")"
  diff "$home/native.out" "$home/windows.out" >&2 || fail "oncard $*: standard output differs"
  diff "$home/native.err" "$home/windows.err" >&2 || fail "oncard $*: standard error differs"
}

# same_files: both folders hold the same files.
same_files() { diff -r "$home/native" "$home/windows" >&2 || fail "the files differ"; }

# says CODE TEXT ARGUMENTS: oncard.exe ends with this code, and says the text on standard error.
says() {
  local code=0
  on_windows "${@:3}" >"$home/windows.out" 2>"$home/windows.err" || code=$?
  [ "$code" = "$1" ] || fail "oncard ${*:3}: exit code $code, expected $1" "$(cat "$home/windows.err")"
  grep -qF -- "$2" "$home/windows.err" || fail "oncard ${*:3} does not say: $2" "$(cat "$home/windows.err")"
}

# copy FILE NAME: a file in both folders.
copy() {
  local at
  for at in "$home/native" "$home/windows"; do
    mkdir -p "$(dirname "$at/$2")"
    cp "$1" "$at/$2"
  done
}

case $what in
  samples)
    cp -r "$samples" "$home/native"
    cp -r "$samples" "$home/windows"
    mapfile -t scenarios < <(cd "$home/native" && ls samples/*/*.toml | grep -v '\.host\.toml$')
    [ "${#scenarios[@]}" -gt 30 ]
    same test "${scenarios[@]}" --format=json
    for scenario in "${scenarios[@]}"; do same run "$scenario" --format=json --trace=t.csv --record=r.schedule; done
    # Hosts are skipped.
    on_windows test samples >"$home/windows.out"
    grep -q ', 0 failed, ' "$home/windows.out" || fail "a sample failed" "$(cat "$home/windows.out")"
    grep -q '^skip samples/15_pvt/pvt.host.toml' "$home/windows.out" || fail "a host was not skipped"
    same_files
    ;;
  commands)
    copy "$samples/26_lost_update/sum.c" p.c
    copy "$samples/01_sum/sum.c" sum.c
    copy "$samples/33_bus_start/bus_start.host.toml" bus.host.toml
    same check p.c sum.c
    same check --diagnostics=sarif sum.c
    same build sum.c
    same dump sum.bin
    same verify sum.bin
    same run sum.bin --thread=0=add:begin=1,end=10 --show sum --steps --record=r.schedule --trace=t.vcd
    same replay r.schedule --format=json
    same explore p.c --save=f.schedule --report=r.html
    same explore p.c --engine=dpor --format=json
    same eni bus.host.toml -o Gecat.eni
    same explain MP027
    same schema
    same_files
    ;;
  names)
    # A source with the ends of lines and the encoding of Chinese Windows, in a folder with a space.
    printf 'int v; // \xB3\xCC\xD0\xF2\r\nint f()\r\n{\r\n  v = 7 // \xD6\xE1\r\n  return v;\r\n}\r\n' >"$home/crlf.c"
    copy "$home/crlf.c" '程序 1/轴.c'
    copy "$samples/01_sum/sum.c" '程序 1/和.c'
    copy "$samples/01_sum/one_thread.toml" '程序 1/场景.toml'
    sed -i 's/sum\.c/和.c/' "$home"/*/'程序 1/场景.toml'
    same check '程序 1/轴.c'
    same --lang=zh check '程序 1/轴.c'
    same build '程序 1/和.c' -o '程序 1'
    same run '程序 1/场景.toml' --show sum --trace='程序 1/值.csv'
    same test '程序 1'
    same test '程序 1/场景.toml' --program '程序 1/*.c'
    same explore '程序 1/和.c' --format=json
    same_files
    on_windows run '程序 1\场景.toml' --show sum >"$home/parted"
    on_windows run "Z:$home/windows/程序 1/场景.toml" --show sum >"$home/absolute"
    on_native run '程序 1/场景.toml' --show sum >"$home/expected"
    diff "$home/expected" "$home/parted" >&2 || fail "a name with \\ does something else"
    diff "$home/expected" "$home/absolute" >&2 || fail "an absolute name does something else"
    ;;
  mistakes)
    copy "$samples/01_sum/sum.c" sum.c
    mkdir "$home/native/folder" "$home/windows/folder"
    same run missing.c
    same --lang=zh run 没有.c
    same run folder
    same test missing.toml
    same test folder
    same test sum.toml --program 'none*.c'
    same build sum.c -o missing/folder
    same run sum.c --record=folder
    same frobnicate
    says 2 'put gts.dll beside the host' exec -- host.exe --with arguments
    says 2 'oncard serve' serve --port 1
    same_files
    ;;
  files)
    copy "$samples/01_sum/sum.c" sum.c
    # What a writer that was killed has left is removed; what another program calls so is not.
    touch "$home/windows/.oncard-0123456789abcdef.tmp" "$home/windows/.oncard-mine.tmp"
    on_windows build sum.c
    [ ! -e "$home/windows/.oncard-0123456789abcdef.tmp" ] || fail "what a killed writer left is still there"
    [ -e "$home/windows/.oncard-mine.tmp" ] || fail "the file of another program is gone"
    # A file that the user has made read-only stays.
    echo old >"$home/windows/sum.ini"
    chmod a-w "$home/windows/sum.ini"
    says 3 "cannot write 'sum.ini': Permission denied" build sum.c
    [ "$(cat "$home/windows/sum.ini")" = old ]
    [ "$(find "$home/windows" -type f | wc -l)" -eq 4 ]
    ;;
  isolated)
    # An endless test ends at its limit and harms no other.
    printf 'int n;\nint f()\n{\nlbl:\n  n = n + 1;\n  goto lbl;\n}\n' >"$home/endless.c"
    copy "$samples/01_sum/sum.c" good.c
    copy "$home/endless.c" endless.c
    printf 'program = "good.c"\nlimit_ms = 1000000000\nexpect = ["sum == 0"]\n[[thread]]\nthread = 0\nfunction = "add"\n' \
      >"$home/s.toml"
    copy "$home/s.toml" s.toml
    sed -i 's/f()/add()/; s/int n/int n, sum/' "$home"/*/endless.c
    same test s.toml --program '*.c' --timeout=1 --format=json
    grep -q 'longer than 1 s' "$home/windows.out"
    ;;
  *) fail "there is no test $what" ;;
esac
