# Sourced by ./run after packages.sh: makes the packages of a release.
# shellcheck shell=bash

# make_packages: build/packages gets what cpack makes, and the npm package if the browser's modules
# are built.
make_packages() {
    if (($#)); then
        say "./run package takes no further words, not '$1'."
        exit 1
    fi
    install_packages "${package_tools[@]}"
    build release edgeshade edgeshade_runtime edgeshade_manual >&2
    rm -rf build/packages
    say "Packing"
    (cd build/release && cpack >&2)
    rm -rf build/packages/_CPack_Packages
    if [[ ! -f build/web/wasm/edgeshade-masks.wasm ]]; then
        say "There is no build/web, so no npm package is made: ./run web --build-only builds it."
    else
        say "Packing for npm"
        (install_node_modules web >&2 && cd web &&
            npm pack --pack-destination ../build/packages >&2)
    fi
    say "The packages:"
    ls -d build/packages/*
}
