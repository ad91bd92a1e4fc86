#!/usr/bin/env bash
# window_test.sh EDGESHADE PICTURE_DIFFERENCE SCENE [DROP_FILE]: `edgeshade view` on a separate
# display. Exits 77 (skipped) without Xvfb or xdotool.
set -euo pipefail
program=$1 difference=$2 scene=$3 drop_file=${4:-}

for tool in Xvfb xdotool; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not here"; exit 77; }
done
fail() { echo "FAILED: $*"; exit 1; }
# at_most LIMIT A B: at most LIMIT pixels per thousand of A and B differ
at_most() {
    local found
    found=$("$difference" "$2" "$3")
    echo "$2 and $3: $found per thousand differ"
    awk -v found="$found" -v limit="$1" 'BEGIN { exit !(found ~ /^[0-9]/ && found <= limit) }'
}

folder=$(mktemp -d)
cd "$folder"
Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp 3>display 2>xvfb.log &
server=$!
window_program=
trap 'kill $window_program $server 2>/dev/null || true; wait 2>/dev/null; rm -rf "$folder"' EXIT
for _ in $(seq 100); do [[ -s display ]] && break; sleep 0.1; done
[[ -s display ]] || fail "Xvfb gives no display"

# Without a display it ends with status 3 and a sentence.
status=0
env -u DISPLAY -u WAYLAND_DISPLAY "$program" view "$scene" 2>message || status=$?
[[ $status == 3 ]] || fail "without a display the status is $status"
grep -q "No window can be opened here" message || fail "$(cat message)"

export DISPLAY=:$(cat display) LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY
view=(--size 400x300 --camera-from 7,5,9 --camera-to 0,1,0 --sun -0.6,0.6,-0.3)

# The window's picture equals that of `render`. Mesa's window and pbuffer configurations may round
# depth differently, so one pixel in a thousand may differ.
"$program" render "$scene" plain.png "${view[@]}" >/dev/null
"$program" view "$scene" --screenshot window.png "${view[@]}"
at_most 1 plain.png window.png || fail "the window shows another picture than render"
from_matrix=(--size 400x300 --camera-matrix 1,0,0,0,0,1,0,0,0,0,1,0,-0.5,-1,-12,1 --sun -0.6,0.6,-0.3)
"$program" render "$scene" plain-matrix.png "${from_matrix[@]}" >/dev/null
"$program" view "$scene" --screenshot matrix.png "${from_matrix[@]}"
at_most 1 plain-matrix.png matrix.png || fail "the window shows another picture by a matrix"

# A sun by place and time, by day and by night.
for hour in 16 01; do
    placed=("${view[@]:0:6}" --place 48.14,11.57 --time-of-day "2026-06-21T$hour:00+02:00" --north 40)
    "$program" render "$scene" plain-placed.png "${placed[@]}" >/dev/null 2>said
    "$program" view "$scene" --screenshot placed.png "${placed[@]}" 2>said-by-view
    at_most 1 plain-placed.png placed.png || fail "the window shows another picture at $hour h"
    cmp said said-by-view || fail "at $hour h the window warns of something else"
done
# The hours of sunlight are another picture, depend on the step, and need a place.
hours=("${view[@]:0:6}" --place 48.14,11.57 --time-of-day 2026-06-21T16:00+02:00 --sun-hours)
"$program" view "$scene" --screenshot hours.png "${hours[@]}"
at_most 200 placed.png hours.png && fail "--sun-hours shows the usual picture"
"$program" view "$scene" --screenshot hours-60.png "${hours[@]}" --step 60
at_most 0 hours.png hours-60.png && fail "--step does nothing"
"$program" view "$scene" --screenshot none.png "${view[@]}" --sun-hours 2>message &&
    fail "there are hours of sun without a place"
grep -q -e '--place' message || fail "$(cat message)"
"$program" view "$scene" --screenshot none.png "${hours[@]}" --step 7 2>message &&
    fail "a step of 7 minutes was taken"
grep -q 'divide a day' message || fail "$(cat message)"
grep -q 'below the horizon, so it lights nothing' said || fail "nobody warned of the night"

# Smoothed as by render, except for means half way between two bytes.
"$program" render "$scene" plain-smooth.png "${view[@]}" --smooth 16 >/dev/null
"$program" view "$scene" --screenshot smooth.png "${view[@]}" --smooth 16
at_most 100 plain-smooth.png smooth.png || fail "the window smooths another way than render"
at_most 150 plain.png smooth.png && fail "--smooth does nothing"

