#!/usr/bin/env bash
# Draws docs/pictures/*.png anew with the program itself.
#   scripts/pictures.sh                    all of them
#   scripts/pictures.sh figure-2 preset-close    those alone (docs/gallery.md shows them with their names)
#   PRESET=debug scripts/pictures.sh       with the binaries of another preset
#   BUILD=folder scripts/pictures.sh       with those of a folder that is built already
# Says SKIPPED for pictures of the window where a display cannot be had (Xvfb).
set -euo pipefail
cd "$(dirname "$0")/.."

names=(window-start window-streaming window-dark window-findings window-suggestions window-clusters window-workshop window-export
  station-panels twisted-roof-panels torus-panels
  figure-2 figure-5 figure-6 figure-7 figure-8
  preset-close-to-design preset-even-panels preset-smooth-shell preset-faceted-shell preset-close preset-uncrossed
  presets-figure-5)
(($# == 0)) || for name in "$@"; do
  if [[ " ${names[*]} " != *" $name "* ]]; then
    echo "There is no picture $name. Known: ${names[*]}" >&2
    exit 2
  fi
done
if [[ -z "${BUILD:-}" ]]; then
  scripts/build.sh "${PRESET:-release}" >&2
  BUILD=build/${PRESET:-release}
fi
pictures=docs/pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pictures"
cli="$BUILD/src/cli/planewright-cli"

# window NAME [OPTION...] < script: plays the script in a window of 1400 x 900; it leaves $work/NAME.png.
window() {
  local name=$1
  shift
  if ! command -v xvfb-run > /dev/null; then
    echo "SKIPPED: $name needs Xvfb (apt-get install xvfb)"
    return
  fi
  sed "s|PICTURE|$work/$name.png|" > "$work/$name.txt"
  xvfb-run -a -s '-screen 0 1400x900x24' \
    "$BUILD/src/ui/planewright" --no-settings --size 1400x900 --script "$work/$name.txt" "$@"
  mv "$work/$name.png" "$pictures/$name.png"
  shrink "$pictures/$name.png"
  echo "$pictures/$name.png"
}

# solve NAME ACTION IN [OPTION...]: planar panels in $work/NAME.obj.
solve() {
  local name=$1 action=$2 input=$3
  shift 3
  # Status 1: written, but with corners that are not well determined; nothing that a picture minds.
  "$cli" "$action" "$input" -o "$work/$name.obj" --quiet "$@" || (($? == 1))
}

# Above 300 kB: 256 colours, which makes a third of it. ImageMagick is welcome, not needed.
shrink() {
  if (($(stat -c %s "$1") > 300000)) && command -v convert > /dev/null; then
    convert "$1" -dither FloydSteinberg -colors 256 "png8:$1"
  fi
}

# A grid of quads with heights drawn by lot (always the same): so crumpled that planar quads want to cross themselves.
crumpled() {
  awk 'BEGIN {
    n = 10; lot = 2
    for (y = 0; y <= n; ++y) for (x = 0; x <= n; ++x) {
      lot = (lot * 16807) % 2147483647
      printf "v %d %d %.4f\n", x, y, 3.2 * (lot / 2147483647 - 0.5)
    }
    for (y = 0; y < n; ++y) for (x = 0; x < n; ++x) {
      v = y * (n + 1) + x + 1
      print "f", v, v + 1, v + n + 2, v + n + 1
    }
  }'
}

# tent OUT.obj REGIONS.csv: a fine mesh of a folded tent, and two rings of 12 regions each between its ridges and
# valleys; the upper ones all meet at the top.
tent() {
  awk -v obj="$1" -v csv="$2" 'BEGIN {
    panels = 12; fine = 8; n = panels * fine; rings = 20; turn = 6.283185307179586 / n
    print "v 0 0 5" > obj
    for (r = 1; r <= rings; ++r) for (k = 0; k < n; ++k) {
      t = r / rings; ridge = cos(panels / 2 * k * turn)
      radius = 6 * t * (1 + 0.05 * t * ridge)
      height = 5 * (1 - t) ^ 1.6 + 1.2 * t * (1 - t) + 0.45 * t * ridge
      printf "v %.5f %.5f %.5f\n", radius * cos(k * turn), radius * sin(k * turn), height > obj
    }
    print "face,region" > csv
    face = 0
    for (r = 0; r < rings; ++r) for (k = 0; k < n; ++k) {
      a = r ? 2 + (r - 1) * n + k : 1; b = r ? 2 + (r - 1) * n + (k + 1) % n : 1
      c = 2 + r * n + (k + 1) % n; d = 2 + r * n + k
      region = int(k / fine) + (r < 9 ? 0 : panels)
      if (r) { print "f", a, d, b > obj; print face++ "," region > csv }
      print "f", b, d, c > obj; print face++ "," region > csv
    }
  }'
}

