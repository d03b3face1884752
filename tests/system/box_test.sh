#!/usr/bin/env bash
# ./box with wrong words: one clear line on what to do, and nothing is installed, built or started.
set -uo pipefail
readonly BOX=$1
REPOSITORY=$(dirname "$BOX")
readonly REPOSITORY
failures=0

expect() {  # expect "what the line says" arguments of box ...
  local wanted=$1 said status
  shift
  said=$(cd / && timeout 20 "$BOX" "$@" 2>&1 >/dev/null)
  status=$?
  if [ $status -eq 0 ] || [[ $(tail -n 1 <<<"$said") != "box: "*"$wanted"* ]]; then
    echo "box $*: ended with $status and said: $said"
    failures=$((failures + 1))
  fi
}

expect "there is no command dance" dance
expect "demo knows no --loud" demo --loud
expect "--record wants a value" demo --record
expect "name of a file is empty" demo --record ""
expect "--port wants a value" demo --port
expect "--listen wants a value" demo --listen
expect "expected an IPv4 address of this machine" demo --listen nowhere
expect "expected an IPv4 address of this machine" demo --listen 192.168.0.256
expect "--pack wants a value" demo --pack
expect "there is no show log /nowhere" demo --evening /nowhere
expect "--evening wants --without" demo --evening /etc/passwd
expect "go with --evening" demo --at 19:43
expect "show wants new, play, take, key, pack" show
expect "show knows no dance" show dance
expect "show new takes the name of one FOLDER" show new
expect "exists already" show new /tmp
expect "letters, digits" show new "/tmp/my show"
expect "show pack takes a FOLDER" show pack
expect "is no folder of a show" show pack /nowhere
expect "show pack knows no --loud" show pack --loud
expect "--sign wants a KEYFILE" show pack /tmp --sign
expect "show key takes the name of one FILE" show key a b
expect "exists already; a key is never written over" show key /etc/passwd
expect "show sign takes one pack" show sign
expect "there is no show /nowhere" show sign /nowhere
expect "there is no key /nowhere" show sign /etc/passwd --key /nowhere
expect "is a folder" show sign /tmp
expect "show push takes a SHOW and the FOLDER" show push /tmp
expect "there is no folder /nowhere" show push /tmp /nowhere
expect "there is no key /nowhere" show push /tmp /tmp --key /nowhere
expect "there is no key /nowhere" image --trust /nowhere
expect "show play takes a FOLDER" show play
expect "show take wants record" show take
expect "check, info, sheet, import, export" show
expect "there is no show /nowhere" show play /nowhere
expect "there is no show /nowhere" demo --pack /nowhere
expect "there is no show /nowhere" image --pack /nowhere
expect "pictures knows no --loud" pictures --loud
expect "fuzz takes --seconds and a number" fuzz --seconds
expect "fuzz takes --seconds and a number" fuzz --seconds soon
expect "fuzz takes --seconds and a number" fuzz 60
expect "--json wants the name of a file" bench --json
expect "--before wants the name of a file" bench --before
expect "there is no such file" bench --before nowhere.json
expect "test takes one PATTERN" test a b
expect "test knows no --loud" test --loud
expect "test --bench takes --chosen" test --bench --loud
expect "image knows no --loud" image --loud
expect "format takes no words" format --loud
expect "build takes no words" build --loud
expect "clean takes no words" clean --loud
expect "sheet takes the name of one FOLDER" sheet --loud
expect "symbols takes the name of one REPORT" symbols --loud
expect "cross builds for arm64" cross
expect "cross builds for arm64" cross m68k
expect "cross knows no --loud" cross arm64 --loud
expect "test --arm64 takes nothing else" test --arm64 board

"$BOX" help | grep -q -e '--service' || { echo "box help does not tell of the desk"; failures=$((failures + 1)); }
"$BOX" help | grep -q -e '--listen ADDRESS' || { echo "box help does not tell of --listen"; failures=$((failures + 1)); }
"$BOX" help | grep -q './box demo --record' || { echo "box help does not tell of films"; failures=$((failures + 1)); }

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
# shellcheck disable=SC2046  # Names of files, without spaces.
(cd "$REPOSITORY" && cp --parents box $(sed -n 's/^source //p' box) "$copy")

