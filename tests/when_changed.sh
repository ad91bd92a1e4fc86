#!/usr/bin/env bash
# Runs a long test only if something it can read has changed since it last passed:
# when_changed.sh STAMP PROGRAM COMMAND... STAMP is the file that keeps the digest of what COMMAND
# passed with; PROGRAM is the native edgeshade. The digest is of the whole repository, of what was built
# for the browser, of PROGRAM, of Node.js and Chromium, and of the environment's settings, so any change
# runs COMMAND. EDGESHADE_TEST_ALL=1 always runs it. The status is COMMAND's, or 0.
set -euo pipefail
stamp=$1
program=$2
shift 2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Files of the repository; what builds and packing write there is left out.
sources() {
    find . \( -path ./build -o -path ./.git -o -path ./.cache -o -path ./web/dist -o -name node_modules \
        -o -name __pycache__ \) -prune -o -type f ! -path './web/LICENSE*' -print0
}

digest() {
    cd "$root"
    {
        { sources && find build/web -type f -print0; } | sort -z | xargs -0 sha256sum || true
        sha256sum <"$program"
        find ../shared/scenes -type f -printf '%p %s %T@\n' 2>/dev/null | sort
        node --version
        for browser in "${EDGESHADE_CHROMIUM:-chromium-headless-shell}" chromium; do
            "$browser" --version || true
        done
        env | grep -E '^(EDGESHADE|MESA|LIBGL|GALLIUM)_' | grep -v '^EDGESHADE_TEST_ALL=' | sort
        echo "$*"
    } 2>&1 | sha256sum
}

before=$(digest "$@")
if [[ -z ${EDGESHADE_TEST_ALL-} && -e $stamp && $(<"$stamp") == "$before" ]]; then
    echo "Nothing has changed since this passed; EDGESHADE_TEST_ALL=1 runs it again."
    exit 0
fi
rm -f "$stamp"
"$@" || exit
[[ $(digest "$@") == "$before" ]] || exit 0
mkdir -p "$(dirname "$stamp")"
echo "$before" >"$stamp"
