# shellcheck shell=bash
# ./box show: a company's own show, from an empty folder to the screen. Read by ./box.

readonly DEFAULT_SHOW=appliance/shows/kaori
readonly SHOWS=out/shows  # Packs of folders that are played.
readonly KEYS=out/keys    # The company's key, made here unless it is kept elsewhere.
readonly COMPANY=$KEYS/company.key

show() {
  local verb=${1:-}
  [ $# -eq 0 ] || shift
  case $verb in
    new) new_show "$@" ;;
    pack) pack_show "$@" ;;
    play) play_show "$@" ;;
    take) take_of_show "$@" ;;
    check | info | sheet | import | export) run_atelier "$verb" "$@" ;;
    key) make_key "$@" ;;
    sign) sign_show "$@" ;;
    push) push_show "$@" ;;
    backup | diff | restore) copy_of_box "$verb" "$@" ;;
    '') fail "show wants new, play, take, key, pack, sign, push, check, info, sheet, import, export, backup, diff or restore; see ./box help" ;;
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

# The show for a box, with pictures for decks with keys: add_keys PACK COPY
add_keys() {
  say "drawing what decks show on their keys"
  $BIN/kaori-atelier keys "$1" "$2" >"$LOGS/keys.log" 2>&1 ||
    { tail -n 3 "$LOGS/keys.log" >&2; fail "the pictures of keys could not be drawn; the reason stands above"; }
}

