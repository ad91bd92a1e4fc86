#!/bin/sh
# Runs the browser's tests: run.sh PROGRAM [FILES...]. PROGRAM is the native edgeshade to compare
# with, FILES are test files in web/, by default all. Status 77: skipped, because something that they
# need is missing.
set -eu
EDGESHADE_PROGRAM=$1
export EDGESHADE_PROGRAM
cd "$(dirname "$0")/.."
skip() {
  echo "Skipped: $1"
  exit 77
}
[ -e ../build/web/wasm/edgeshade.wasm ] || skip "build/web is not built; './run web --build-only' does that."
command -v node > /dev/null || skip "there is no Node.js."
[ -d node_modules/playwright-core ] || skip "playwright-core is not installed; 'npm ci' in web/ does that."
[ -x "${EDGESHADE_CHROMIUM:-/usr/bin/chromium}" ] || skip "there is no Chromium."
shift
[ $# -gt 0 ] || set -- tests/*.test.mjs
exec node --test --test-concurrency=1 "$@"
