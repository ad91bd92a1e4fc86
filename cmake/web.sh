# Sourced by ./run and ./test after packages.sh: tools for the browser's build, besides packages.
# shellcheck shell=bash

source cmake/sources.sh

web_packages=(emscripten cmake ninja-build dpkg-dev libglm-dev libtinygltf-dev libstb-dev
    nlohmann-json3-dev libboost-dev)

# install_web_test_packages: what the browser's tests take, with Chromium's engine alone where the system has it.
install_web_test_packages() {
    local chromium=chromium
    if apt-cache show chromium-headless-shell >/dev/null 2>&1; then chromium=chromium-headless-shell; fi
    install_packages "${web_packages[@]}" "$chromium" fonts-dejavu-core
}

# build_web: builds the viewer for browsers into build/web.
build_web() {
    install_packages "${web_packages[@]}"
    fetch_sources build/sources
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
    serve_folder build/web "$port"
}

# serve_folder FOLDER PORT: serves it on localhost, by a later port if this one is taken.
serve_folder() {
    local port=$2
    while ! python3 -c "import socket; socket.socket().bind(('127.0.0.1', $port))" 2>/dev/null; do
        ((port < 65535)) || exit 1
        port=$((port + 1))
    done
    say "Open http://localhost:$port/ in a browser; Ctrl-C ends it."
    exec python3 -m http.server "$port" --bind 127.0.0.1 --directory "$1"
}
