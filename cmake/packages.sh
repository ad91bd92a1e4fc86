# Sourced by ./run and ./test: installs missing Debian packages, and no others.

say() { printf '\033[1m==>\033[0m %s\n' "$*" >&2; }

build_packages=(
    g++ cmake ninja-build libglfw3-dev libglm-dev libtinygltf-dev libstb-dev nlohmann-json3-dev
    libdraco-dev libmeshoptimizer-dev liberfa-dev libwebp-dev libcli11-dev libegl-dev libgles-dev libglu1-mesa-dev
    libembree-dev libgeotiff-dev libtiff-dev libproj-dev proj-data libboost-dev libcairo2-dev libegl1 libegl-mesa0 libgles2 libgl1-mesa-dri
)
package_tools=(dpkg-dev) # finds the libraries that a Debian package needs
test_packages=(python3 libgtest-dev librapidcheck-dev libnova-dev clang clang-format xvfb xdotool libx11-dev valgrind
    dpkg-dev lintian man-db jq)

# install_packages PACKAGE...
install_packages() {
    local missing=() package
    if ! command -v apt-get >/dev/null; then
        say "There is no apt-get here. Please install what these Debian packages hold, by your system's names:"
        printf '      %s\n' "$@" >&2
        return 0
    fi
    for package in "$@"; do
        [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == "install ok installed" ]] ||
            missing+=("$package")
    done
    ((${#missing[@]})) || return 0
    local as_root=()
    if [[ $(id -u) != 0 ]]; then as_root=(sudo); fi
    say "Installing ${missing[*]}"
    "${as_root[@]}" apt-get update -qq
    DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq \
        --no-install-recommends "${missing[@]}" >/dev/null
}

# install_node_modules FOLDER: what its package-lock.json names, unless that is there.
install_node_modules() {
    local installed=$1/node_modules/.edgeshade-installed
    cat "$1/package.json" "$1/package-lock.json" | cmp -s - "$installed" && return
    npm ci --prefix "$1" --no-audit --no-fund --loglevel error || return
    cat "$1/package.json" "$1/package-lock.json" >"$installed"
}

# build PRESET [TARGET...]: configures with ${configure_options[@]}, then builds.
build() {
    local preset=$1
    shift
    if ! command -v cmake >/dev/null; then
        say "CMake is missing, so nothing can be built. Install what is listed above, then call this again."
        exit 1
    fi
    say "Building ($preset)"
    cmake --preset "$preset" "${configure_options[@]}" >/dev/null
    cmake --build --preset "$preset" ${1:+--target "$@"}
}
