#!/usr/bin/env bash
# same_bytes.sh PACK_HASHES SOURCES SHARED_SCENES: packs the same scenes here, on aarch64 (by
# qemu-user) and in WebAssembly (by node), prints the hashes, and fails if they differ. Platforms
# that were not built are left out; without any it exits with 77 (skipped).
set -euo pipefail
here=$1 sources=$2 shared=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

aarch64=$sources/build/aarch64/tests/platforms/pack_hashes
libraries=$sources/build/aarch64-sysroot/usr/lib/aarch64-linux-gnu
web=$sources/build/web-build/tests/platforms/pack_hashes.cjs

# Without another platform to compare with, the sample is enough.
files=("$sources/assets/pavilion.glb")
if [[ -e $aarch64 || -e $web ]]; then
    for file in "$shared"/*.glb; do
        [[ -e $file ]] && files+=("$file")
    done
fi

echo "$(uname -m):"
"$here" "${files[@]}" | tee "$work/here"
compared=0 failed=0

# against NAME COMMAND...: whether the command prints the same hashes.
against() {
    local name=$1
    shift
    compared=1
    if ! "$@" "${files[@]}" >"$work/there"; then
        echo "$name: packing failed"
        failed=1
    elif diff "$work/here" "$work/there"; then
        echo "$name: the same $(wc -l <"$work/here") hashes"
    else
        echo "$name: packs other bytes"
        failed=1
    fi
}

if [[ ! -x $aarch64 ]]; then
    echo "aarch64: left out, preset aarch64 is not built (./test --long does)"
elif ! command -v qemu-aarch64 >/dev/null; then
    echo "aarch64: left out, qemu-aarch64 is not installed"
else
    against aarch64 qemu-aarch64 -L /usr/aarch64-linux-gnu -E "LD_LIBRARY_PATH=$libraries" "$aarch64"
fi

if [[ ! -e $web ]]; then
    echo "WebAssembly: left out, pack_hashes of preset web is not built (./test --long does)"
elif ! command -v node >/dev/null; then
    echo "WebAssembly: left out, node is not installed"
else
    against WebAssembly node "$web"
fi

((failed == 0)) || exit 1
((compared)) || exit 77
