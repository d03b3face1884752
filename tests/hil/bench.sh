# shellcheck shell=bash
# ./box test --bench: the image in a virtual machine. Read by ./box.

# What looks at devices in the guest; the firmware; what a check runs on this machine.
readonly MACHINE_PACKAGES=(e2fsprogs dosfstools exfatprogs evtest v4l-utils gpiod alsa-utils usbutils ovmf curl)
readonly WINDOW_PACKAGES=(xvfb qemu-system-gui)  # What draws for the guest.
readonly LONG_PACKAGES=(cpio curl zstd xz-utils dosfstools mtools openssl efitools sbsigntool)  # What the long mode's checks call.
readonly BENCH_KERNEL=out/image/kernel-bench/bzImage
readonly PLAIN_SHOW=out/plain.kaori
readonly STICKS=out/sticks
readonly CHIP=out/chip

go_on=()  # --go-on: what has passed before is not tried again.

# Runs checks of kaori-bench on the image, with simulated devices plugged in: run_checks OPTION...
run_checks() {
  tests/hil/bench_disk $BIN/kaori-hil-agent out/bench.disk $PLAIN_SHOW
  $BIN/kaori-bench --image out/image --bench-disk out/bench.disk --report out/bench --figures out/boot.json --play "$PLAY" --sticks $STICKS "${go_on[@]}" "$@" ||
    { say "the report is out/bench/report.html"; return 1; }
}

# A kernel with the box's settings and simulated hardware besides. Of its files only those that differ are compiled.
build_bench_kernel() {
  say "building the bench's kernel, where its settings are new"
  rootfs/image/kernel/build out/image/kernel --more rootfs/image/kernel/bench.config --into "$(dirname $BENCH_KERNEL)" ||
    fail "the bench's kernel could not be built; see $(dirname $BENCH_KERNEL)/build.log"
}

# The show, but that its first scene is cheap to draw: a plain face, drawn flat, before two colours.
pack_plain_show() {
  local folder
  [ ! $PLAIN_SHOW -nt "$PACK" ] || return 0
  say "packing a plain show"
  folder=$(mktemp -d)
  cp -r appliance/shows/kaori "$folder/show"
  sed -i -e '0,/^face = .*/s//face = "mask"/; 0,/^style = .*/s//style = "flat"/' \
    -e '0,/^backdrop = .*/s//backdrop = { kind = "gradient", top = "#5a6c8c", bottom = "#2c3448" }/' "$folder/show/show.toml"
  $BIN/kaori-atelier pack "$folder/show" $PLAIN_SHOW >"$LOGS/plain.log" 2>&1 || fail "the plain show could not be packed; see $LOGS/plain.log"
  rm -r "$folder"
}

# Writes files onto an empty FAT32 of 64 MiB, which begins so many blocks of 512 bytes within the image: fill_stick BLOCKS IMAGE FILE...
fill_stick() {
  mkfs.vfat -F 32 -n STICK --offset "$1" "$2" 65536 >"$LOGS/sticks.log" && mcopy -i "$2@@$(($1 * 512))" "${@:3}" ::/ >>"$LOGS/sticks.log" 2>&1 ||
    fail "a stick could not be made; see $LOGS/sticks.log"
}

# A small show of one scene, signed: pack_small_show FOLDER NAME FACE
pack_small_show() {
  local show=$1/$2
  mkdir -p "$show"/{faces,looks}
  cp appliance/shows/kaori/expressions.toml "$show"
  cp appliance/shows/kaori/faces/{cast,kaori}.toml "$show/faces"
  cp appliance/shows/kaori/looks/kaori.toml "$show/looks"
  sed -i 's/^faces = .*/faces = ["kaori"]/' "$show/faces/cast.toml"
  printf '%s\n' "name = \"$2\"" '[[scene]]' 'name = "opening"' "face = \"$3\"" 'expression = "smile"' 'style = "flat"' \
    'light = 1.0' 'backdrop = { kind = "gradient", top = "#8c6c5a", bottom = "#48342c" }' >"$show/show.toml"
  [ "$3" = kaori ] || add_modelled_face "$show" "$3"
  $BIN/kaori-atelier pack "$show" "$show.kaori" --sign "$1/theatre" >"$LOGS/sticks.log" 2>&1 ||
    fail "the show of a stick could not be packed; see $LOGS/sticks.log"
}

