# shellcheck shell=bash
# ./box test --bench: the image in a virtual machine. Read by ./box.

# What looks at devices in the guest; the firmware; what a check runs on this machine.
readonly MACHINE_PACKAGES=(e2fsprogs evtest v4l-utils gpiod alsa-utils usbutils ovmf)
readonly WINDOW_PACKAGES=(xvfb qemu-system-gui)  # What draws for the guest.
readonly LONG_PACKAGES=(cpio zstd xz-utils gdisk)  # What the long mode's checks call.
readonly BENCH_KERNEL=out/image/kernel-bench/bzImage

# Runs checks of kaori-bench on the image, with simulated devices plugged in: run_checks OPTION...
run_checks() {
  tests/hil/bench_disk $BIN/kaori-hil-agent out/bench.disk
  $BIN/kaori-bench --image out/image --bench-disk out/bench.disk --report out/bench --figures out/boot.json --play "$PLAY" "$@" ||
    { say "the report is out/bench/report.html"; return 1; }
}

# A kernel with the box's settings and simulated hardware besides. Of its files only those that differ are compiled.
build_bench_kernel() {
  say "building the bench's kernel, where its settings are new"
  rootfs/image/kernel/build out/image/kernel --more rootfs/image/kernel/bench.config --into "$(dirname $BENCH_KERNEL)" ||
    fail "the bench's kernel could not be built; see $(dirname $BENCH_KERNEL)/build.log"
}

failed_checks=()

# Runs a command, says whether it passed, and goes on after a failure: run_check SENTENCE COMMAND...
run_check() {
  local began=$SECONDS
  say "checking: $1"
  if "${@:2}"; then
    say "passed: $1 ($((SECONDS - began)) s)"
  else
    say "failed: $1 ($((SECONDS - began)) s)"
    failed_checks+=("$1")
  fi
}

# One after another, since they share the processors. kaori-bench runs its checks with their negative controls; the others
# are programs of their own, with their controls in them.
run_all_checks() {
  local image=out/image packages=out/image/packages
  run_check "the checks of kaori-bench pass" run_checks --replugs 200 --bench-kernel $BENCH_KERNEL --controls
  run_check "the last face comes back with the power" tests/hil/last_face.py $image
  run_check "the box shows its face on every kind of screen" tests/hil/screens.py $image
  run_check "screens are plugged in and unplugged while the face plays" tests/hil/outputs.py $image
  run_check "input is sampled late, and no flip is missed" tests/hil/latency.py $image $packages $BENCH_KERNEL $BIN
  run_check "a slow stage is left alone, and one that hangs is not" tests/hil/watchdog.py $BIN "$PACK"
  run_check "two builds of the image are the same" tests/hil/reproducible.py $image $BIN
}

# --chosen: what runs each time.
test_on_the_bench() {
  [ $# -eq 0 ] || [ "$*" = --chosen ] || fail "test --bench takes --chosen; see ./box help"
  need "${MACHINE_PACKAGES[@]}"
  [ $# -gt 0 ] || need "${WINDOW_PACKAGES[@]}" "${LONG_PACKAGES[@]}"
  image
  build release kaori-bench kaori-hil-agent kaori-gadget kaori-lips kaori-camera-libcamera kaori-input-latency
  if [ $# -gt 0 ]; then
    say "running the chosen checks on the image in a virtual machine"
    run_checks --chosen --replugs 24 --scenes 2 || fail "the box failed on the bench"
    return
  fi
  build_bench_kernel
  run_all_checks
  [ ${#failed_checks[@]} -eq 0 ] || fail "failed: $(printf '%s; ' "${failed_checks[@]}")the reasons stand above"
}
