#!/usr/bin/env bash
# use_packages.sh PREFIX FOLDER: uses what packages installed into PREFIX. FOLDER has scene.glb and the
# project consumer/, and takes the results. Ends with status 1 and a sentence at the first fault.
set -euo pipefail
prefix=$1
cd "$2"
export PATH=$prefix/bin:$PATH MANPATH=$prefix/share/man MANPAGER=cat PAGER=cat LC_ALL=C

fail() {
    echo "$*" >&2
    exit 1
}
completed() { # completed WORD...: what bash offers for the last word
    bash -c "source '$prefix/share/bash-completion/completions/edgeshade'
        COMP_WORDS=(\"\$@\") COMP_CWORD=\$((\$# - 1)); _edgeshade 2>/dev/null; echo \" \${COMPREPLY[*]} \"" complete "$@"
}

[[ $(command -v edgeshade) == "$prefix/bin/edgeshade" ]] || fail "Another edgeshade than $prefix's is found."
edgeshade render scene.glb picture.png --size 320x240 --light 1,5,2
[[ $(head -c 4 picture.png | tail -c 3) == PNG ]] || fail "render wrote no PNG."

# man-db would ask for locales that a bare root has not.
page=$(man edgeshade 2>/dev/null) || fail "There is no manual page."
for word in SYNOPSIS sunhours-merge --shadows "EXIT STATUS"; do
    [[ $page == *"$word"* ]] || fail "The manual page lacks $word."
done

[[ $(completed edgeshade ren) == " render " ]] || fail "'edgeshade ren' is completed to '$(completed edgeshade ren)'."
[[ $(completed edgeshade render scene.glb --shad) == *" --shadows "* ]] || fail "Options are not completed."
[[ $(completed edgeshade render scene.glb --shadows vol) == " volumes " ]] || fail "Words are not completed."
[[ $(completed edgeshade render scene.glb --shadows = vol) == " volumes " ]] || fail "Words after = are not completed."
[[ $(completed edgeshade render scene.glb --size "") == "  " ]] || fail "A size is completed."

cmake -S consumer -B built -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release >cmake.log 2>&1 ||
    fail "find_package(edgeshade) fails: $(cat cmake.log)"
cmake --build built >build.log 2>&1 || fail "The consumer can't be built: $(cat build.log)"
[[ $(./built/silhouettes | head -1) == "6 4" ]] || fail "The consumer finds other silhouettes."
./built/draw drawn.ppm
[[ $(head -c 2 drawn.ppm) == P6 ]] || fail "The consumer draws no picture."
echo "Used: render, manual page, completion, find_package()."
