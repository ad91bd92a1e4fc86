#!/usr/bin/env bash
# load_cityjson.sh EDGESHADE MAKE_CITY: CityJSON's own loader for three.js reads the files of city merge.
# Skipped (77) if it isn't installed.
set -euo pipefail
edgeshade=$1 make_city=$2
tests=$(cd "$(dirname "$0")" && pwd)
command -v node >/dev/null && [[ -d $tests/node_modules/cityjson-threejs-loader ]] || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$make_city" tiles cityjson 5 2 2 15 1 >/dev/null
"$edgeshade" city plan tiles --date 2026-06-21 --step 60 --grid 2 -o plan.json
"$edgeshade" city run plan.json --job 1
"$edgeshade" city merge plan.json -o map
node "$tests/load_cityjson.mjs" map tiles/*
