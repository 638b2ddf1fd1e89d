#!/usr/bin/env bash
# Draws docs/pictures/*.png anew with the program itself. Says SKIPPED where a display cannot be had (Xvfb).
#   PRESET=debug scripts/pictures.sh       with the binaries of another preset
#   BUILD=folder scripts/pictures.sh       with those of a folder that is built already
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v xvfb-run > /dev/null; then
  echo "SKIPPED: pictures of the window need Xvfb (apt-get install xvfb)"
  exit 0
fi
if [[ -z "${BUILD:-}" ]]; then
  scripts/build.sh "${PRESET:-release}" >&2
  BUILD=build/${PRESET:-release}
fi
pictures=docs/pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pictures"

# window NAME [OPTION...] < script: plays the script in a window of 1400 x 900; it leaves $work/NAME.png.
window() {
  local name=$1
  shift
  sed "s|PICTURE|$work/$name.png|" > "$work/$name.txt"
  xvfb-run -a -s '-screen 0 1400x900x24' \
    "$BUILD/src/ui/planewright" --no-settings --size 1400x900 --script "$work/$name.txt" "$@"
  mv "$work/$name.png" "$pictures/$name.png"
  echo "$pictures/$name.png"
}

# panels NAME IN ACTION [OPTION...]: the planar panels of a mesh over its ghost.
panels() {
  local name=$1 input=$2 action=$3
  shift 3
  # Status 1: written, but with corners that are not well determined; nothing that a picture minds.
  "$BUILD/src/cli/planewright-cli" "$action" "$input" -o "$work/$name.obj" "$@" > /dev/null 2>&1 || (($? == 1))
  "$BUILD/src/cli/planewright-cli" render "$work/$name.obj" --ghost "$input" --width 1000 --height 640 \
    -o "$pictures/$name.png" > /dev/null
  echo "$pictures/$name.png"
}

window window-start assets/train-station.obj << 'SCRIPT'
wait_loaded 20
wait_solved 120
wait_frames 8
screenshot PICTURE
SCRIPT

# In the middle of a solve, so each run gives another moment of it.
window window-streaming << 'SCRIPT'
click Hint/close
sample train-station 4000
wait_loaded 20
click "Toolbar/colours Planarity"
drag "Design/weight fairing" 0.5
wait_iterates 6 120
expect solving == 1
wait_frames 2
screenshot PICTURE
SCRIPT

window window-dark assets/alpine-hut.obj --theme dark << 'SCRIPT'
click Hint/close
wait_loaded 20
wait_solved 120
click "Toolbar/colours Displacement"
wait_frames 8
screenshot PICTURE
SCRIPT

window window-findings assets/train-station.obj << 'SCRIPT'
click Hint/close
wait_loaded 20
wait_solved 120
click "Findings/finding 0"
wait_frames 12
expect selected_point >= 0
screenshot PICTURE
SCRIPT

panels station-panels assets/train-station.obj dual
panels twisted-roof-panels assets/twisted-roof.obj planarize
panels torus-panels assets/torus.obj dual