# sheet NAME [OPTION...]: what render draws, with files and options as it takes them.
sheet() {
  local name=$1
  shift
  "$cli" render -o "$pictures/$name.png" "$@"
  shrink "$pictures/$name.png"
}

# panels NAME IN ACTION: the planar panels of a mesh over its ghost.
panels() {
  solve "$1" "$3" "$2"
  sheet "$1" "$work/$1.obj" --ghost "$2" --width 1000 --height 640
}

# pair NAME ACTION IN VIEW HEIGHT [OPTION...]: position alone on the left, the preset on the right.
pair() {
  local name=$1 action=$2 input=$3 view=$4 height=$5
  shift 5
  solve before "$action" "$input" --preset close-to-design "$@"
  solve after "$action" "$input" --preset "$name" "$@"
  sheet "preset-$name" "$work/before.obj" "$work/after.obj" --caption close-to-design --caption "$name" \
    --view="$view" --width 1000 --height "$height" "${marks[@]}"
}
marks=()

hut=assets/alpine-hut.obj station=assets/train-station.obj twisted=assets/twisted-roof.obj

draw() {
  case $1 in
    window-start)
      window window-start assets/train-station.obj << 'SCRIPT'
wait_loaded 20
wait_solved 120
wait_frames 8
screenshot PICTURE
SCRIPT
      ;;

    window-workshop)
      window window-workshop assets/train-station.obj << 'SCRIPT'
wait_loaded 20
wait_solved 120
click Hint/close
click "Findings/tab Workshop"
wait_frames 3
ctrl_click "Findings/edge min"
wait_frames 2
type 250
key Enter
wait_frames 3
ctrl_click "Findings/area max"
wait_frames 2
type 4
key Enter
wait_frames 3
key M
key G
key Y
key E
click "Findings/colour by"
wait_frames 3
click "Findings/colour by/all limits"
wait_frames 3
wait_solved 20
click "Findings/failure 0"
wait_frames 60
hover Menu/View
wait_frames 3
screenshot PICTURE
SCRIPT
      ;;

    window-export)
      window window-export assets/train-station.obj << 'SCRIPT'
wait_loaded 20
wait_solved 120
click Hint/close
click Toolbar/export
wait_frames 5
ctrl_click Export/thickness
wait_frames 2
type 20
key Enter
wait_frames 3
ctrl_click Export/gap
wait_frames 2
type 8
key Enter
wait_frames 3
wait_export 60
click "Export/next sheet"
click Export/folder
wait_frames 2
key Ctrl+A
type "workshop/train-station"
key Enter
wait_frames 3
hover Menu/View
wait_frames 5
screenshot PICTURE
SCRIPT
      ;;

    # In the middle of a solve, so each run gives another moment of it.
    window-streaming)
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
      ;;

    window-dark)
      window window-dark assets/alpine-hut.obj --theme dark << 'SCRIPT'
click Hint/close
wait_loaded 20
wait_solved 120
click "Toolbar/colours Displacement"
wait_frames 8
screenshot PICTURE
SCRIPT
      ;;

    window-findings)
      window window-findings assets/train-station.obj << 'SCRIPT'
click Hint/close
wait_loaded 20
wait_solved 120
click "Findings/finding 0"
wait_frames 12
expect finding == 0
screenshot PICTURE
SCRIPT
      ;;

    window-suggestions)
      window window-suggestions assets/train-station.obj << 'SCRIPT'
click Hint/close
wait_loaded 20
wait_solved 120
wait_rated 300
click "Findings/suggestion 0"
wait_frames 40
screenshot PICTURE
SCRIPT
      ;;

    window-clusters)
      window window-clusters << 'SCRIPT'
