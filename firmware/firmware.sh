# shellcheck shell=bash
# ./box firmware. Read by ./box.

# The compiler for the chip; of its C++ library the headers alone.
readonly FIRMWARE_PACKAGES=(gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev cmake ninja-build python3)
readonly FIRMWARE_TEST_PACKAGES=(qemu-system-arm)
readonly FIRMWARE=out/firmware

build_firmware() {
  need "${FIRMWARE_PACKAGES[@]}"
  mkdir -p $LOGS
  cmake -S firmware/board -B $FIRMWARE/build -G Ninja >$LOGS/firmware.log 2>&1 || fail "see $LOGS/firmware.log"
  ninja --quiet -C $FIRMWARE/build >&2 || fail "the firmware could not be built; the first error stands above"
  python3 -B firmware/images.py $FIRMWARE/build $FIRMWARE
}

# prove_by_tests FIGURES EFFORT PATTERN
prove_by_tests() {
  KAORI_FIRMWARE_FIGURES=$1 KAORI_FIRMWARE_EFFORT=$2 \
    ctest --test-dir $BUILD --output-on-failure --no-tests=error --timeout 7200 -R "$3" || fail "a proof failed; it is named above"
}

# Of the USB machine, two million inputs and as many more as the effort says.
fuzz_firmware() {
  say "fuzzing the USB machine"
  build fuzz fuzz-usb_device
  mkdir -p out/fuzz/fuzz-usb_device
  out/build/fuzz/bin/fuzz-usb_device -runs=$((2100000 * $1)) -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix=out/fuzz/fuzz-usb_device- \
    out/fuzz/fuzz-usb_device tests/fuzz/corpus/usb_device >$LOGS/fuzz-usb_device.log 2>&1 ||
    fail "fuzz-usb_device found a fault; the input lies in out/fuzz, the report in $LOGS/fuzz-usb_device.log"
}

# The core's proofs on this machine take ten times the effort of those in emulated ones: a hundred million edges at least.
prove_firmware() {
  need "${BUILD_PACKAGES[@]}" "${TEST_PACKAGES[@]}" "${FIRMWARE_TEST_PACKAGES[@]}" "${FUZZ_PACKAGES[@]}"
  need_node
  build release test-surface test-surface-update test-decode test-input
  local figures=$PWD/$FIRMWARE/figures.txt
  mkdir -p $FIRMWARE
  : >"$figures"
  prove_by_tests "$figures" $((10 * $1)) '^surface:'
  prove_by_tests "$figures" "$1" '^(surface-update|chip):|^decode: ?(SerialDials|Quadrature)'
  fuzz_firmware "$1"
  tests/hil/firmware_report.py "$figures" $FIRMWARE/sizes.json out/boot.json $LOGS/fuzz-usb_device.log $BIN/test-input out/firmware.json
}

firmware() {
  case ${1:-} in
    '') build_firmware ;;
    --pins) [ $# = 1 ] || fail "--pins takes nothing else; see ./box help"
      need python3
      python3 -B firmware/images.py --pins ;;
    --prove)
      [[ $# = 1 || ($# = 3 && $2 == --effort && $3 =~ ^[1-9][0-9]{0,2}$) ]] ||
        fail "--prove takes --effort and a number; see ./box help"
      build_firmware
      prove_firmware "${3:-1}" ;;
    *) fail "firmware knows no $1; see ./box help" ;;
  esac
}
