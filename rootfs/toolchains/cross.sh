# shellcheck shell=bash
# ./box cross and ./box test --arm64: the box for 64-bit ARM, built with Debian's cross compiler. Read by ./box.

readonly CROSS_PACKAGES=(g++-aarch64-linux-gnu gcc-aarch64-linux-gnu binutils-aarch64-linux-gnu mmdebstrap)
readonly CROSS_TEST_PACKAGES=(qemu-user-static kas python3)
readonly LAYER_MODULES=(language-server-bitbake@2.10.0 web-tree-sitter@0.20.8)  # The grammar of recipes.
# What looks at devices in a machine on the bench: programs of that processor, from the same folder (tests/hil/bench_disk).
readonly GUEST_PACKAGES=(evtest v4l-utils gpiod alsa-utils usbutils coreutils)
# What Mesa for a board is built with, besides (rootfs/image/mesa/build).
readonly MESA_LIBRARIES=(libexpat1-dev libglvnd-dev)
readonly SYSROOT=out/cross/arm64/sysroot
readonly CROSS_RELEASE=bookworm

# The build packages that a compiler for another processor reads, and what their programs need to run. Programs that the build
# runs (-bin) are this machine's.
sysroot_packages() {
  { printf '%s\n' libc6-dev libstdc++-12-dev "${BUILD_PACKAGES[@]}" "${MESA_LIBRARIES[@]}" | grep -E '^lib|-dev$' | grep -v -- '-bin$'; printf '%s\n' "${GUEST_PACKAGES[@]}"; } | sort -u
}

# Runs a command whose words go to a log, and says every ten seconds that it still runs: wait_for WHAT LOG COMMAND...
wait_for() {
  local what=$1 log=$2 running waited=0
  shift 2
  "$@" >"$log" 2>&1 &
  running=$!
  while kill -0 $running 2>/dev/null; do
    sleep 1
    ((++waited % 10)) || printf '%s: %s s\n' "$what" $waited >&2
  done
  wait $running
}

# Links that begin with / mean the sysroot's own files.
mend_links() {
  local link
  while IFS= read -r link; do
    ln -sfnr "$1$(readlink "$link")" "$link"
  done < <(find "$1" -type l -lname '/*')
}

# Debian's build packages of arm64, unpacked and never installed: no script of theirs runs, and this machine's packages stay as
# they are. Made anew when the list changes. What they are is written down, for the list of what an image has compiled in.
make_sysroot() {
  local list stamp new=$SYSROOT.new
  local -a sources
  list=$(sysroot_packages | paste -sd,)
  stamp=$(sha256sum <<<"$list")
  [ "$(cat $SYSROOT.stamp 2>/dev/null)" != "$stamp" ] || return 0
  # shellcheck source=rootfs/debian.sh
  source rootfs/debian.sh
  mapfile -t sources < <(debian_sources $CROSS_RELEASE)
  [ ${#sources[@]} -gt 0 ] || fail "apt knows no sources of Debian's $CROSS_RELEASE; say apt-get update"
  say "fetching the build packages of arm64 (110 MB, minutes)"
  mkdir -p $LOGS
  rm -rf $SYSROOT $SYSROOT.stamp "$new" "$new.tar"
  mkdir -p "$new"
  wait_for fetching $LOGS/sysroot.log mmdebstrap --quiet --variant=extract --architectures=arm64 --include="$list" \
    --aptopt='APT::Install-Recommends false' --extract-hook=rootfs/image/keep_control $CROSS_RELEASE "$new.tar" "${sources[@]}" ||
    { tail -n 20 $LOGS/sysroot.log >&2; fail "the packages could not be fetched; see $LOGS/sysroot.log"; }
  tar -C "$new" --no-same-owner --exclude='./dev/*' --exclude=./usr/share/{doc,man,locale} -xf "$new.tar"
  rm "$new.tar"
  mend_links "$new"
  mv "$new" $SYSROOT
  echo "$stamp" >$SYSROOT.stamp
}

cross() {
  [ "${1:-}" = arm64 ] || fail "cross builds for arm64: ./box cross arm64; see ./box help"
  [[ $# -eq 1 || ( $# -eq 2 && $2 = --sysroot ) ]] || fail "cross knows no ${*:2}; see ./box help"
  need "${BUILD_PACKAGES[@]}" "${CROSS_PACKAGES[@]}"
  make_sysroot
  [ $# -eq 1 ] || { say "the sysroot is $SYSROOT"; return 0; }
  # What the build itself runs, kaori-atelier, is this machine's.
  build release kaori-atelier
  build arm64 programs kaori-bench kaori-gadget
  say "the programs lie in out/build/arm64/bin"
}

# What is not run in QEMU's user mode, by the names of tests: what reads the sources alone; what starts programs of its own, which the kernel
# would have to hand to QEMU (UsbProgram, AgentPrograms, the firmware's wrong builds); what is within umockdev, for which a program starts itself again
# (drivers-mock, and libusb of the contracts); golden pictures, whose last bits are a processor's; what draws hundreds of
# pictures, of which a processor that is emulated draws one in a second (how they are drawn is tested by passes, stage and captions); a time
# that is for a real processor (cue-lists); and of six tests what they look at: how posix_spawn fails, what is said beside a crash, how a
# fault ends a program, and the file of /proc/self/exe are QEMU's there.
readonly NOT_EMULATED='^(rules|gates|rootfs|system|files|boot|drivers-mock|golden)[:-]|^contracts:.*/Libusb| in Chromium$|^usb-policy:UsbProgram\.|^surface: builds that are wrong|^look:(Expressions|Garments|Hair|QualityTest)\.|^passes:Painter\.AllocatesNothing|^stage:StageTest\.TakesNothingFromTheHeap|^voice:.*SoundAndMouth\.|^scenario:LogPlayerTest\.ShowsWhatTheWhole|^drivers:RunProgram\.ThatAreMissing|^shows:Trial\.SaysWhatTheOther|^scenario:FilmTest\.WithoutFfmpeg|^bench:AgentPrograms\.|^cue-lists:ManyCues\.LoadWithin|^board:Healing\.LeavesOtherFaults|^crash:CrashReport\.(HoldsNoPath|OfAnOlderImage)'

test_arm64() {
  need "${BUILD_PACKAGES[@]}" "${CROSS_PACKAGES[@]}" "${CROSS_TEST_PACKAGES[@]}"
  need_node
  make_sysroot
  build release
  # Programs of tests start themselves again within umockdev, but where this is set (tests/drivers/hid_mock_main.cpp).
  export KAORI_IN_MOCK_KERNEL=no
  build arm64
  say "fetching the grammar of recipes"
  npm install --prefix out/cross --no-audit --no-fund --silent "${LAYER_MODULES[@]}" >$LOGS/npm.log 2>&1 ||
    fail "npm could not fetch it; see $LOGS/npm.log"
  local failed=0
  ctest --test-dir out/build/arm64 --output-on-failure -j 2 --no-tests=error -E "$NOT_EMULATED" \
    --output-junit "$PWD/out/cross/arm64/tests.xml" || failed=1
  python3 -B tests/rootfs/layer_test.py . out/build/release --grammar out/cross/node_modules || failed=1
  python3 -B tests/rootfs/cross_report.py . out/build/arm64 out/cross/arm64/tests.xml out/cross/node_modules out/cross.json || failed=1
  [ $failed -eq 0 ] || fail "what failed is named above; the figures are in out/cross.json"
}
