#!/bin/sh
# Builds the site and runs its tests. Status 77: skipped, because something that they need is missing.
set -eu
cd "$(dirname "$0")/.."
skip() {
  echo "Skipped: $1"
  exit 77
}
[ -e ../build/web/wasm/edgeshade-masks.wasm ] || skip "build/web is not built; './run web --build-only' does that."
command -v doxygen > /dev/null || skip "Doxygen is not here; Debian's package of that name has it."
command -v node > /dev/null || skip "there is no Node.js."
[ -d node_modules/axe-core ] || skip "the site's packages are not installed; 'npm ci' in site/ does that."
[ -d ../web/node_modules/playwright-core ] || skip "playwright-core is not installed; 'npm ci' in web/ does that."
[ -x "$(node ../web/tests/support/chromium-path.mjs)" ] || skip "there is no Chromium."
node tools/build.mjs
exec node --test --test-concurrency=1 tests/*.test.mjs
