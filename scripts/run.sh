#!/usr/bin/env bash
# The main job: opens the window on a design; without a display it makes the planar panels and a picture instead.
#
#   scripts/run.sh [MESH]      a triangle mesh becomes its planar dual, any other polygon mesh is planarized
#
# Without MESH: a bundled design. Headless results go to out/ (or $PLANEWRIGHT_OUT). Exit status: the program's own.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
mesh=${1:-$root/assets/train-station.obj}
if [ ! -f "$mesh" ]; then
  echo "run.sh: there is no file '$mesh'" >&2
  exit 3
fi
mesh=$(realpath "$mesh")
"$root/scripts/build.sh" release --target planewright planewright-cli >&2

bin=$root/build/release/src
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$bin/ui/planewright" "$mesh"
fi

out=${PLANEWRIGHT_OUT:-$root/out}
mkdir -p "$out"
name=$(basename "${mesh%.*}")
echo "No display: making panels and a picture in $out" >&2
status=0
"$bin/cli/planewright-cli" panels "$mesh" -o "$out/$name-panels.obj" --report "$out/$name-report.json" || status=$?
if [ -f "$out/$name-panels.obj" ]; then
  "$bin/cli/planewright-cli" render "$out/$name-panels.obj" --ghost "$mesh" -o "$out/$name-panels.png"
fi
exit $status
