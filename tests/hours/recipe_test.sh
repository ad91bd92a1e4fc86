#!/usr/bin/env bash
# recipe_test.sh EDGESHADE ASSETS: the recipe for Snakemake gives the same bytes as a run in one
# piece; without Snakemake it runs the recipe's commands.
set -euo pipefail
edgeshade=$1 assets=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
options=(--place 48.14,11.57 --date 2026-03-21 --step 60 --size 96x64 --at 0,0.01,3)
cp "$assets/pavilion.glb" scene.glb
"$edgeshade" sunhours scene.glb whole.png "${options[@]}" --report whole.json \
    --counts whole-counts.png 2>whole.log || { cat whole.log; exit 1; }

if command -v snakemake >/dev/null; then
    snakemake --quiet all --cores 2 --snakefile "$assets/recipes/sunhours.smk" \
        --config edgeshade="$edgeshade" scene=scene.glb parts=3 options="${options[*]}"
else
    echo "Snakemake is not there: its commands are run without it."
    mkdir sunhours
    for part in 1 2 3; do
        "$edgeshade" sunhours scene.glb "sunhours/$part.part" "${options[@]}" --part "$part/3"
    done
    "$edgeshade" sunhours-merge sunhours/hours.png sunhours/*.part --counts sunhours/counts.png \
        --report sunhours/report.json
fi
cmp whole.png sunhours/hours.png
cmp whole-counts.png sunhours/counts.png
cmp whole.json sunhours/report.json
