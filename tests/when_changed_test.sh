#!/usr/bin/env bash
# Checks that when_changed.sh runs a command again after a failure and after any change, and only then.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp /bin/true "$folder/program"
unset EDGESHADE_TEST_ALL

expect() { # expect ran|kept STATUS: how a command that exits with STATUS is treated
    local what=kept status=0
    "$(dirname "$0")/when_changed.sh" "$folder/stamp" "$folder/program" \
        sh -c 'touch "$0"/ran; exit "$(cat "$0"/status)"' "$folder" >/dev/null || status=$?
    ! rm "$folder/ran" 2>/dev/null || what=ran
    [[ "$what $status" == "$*" ]] || {
        echo "line ${BASH_LINENO[0]}: $what with status $status, not $*"
        exit 1
    }
}

echo 3 >"$folder/status"
expect ran 3
expect ran 3
echo 77 >"$folder/status"
expect ran 77
echo 0 >"$folder/status"
expect ran 0
expect kept 0
EDGESHADE_TEST_ALL=1 expect ran 0
expect kept 0
EDGESHADE_TEST_SETTING=1 expect ran 0
expect ran 0
echo >>"$folder/program"
expect ran 0
expect kept 0
