# shellcheck shell=bash
# ./box evening and soak. Read by ./box.

readonly EVENING=hw-sim/scenario/plays/evening.play

# Plays the running order; all that the programs say goes to a log: play_evening NAME OPTION...
play_evening() {
  local name=$1
  shift
  need "${BUILD_PACKAGES[@]}"
  build release kaori-evening kaori-show
  mkdir -p $LOGS
  say "playing $EVENING; what the programs say goes to $LOGS/$name.log"
  exec $BIN/kaori-evening --pack $PACK --order $EVENING --json "out/$name.json" "$@" 2>"$LOGS/$name.log"
}

evening() {
  local -a options=()
  while [ $# -gt 0 ]; do
    [[ $# -gt 1 && $1 =~ ^--(minutes|seed)$ && $2 =~ ^[0-9]{1,9}$ ]] ||
      fail "evening takes --minutes and --seed, each with a number, as in ./box evening --minutes 10"
    options+=("$1" "$2")
    shift 2
  done
  play_evening evening "${options[@]}"
}

soak() {
  local -a options=()
  while [ $# -gt 0 ]; do
    [[ $# -gt 1 && $1 =~ ^--(hours|seed)$ && $2 =~ ^[0-9]{1,6}$ ]] ||
      fail "soak takes --hours and --seed, each with a whole number, as in ./box soak --hours 24"
    options+=("$1" "$2")
    shift 2
  done
  [[ " ${options[*]} " == *" --hours "* ]] || fail "how long? ./box soak --hours 24 plays a day of evenings"
  play_evening soak "${options[@]}"
}
