#include "tests/support/kept_gl.hpp"

#include <dlfcn.h>
#include <initializer_list>

namespace edgeshade::test {

void keepGlLoaded() {
    [[maybe_unused]] static const bool loaded = [] {
        for (const char* const library :
             {"libEGL_mesa.so.0", "/usr/lib/x86_64-linux-gnu/dri/swrast_dri.so"})
            ::dlopen(library, RTLD_NOW);
        return true;
    }();
}

} // namespace edgeshade::test
