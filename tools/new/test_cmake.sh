#!/bin/sh
# Builds the host program, and runs all scenarios of the project as tests.
set -eu
cd "$(dirname "$0")"
cmake -B build
cmake --build build
oncard test .
