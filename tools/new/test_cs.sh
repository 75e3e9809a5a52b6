#!/bin/sh
# Compiles the host program, and runs all scenarios of the project as tests. GTS_CS is the file with the
# declarations of gts.dll, where it is not that of the package libgts-dev.
set -eu
cd "$(dirname "$0")"
mcs -out:@NAME@_host.exe @NAME@_host.cs "${GTS_CS:-/usr/include/Gts.cs}"
oncard test .
