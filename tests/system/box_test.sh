#!/usr/bin/env bash
# ./box with wrong words: one clear line on what to do, and nothing is installed, built or started.
set -uo pipefail
readonly BOX=$1
REPOSITORY=$(dirname "$BOX")
readonly REPOSITORY
failures=0

expect() {  # expect "what the line says" arguments of box ...
  local wanted=$1 said status
  shift
  said=$(cd / && timeout 20 "$BOX" "$@" 2>&1 >/dev/null)
  status=$?
  if [ $status -eq 0 ] || [[ $(tail -n 1 <<<"$said") != "box: "*"$wanted"* ]]; then
    echo "box $*: ended with $status and said: $said"
    failures=$((failures + 1))
  fi
}

expect "there is no command dance" dance
expect "demo knows no --loud" demo --loud
expect "--record wants a value" demo --record
expect "name of a file is empty" demo --record ""
expect "--port wants a value" demo --port
expect "--listen wants a value" demo --listen
expect "expected an IPv4 address of this machine" demo --listen nowhere
expect "expected an IPv4 address of this machine" demo --listen 192.168.0.256
expect "pictures knows no --loud" pictures --loud
expect "fuzz takes --seconds and a number" fuzz --seconds
expect "fuzz takes --seconds and a number" fuzz --seconds soon
expect "fuzz takes --seconds and a number" fuzz 60
expect "--json wants the name of a file" bench --json
expect "test takes one PATTERN" test a b
expect "test knows no --loud" test --loud
expect "test --bench takes --chosen" test --bench --loud
expect "image knows no --loud" image --loud

"$BOX" help | grep -q -e '--service' || { echo "box help does not tell of the desk"; failures=$((failures + 1)); }
"$BOX" help | grep -q -e '--listen ADDRESS' || { echo "box help does not tell of --listen"; failures=$((failures + 1)); }
"$BOX" help | grep -q './box demo --record' || { echo "box help does not tell of films"; failures=$((failures + 1)); }

# What ./box fuzz starts are the targets that there are, each with the inputs that are kept for it.
targets=$(sed -n 's/^kaori_fuzz(\([a-z_]*\).*/\1/p' "$REPOSITORY/tests/fuzz/CMakeLists.txt" | sort)
kept=$(ls "$REPOSITORY/tests/fuzz/corpus" | sort)
[ -n "$targets" ] && [ "$targets" = "$kept" ] || { echo "fuzz targets: $targets; kept inputs: $kept"; failures=$((failures + 1)); }
grep -q 'fuzz/bin/fuzz-\*' "$REPOSITORY/tests/tests.sh" && grep -q 'add_custom_target(fuzzers' "$REPOSITORY/tests/fuzz/CMakeLists.txt" ||
  { echo "box fuzz builds or starts what does not exist"; failures=$((failures + 1)); }
exit $((failures > 0))
