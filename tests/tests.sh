# shellcheck shell=bash
# ./box test, bench and fuzz. Read by ./box.

readonly TEST_PACKAGES=(python3 chromium dosfstools e2fsprogs ffmpeg mtools systemd clang-format clang-tidy shellcheck pyflakes3
  openssl efitools sbsigntool strace)
readonly BENCH_PACKAGES=(libopencv-core-dev libopencv-imgproc-dev)  # What the lips are compared with: ten seconds.
readonly FUZZ_PACKAGES=(clang-14 libclang-rt-14-dev)
readonly BUILD_COSTS=out/build_cpu.json

run_tests() {
  if [ "${1:-}" = --bench ]; then
    shift
    test_on_the_bench "$@"
    return
  fi
  if [ "${1:-}" = --release ]; then
    [[ $# -eq 1 || ($# -eq 2 && $2 == --go-on) ]] || fail "test --release takes --go-on; see ./box help"
    test_on_the_bench "$@"
    return
  fi
  if [ "${1:-}" = --arm64 ]; then
    [ $# -eq 1 ] || fail "test --arm64 takes nothing else; see ./box help"
    test_arm64
    return
  fi
  [[ ${1:-} != --* || $1 =~ ^--(sanitizers|tidy)$ ]] || fail "test knows no $1; see ./box help"
  [ $# -le 1 ] || fail "test takes one PATTERN; put it in quotes where it has spaces"
  need "${BUILD_PACKAGES[@]}" "${TEST_PACKAGES[@]}" "${FIRMWARE_PACKAGES[@]}" "${FIRMWARE_TEST_PACKAGES[@]}"
  need_node
  if [ "${1:-}" = --sanitizers ]; then
    for preset in asan tsan; do
      build $preset
      ctest --test-dir out/build/$preset --output-on-failure -j 2 -E 'Chromium|golden: |rules: ' ||
        fail "tests failed under the $preset preset; they are named above"
    done
    return
  fi
  build release
  if [ "${1:-}" = --tidy ]; then
    say "clang-tidy and its analyzer read every source; what did not change since is not read again"
    exec python3 -B tests/rules/tidy.py . $BUILD --analyze
  fi
  local match=()
  [ $# -gt 0 ] && match=(-R "$1")
  local results=$PWD/$BUILD/Testing/results.xml
  ctest --test-dir $BUILD --output-on-failure -j 2 --no-tests=error --output-junit "$results" "${match[@]}" ||
    fail "tests failed; they are named above"
  # A build machine has every tool: what it skips would be run by nobody.
  [ -z "${CI:-}" ] || python3 -B tests/skips.py "$results" || fail "tests were skipped that a build machine runs; they are named above"
  [ ${#match[@]} -eq 0 ] || return 0
  python3 -B tests/rules/report.py . $BUILD out/house.json
  python3 -B tests/system/company_report.py out || fail "out/company.json misses a bar; see above"
  python3 -B tests/appliance/show_report.py $BIN out/show.json || fail "out/show.json is not whole; see above"
  python3 -B tests/look/look_report.py $BIN out/look.json || fail "out/look.json is not whole, or misses a bar; see above"
}

# What bash's `time` says of the named command, whose words go to the log: timed TIMEFORMAT LOG COMMAND... How far ninja and the
# kernel are is said besides, on stderr, by programs whose own time does not count.
timed() {
  local TIMEFORMAT=$1 log=$2
  local -x NINJA_STATUS=$NINJA_LINE
  shift 2
  { time "$@" 2>&1; } 2>"$log.time" | tee -a "$log" | show_progress | sed -unE '/^(building:|     ) [0-9]+ of /p' >&2 ||
    fail "the measured build, or its tests, failed; see $log"
  cat "$log.time"
}

# The CPU seconds, user and system, of all that a command runs: cpu_seconds LOG COMMAND...
cpu_seconds() {
  timed '%U %S' "$@" | awk '{ print $1 + $2 }'
}

# Seconds from the touch of one source to the end of its tests: touched_seconds LOG FOLDER
touched_seconds() {
  touch appliance/core/performance/controls.cpp
  timed %R "$1" sh -c "ninja -C $2 test-performance && $2/bin/test-performance"
}

# Measures what builds cost from nothing, without the compiler cache, in a folder of their own, and keeps the figures in
# BUILD_COSTS. Takes a quarter of an hour or more.
measure_builds() {
  local folder=out/build/measured log=$LOGS/measured.log demo rest touched kernel
  need "${BUILD_PACKAGES[@]}" "${IMAGE_PACKAGES[@]}"
  local -x CCACHE_DISABLE=1
  rm -rf $folder
  mkdir -p $LOGS $folder/kernel
  : >$log
  say "building what ./box demo needs, from nothing (minutes)"
  demo=$(cpu_seconds $log sh -c "cmake --preset release -B $folder && ninja -C $folder demo")
  say "building the rest of what ./box test needs (minutes)"
  rest=$(cpu_seconds $log ninja -C $folder)
  say "building and running the tests of one touched source"
  touched=$(touched_seconds $log $folder)
  say "building the kernel (minutes)"
  kernel=$(cpu_seconds $log rootfs/image/kernel/build $folder/kernel)
  rm -rf $folder
  awk -v demo="$demo" -v rest="$rest" -v touched="$touched" -v kernel="$kernel" 'BEGIN {
    printf "{\"build_demo_cpu_s\": %.1f, \"build_test_cpu_s\": %.1f, \"build_touched_s\": %.1f, ", demo, demo + rest, touched
    printf "\"build_kernel_cpu_s\": %.1f}\n", kernel
  }' >$BUILD_COSTS
  cat $BUILD_COSTS
}

bench() {
  local -a options=()
  if [ "${1:-}" = --build ]; then
    [ $# = 1 ] || fail "bench --build takes nothing else; see ./box help"
    measure_builds
    return
  fi
  local json=$PWD/out/bench.json before=
  while [ $# -gt 0 ]; do
    [[ ! $1 =~ ^--(json|before)$ || $# -gt 1 ]] || fail "$1 wants the name of a file; see ./box help"
    case $1 in
      --json) json=$(from_caller "$2"); shift ;;
      --before)
        before=$(from_caller "$2")
        [ -f "$before" ] || fail "--before $2: there is no such file; ./box bench --json makes one of a build"
        shift ;;
      *) options+=("$1") ;;
    esac
    shift
  done
  need "${BUILD_PACKAGES[@]}" "${BENCH_PACKAGES[@]}"
  # OpenCV may have come after the build was configured, by another way than this run's `need`.
  # shellcheck disable=SC2034  # ./box reads it before it configures.
  ! grep -qs '^OPENCV_.*-NOTFOUND$' $BUILD/CMakeCache.txt || installed=yes  # Read by build.
  build release programs kaori-benchmark test-performance
  if [ -f $BUILD_COSTS ]; then
    say "figures of builds are those that ./box bench --build measured on $(date -r $BUILD_COSTS '+%F %R')"
    options+=(--builds "$BUILD_COSTS")
  fi
  rm -f "$json"
  local status=0
  $BIN/kaori-benchmark --pack $PACK --json "$json" "${options[@]}" || status=$?
  ! grep -qs '"frame.default.960x540.wall_ms"' "$json" || complete_look "$json" "$before"
  return $status
}

# Speed is a part of what the look is to have: out/look.json gets it of a benchmark's figures, and of those of a build before
# where there are any. complete_look FIGURES BEFORE
complete_look() {
  local -a before=()
  [ -z "$2" ] || before=(--before "$2")
  python3 -B tests/look/look_report.py $BIN out/look.json --bench "$1" "${before[@]}" || say "out/look.json is not whole, or misses a bar; see above"
}

fuzz() {
  local seconds=60
  if [ $# -gt 0 ]; then
    [[ $# = 2 && $1 == --seconds && $2 =~ ^[1-9][0-9]{0,5}$ ]] ||
      fail "fuzz takes --seconds and a number, as in ./box fuzz --seconds 60"
    seconds=$2
  fi
  need "${BUILD_PACKAGES[@]}" "${FUZZ_PACKAGES[@]}"
  build fuzz fuzzers
  local target name
  for target in out/build/fuzz/bin/fuzz-*; do
    name=$(basename "$target")
    say "fuzzing $name for $seconds s"
    mkdir -p "out/fuzz/$name"
    "$target" -max_total_time="$seconds" -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix="out/fuzz/$name-" \
      "out/fuzz/$name" "tests/fuzz/corpus/${name#fuzz-}" >"$LOGS/$name.log" 2>&1 ||
      fail "$name found a fault; the input lies in out/fuzz, the report in $LOGS/$name.log"
    grep -E 'number_of_executed_units|peak_rss' "$LOGS/$name.log" >&2
  done
}