click Hint/close
sample dome 3000
wait_loaded 20
wait_solved 120
zoom 1
key 3
wait_frames 4
wait_solved 120
click "Design/regions number"
wait_frames 3
type "64"
key Enter
wait_frames 4
wait_solved 120
click "Findings/tab Report"
click_region any
hover_model 0.04 0.9
wait_frames 12
screenshot PICTURE
SCRIPT
      ;;

    station-panels) panels station-panels "$station" dual ;;
    twisted-roof-panels) panels twisted-roof-panels "$twisted" planarize ;;
    torus-panels) panels torus-panels assets/torus.obj dual ;;

    figure-2)
      solve free dual "$hut" --offset 0.1
      solve clear dual "$hut" --offset 0.1 --no-penetration
      sheet figure-2 "$work/free.obj" "$work/clear.obj" "$work/free.obj" "$work/clear.obj" --columns 2 \
        --with "$hut" --mark-crossings --width 900 --height 700 \
        --caption "Position alone: red panels cross the mesh" --caption "With --no-penetration: none do" \
        --caption "The same, closer" --caption "The same, closer" \
        --view=-123:31.5 --view=-123:31.5 --view=-123:31.5:3:-0.5:0:5 --view=-123:31.5:3:-0.5:0:5
      ;;
    figure-5)
      for preset in hll llh hhh; do solve "$preset" planarize "$twisted" --preset "$preset"; done
      sheet figure-5 "$twisted" "$work"/{hll,llh,hhh}.obj --columns 2 --width 1000 --height 500 --view=-105:32 \
        --caption "The design, not planar" --caption "HLL: mainly position" \
        --caption "LLH: mainly the shape of the quads; ripples" --caption "HHH: everything; close to the design"
      ;;
    figure-6)
      "$cli" sample wave-roof --panels 3000 -o "$work/wave.obj" > /dev/null
      tent "$work/tent.obj" "$work/tent.csv"
      solve wave-panels cluster "$work/wave.obj" --panels 48
      solve tent-panels cluster "$work/tent.obj" --from-regions "$work/tent.csv"
      sheet figure-6 "$work"/{wave,wave-panels,tent,tent-panels}.obj --columns 2 --width 1000 --height 720 \
        --caption "Wave roof, 5,800 triangles" --caption "48 planar panels" \
        --caption "Folded tent, 3,744 triangles" --caption "24 planar panels, 12 of them through the top" \
        --view=-120:32 --view=-120:32 --view=-100:34:1.7:0:0:2 --view=-100:34:1.7:0:0:2
      ;;
    figure-7)
      solve fair dual "$hut" --offset 0.2 --weights position=0.1,fairing=1
      solve smooth dual "$hut" --offset 0.2 --weights position=0.1,normal-smoothness=1
      solve fair-clear dual "$hut" --offset 0.2 --weights position=0.1,fairing=1 --no-penetration
      solve smooth-clear dual "$hut" --offset 0.2 --weights position=0.1,normal-smoothness=1 --no-penetration
      sheet figure-7 "$work"/{fair,smooth,fair-clear,smooth-clear}.obj --columns 2 --width 900 --height 860 \
        --view=-105:45 \
        --caption "Fairing: flat patches, sharp creases" --caption "Normal smoothness: rounder" \
        --caption "Fairing, --no-penetration" --caption "Normal smoothness, --no-penetration"
      ;;
    figure-8)
      solve symmetric dual "$station" --preset even-panels --offset 0.2
      solve unsymmetric dual assets/train-station-unsymmetric.obj --preset even-panels --offset 0.2
      sheet figure-8 "$work"/{symmetric,unsymmetric}.obj --columns 1 --width 900 --height 760 --view=-90:50 \
        --caption "Symmetric triangulation" --caption "Unsymmetric triangulation, same parameters"
      ;;

    preset-close-to-design)
      solve after dual "$station" --preset close-to-design --offset 0.2
      sheet preset-close-to-design "$station" "$work/after.obj" --caption "The design" \
        --caption close-to-design --view=-110:35 --width 1000 --height 270
      ;;
    preset-even-panels) pair even-panels dual "$station" -110:35 270 --offset 0.2 ;;
    preset-smooth-shell) pair smooth-shell dual "$station" -110:35 270 --offset 0.2 ;;
    preset-faceted-shell) pair faceted-shell dual "$station" -110:35 270 --offset 0.2 ;;
    preset-close) pair close planarize "$twisted" -105:32 270 ;;
    preset-uncrossed)
      marks=(--mark-crossings)
      crumpled > "$work/crumpled.obj"
      pair uncrossed planarize "$work/crumpled.obj" -115:55 430
      marks=()
      ;;
    presets-figure-5)
      letters=(lll llh lhl lhh hll hlh hhl)
      for preset in "${letters[@]}"; do solve "$preset" planarize "$twisted" --preset "$preset"; done
      inputs=("$twisted") captions=(--caption "The design")
      for preset in "${letters[@]}"; do
        inputs+=("$work/$preset.obj") captions+=(--caption "$preset")
      done
      captions[3]="lll, hhh"  # only ratios matter
      sheet presets-figure-5 "${inputs[@]}" "${captions[@]}" --columns 2 --width 860 --height 900 --view=-105:32
      ;;
  esac
}

if (($# == 0)); then set -- "${names[@]}"; fi
for name in "$@"; do draw "$name"; done
