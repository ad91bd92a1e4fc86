#!/bin/bash
# Runs the browser's tests: run.sh PROGRAM [FILES...]. PROGRAM is the native edgeshade to compare
# with, FILES are test files in web/, by default all. A file that fails runs once more, as pages on a
# busy machine may be too slow for what a test waits for; the output names it. Status 77: skipped,
# because something that they need is missing.
set -euo pipefail
EDGESHADE_PROGRAM=$1
export EDGESHADE_PROGRAM
cd "$(dirname "$0")/.."
skip() {
    echo "Skipped: $1"
    exit 77
}
[[ -e ../build/web/wasm/edgeshade.wasm ]] || skip "build/web is not built; './run web --build-only' does that."
command -v node >/dev/null || skip "there is no Node.js."
[[ -d node_modules/playwright-core ]] || skip "playwright-core is not installed; 'npm ci' in web/ does that."
[[ -x $(node tests/support/chromium-path.mjs) ]] || skip "there is no Chromium."
shift
(($#)) || set -- tests/*.test.mjs

run() {
    node "$1"
}

failed=()
for file; do
    run "$file" || failed+=("$file")
done
status=0
for file in ${failed[@]+"${failed[@]}"}; do
    echo "# $file failed, and runs once more"
    if run "$file"; then
        echo "# $file failed once, and passed when it ran again"
    else
        echo "# $file failed twice"
        status=1
    fi
done
exit $status
