# Sourced by ./run and ./test after packages.sh: what the browser's build needs beyond packages.
# shellcheck shell=bash

web_packages=(emscripten cmake ninja-build dpkg-dev libglm-dev libtinygltf-dev libstb-dev
    nlohmann-json3-dev)
web_test_packages=(chromium fonts-dejavu-core)
web_sources=(draco meshoptimizer) # built for WebAssembly from Debian's source packages

# Debian's own sources of this machine, as source packages, in a folder of their own: the machine's
# lists stay as they are.
source_lists() {
    local folder=$1 list
    mkdir -p "$folder/parts" "$folder/state/partial"
    for list in /etc/apt/sources.list.d/debian*.sources; do
        [[ -e $list ]] && sed 's/^Types:.*/Types: deb-src/' "$list" \
            >"$folder/parts/$(basename "$list")"
    done
    [[ -e /etc/apt/sources.list ]] && sed -n 's/^deb \(.*debian.*\)/deb-src \1/p' \
        /etc/apt/sources.list >"$folder/parts/debian.list"
    return 0
}

# fetch_web_sources FOLDER: FOLDER/draco and FOLDER/meshoptimizer, unless they are there.
fetch_web_sources() {
    local folder=$1 package lists
    mkdir -p "$folder"
    lists=$(cd "$folder" && pwd)/lists
    for package in "${web_sources[@]}"; do
        [[ -e $folder/$package/.complete ]] && continue
        command -v apt-get >/dev/null || return 0 # CMake fetches them from upstream
        say "Fetching the source of $package"
        source_lists "$lists"
        local options=(-qq -o "Dir::Etc::sourcelist=/dev/null" -o "Dir::State::lists=$lists/state"
            -o "Dir::Etc::sourceparts=$lists/parts" -o "APT::Get::List-Cleanup=0")
        compgen -G "$lists/state/*Sources*" >/dev/null || apt-get "${options[@]}" update
        rm -rf "${folder:?}/$package" "$folder/fetching"
        mkdir "$folder/fetching"
        (cd "$folder/fetching" && apt-get "${options[@]}" source "$package" >/dev/null 2>&1)
        mv "$folder/fetching/$package"-*/ "$folder/$package"
        rm -rf "$folder/fetching"
        touch "$folder/$package/.complete"
    done
}

# build_web: the viewer for browsers, into build/web.
build_web() {
    install_packages "${web_packages[@]}"
    fetch_web_sources build/web-sources
    configure_options=()
    build web
}

# run_web [--build-only] [--port N]
run_web() {
    local port=8000 serve=1
    while (($#)); do
        case $1 in
        --build-only) serve= ;;
        --port)
            port=${2:?--port needs a number}
            shift
            ;;
        *)
            say "./run web takes --build-only and --port N, not '$1'."
            exit 1
            ;;
        esac
        shift
    done
    build_web >&2
    say "The viewer is in $PWD/build/web"
    [[ -n $serve ]] || return 0
    while ! python3 -c "import socket; socket.socket().bind(('127.0.0.1', $port))" 2>/dev/null; do
        ((port < 65535)) || exit 1
        port=$((port + 1)) # somebody else's
    done
    say "Open http://localhost:$port/ in a browser; Ctrl-C ends it."
    exec python3 -m http.server "$port" --bind 127.0.0.1 --directory build/web
}