# A head as it comes back from a modelling tool: that of the show, whose jaw somebody has made broader. add_modelled_face SHOW NAME
add_modelled_face() {
  local face=$1/faces/$2
  $BIN/kaori-atelier export appliance/shows/kaori "$face.from.obj" --face narrator >"$LOGS/sticks.log" 2>&1 ||
    fail "a face could not be exported; see $LOGS/sticks.log"
  awk '/^o / { ball = /eye/ } /^v / && !ball { $2 *= 1 + 0.11 * exp(-(($3 + 0.085) / 0.035) ^ 2) } 1' "$face.from.obj" >"$face.obj"
  rm "$face.from.obj"
  printf 'shape = "modelled"\nmesh = "%s.obj"\n' "$2" >"$face.toml"
  cp appliance/shows/kaori/looks/narrator.toml "$1/looks/$2.toml"
  sed -i "s/^faces = .*/faces = [\"kaori\", \"$2\"]/" "$1/faces/cast.toml"
}

# An update of the box: the image's own system again, which its box takes. None of an image that trusts no key of ours.
make_update_stick() {
  local key=out/keys/update-1.key
  if [ ! -f $key ] || ! grep -qrsF "$(cat $key.pub)" out/image/root/usr/share/kaori/update-keys; then return 0; fi
  build release kaori-bundle
  $BIN/kaori-bundle --image out/image --key $key --news "the same again" --to $STICKS/box.kaoriupdate >"$LOGS/sticks.log" 2>&1 &&
    mkfs.vfat -F 32 -n STICK -C $STICKS/update.stick 163840 >>"$LOGS/sticks.log" &&
    mcopy -i $STICKS/update.stick $STICKS/box.kaoriupdate ::/ >>"$LOGS/sticks.log" 2>&1 ||
    fail "the stick with an update could not be made; see $LOGS/sticks.log"
}

