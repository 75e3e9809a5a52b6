#!/usr/bin/env bash
# states.sh ONCARD STATES SCENARIO...: every run ends in the same state in 32 bits, where STATES
# (states.cc) runs the scenarios, and in 64 bits, where ONCARD does.
set -euo pipefail
oncard=$1 states=$2
shift 2

in_64_bits() {
  local scenario policy hashes
  for scenario in "$@"; do
    for policy in rr random:7 pct:7:3; do
      # A scenario whose expectations fail also has hashes.
      hashes=$("$oncard" run "$scenario" --schedule "$policy" --format json 2>/dev/null |
        sed -n 's/.*"\(program\|state\)_hash": "\([0-9a-f]*\)".*/\2/p') || true
      echo "$scenario $policy" ${hashes:-refused}
    done
  done
}

in_64_bits "$@" >states.64
"$states" "$@" >states.32
diff states.64 states.32
# Most scenarios are single runs.
[ "$(grep -vc refused states.32)" -gt $# ]
