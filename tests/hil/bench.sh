# ./box test --bench: the image in a virtual machine. Read by ./box.

readonly MACHINE_PACKAGES=(e2fsprogs evtest v4l-utils gpiod alsa-utils usbutils ovmf)  # What looks at devices in the machine.
readonly WINDOW_PACKAGES=(xvfb qemu-system-gui)  # What draws for it.
readonly BENCH_KERNEL=out/image/kernel-bench/bzImage

# The image, with simulated devices plugged in: play_on_the_bench OPTION...
play_on_the_bench() {
  tests/hil/bench_disk $BIN/kaori-hil-agent out/bench.disk
  $BIN/kaori-bench --image out/image --bench-disk out/bench.disk --report out/bench --figures out/boot.json --play $PLAY "$@" ||
    { say "the report is out/bench/report.html"; return 1; }
}

# A kernel with the box's settings, and devices that are not there. Of its files only those that differ are compiled.
build_bench_kernel() {
  say "building the bench's kernel, where its settings are new (minutes)"
  rootfs/image/kernel/build out/image/kernel --more rootfs/image/kernel/bench.config --into "$(dirname $BENCH_KERNEL)" ||
    fail "the bench's kernel could not be built; see $(dirname $BENCH_KERNEL)/build.log"
}

failed_proofs=()

# Goes on after a failure, and remembers it: prove SENTENCE COMMAND...
prove() {
  local began=$SECONDS
  say "$1"
  if "${@:2}"; then
    say "$1: so it is ($((SECONDS - began)) s)"
  else
    failed_proofs+=("$1")
  fi
}

# One by one: they share the processors.
prove_all() {
  local image=out/image packages=out/image/packages
  prove "devices are played, pulled and plugged" play_on_the_bench --replugs 200 --bench-kernel $BENCH_KERNEL
  prove "the face is there soon" tests/hil/boot.py $image
  prove "the last face comes back with the power" tests/hil/last_face.py $image
  prove "the last picture stays while the stage dies" tests/hil/hold.py $image $packages
  prove "the box takes whatever screens it finds" tests/hil/screens.py $image
  prove "screens come and go" tests/hil/outputs.py $image
  prove "hands are read late, and no flip is missed" tests/hil/latch.py $image $packages $BENCH_KERNEL $BIN
  prove "a box that hangs starts again" tests/hil/restart.py $image $packages
  prove "a stage that is slow is left alone, one that hangs is not" tests/hil/watchdog.py $BIN $PACK
  prove "a changed root is not played" tests/hil/verity.py $image
  prove "the disk starts on a PC with UEFI" tests/hil/uefi.py $image
  prove "two builds are the same" tests/hil/reproducible.py $image $BIN
}

# --chosen: what runs each time.
test_on_the_bench() {
  [ $# -eq 0 ] || [ "$*" = --chosen ] || fail "test --bench takes --chosen; see ./box help"
  need "${MACHINE_PACKAGES[@]}"
  image
  build release kaori-bench kaori-hil-agent kaori-gadget kaori-lips kaori-camera-libcamera kaori-latch
  if [ $# -gt 0 ]; then
    say "playing the image in a virtual machine"
    play_on_the_bench --chosen --replugs 24 --scenes 2 || fail "the box failed on the bench"
    return
  fi
  need "${WINDOW_PACKAGES[@]}"
  build_bench_kernel
  prove_all
  [ ${#failed_proofs[@]} -eq 0 ] || fail "not so: $(printf '%s; ' "${failed_proofs[@]}")see above"
}
