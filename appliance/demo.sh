# shellcheck shell=bash
# ./box demo: the programs of the box on this machine, with simulated devices and a screen in the browser. Read by ./box.

readonly PORT=8093
readonly DESK_PORT=8443
readonly SCREEN_HZ=60  # A frame that is late by a little waits for little; the page shows 30 of them.
readonly RUN=out/run

readonly RECORD_PACKAGES=(ffmpeg)

demo() {
  local port='' listen='' size=960x540 hz='' record='' play='' input='' value pack='' evening='' without='' at='' quality=''
  while [ $# -gt 0 ]; do
    if [ "$1" = --service ]; then
      in_service=yes
      shift
      continue
    fi
    [[ $1 =~ ^--(port|listen|size|hz|quality|record|play|input|pack|evening|without|at)$ ]] || fail "demo knows no $1; see ./box help"
    [ $# -gt 1 ] || fail "$1 wants a value; see ./box help"
    value=$2
    [[ ! $1 =~ ^--(record|play|input|pack|evening)$ ]] || value=$(from_caller "$2")
    local "${1#--}=$value"
    shift 2
  done
  [ -z "$listen" ] || is_address "$listen" ||
    fail "--listen $listen: expected an IPv4 address of this machine, such as 192.168.0.7, or 0.0.0.0 for all of them"
  [ -z "$pack" ] || is_show "$pack"
  [[ $quality =~ ^(auto|basic|fine|finest)?$ ]] || fail "--quality $quality: expected auto, basic, fine or finest"
  [ -z "$quality" ] || of_stage+=(--quality "$quality")
  choose_evening
  need "${BUILD_PACKAGES[@]}"
  [ -n "$record" ] && need "${RECORD_PACKAGES[@]}"
  build release demo ${record:+kaori-rehearsal} ${in_service:+kaori-desk} ${pack:+kaori-atelier}
  local labels=$LABELS
  if [ -n "$pack" ]; then
    choose_pack "$pack"
    choose_labels
  else
    pack=$PACK
  fi
  if [ -n "$record" ]; then
    exec $BIN/kaori-rehearsal --pack "$pack" --play "${play:-$PLAY}" --film "$record" --size "$size" --hz "${hz:-30}" "${of_stage[@]}"
  fi
  [ "$pack" = $PACK ] || say "playing the show $pack"
  local -a of_simulator=()
  [ -n "$play" ] && of_simulator+=(--play "$play")
  [ -n "$input" ] && of_simulator+=(--record "$input")
  run_programs "$port" "$listen" "$size" "${hz:-$SCREEN_HZ}" "${of_simulator[@]}"
}

# Minus one: sets what the stage is told of the evening that it plays again. The variables are those of demo.
choose_evening() {
  [ -n "$evening" ] || { [ -z "$without$at" ] || fail "--without and --at go with --evening; see ./box help"; return 0; }
  [ -f "$evening" ] || fail "there is no show log $evening"
  [ -n "$without" ] || fail "--evening wants --without and the role that is live, such as head"
  [ -z "$record" ] || fail "--evening is played live, and --record plays a scenario; kaori-rehearsal --log films an evening"
  of_stage+=(--evening "$evening" --without "$without" ${at:+--at "$at"})
}

# Whether some program listens on the port: in_use PORT [ADDRESS].
in_use() { (: <>"/dev/tcp/${2:-127.0.0.1}/$1") 2>/dev/null; }

# An IPv4 address as numbers, each up to 255.
is_address() {
  [[ $1 =~ ^([0-9]{1,3})\.([0-9]{1,3})\.([0-9]{1,3})\.([0-9]{1,3})$ ]] || return 1
  local part
  for part in "${BASH_REMATCH[@]:1}"; do [ $((10#$part)) -le 255 ] || return 1; done
}

# The port that was asked for; else the usual one, so that a page that is still open finds the next show; else any:
# choose_port PORT ADDRESS.
choose_port() {
  local port=$1 address=$2
  [ "$address" != 0.0.0.0 ] || address=127.0.0.1
  [[ -z $port || $port =~ ^[0-9]{1,5}$ && $((10#$port)) -le 65535 ]] || fail "--port $port: expected a number up to 65535"
  if [ -z "$port" ]; then
    if in_use $PORT "$address"; then echo 0; else echo $PORT; fi
  elif [ "$port" != 0 ] && in_use "$port" "$address"; then
    fail "port $port is in use by another program; choose another one with --port"
  else
    echo "$port"
  fi
}

of_stage=()  # What the stage is told besides: of its quality, and of an evening that it plays again.
in_service=  # Whether the lips can be calibrated.
declare -A playing=() started=()  # Process id -> program; program -> second of its start.

# Starts a program of the box, which ends with this script, however that ends: launch PROGRAM OPTION...
launch() {
  local program=$1
  local -a options=(--links "$RUN/links" "${@:2}")
  case $program in
    kaori-sim) options+=(--board "$RUN/board" --labels "$labels" --address-file "$RUN/address") ;;
    kaori-stage) options+=(--board "$RUN/board" --pack "$pack" "${of_stage[@]}") ;;
    kaori-lips) options+=(--board "$RUN/board" --pack "$pack") ;;
    kaori-desk) options=(--service --local --board "$RUN/board" --port "$desk_port" --data out/desk --address-file "$RUN/desk") ;;
    *) options+=(--board "$RUN/board") ;;
  esac
  [ "$program$in_service" != kaori-lipsyes ] || options+=(--service --settings out/desk/lips.settings)
  setpriv --pdeathsig TERM $BIN/"$program" "${options[@]}" >>"$LOGS/$program.log" 2>&1 &
  playing[$!]=$program
  started[$program]=$SECONDS
}

end_programs() {
  trap '' INT TERM HUP
  kill "${!playing[@]}" 2>/dev/null
  wait "${!playing[@]}" 2>/dev/null
}

# The simulator writes its address when the page can be opened; where it cannot start, its own log says why.
await_address() {
  local simulator=$1
  for _ in $(seq 200); do
    [ -s $RUN/address ] && return
    kill -0 "$simulator" 2>/dev/null || break
    sleep 0.05
  done
  fail "$(sed -n '$s/^kaori-sim: //p' $LOGS/kaori-sim.log) (see $LOGS/kaori-sim.log)"
}

tell_of_desk() {
  for _ in $(seq 100); do
    [ ! -s $RUN/desk ] || break
    sleep 0.05
  done
  [ -s $RUN/desk ] || fail "the desk does not start; see $LOGS/kaori-desk.log"
  say "The desk is at $(cat $RUN/desk) - its code is on the screen of the box; your browser will ask about its certificate."
}

# Starts again whatever ends. A scenario that has begun is not played, nor recorded, a second time.
watch_programs() {
  local of_simulator=("$@") program ended
  while true; do
    wait -n -p ended "${!playing[@]}" 2>/dev/null || true  # Bash would report the kill by itself.
    program=${playing[$ended]}
    unset "playing[$ended]"
    say "$program ended and is started again; see $LOGS/$program.log"
    [ $((SECONDS - started[$program])) -gt 1 ] || sleep 1
    if [ "$program" = kaori-sim ]; then launch kaori-sim "${of_simulator[@]}"; else launch "$program"; fi
  done
}

# What a person must know who lets the network in.
warn_of_network() {
  say "WARNING: the page is served on $1. Whoever reaches this port sees the picture and plays the face: it has no password."
}

# The programs of the box and the simulator, each a process of its own:
# run_programs PORT ADDRESS SIZE HZ SIMULATOR_OPTION...
run_programs() {
  local port address=$2 program simulator lock desk_port=$DESK_PORT
  ! in_use $DESK_PORT || desk_port=0
  mkdir -p $LOGS
  exec {lock}>out/demo.lock
  flock -n "$lock" || fail "a demo plays already at $(cat $RUN/address); end it with Ctrl-C first"
  port=$(choose_port "$1" "${address:-127.0.0.1}")
  rm -rf $RUN && mkdir -p $RUN/links
  rm -f $LOGS/kaori-*.log
  trap end_programs EXIT
  trap 'exit 0' INT TERM HUP
  launch kaori-sim --console "$port" ${address:+--listen "$address"} --size "$3" --hz "$4" "${@:5}"
  simulator=$!
  for program in kaori-input kaori-lips kaori-stage ${in_service:+kaori-desk}; do launch $program; done
  await_address $simulator
  port=$(sed 's/.*:\([0-9]*\).*/\1/' $RUN/address)  # A simulator that is started again keeps it.
  say "The show plays at $(cat $RUN/address) - open it in a browser. Ctrl-C ends it."
  case $address in
    '' | 127.*) say "Only this machine reaches it; --listen ADDRESS lets others in." ;;
    *) warn_of_network "$address" ;;
  esac
  [ -z "$in_service" ] || tell_of_desk
  watch_programs --console "$port" ${address:+--listen "$address"} --size "$3" --hz "$4"
}
