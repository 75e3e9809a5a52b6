#!/bin/sh
# Runs all scenarios of the project as tests.
set -eu
cd "$(dirname "$0")"
oncard test .
