# Sourced by ./run and ./test after packages.sh: libraries that are built from source where Debian's
# builds won't do, see LibrariesFromSource.cmake.
# shellcheck shell=bash

# Debian's own source packages for this machine's sources, in a separate folder: the machine's lists
# stay unchanged.
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

# fetch_sources FOLDER: fetches FOLDER/draco, FOLDER/meshoptimizer, FOLDER/erfa and FOLDER/glu, unless
# they exist.
fetch_sources() {
    local folder=$1 package lists
    mkdir -p "$folder"
    lists=$(cd "$folder" && pwd)/lists
    for package in draco meshoptimizer erfa glu; do
        [[ -e $folder/$package/.complete ]] && continue
        command -v apt-get >/dev/null || return 0 # CMake fetches them from upstream
        say "Fetching the source of $package"
        source_lists "$lists"
        local options=(-qq -o "Dir::Etc::sourcelist=/dev/null" -o "Dir::State::lists=$lists/state"
            -o "Dir::Etc::sourceparts=$lists/parts" -o "APT::Get::List-Cleanup=0")
        compgen -G "$lists/state/*Sources*" >/dev/null || apt-get "${options[@]}" update
        rm -rf "${folder:?}/$package" "$folder/fetching"
        mkdir "$folder/fetching"
        if [[ $package == glu ]]; then # Debian's patches of libglu don't touch the tessellator
            (cd "$folder/fetching" && apt-get "${options[@]}" source --tar-only libglu >/dev/null 2>&1 &&
                tar -xzf libglu_*.orig.tar.gz)
        else
            (cd "$folder/fetching" && apt-get "${options[@]}" source "$package" >/dev/null 2>&1)
        fi
        mv "$folder/fetching/$package"-*/ "$folder/$package"
        rm -rf "$folder/fetching"
        touch "$folder/$package/.complete"
    done
}
