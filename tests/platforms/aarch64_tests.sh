#!/usr/bin/env bash
# aarch64_tests.sh SOURCES: runs the preprocessor's tests as aarch64 programs in qemu-user. Exits
# with 77 (skipped) if they are not built.
set -euo pipefail
folder=$1/build/aarch64/tests/preprocess
libraries=$1/build/aarch64-sysroot/usr/lib/aarch64-linux-gnu
if [[ ! -x $folder/preprocess_test ]] || ! command -v qemu-aarch64 >/dev/null; then
    echo "skipped: preset aarch64 is not built, or qemu-aarch64 not installed (./test --long does)"
    exit 77
fi
for test in preprocess_test closed_chain_test closed_chain_precision_test; do
    qemu-aarch64 -L /usr/aarch64-linux-gnu -E "LD_LIBRARY_PATH=$libraries" "$folder/$test" \
        --gtest_brief=1
done