# Every command of the page answers --help and -h with its own lines, and does nothing else. In a copy, of which nothing
# may be built, removed or made, with programs that end everything in place of those that install and build.
commands=$("$copy/box" help | sed -n 's/^  \.\/box \([a-z][a-z]*\).*/\1/p' | sort -u)
known=$(sed -n 's/^  \([a-z]*\)[ |)].*;;$/\1/p' "$copy/box" | sort -u)
[ -n "$commands" ] && [ "$commands" = "$known" ] || { echo "the page has the commands $commands; box knows $known"; failures=$((failures + 1)); }
mkdir "$copy/never"
printf '#!/bin/sh\nkill $PPID\n' | tee "$copy"/never/{dpkg-query,apt-get,cmake,ninja,rm,python3} >/dev/null
chmod +x "$copy"/never/*
before=$(find "$copy")
for command in $commands; do
  for words in --help -h '--loud --help'; do
    # shellcheck disable=SC2086  # Two words.
    said=$(PATH="$copy/never:$PATH" timeout 20 "$copy/box" "$command" $words 2>&1)
    status=$?
    if [ $status -ne 0 ] || [[ $said != "  ./box $command"* ]] || grep -v "^   " <<<"$said" | grep -qv "^  ./box $command\b"; then
      echo "box $command $words: ended with $status and said: $said"
      failures=$((failures + 1))
    fi
  done
done
[ "$(find "$copy")" = "$before" ] || { echo "a --help made something"; failures=$((failures + 1)); }
[[ $("$copy/box" test --help) == *"--bench [--chosen]"* ]] || { echo "box test --help lacks lines"; failures=$((failures + 1)); }

# A build that waits for another one says so, with programs that do nothing in place of those that build.
mkdir -p "$copy/bin" "$copy/out/build/release"
printf '#!/bin/sh\nshift 2\nfor p; do echo "installed $p"; done\n' >"$copy/bin/dpkg-query"
printf '#!/bin/sh\n' | tee "$copy/bin/apt-get" "$copy/bin/ninja" >"$copy/bin/cmake"
chmod +x "$copy"/bin/*
waits="another build of this folder is running"
said=$(PATH="$copy/bin:$PATH" timeout 20 "$copy/box" build 2>&1)
[[ $said == *"building (release)"* && $said != *"$waits"* ]] || { echo "box build, alone, said: $said"; failures=$((failures + 1)); }
said=$(PATH="$copy/bin:$PATH" flock "$copy/out/build/release/box.lock" timeout 2 "$copy/box" build 2>&1)
[[ $said == *"$waits"* ]] || { echo "box build beside another build said: $said"; failures=$((failures + 1)); }

# What a command needs is installed before anything is configured, OpenCV that came after the build was configured is found,
# and the build machine refuses warnings, in a folder too that was configured without. The programs in place of those that
# install and build write down what they are asked to do.
done=$copy/done
mkdir -p "$copy/out/build/release/bin"
for program in apt-get cmake ninja; do printf '#!/bin/sh\necho "%s $*" >>"%s"\n' $program "$done" >"$copy/bin/$program"; done
printf '#!/bin/sh\nexec "$@"\n' >"$copy/bin/sudo"
printf '#!/bin/sh\n' >"$copy/out/build/release/bin/kaori-benchmark"
chmod +x "$copy"/bin/* "$copy"/out/build/release/bin/*

does() {  # does "what is done, as a pattern over all of its lines" arguments of box ...
  : >"$done"
  PATH="$copy/bin:$PATH" timeout 20 "$copy/box" "${@:2}" >/dev/null 2>&1
  # shellcheck disable=SC2053  # A pattern.
  [[ $(<"$done") == $1 ]] || { echo "box ${*:2} did, where $1 was wanted: $(<"$done")"; failures=$((failures + 1)); }
}

printf '#!/bin/sh\nshift 2\nfor p; do case $p in *opencv*) ;; *) echo "installed $p" ;; esac; done\n' >"$copy/bin/dpkg-query"
does 'apt-get update*apt-get install*libopencv-core-dev*libopencv-imgproc-dev*cmake*ninja*' bench
printf '#!/bin/sh\nshift 2\nfor p; do echo "installed $p"; done\n' >"$copy/bin/dpkg-query"
touch "$copy/out/build/release/build.ninja"
CI='' does 'ninja*' bench
echo "OPENCV_CORE:FILEPATH=OPENCV_CORE-NOTFOUND" >"$copy/out/build/release/CMakeCache.txt"
does 'cmake*ninja*' bench
rm "$copy/out/build/release/build.ninja"
CI=yes does 'cmake*-D KAORI_WERROR=ON*ninja*' build
CI='' does 'cmake --preset release'$'\n''ninja*' build
touch "$copy/out/build/release/build.ninja"
echo "KAORI_WERROR:BOOL=OFF" >"$copy/out/build/release/CMakeCache.txt"
CI=yes does 'cmake*-D KAORI_WERROR=ON*ninja*' build
CI='' does 'ninja*' build
echo "KAORI_WERROR:BOOL=ON" >"$copy/out/build/release/CMakeCache.txt"
CI=yes does 'ninja*' build

# How far a build is stands in a line every ten seconds, and what is no progress is not lost. Each line here takes six.
said=$(bash -c "$(sed -n '/^show_progress()/,/^}/p' "$BOX")"'
  read() { builtin read "$@" && SECONDS=$((SECONDS + 6)); }
  show_progress' <<<$'ninja: Entering directory\n[1 of 4, 6s] a\n[2 of 4, 12s] b\na warning\n[3 of 4, 24s] c\n[4 of 4, 30s] d')
wanted=$'building: 1 of 4 steps\na warning\nbuilding: 3 of 4 steps'
[ "$said" = "$wanted" ] || { echo "the progress of a build was said as: $said"; failures=$((failures + 1)); }

# A build that is measured says the same, and the kernel's too; all of its words go to the log, and what it cost to the caller.
measured="$(sed -n '/^readonly NINJA_LINE/p; /^show_progress()/,/^}/p' "$BOX"; sed -n '/^timed()/,/^}/p' "$REPOSITORY/tests/tests.sh")"'
  read() { builtin read "$@" && SECONDS=$((SECONDS + 6)); }
  timed "it took %0lR" "$@"'
printf '#!/bin/sh\necho "[1 of 4, 6s] a\n${NINJA_STATUS%%%%%%*}2 of 4, 12s] b\na warning\n      7 of 70 objects of the kernel"\n' >"$copy/bin/measured"
chmod +x "$copy/bin/measured"
said=$(bash -c "$measured" measured "$copy/measured.log" "$copy/bin/measured" 2>&1 >"$copy/cost")
wanted=$'building: 2 of 4 steps\n      7 of 70 objects of the kernel'
[ "$said" = "$wanted" ] && [[ $(<"$copy/cost") == "it took 0m0"* && $(wc -l <"$copy/measured.log") -eq 4 ]] ||
  { echo "a measured build said: $said; $(<"$copy/cost")"; failures=$((failures + 1)); }

# What a stick holds is compared with what was written, the key beside the show too. cp spoils one of them in place of the stick.
mkdir "$copy/stick"
touch "$copy/evening.kaori" "$copy/company.key"
echo key >"$copy/company.key.pub"
printf '#!/bin/sh\n' >"$copy/out/build/release/bin/kaori-stage"
# What is drawn for keys goes into a copy.
printf '#!/bin/sh\n[ "$1" != keys ] || /bin/cp "$2" "$3"\n' >"$copy/out/build/release/bin/kaori-atelier"
chmod +x "$copy"/out/build/release/bin/*
for spoilt in nothing evening.kaori company.pub; do
  printf '#!/bin/sh\n/bin/cp "$@"\ncase $2 in */stick/%s) echo spoilt >>"$2" ;; esac\n' $spoilt >"$copy/bin/cp"
  chmod +x "$copy/bin/cp"
  said=$(PATH="$copy/bin:$PATH" timeout 20 "$copy/box" show push "$copy/evening.kaori" "$copy/stick" --key "$copy/company.key" 2>&1)
  [[ $spoilt = nothing && $said = *"is on the stick"* || $spoilt != nothing && $said = *"does not hold what was written"* ]] ||
    { echo "a push with $spoilt spoilt said: $said"; failures=$((failures + 1)); }
