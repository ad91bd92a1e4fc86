#!/usr/bin/env bash
# cmake/aarch64.sh [FOLDER]   Debian's arm64 libraries for the preset aarch64, unpacked into FOLDER
#                             (build/aarch64-sysroot). Installs nothing: the machine's own packages
#                             and lists stay unchanged, and no root is needed. The sources of
#                             Draco, meshoptimizer and ERFA go to build/sources.
# ./test sources it for --long.
# shellcheck shell=bash

# The compiler, and the emulator that runs its programs here: ordinary packages of this machine.
aarch64_tools=(g++-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user dpkg-dev)
aarch64_libraries=(libglm-dev nlohmann-json3-dev libtinygltf-dev libstb-dev libcli11-dev
    libgtest-dev librapidcheck-dev libwebp-dev libwebp7 libegl-dev libgles-dev libegl1 libgles2 libglvnd0
    libgl-dev libglu1-mesa-dev
    libboost-dev "$(apt-cache depends libboost-dev | sed -n 's/.*Depends: //p')") # which only names its headers

# Targets that ./test --long builds and runs, except for the program, which is only linked: this is
# the one build without GLFW and cairo, and with the rays of pages in place of Embree.
aarch64_targets=(preprocess_test closed_chain_test closed_chain_precision_test pack_hashes edgeshade)

# unpack_aarch64 FOLDER: fills FOLDER/usr, unless it is complete.
unpack_aarch64() {
    local folder=$1 lists list package
    [[ -e $folder/.complete ]] && return 0
    mkdir -p "$folder/packages"
    folder=$(cd "$folder" && pwd)
    lists=$folder/lists
    mkdir -p "$lists/parts" "$lists/state/partial" "$lists/cache"
    : >"$lists/status"
    for list in /etc/apt/sources.list.d/debian*.sources; do
        [[ -e $list ]] && cp "$list" "$lists/parts/"
    done
    [[ -e /etc/apt/sources.list ]] &&
        sed -n '/^deb .*debian/p' /etc/apt/sources.list >"$lists/parts/debian.list"
    local options=(-qq -o APT::Architecture=arm64 -o APT::Architectures=arm64
        -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$lists/parts"
        -o "Dir::State=$lists" -o "Dir::State::lists=$lists/state"
        -o "Dir::State::status=$lists/status" -o "Dir::Cache=$lists/cache"
        -o APT::Sandbox::User=)
    apt-get "${options[@]}" update
    (cd "$folder/packages" && apt-get "${options[@]}" download "${aarch64_libraries[@]}")
    for package in "$folder"/packages/*.deb; do
        dpkg -x "$package" "$folder"
    done
    # Some of their CMake files assume /usr.
    find "$folder/usr" -name '*.cmake' -exec sed -i "s|\"/usr|\"$folder/usr|g" {} +
    rm -rf "$folder/packages" "$lists"
    touch "$folder/.complete"
}

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
    set -euo pipefail
    cd "$(dirname "$0")/.."
    source cmake/packages.sh
    source cmake/sources.sh
    fetch_sources build/sources
    unpack_aarch64 "${1:-build/aarch64-sysroot}"
fi
