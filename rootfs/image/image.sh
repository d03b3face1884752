# shellcheck shell=bash
# ./box image and boot: the appliance's image. Read by ./box.

readonly IMAGE_PACKAGES=(
  mmdebstrap erofs-utils e2fsprogs cryptsetup-bin gdisk dosfstools mtools zstd xz-utils python3 binutils
  linux-source-6.12 make gcc ccache flex bison bc libelf-dev libssl-dev lz4 patch)
readonly BOARD_PACKAGES=(meson ninja-build python3-mako dpkg-dev)  # By which Mesa for a board is built.
readonly KEYS_PACKAGES=(openssl efitools sbsigntool)
readonly SECURE_BOOT_KEYS=out/keys/secure-boot
readonly UPDATE_KEYS=$KEYS/update  # Of updates of the box: -1.key signs, -2.key waits for the day on which that is lost.
readonly LISTS_RENEWED=out/image/packages.asked
readonly BOOT_PACKAGES=(qemu-system-x86 python3)
readonly ARM64_BOOT_PACKAGES=(qemu-system-arm qemu-efi-aarch64)

# Lets apt ask its servers for newer versions: renew_lists [SUDO_OPTION]. Without a network, or where only root may and nobody
# is asked (sudo -n), what apt knows stays as it is, and that is said.
renew_lists() {
  local -a root=()
  [ "$(id -u)" = 0 ] || root=(sudo "$@")
  mkdir -p $LOGS
  if "${root[@]}" apt-get update -qq -o Acquire::Retries=0 -o Acquire::http::Timeout=20 >$LOGS/apt.log 2>&1; then
    mkdir -p "${LISTS_RENEWED%/*}"
    touch $LISTS_RENEWED
  else
    say "apt could not ask for newer packages (see $LOGS/apt.log); what it knew before counts"
  fi
}

# Names what of Debian an image carries in a version that apt has a newer one of, and ends with 1 where there is any.
name_stale() {
  local listed=$1.spdx.json
  [ -f "$listed" ] || fail "there is no $listed, in which an image's packages stand; ./box image makes it with the image"
  need python3
  renew_lists
  exec rootfs/image/stale.py --list "$listed"
}

