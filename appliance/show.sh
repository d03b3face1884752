# shellcheck shell=bash
# ./box show: a company's own show, from an empty folder to the screen. Read by ./box.

readonly DEFAULT_SHOW=appliance/shows/kaori
readonly SHOWS=out/shows  # Packs of folders that are played.

show() {
  local verb=${1:-}
  [ $# -eq 0 ] || shift
  case $verb in
    new) new_show "$@" ;;
    pack) pack_show "$@" ;;
    play) play_show "$@" ;;
    take) take_of_show "$@" ;;
    '') fail "show wants new, pack, play or take; see ./box help" ;;
    *) fail "show knows no $verb; see ./box help" ;;
  esac
}

# A folder that plays at once and can be changed piece by piece.
new_show() {
  [[ $# = 1 && ${1:-} != -* ]] || fail "show new takes the name of one FOLDER that does not exist yet; see ./box help"
  local folder name
  folder=$(from_caller "$1")
  name=$(basename "$folder")
  [ ! -e "$folder" ] || fail "$1 exists already; a new show wants a folder of its own"
  [[ $name =~ ^[A-Za-z0-9][A-Za-z0-9._-]*$ ]] || fail "$name: a show's folder is named with letters, digits, - _ and . only"
  mkdir -p "$(dirname "$folder")" && cp -r $DEFAULT_SHOW "$folder" || fail "$1 could not be made; the reason stands above"
  sed -i "0,/^name = .*/s//name = \"$name\"/" "$folder/show.toml"
  say "$1 holds a show of your own: the default show under the name $name. Change what you like, then: ./box show play $1"
}

pack_show() {
  local -a words=() sign=()
  while [ $# -gt 0 ]; do
    case $1 in
      --sign)
        [ $# -gt 1 ] || fail "--sign wants a KEYFILE; see ./box help"
        sign=(--sign "$(from_caller "$2")")
        shift
        ;;
      -*) fail "show pack knows no $1; see ./box help" ;;
      *) words+=("$(from_caller "$1")") ;;
    esac
    shift
  done
  [[ ${#words[@]} -ge 1 && ${#words[@]} -le 2 ]] || fail "show pack takes a FOLDER and a FILE; see ./box help"
  [ -d "${words[0]}" ] || fail "${words[0]} is no folder of a show; ./box show new FOLDER makes one"
  need "${BUILD_PACKAGES[@]}"
  build release kaori-atelier
  $BIN/kaori-atelier pack "${words[0]}" "${words[1]:-${words[0]%/}.kaori}" "${sign[@]}" ||
    fail "the show could not be packed; the reasons stand above"
}

# Names of files are the caller's, who may stand elsewhere.
take_of_show() {
  [[ $# -ge 1 ]] || fail "show take wants record, trim, stretch, gain, ease, loop, layer, punch or list; see kaori-atelier take --help"
  need "${BUILD_PACKAGES[@]}"
  build release kaori-atelier
  local tool=$PWD/$BIN/kaori-atelier
  cd "$CALLED_FROM" && exec "$tool" take "$@"
}

play_show() {
  [[ $# -ge 1 && $1 != -* ]] || fail "show play takes a FOLDER or a pack's FILE; see ./box help"
  demo --pack "$@"
}

# Before anything is built: is_show FOLDER_OR_FILE.
is_show() { [ -e "$1" ] || fail "there is no show $1; ./box show new FOLDER makes one"; }

# Sets `pack` to that of a folder, or to the file itself. A folder is packed where one of its files is newer than its pack.
choose_pack() {
  local given=$1
  pack=$given
  [ -d "$given" ] || return 0
  mkdir -p $SHOWS
  pack=$SHOWS/$(basename "$given")-$(cksum <<<"$given" | cut -d ' ' -f 1).kaori
  if [ ! -f "$pack" ] || [ $BIN/kaori-atelier -nt "$pack" ] || [ -n "$(find "$given" -newer "$pack" -print -quit)" ]; then
    $BIN/kaori-atelier pack "$given" "$pack" || fail "the show could not be packed; the reasons stand above"
  fi
}

# Sets `labels` to a file of what the show writes on the controls.
choose_labels() {
  mkdir -p $SHOWS
  labels=$SHOWS/$(basename "$pack" .kaori).labels.json
  $BIN/kaori-atelier labels "$pack" "$labels" || fail "$pack cannot be played; the reason stands above"
}
