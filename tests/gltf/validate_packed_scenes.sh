#!/bin/sh
# Packs every scene of the given folders with every encoding, makes the mesh of sunhours --surfaces
# of one, and runs Khronos' validator over the results. Status 77: skipped, because the validator isn't installed.
#
#   validate_packed_scenes.sh PROGRAM FOLDER_OF_THE_VALIDATOR FOLDER_OF_SCENES...
set -eu
program=$1
validator=$2
shift 2
if ! command -v node > /dev/null; then
  echo "Skipped: there is no Node.js to run the glTF validator with."
  exit 77
fi
if [ ! -d "$validator/node_modules/gltf-validator" ]; then
  echo "Skipped: the glTF validator is not installed; 'npm ci' in tests/gltf does that."
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for scenes in "$@"; do
  for scene in "$scenes"/*.glb; do
    [ -e "$scene" ] || continue
    for encoding in expanded indexed none; do
      "$program" pack "$scene" "$folder/$(basename "$scene" .glb).$encoding.glb" \
        --encoding "$encoding" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
    done
  done
done
status=0
"$program" sunhours "$1/pavilion.glb" "$folder/cells.glb" --surfaces --place 48.14,11.57 \
  --date 2026-03-21 --step 60 > "$folder/log" 2>&1 || status=$?
[ $status = 0 ] || [ $status = 3 ] || { cat "$folder/log"; exit 1; }
node "$validator/validate_packed.mjs" "$folder"/*.glb