# Makes the keys for PCs' Secure Boot, once: keys [FOLDER]
keys() {
  local folder=$SECURE_BOOT_KEYS
  [[ $# -le 1 && ${1:-} != -* ]] || fail "keys takes the name of one FOLDER; see ./box help"
  [ $# -eq 0 ] || folder=$(from_caller "$1")
  need python3 "${KEYS_PACKAGES[@]}"
  rootfs/image/secure_boot.py keys "$folder" || fail "no keys were made; the reason stands above"
  say "the keys are in $folder; whoever has those that end in .key can sign for your boxes, so keep them where nobody else comes"
}

# Makes both keys for updates of the box, once. An image trusts both, so that the second can follow on the first.
make_update_keys() {
  local number
  for number in 1 2; do
    [ ! -f "$UPDATE_KEYS-$number.key" ] || continue
    build release kaori-atelier
    mkdir -p "$KEYS"
    $BIN/kaori-atelier keygen "$UPDATE_KEYS-$number.key" >&2 || fail "the keys for updates could not be made"
    say "$UPDATE_KEYS-$number.key is new; whoever has it can change your boxes, so keep it where nobody else comes"
  done
}

# An update of the box, of an image that was built and tested: for a stick.
bundle() {
  local image=out/image key=$UPDATE_KEYS-1.key news='' from='' to='' version untested='' tested
  while [ $# -gt 0 ]; do
    if [ "$1" = --untested ]; then untested=yes; shift; continue; fi
    [[ $1 =~ ^--(image|key|news|from|to)$ ]] || fail "bundle knows no $1; see ./box help"
    [ $# -gt 1 ] || fail "$1 wants a value; see ./box help"
    case $1 in
      --news | --from) local "${1#--}=$2" ;;
      *) local "${1#--}=$(from_caller "$2")" ;;
    esac
    shift 2
  done
  [ -f "$image/root.erofs" ] || fail "there is no image in $image; ./box image builds one"
  [ -f "$key" ] || fail "there is no key $key, which signs; ./box image makes one and has the box trust it"
  grep -qrsF "$(cat "$key.pub")" "$image/root/usr/share/kaori/update-keys" ||
    fail "the image in $image does not trust the key $key: a box that had it would take no update any more"
  need "${BUILD_PACKAGES[@]}" python3
  if [ -z "$untested" ]; then
    tested=$(rootfs/image/tested.py "$image" out/bench/report.json out/bench-arm64/report.json) ||
      fail "$tested; no update is made of it but with --untested"
    say "$tested"
  fi
  build release kaori-bundle
  version=$(sed -n 's/^version //p' "$image/root/usr/share/kaori/version")
  say "packing the update as small as it can be (minutes)"
  $BIN/kaori-bundle --smallest --image "$image" --key "$key" --news "$news" --from "${from:-1}" --to "${to:-out/kaori-$version.kaoriupdate}" ||
    fail "no update was made; the reason stands above"
}

# Ends where a command is not for this processor: known_arch COMMAND ARCH
known_arch() {
  [[ $2 =~ ^(amd64|arm64)$ ]] || fail "$1 --arch takes amd64 or arm64, not $2"
}

# The folder with the image for a processor, by Debian's name of it.
image_folder() {
  [ "$1" = amd64 ] && echo out/image || echo "out/image-$1"
}

# Builds the programs of an image, and those that make it, where it names none: build_programs ARCH [BOARD]
build_programs() {
  if [ "$1" = amd64 ]; then build release programs kaori-bench; return; fi
  need "${CROSS_PACKAGES[@]}"
  make_sysroot
  build release kaori-atelier kaori-bench ${2:+kaori-rehearsal}
  build arm64 programs
}

# Ends where a board, its processor and the files by which it starts do not go together: need_firmware_of_board BOARD ARCH FOLDER
need_firmware_of_board() {
  [ -n "$1" ] || return 0
  local arch
  need python3
  arch=$(rootfs/image/boards.py "$1" arch) || exit 1
  [ "$2" = "$arch" ] || fail "image --board $1 wants --arch $arch"
  rootfs/image/boards.py "$1" firmware "$3" || exit 1
}

# shellcheck disable=SC2120  # ./box gives it its words.
image() {
  local arch=amd64 out='' programs='' disk='' pack='' firmware='' trust='' value stale='' option
  local medium='' graphics='' gpu_firmware='' secure_boot='' version='' board='' board_firmware='' tools=$BIN sysroot=''
  while [ $# -gt 0 ]; do
    if [ "$1" = --stale ]; then stale=yes; shift; continue; fi
    [[ $1 =~ ^--(arch|out|programs|disk|pack|firmware|trust|medium|graphics|gpu-firmware|secure-boot|version|board|board-firmware)$ ]] || fail "image knows no $1; see ./box help"
    [ $# -gt 1 ] || fail "$1 wants a value; see ./box help"
    value=$2
    [[ $1 =~ ^--(arch|disk|medium|graphics|version|board)$ ]] || value=$(from_caller "$2")
    option=${1#--}
    local "${option//-/_}=$value"
    shift 2
  done
  known_arch image "$arch"
  [ -n "$out" ] || out=$(image_folder "${board:-$arch}")
  if [ -n "$stale" ]; then
    [ -z "$programs$disk$pack$firmware$trust$medium$graphics$gpu_firmware$secure_boot$version$board_firmware" ] ||
      fail "image --stale looks at an image and builds none; it takes --arch, --board and --out alone"
    name_stale "$out"
  fi
  [[ $medium =~ ^(usb|disk)?$ ]] || fail "image --medium takes usb or disk, not $medium"
  [[ $graphics =~ ^(intel|amd|all)?$ ]] || fail "image --graphics takes intel, amd or all, not $graphics"
  [ "$arch" = amd64 ] || [ -z "$graphics$secure_boot" ] || fail "image --graphics and --secure-boot are for PCs, not for $arch"
  [ -z "$secure_boot" ] || [ -f "$secure_boot/db.key" ] || fail "there are no keys in $secure_boot; ./box keys makes them"
  [ -n "$board" ] || [ -z "$board_firmware" ] || fail "image --board-firmware wants --board: no other machine starts by such files"
  need_firmware_of_board "$board" "$arch" "$board_firmware"
  [ -z "$pack" ] || is_show "$pack"
  [ -n "$trust" ] || [ ! -f $COMPANY.pub ] || trust=$COMPANY.pub
  [ -z "$trust" ] || [ -f "$trust" ] || fail "there is no key $trust; ./box show key makes one"
  need "${BUILD_PACKAGES[@]}" "${IMAGE_PACKAGES[@]}" "${BOOT_PACKAGES[@]}"
  [ -z "$secure_boot" ] || need "${KEYS_PACKAGES[@]}"
  [ -z "$board" ] || need "${BOARD_PACKAGES[@]}"
  # Security updates reach an image by apt's lists; those of yesterday are renewed.
  [ -n "$(find $LISTS_RENEWED -mtime -1 2>/dev/null)" ] || renew_lists -n
  [ "$arch" = amd64 ] || need "${ARM64_BOOT_PACKAGES[@]}"
  [ -n "$programs" ] || build_programs "$arch" "$board"
  [ -z "$pack" ] || choose_pack "$pack"
  make_update_keys
  # An image for this machine's own processor is made by programs of its own build.
  if [ "$arch" = amd64 ]; then tools=${programs:-$BIN}; else sysroot=$SYSROOT; fi
  [ -n "$programs" ] || { [ "$arch" = amd64 ] && programs=$BIN || programs=out/build/$arch/bin; }
  rootfs/image/build --arch "$arch" --out "$out" --programs "$programs" --tools "$tools" --kept out/image ${sysroot:+--sysroot "$sysroot"} ${disk:+--disk "$disk"} \
    ${pack:+--pack "$pack"} ${firmware:+--firmware "$firmware"} ${trust:+--trust "$trust"} ${medium:+--medium "$medium"} \
    --update-key "$UPDATE_KEYS-1.key.pub" --update-key "$UPDATE_KEYS-2.key.pub" ${version:+--version "$version"} \
    ${graphics:+--graphics "$graphics"} ${gpu_firmware:+--gpu-firmware "$gpu_firmware"} ${secure_boot:+--secure-boot "$secure_boot"} \
    ${board:+--board "$board" --board-firmware "$board_firmware"} ||
    fail "the image could not be built; the reason stands above"
}

boot() {
  local -a options=()
  local folder='' arch=amd64
  while [ $# -gt 0 ]; do
    case $1 in
      --arch) arch=${2:-} ;;
      --image) folder=$(from_caller "${2:-}") ;;
      --shot) options+=(--shot "$(from_caller "${2:-}")") ;;
      --size | --memory) options+=("$1" "${2:-}") ;;
      --trace) options+=(--trace); shift; continue ;;
      *) fail "boot knows no $1; see ./box help" ;;
    esac
    [ $# -gt 1 ] || fail "$1 wants a value; see ./box help"
    shift 2
  done
  known_arch boot "$arch"
  [ -z "$folder" ] || [ -f "$folder/kaori.disk" ] || fail "there is no image in $folder"
  [ -n "$folder" ] || folder=$(image_folder "$arch")
  need "${BUILD_PACKAGES[@]}" "${BOOT_PACKAGES[@]}"
  [ "$arch" = amd64 ] || need "${ARM64_BOOT_PACKAGES[@]}"
  [ -f "$folder/kaori.disk" ] || image --arch "$arch"
  build release kaori-bench
  exec $BIN/kaori-bench --boot --arch "$arch" --size 960x540 --image "$folder" "${options[@]}"
}
