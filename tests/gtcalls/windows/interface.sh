#!/bin/bash
# interface.sh WORD COMPILER FOLDER GENERATOR BUILD SOURCES: the interface of gts.dll for Windows in
# x64 or x86. A library of the generated entry points, with host_calls.cc in place of a card, exports
# plain names; the decoration that the generator computes is that of the compiler; hosts in C are linked
# with gts.lib, which llvm-dlltool makes, and with libgts.a, and run where Wine can run them.
set -eu
word=$1 compiler=$2 folder=$3 generator=$4 build=$5 sources=$6
here=$sources/tests/gtcalls/windows
cxx=$compiler-w64-mingw32-g++-posix
cc=$compiler-w64-mingw32-gcc-posix
declare -A machines=([x64]=i386:x86-64 [x86]=i386)
# Each Wine runs programs of its own word length only, but that for 64 bits alone does not say so.
declare -A wines=([x64]=/usr/lib/wine/wine64 [x86]=/usr/lib/wine/wine)

skip() { printf '%s: Skipped\n%s\n' "${0##*/}" "$*"; exit 77; }
fail() { echo "failed: $*"; exit 1; }

for tool in "$cxx" "$compiler-w64-mingw32-dlltool" llvm-dlltool-19; do
  command -v "$tool" >/dev/null ||
    skip "$tool is missing: install g++-mingw-w64-x86-64-posix, g++-mingw-w64-i686-posix and llvm-19"
done
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

# --- The library -----------------------------------------------------------------------------------

for part in entry-points multi-entry-points basic-entry-points multi-basic-entry-points; do
  "$generator" gts "$part" "$part.cc"
  "$cxx" -std=c++20 -O1 -I"$sources" -I"$build/include" -c "$part.cc" -o "$part.o"
done
"$cxx" -std=c++20 -O1 -I"$sources" -c "$here/host_calls.cc" -o host_calls.o

# The names of functions in the objects, without the underscore of 32 bits.
defined() { "$compiler-w64-mingw32-nm" "$@" | grep -o ' T _\?\(Basic\)\?\(GT[MX]\?_\|GetMac\).*' | sed 's/ T _\?//'; }
# The names to the right of `=` in a module definition, or the only ones.
functions() { sed -n 's/^  \(.* = \)\?//p' "$1" | sort -u; }

"$generator" gts "exports-$word" single.def
"$generator" gts "multi-exports-$word" multi.def
defined ./*.o | sort >defined.txt
{ functions single.def; functions multi.def; } | sort -u >exported.txt
diff exported.txt defined.txt || fail "the compiler names functions otherwise than the generator"

# --- Hosts -----------------------------------------------------------------------------------------

wine=${wines[$word]}
[ -x "$wine" ] || echo "hosts are linked, but not run: $wine is missing"
run() {
  if [ -x "$wine" ]; then
    env -u DISPLAY WINEPREFIX="$folder/wine" WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=' \
      "$wine" "$1" || fail "$1 ended with $?"
  fi
}

for kind in single multi; do
  flags=()
  if [ "$kind" = multi ]; then flags=(-DSEVERAL_CARDS); fi
  mkdir "$kind"
  "$cxx" -shared -static -s ./*.o "$kind.def" -Wl,--kill-at -o "$kind/gts.dll"
  llvm-dlltool-19 -m "${machines[$word]}" -k -d "$kind.def" -l "$kind/gts.lib"
  "$compiler-w64-mingw32-dlltool" -k -d "$kind.def" -l "$kind/libgts.a"
  "$compiler-w64-mingw32-objdump" -p "$kind/gts.dll" | sed -n '/Ordinal\/Name/,$p' |
    grep -o '\(GT[MX]\?_\|GetMac\).*' | sort >"$kind/names.txt"
  sed -n 's/^  \([A-Za-z0-9_]*\).*/\1/p' "$kind.def" | sort | diff - "$kind/names.txt" ||
    fail "the names of $kind/gts.dll are decorated, or some are missing"
  for host in host declarations; do
    for library in gts.lib libgts.a; do
      program=$kind/$host-$library.exe
      "$cc" -std=c99 -Wall -Wextra -Werror "${flags[@]}" -I"$build/include" "$here/$host.c" \
        "$kind/$library" -o "$program"
      "$compiler-w64-mingw32-objdump" -p "$program" | sed -n '/DLL Name: gts.dll/,/^$/p' |
        grep -q 'GT_.*@' && fail "$program looks for decorated names"
      run "$program"
    done
  done
done
