#include "tests/support/kept_gl.hpp"

#include <dlfcn.h>
#include <initializer_list>

namespace edgeshade::test {

void keepGlLoaded() {
    for (const char* const library :
         {"libEGL_mesa.so.0", "/usr/lib/x86_64-linux-gnu/dri/swrast_dri.so"})
        ::dlopen(library, RTLD_NOW); // costs nothing once it is there
}

} // namespace edgeshade::test
