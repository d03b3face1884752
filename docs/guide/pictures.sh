#!/usr/bin/env bash
# Makes the pictures of the guide again, with the tools it tells of: docs/guide/pictures.sh [BUILD_FOLDER]
# Needs a built tree, ffmpeg and chromium.
set -euo pipefail
cd "$(dirname "$0")/../.."
readonly BIN=${1:-out/build/release}/bin
readonly PACK=${1:-out/build/release}/shows/kaori.kaori
readonly HERE=docs/guide
WORK=$(mktemp -d)
readonly WORK
trap 'rm -rf "$WORK"' EXIT

# jpeg FROM NAME FILTERS: a picture of the guide.
jpeg() { ffmpeg -loglevel error -y -i "$1" -vf "$3" -frames:v 1 -q:v 4 "$HERE/pictures/$2.jpg"; }

# Stills of the play, numbered by its seconds.
still() { printf '%s/stills/%04d.png' "$WORK" "$1"; }

$BIN/kaori-atelier sheet "$PACK" "$WORK/sheets" >/dev/null
jpeg "$WORK/sheets/cast.png" cast scale=2000:-1
jpeg "$WORK/sheets/morphs.png" morphs scale=1200:-1
jpeg "$WORK/sheets/styles.png" styles 'crop=iw:ih*0.48:0:0,scale=1200:-1'
jpeg "$WORK/sheets/face-kaori.png" expressions 'crop=iw:ih*0.435:0:0,scale=1400:-1'

chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1400,860 --virtual-time-budget=4000 \
  --screenshot="$WORK/page.png" "file://$WORK/sheets/index.html" >/dev/null 2>&1
jpeg "$WORK/page.png" page scale=1200:-1

$BIN/kaori-rehearsal --pack "$PACK" --play $HERE/pictures.play --pictures "$WORK/stills" --hz 30 --size 960x540 2>/dev/null
jpeg "$(still 3)" needles crop=800:540:0:0
inputs=()
for second in 6 9 12 15 18 21 24 27 30; do inputs+=(-i "$(still $second)"); done
ffmpeg -loglevel error -y "${inputs[@]}" \
  -filter_complex "$(for i in 0 1 2 3 4 5 6 7 8; do printf '[%d]scale=480:-1[s%d];' $i $i; done)$(
    for i in 0 1 2 3 4 5 6 7 8; do printf '[s%d]' $i; done)xstack=inputs=9:layout=0_0|480_0|960_0|0_270|480_270|960_270|0_540|480_540|960_540" \
  -frames:v 1 -q:v 4 $HERE/pictures/scenes.jpg
du -sh $HERE/pictures