# Keys and mouse change it. Every P saves the next edgeshade-N.png.
"$program" view "$scene" "${view[@]}" 2>window.log &
window_program=$!
window=$(timeout 60 xdotool search --sync --onlyvisible --name 'edgeshade$' | head -1)
xdotool windowfocus --sync "$window"
shots=0
shoot() {
    shots=$((shots + 1))
    xdotool key p
    for _ in $(seq 200); do [[ -s edgeshade-$shots.png ]] && return; sleep 0.1; done
    fail "no screenshot $shots: $(cat window.log)"
}
shoot
at_most 1 plain.png edgeshade-1.png || fail "the first screenshot differs from render"
xdotool key Left Left Left
shoot
at_most 20 edgeshade-1.png edgeshade-2.png && fail "the arrow keys did nothing"
xdotool mousemove --window "$window" 60 250 mousedown 1
xdotool mousemove --window "$window" 120 240 mousemove --window "$window" 180 230 mouseup 1
shoot
at_most 20 edgeshade-2.png edgeshade-3.png && fail "dragging did nothing"
xdotool mousemove --window "$window" 200 150 click 4 click 4 click 4
shoot
at_most 20 edgeshade-3.png edgeshade-4.png && fail "the wheel did nothing"
xdotool key ctrl+Left ctrl+Left ctrl+Left ctrl+Left ctrl+Left ctrl+Left
shoot
at_most 5 edgeshade-4.png edgeshade-5.png && fail "the light did not move"
if [[ -n $drop_file ]]; then
    # A file that is no scene changes nothing and gives a sentence; a scene is shown and framed.
    echo nonsense >broken.glb
    "$drop_file" "$window" broken.glb || fail "the window takes no drop"
    shoot
    at_most 0 edgeshade-5.png edgeshade-6.png || fail "a broken file changed the picture"
    grep -q "broken.glb" window.log || fail "no sentence on the broken file: $(cat window.log)"
    "$program" pack "$scene" "dropped one.glb" 2>/dev/null >/dev/null
    "$drop_file" "$window" "dropped one.glb" || fail "the window takes no drop"
    timeout 60 xdotool search --sync --name '^dropped one.glb - edgeshade$' >/dev/null ||
        fail "the dropped scene is not shown: $(cat window.log)"
    shoot
    at_most 5 edgeshade-6.png edgeshade-7.png && fail "the dropped scene is not framed"
fi
before=edgeshade-$shots.png
xdotool key h i # text is over the window, but never in a screenshot
shoot
at_most 0 "$before" "edgeshade-$shots.png" || fail "the help is in the screenshot"
xdotool windowsize "$window" 500 320
for _ in $(seq 50); do
    shoot
    [[ $("$difference" "$before" "edgeshade-$shots.png") == sizes ]] && break
done
[[ $("$difference" "$before" "edgeshade-$shots.png") == sizes ]] || fail "no resize"
xdotool key Escape Escape # closes the help, then the window
status=0
wait "$window_program" || status=$?
window_program=
[[ $status == 0 ]] || fail "the window ended with status $status: $(cat window.log)"

# K cycles through the file's own materials and its variants, C through the cameras.
cat >variants.gltf <<END
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
 "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0.5, 0, 3]},
           {"camera": 0, "translation": [-0.5, 0, 5], "name": "far"}],
 "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}, "name": "near"}],
 "extensionsUsed": ["KHR_materials_variants"],
 "extensions": {"KHR_materials_variants": {"variants": [{"name": "red"}]}},
 "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 1]}},
               {"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0, "extensions":
   {"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [0]}]}}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [-1, -1, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAAAAAAAAgD8AAAAA"}]}
END
for camera in 0 1; do
    "$program" view variants.gltf --size 400x300 --camera $camera --screenshot camera-$camera.png
done
"$program" view variants.gltf --size 400x300 2>window.log &
window_program=$!
window=$(timeout 60 xdotool search --sync --onlyvisible --name 'variants.gltf - edgeshade$' | head -1)
xdotool windowfocus --sync "$window"
own=$((shots + 1))
shoot
xdotool key k
shoot
at_most 20 edgeshade-$own.png edgeshade-$shots.png && fail "K did nothing"
xdotool key k
shoot
at_most 0 edgeshade-$own.png edgeshade-$shots.png || fail "K does not lead back"
for camera in 0 1 0; do
    xdotool key c
    shoot
    at_most 0 camera-$camera.png edgeshade-$shots.png || fail "C does not show camera $camera"
done
xdotool key Escape
wait "$window_program" || fail "the window ended badly: $(cat window.log)"
window_program=
echo "the window shows what render draws, and reacts"
