# Sourced by ./run after packages.sh: builds the documentation site.
# shellcheck shell=bash

source cmake/web.sh

site_packages=(doxygen)
site_node=18 # the least version of Node.js that builds the site

# install_site_tools: what building the site takes, besides build/web.
install_site_tools() {
    install_packages "${site_packages[@]}"
    command -v npm >/dev/null || install_packages nodejs npm
    local node
    node=$(node --version)
    node=${node#v}
    if ((${node%%.*} < site_node)); then
        say "The site takes Node.js $site_node or later, and this is $node."
        return 1
    fi
    install_node_modules site
}

# build_site: builds the site into build/site.
build_site() {
    install_site_tools
    [[ -f build/web/wasm/edgeshade.wasm && -f build/web/wasm/edgeshade-masks.wasm ]] || build_web
    say "Building the site"
    npm run --silent build --prefix site
}

# run_site [--serve] [--port N]
run_site() {
    local port=8000 serve=
    while (($#)); do
        case $1 in
        --serve) serve=1 ;;
        --port)
            port=${2:?--port needs a number}
            serve=1
            shift
            ;;
        *)
            say "./run site takes --serve and --port N, not '$1'."
            exit 1
            ;;
        esac
        shift
    done
    build_site >&2
    say "The site is in $PWD/build/site: index.html opens as a file; live pictures need a server."
    [[ -z $serve ]] || serve_folder build/site "$port"
}
