# shellcheck shell=bash
# ./box pictures: makes the pictures of the docs anew. Read by ./box; docs/pictures.py knows what each of them shows.

readonly PICTURES_PACKAGES=(ffmpeg chromium python3 fonts-noto-cjk)

pictures() {
  local -a options=()
  while [ $# -gt 0 ]; do
    [ "$1" = --all ] || fail "pictures knows no $1; see ./box help"
    options+=(--all)
    shift
  done
  need "${BUILD_PACKAGES[@]}" "${PICTURES_PACKAGES[@]}"
  need_node
  build release programs desk-harness
  exec docs/pictures.py make "${options[@]}" --build "$BUILD"
}
