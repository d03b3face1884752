# ./box image and boot: the appliance's image. Read by ./box.

readonly IMAGE_PACKAGES=(
  mmdebstrap erofs-utils e2fsprogs cryptsetup-bin gdisk dosfstools mtools zstd xz-utils python3 binutils
  linux-source-6.12 make gcc ccache flex bison bc libelf-dev libssl-dev lz4)
readonly BOOT_PACKAGES=(qemu-system-x86 python3)

image() {
  local out=out/image programs= disk= value
  while [ $# -gt 0 ]; do
    [[ $1 =~ ^--(out|programs|disk)$ ]] || fail "image knows no $1; see ./box help"
    [ $# -gt 1 ] || fail "$1 wants a value; see ./box help"
    value=$2
    [ "$1" = --disk ] || value=$(from_caller "$2")
    local "${1#--}=$value"
    shift 2
  done
  need "${BUILD_PACKAGES[@]}" "${IMAGE_PACKAGES[@]}" "${BOOT_PACKAGES[@]}"
  [ -n "$programs" ] || build release programs
  rootfs/image/build --out "$out" --programs "${programs:-$BIN}" --kept out/image ${disk:+--disk "$disk"} ||
    fail "the image could not be built; the reason stands above"
}

boot() {
  local -a options=()
  local folder=out/image
  while [ $# -gt 0 ]; do
    if [[ $1 == --image && $# -gt 1 ]]; then
      folder=$(from_caller "$2")
      [ -f "$folder/kaori.disk" ] || fail "there is no image in $folder"
      shift 2
      continue
    fi
    options+=("$1")
    if [[ $1 == --shot && $# -gt 1 ]]; then
      options+=("$(from_caller "$2")")
      shift
    fi
    shift
  done
  need "${BOOT_PACKAGES[@]}"
  [ -f "$folder/kaori.disk" ] || image
  exec rootfs/image/boot.py "$folder" "${options[@]}"
}
