#!/usr/bin/env bash
# bad_input.sh WHAT FOLDER: what hosts for Windows are told of mistakes, and how they end. The environment
# is that of same.sh.
set -euo pipefail
what=$1 folder=$2
here=$(realpath "$(dirname "$0")")
root=$(realpath "$here/../..")
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
cp "$WINDOWS/bin/gts.dll" .

# host SOURCE: host.exe
host() {
  "$MINGW-gcc-posix" -std=gnu99 -I"$WINDOWS/include" -I"$root/tests/runtime/clients" -I"$root/samples" "$1" \
    "-L$WINDOWS/bin" -lgts -o host.exe
}

# expect CODE TEXT COMMAND: ends with this code, and says the text on standard error.
expect() {
  local code=0
  "${@:3}" >out.txt 2>err.txt || code=$?
  if [ "$code" != "$1" ] || ! grep -qF -- "$2" err.txt; then
    echo "exit code $code, expected $1; standard error, expected '$2':" >&2
    cat err.txt >&2
    exit 1
  fi
}

case $what in
  no_scenario)
    host "$root/tests/windows/open.c"
    expect 6 "missing.toml" env ONCARD_CLOCK=virtual ONCARD_LOG=calls ONCARD_SCENARIO=missing.toml \
      "$here/under_wine.sh" host.exe
    ;;
  one_record)
    # The second host is started by the first while its card is open.
    host "$root/tests/windows/open.c"
    expect 0 "another process is writing it" env ONCARD_CLOCK=virtual ONCARD_LOG=calls ONCARD_RECORD=host.calls \
      "$here/under_wine.sh" host.exe host.exe
    tail -1 host.calls | grep -q '"close":0'
    [ "$(grep -c '"open":0' host.calls)" -eq 1 ]
    ;;
  judged)
    # Only the exit code 0 becomes 120.
    host "$root/tests/windows/open.c"
    printf 'card = "GTS-800"\nexpect = ["axis1.prfPos == 1"]\n' >never.toml
    expect 120 "axis1.prfPos == 1" env ONCARD_CLOCK=virtual ONCARD_SCENARIO=never.toml "$here/under_wine.sh" host.exe
    expect 7 "axis1.prfPos == 1" env ONCARD_CLOCK=virtual ONCARD_SCENARIO=never.toml "$here/under_wine.sh" host.exe 7
    ;;
  other_bits)
    # Windows itself refuses a library for the other word length.
    host "$root/tests/windows/open.c"
    case $MINGW in x86_64*) other=i686-w64-mingw32 ;; *) other=x86_64-w64-mingw32 ;; esac
    echo 'short GT_Open(short a, short b) { return (short)(a + b); }' >gts.c
    "$other-gcc-posix" -shared gts.c -o gts.dll
    code=0
    env -u WINEPATH "$here/under_wine.sh" host.exe >out.txt 2>err.txt || code=$?
    [ "$code" -ne 0 ]
    ;;
esac