# Five sticks: a show of a theatre that the box does not know, with its key; the same of a show whose face came from a modelling tool, in
# a partition as sticks are sold; another show with some bytes changed; an empty one; and an update of the box.
make_sticks() {
  local folder
  say "making sticks"
  mkdir -p $STICKS
  rm -f $STICKS/*.stick $STICKS/box.kaoriupdate
  folder=$(mktemp -d)
  $BIN/kaori-atelier keygen "$folder/theatre" >"$LOGS/sticks.log" 2>&1 || fail "a key could not be made; see $LOGS/sticks.log"
  pack_small_show "$folder" evening kaori
  pack_small_show "$folder" guest guest
  pack_small_show "$folder" matinee kaori
  printf 'damaged' | dd of="$folder/matinee.kaori" bs=1 seek=$(($(stat -c %s "$folder/matinee.kaori") / 2)) conv=notrunc status=none
  truncate -s 64M $STICKS/{evening,damaged}.stick
  fill_stick 0 $STICKS/evening.stick "$folder/evening.kaori" "$folder/theatre.pub"
  fill_stick 0 $STICKS/damaged.stick "$folder/matinee.kaori"
  truncate -s 65M $STICKS/guest.stick
  # An entry of a partition table: FAT32 by its blocks (0c), from block 2048 on, 64 MiB.
  printf '\0\0\0\0\x0c\0\0\0\0\x08\0\0\0\0\x02\0' | dd of=$STICKS/guest.stick bs=1 seek=446 conv=notrunc status=none
  printf '\x55\xaa' | dd of=$STICKS/guest.stick bs=1 seek=510 conv=notrunc status=none
  fill_stick 2048 $STICKS/guest.stick "$folder/guest.kaori" "$folder/theatre.pub"
  make_update_stick
  truncate -s 64M $STICKS/empty.stick
  mkfs.vfat -F 32 -n STICK $STICKS/empty.stick >"$LOGS/sticks.log" || fail "a stick could not be made; see $LOGS/sticks.log"
  rm -r "$folder"
}

# The firmware as it ships, and the emulator of its chip. Without them the check of the chip is skipped, and says so.
bring_chip() {
  need "${FIRMWARE_PACKAGES[@]}"
  need_node
  say "bringing the chip's emulator, where it is new"
  python3 -B tests/firmware/chip.py . $CHIP bring >"$LOGS/chip.log" 2>&1 || say "without the chip's emulator; see $LOGS/chip.log"
}

# What ./box test measures of a company's own box, for a report that is whole by this run alone.
try_company() {
  python3 -B tests/system/company_test.py "$PWD/$BIN" "$PWD/$PACK" docs/guide/box.md out/company.json &&
    python3 -B tests/system/backup_test.py "$PWD/$BIN" "$PWD/$PACK" out/backup.json
}

failed_checks=()
effort=1  # Rounds of the checks that may have several.
release=()  # --release: the checks of a release alone, too.

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

# One after the other, since they share the processors. kaori-bench runs its checks with their negative controls; the other
# one has its control in it. Figures of a run before would stand for checks that this one never came to.
run_all_checks() {
  rm -f out/boot.json
  run_check "the checks of kaori-bench pass" run_checks --replugs 200 --effort $effort "${release[@]}" --bench-kernel $BENCH_KERNEL --chip $CHIP --controls
  run_check "two builds of the image are the same" tests/hil/reproducible.py out/image $BIN
  run_check "a box can be trusted (out/trust.json)" tests/hil/trust_report.py out/boot.json $BIN/test-desk out/trust.json
  run_check "updates can be trusted (out/update.json)" tests/hil/update_report.py out/boot.json $BIN/test-update out/image.json $STICKS/box.kaoriupdate out/update.json "${release[@]}"
  run_check "a company's show and backup on this machine (out/backup.json)" try_company
  run_check "a company has all of a box of its own (out/company.json)" tests/system/company_report.py out --whole
}

# What an image for another processor is tried by: its start, play, kills, cables and lines, and the same disk by UEFI.
readonly ARM64_CHECKS=face,stage-killed,play,dials,sticks,keys,camera,camera-pulled,lines,machine-dials,sound,pulled-box,replugs,crossed,input-killed,hung,kernel,uefi

# The image for 64-bit ARM in QEMU's machine virt, with the same simulated devices; figures for out/cross.json.
test_arm64_on_the_bench() {
  local bin=out/build/arm64/bin disk=out/bench-arm64.disk
  need "${MACHINE_PACKAGES[@]}" "${CROSS_TEST_PACKAGES[@]}"
  image --arch arm64
  build release kaori-bench
  build arm64 kaori-hil-agent kaori-lips kaori-camera-libcamera
  tests/hil/bench_disk $bin/kaori-hil-agent $disk '' "$SYSROOT"
  rm -f out/boot-arm64.json
  say "running checks on the image for arm64 in a virtual machine"
  $BIN/kaori-bench --arch arm64 --image out/image-arm64 --bench-disk $disk --report out/bench-arm64 --figures out/boot-arm64.json \
    --play "$PLAY" --box-draws --only $ARM64_CHECKS --replugs 24 --scenes 2 || fail "the box failed on the bench; the report is out/bench-arm64/report.html"
}

# --chosen: what runs each time. --release: cuts of the power as often as a release wants them, for hours.
test_on_the_bench() {
  if [ "$*" = "--arch arm64" ]; then test_arm64_on_the_bench; return; fi
  if [ "${*: -1}" = --go-on ]; then
    go_on=(--go-on)
    set -- "${@:1:$#-1}"
  fi
  [[ $# -eq 0 || $* =~ ^--(chosen|release)$ ]] || fail "test --bench takes --chosen, --go-on, --release or --arch arm64; see ./box help"
  if [ "$*" = --release ]; then
    effort=10
    release=(--release)
    shift
  fi
  need "${MACHINE_PACKAGES[@]}" "${WINDOW_PACKAGES[@]}"
  [ $# -gt 0 ] || need "${LONG_PACKAGES[@]}"
  image
  build release kaori-atelier kaori-bench kaori-hil-agent kaori-gadget kaori-lips kaori-camera-libcamera kaori-input-latency test-desk test-update
  if [ $# -gt 0 ]; then
    say "running the chosen checks on the image in a virtual machine"
    run_checks --chosen --replugs 24 --scenes 2 || fail "the box failed on the bench"
    return
  fi
  build_bench_kernel
  pack_plain_show
  make_sticks
  bring_chip
  run_all_checks
  [ ${#failed_checks[@]} -eq 0 ] || fail "failed: $(printf '%s; ' "${failed_checks[@]}")the reasons stand above"
}
