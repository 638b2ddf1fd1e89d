#!/bin/bash
# The window under a real mouse: slider drag, click on an edge, orbit, wheel, keys, regions of clusters, and quitting, as X events
# from xdotool.
#
#   mouse_test.sh PLANEWRIGHT [FOLDER]
#
# PLANEWRIGHT: the window's binary; FOLDER: where its output is left. Makes a virtual display of its own, so that
# nobody's mouse is moved. Exit status: 0 all well, 1 something is not, 77 skipped (xdotool or Xvfb is missing).
set -u
window=$1
folder=${2:-$(mktemp -d)}
mkdir -p "$folder"
for tool in xdotool Xvfb; do
  if ! command -v "$tool" > /dev/null; then
    echo "skipped: $tool is missing (apt-get install xdotool xvfb)"
    exit 77
  fi
done

log=$folder/window.log
: > "$log"
rm -f "$folder/display"
Xvfb -displayfd 4 -screen 0 1600x1000x24 -nolisten tcp 4> "$folder/display" > /dev/null 2>&1 &
server=$!
app=
cleanup() {
  [ -n "$app" ] && kill "$app" 2> /dev/null
  kill "$server" 2> /dev/null
  wait 2> /dev/null
}
trap cleanup EXIT
for _ in $(seq 100); do
  [ -s "$folder/display" ] && break
  sleep 0.1
done
[ -s "$folder/display" ] || { echo "FAILED: Xvfb does not start"; exit 1; }
DISPLAY=:$(head -1 "$folder/display")
export DISPLAY
unset XAUTHORITY

XDG_CONFIG_HOME=$folder/config "$window" --size 1440x900 --no-settings --dump-ui > "$log" 2>&1 &
app=$!

fail() {
  echo "FAILED: $1"
  echo "the last state: $(grep '^state' "$log" | tail -1)"
  exit 1
}
# The newest value of a key.
value() { grep '^state' "$log" | tail -1 | grep -o " $1=\"[^\"]*\"" | cut -d'"' -f2; }
# wait_for SECONDS WHAT TEST...: until the test holds
wait_for() {
  local tenths=$(($1 * 10)) what=$2
  shift 2
  for _ in $(seq "$tenths"); do
    "$@" && return 0
    kill -0 "$app" 2> /dev/null || fail "the window has ended ($what)"
    sleep 0.1
  done
  fail "waited in vain: $what"
}
is() { [ "$(value "$1")" = "$2" ]; }
is_not() { [ "$(value "$1")" != "$2" ]; }
# The newest rectangle of a control: x0 y0 x1 y1 knob.
control() {
  tac "$log" | awk -v path="$1" '
    /^control / { name = $9; for (i = 10; i <= NF; i++) name = name " " $i
                  if (name == path) { print $2, $3, $4, $5, $8; exit } }'
}
newest_edge() { tac "$log" | grep -m1 '^edge '; }
drag() {  # x0 y0 x1 y1 button
  xdotool mousemove "$1" "$2" sleep 0.3 mousedown "$5" sleep 0.2
  for i in 1 2 3 4 5 6 7 8; do
    xdotool mousemove $(($1 + ($3 - $1) * i / 8)) $(($2 + ($4 - $2) * i / 8)) sleep 0.06
  done
  xdotool sleep 0.2 mouseup "$5"
}

wait_for 60 "the sample is solved" is settled 1
for _ in $(seq 50); do [ -n "$(control 'Design/weight fairing')" ] && break; sleep 0.1; done

# 1. A slider is dragged: the weight changes, the solver runs anew, and the drag is one step of undo.
read -r x0 y0 x1 y1 knob <<< "$(control 'Design/weight fairing')"
[ -n "${knob:-}" ] || fail "the fairing slider is not on the screen"
ticket=$(value ticket)
y=$(((y0 + y1) / 2))
drag "$knob" $y $((x0 + (x1 - x0) * 6 / 10)) $y 1
wait_for 20 "the weight follows the mouse" is_not weight.fairing 0
wait_for 20 "a solve was started" is_not ticket "$ticket"
is undo "Weight of fairing" || fail "the drag is not in the undo list"
wait_for 120 "the solve ends" is settled 1
echo "slider: fairing $(value weight.fairing), $(value iterates_before_end) iterates shown before the end"

# 2. Ctrl Z takes it back.
xdotool mousemove 700 400 sleep 0.2 key ctrl+z
wait_for 20 "undo" is weight.fairing 0
wait_for 120 "the solve ends" is settled 1