done
rm "$copy/bin/cp"

# What is no show is refused with its reason, and not with a log's name.
printf '#!/bin/sh\necho "evening.kaori is no show pack"; exit 1\n' >"$copy/out/build/release/bin/kaori-atelier"
said=$(PATH="$copy/bin:$PATH" timeout 20 "$copy/box" show push "$copy/evening.kaori" "$copy/stick" --key "$copy/company.key" 2>&1)
[[ $said = *"is no show pack"* ]] || { echo "a push of what is no show said: $said"; failures=$((failures + 1)); }

# A demo says who reaches its page. The programs that it starts only write the address and wait.
# shellcheck disable=SC2016  # For the program itself.
printf '#!/bin/sh\nwhile [ $# -gt 0 ]; do [ "$1" != --address-file ] || echo http://127.0.0.1:1/ >"$2"; shift; done\nexec sleep 60\n' |
  tee "$copy"/out/build/release/bin/kaori-{sim,input,lips,stage} >/dev/null
chmod +x "$copy"/out/build/release/bin/*

demo_says() {  # demo_says "a part of its last line" arguments of box demo ...
  local demo
  PATH="$copy/bin:$PATH" "$copy/box" demo "${@:2}" >"$copy/demo" 2>&1 &
  demo=$!
  for _ in $(seq 200); do
    if grep -qF "$1" "$copy/demo" || ! kill -0 $demo 2>/dev/null; then break; fi
    sleep 0.1
  done
  kill $demo
  wait $demo
  grep -qF "$1" "$copy/demo" || { echo "box demo ${*:2} said: $(<"$copy/demo")"; failures=$((failures + 1)); }
}

demo_says "Only this machine reaches it; --listen ADDRESS lets others in."
demo_says "WARNING: the page is served on 0.0.0.0. Whoever reaches this port sees the picture and plays the face" --listen 0.0.0.0

# An update is made of the image that the bench has tried, and of no other one unless that is asked for.
(cd "$REPOSITORY" && cp --parents rootfs/image/tested.py "$copy")
image=$copy/out/image
mkdir -p "$image"/{boot/EFI/Linux,root/usr/share/kaori/update-keys} "$copy"/out/{keys,bench}
for file in root.erofs root.verity boot/EFI/Linux/kaori-{a,b}.efi; do echo "$file" >"$image/$file"; done
echo "version 12" >"$image/root/usr/share/kaori/version"
touch "$copy/out/keys/update-1.key"
echo "a key" | tee "$copy/out/keys/update-1.key.pub" >"$image/root/usr/share/kaori/update-keys/1"
printf '#!/bin/sh\necho "bundle $*" >>"%s"\n' "$done" >"$copy/out/build/release/bin/kaori-bundle"
chmod +x "$copy/out/build/release/bin/kaori-bundle"

bundle() {  # bundle made|refused "a part of what is said" arguments of box bundle ...
  local said made=refused
  : >"$done"
  said=$(PATH="$copy/bin:$PATH" timeout 20 "$copy/box" bundle "${@:3}" 2>&1)
  ! grep -q '^bundle .*kaori-12.kaoriupdate' "$done" || made=made
  [[ $made = "$1" && $said = *"$2"* ]] || { echo "box bundle ${*:3} was $made and said: $said"; failures=$((failures + 1)); }
}

# What the bench writes of an image as it is now, with these checks of so many: reports CHECKS COUNT
reports() {
  local files
  files=$(cd "$image" && sha256sum root.* boot/EFI/Linux/* | sed 's/\(.*\)  \(.*\)/"\2": "\1"/' | paste -sd,)
  echo "{\"files\": {$files}, \"wanted\": $2, \"checks\": [$1]}" >"$copy/out/bench/report.json"
}

passed='{"name": "face", "passed": true, "skipped": false}, {"name": "chip", "passed": false, "skipped": true}'
bundle refused "the image in out/image was not tested; ./box test --bench does it"
bundle made "" --untested
reports "$passed" 2
bundle made "is the one that was tested: 1 checks have passed, 1 were skipped"
reports "$passed" 3
bundle refused "was not tried to the end: 1 checks are left"
reports "$passed, {\"name\": \"held\", \"passed\": false, \"skipped\": false}" 3
bundle refused "failed on the bench: held; no update is made of it but with --untested"
reports "$passed" 2
echo "another" >>"$image/boot/EFI/Linux/kaori-b.efi"
bundle refused "was not tested: the bench tried another boot/EFI/Linux/kaori-b.efi"
bundle made "" --untested --news "the same again"
echo "no report" >"$copy/out/bench/report.json"
bundle refused "was not tested"

# What ./box fuzz starts are the targets that there are, each with the inputs that are kept for it.
targets=$(sed -n 's/^kaori_fuzz(\([a-z_]*\).*/\1/p' "$REPOSITORY/tests/fuzz/CMakeLists.txt" | sort)
kept=$(ls "$REPOSITORY/tests/fuzz/corpus" | sort)
[ -n "$targets" ] && [ "$targets" = "$kept" ] || { echo "fuzz targets: $targets; kept inputs: $kept"; failures=$((failures + 1)); }
grep -q 'fuzz/bin/fuzz-\*' "$REPOSITORY/tests/tests.sh" && grep -q 'add_custom_target(fuzzers' "$REPOSITORY/tests/fuzz/CMakeLists.txt" ||
  { echo "box fuzz builds or starts what does not exist"; failures=$((failures + 1)); }
exit $((failures > 0))
