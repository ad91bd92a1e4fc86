#!/usr/bin/env bash
# Checks that clang-format would leave every C++ file unchanged. Exits 77 (skipped) without
# clang-format 14, since other versions disagree about details.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if ! clang-format --version 2>/dev/null | grep -q 'version 14'; then
    echo "skipped: clang-format 14 is not here"
    exit 77
fi
find include preprocess src tests web -name node_modules -prune -o -name '*.[ch]pp' -print0 | xargs -0 clang-format --dry-run --Werror