# 3. A click on an edge flips it.
sleep 1
edge_line=$(newest_edge)
[ -n "$edge_line" ] || fail "no edge can be clicked"
read -r _ edge ex ey <<< "$edge_line"
revision=$(value revision)
xdotool mousemove "$ex" "$ey" sleep 0.5
wait_for 10 "the edge under the mouse is shown" is hovered_edge "$edge"
xdotool mousedown 1 sleep 0.2 mouseup 1
wait_for 20 "the flip" is undo "Flip edge $edge"
wait_for 120 "the solve ends" is settled 1
echo "edge: $edge flipped at $ex, $ey"

# 4. I polishes what the solve came to.
is polished 0 || fail "the result is polished, though nobody asked"
xdotool mousemove 700 420 sleep 0.2 key i
wait_for 20 "the polish starts" is asked auto
wait_for 120 "the polish ends" is settled 1
is polished 1 || fail "the result is not polished"
echo "polish: $(value badge)"

# 5. A drag over the model orbits and flips nothing.
revision=$(value revision)
camera=$(value camera)
drag 700 420 850 460 1
wait_for 20 "the camera moves" is_not camera "$camera"
is revision "$revision" || fail "the orbit changed the design"
camera=$(value camera)
xdotool mousemove 700 420 sleep 0.2 click 4 sleep 0.2 click 4
wait_for 20 "the wheel zooms" is_not camera "$camera"
echo "orbit and zoom: camera $(value camera)"

# 6. Keys.
xdotool mousemove 700 420 sleep 0.2 key c
wait_for 20 "C colours by planarity" is colours planarity

# 7. Clusters: 3 makes them, the slider changes their number, a click splits one, a drag paints.
xdotool mousemove 700 420 sleep 0.2 key c sleep 0.2 key 3 sleep 0.2 key f
wait_for 20 "3 makes clusters" is mode cluster
wait_for 60 "the clusters are solved" is settled 1
for _ in $(seq 50); do [ -n "$(control 'Design/regions')" ] && break; sleep 0.1; done
read -r x0 y0 x1 y1 knob <<< "$(control 'Design/regions')"
[ -n "${knob:-}" ] || fail "the slider of regions is not on the screen"
regions=$(value regions)
y=$(((y0 + y1) / 2))
drag "$knob" $y $((knob - 60)) $y 1
wait_for 20 "the regions follow the mouse" is_not regions "$regions"
wait_for 60 "the solve ends" is settled 1
case "$(value undo)" in
  "Cluster into"*) ;;
  *) fail "the drag is not in the undo list" ;;
esac
regions=$(value regions)
read -r x0 y0 x1 y1 _ <<< "$(control 'model')"
x=$((x0 + (x1 - x0) / 4))
y=$(((y0 + y1) / 2))
xdotool mousemove $((x + 3)) $y sleep 0.2 key x sleep 0.2 mousemove $x $y sleep 0.4
wait_for 20 "X takes the tool that splits" is tool split
wait_for 20 "the region under the mouse is marked" is_not hovered_region -1
xdotool mousedown 1 sleep 0.2 mouseup 1
wait_for 20 "the click splits" is_not regions "$regions"
wait_for 60 "the solve ends" is settled 1
xdotool key r
wait_for 20 "R takes the brush" is tool paint
camera=$(value camera)
drag $x $y $((x + 60)) $((y + 15)) 1
wait_for 60 "the solve ends" is settled 1
case "$(value undo)" in
  "Paint region"*) ;;
  *) fail "the stroke is not in the undo list" ;;
esac
is camera "$camera" || fail "the stroke turned the view"
echo "clusters: $(value regions) regions, $(value undo)"

# 8. Ctrl Q asks what is to become of the changes, and quits without them.
xdotool key ctrl+q
for _ in $(seq 50); do [ -n "$(control 'Leaving/discard')" ] && break; sleep 0.1; done
read -r x0 y0 x1 y1 _ <<< "$(control 'Leaving/discard')"
[ -n "${x0:-}" ] || fail "Ctrl Q does not ask about the changes"
xdotool mousemove $(((x0 + x1) / 2)) $(((y0 + y1) / 2)) sleep 0.3 mousedown 1 sleep 0.2 mouseup 1
for _ in $(seq 100); do
  kill -0 "$app" 2> /dev/null || break
  sleep 0.1
done
kill -0 "$app" 2> /dev/null && fail "Ctrl Q does not quit"
wait "$app"
status=$?
app=
[ $status -eq 0 ] || fail "the window ended with status $status"
echo "all well"
