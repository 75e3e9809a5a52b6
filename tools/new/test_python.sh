#!/bin/sh
# Runs all scenarios of the project, and what is written in Python, as tests.
set -eu
cd "$(dirname "$0")"
oncard test .
python3 -m pytest