pack_show() {
  local -a words=() sign=()
  while [ $# -gt 0 ]; do
    case $1 in
      --sign)
        [ $# -gt 1 ] || fail "--sign wants a KEYFILE; see ./box help"
        sign=("$(from_caller "$2")")
        [ -f "${sign[0]}" ] || fail "there is no key $2; ./box show key makes one"
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
  local pack=${words[1]:-${words[0]%/}.kaori}
  $BIN/kaori-atelier pack "${words[0]}" "$pack" || fail "the show could not be packed; the reasons stand above"
  [ ${#sign[@]} -eq 0 ] || { add_keys "$pack" "$pack" && $BIN/kaori-atelier sign "$pack" "${sign[0]}"; } ||
    fail "the show could not be signed; the reason stands above"
}

take_of_show() {
  [[ $# -ge 1 ]] || fail "show take wants record, trim, stretch, gain, ease, loop, put, layer, punch or list; see ./box show take --help"
  run_atelier take "$@"
}

# What kaori-atelier does by itself. Names of files are the caller's, who may stand elsewhere.
run_atelier() {
  need "${BUILD_PACKAGES[@]}"
  build release kaori-atelier
  local tool=$PWD/$BIN/kaori-atelier
  cd "$CALLED_FROM" && exec "$tool" "$@"
}

# The company's key, which signs its shows: made once. The public half goes to the boxes.
make_key() {
  [[ $# -le 1 && ${1:-} != -* ]] || fail "show key takes the name of one FILE; see ./box help"
  local key=$COMPANY
  [ $# -eq 0 ] || key=$(from_caller "$1")
  [ ! -e "$key" ] || fail "$key exists already; a key is never written over, since boxes trust it"
  mkdir -p "$(dirname "$key")" || fail "the key could not be made; the reason stands above"
  need "${BUILD_PACKAGES[@]}"
  build release kaori-atelier
  $BIN/kaori-atelier keygen "$key" || fail "the key could not be made; the reason stands above"
}

# Takes --key FILE out of the words: sets `key` and `words`: read_key WORD...
read_key() {
  key=$COMPANY words=()
  while [ $# -gt 0 ]; do
    case $1 in
      --key)
        [ $# -gt 1 ] || fail "--key wants a FILE; see ./box help"
        key=$(from_caller "$2")
        shift
        ;;
      -*) fail "show knows no $1; see ./box help" ;;
      *) words+=("$(from_caller "$1")") ;;
    esac
    shift
  done
}

need_key() {
  [ -f "$1" ] || fail "there is no key $1; ./box show key makes one, once"
}

# A pack that is there already.
sign_show() {
  local key
  local -a words
  read_key "$@"
  [ ${#words[@]} -eq 1 ] || fail "show sign takes one pack's FILE; see ./box help"
  is_show "${words[0]}"
  [ ! -d "${words[0]}" ] || fail "${words[0]} is a folder; ./box show pack FOLDER --sign KEYFILE packs and signs it"
  need_key "$key"
  need "${BUILD_PACKAGES[@]}"
  build release kaori-atelier
  $BIN/kaori-atelier sign "${words[0]}" "$key" || fail "the show could not be signed; the reason stands above"
}

# Onto a stick, with the public key beside it: checked, signed, tried as a box tries it, and read back.
push_show() {
  local key name pack copy
  local -a words
  read_key "$@"
  [ ${#words[@]} -eq 2 ] || fail "show push takes a SHOW and the FOLDER of a stick; see ./box help"
  is_show "${words[0]}"
  [ -d "${words[1]}" ] || fail "there is no folder ${words[1]}; plug the stick in and name where it is mounted"
  need_key "$key"
  need "${BUILD_PACKAGES[@]}"
  build release kaori-atelier kaori-stage
  choose_pack "${words[0]}"
  name=$(basename "${words[0]%/}" .kaori)
  mkdir -p $SHOWS
  copy=$SHOWS/$name.signed.kaori
  add_keys "$pack" "$copy" && $BIN/kaori-atelier sign "$copy" "$key" || fail "the show could not be signed; the reason stands above"
  $BIN/kaori-stage --rehearse "$copy" || fail "a box would not play it; the reason stands above"
  cp "$copy" "${words[1]}/$name.kaori" && cp "$key.pub" "${words[1]}/$(basename "$key" .key).pub" && sync -f "${words[1]}" ||
    fail "the stick could not be written; the reason stands above"
  is_written "$copy" "${words[1]}/$name.kaori" && is_written "$key.pub" "${words[1]}/$(basename "$key" .key).pub" ||
    fail "${words[1]} does not hold what was written; take another stick"
  rm "$copy"
  say "$name is on the stick. At the box: key on, stick in, and GO takes it."
}

# Of a box whose disk is in this computer: copy_of_box backup DATA FOLDER, or diff and restore FILE DATA [--at-once].
copy_of_box() {
  local verb=$1 words=("${@:2}") data other at_once=''
  if [[ $verb = restore && ${words[-1]-} = --at-once ]]; then at_once=--at-once; unset 'words[-1]'; fi
  [[ ${#words[@]} = 2 && ${words[0]} != -* && ${words[1]} != -* ]] ||
    fail "show backup takes the data partition's folder and a FOLDER, diff and restore a FILE and that folder; see ./box help"
  if [ "$verb" = backup ]; then data=${words[0]} other=${words[1]}; else data=${words[1]} other=${words[0]}; fi
  data=$(from_caller "$data") other=$(from_caller "$other")
  [ -d "$data/shows" ] || fail "$data is no data partition of a box: it has no folder shows"
  build release kaori-shows kaori-stage
  $BIN/kaori-shows "--$verb" "$other" --shows "$data/shows" --keys "$data/settings/keys" --board "$data/none" --stage $BIN/kaori-stage $at_once
}

# Whether a file of a stick is what was written: is_written FILE COPY. Not what the kernel remembers of it: what is on the stick.
is_written() {
  dd if="$2" iflag=nocache count=0 status=none
  cmp -s "$1" "$2"
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

# Pictures of every face with every expression, of the show that is built here.
sheet() {
  local folder=$PWD/out/sheets
  [[ $# -le 1 && ${1:-} != -* ]] || fail "sheet takes the name of one FOLDER; see ./box help"
  [ $# -eq 0 ] || folder=$(from_caller "$1")
  need "${BUILD_PACKAGES[@]}"
  build release programs
  exec $BIN/kaori-atelier sheet $PACK "$folder"
}
